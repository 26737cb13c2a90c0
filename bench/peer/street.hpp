// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <opencv2/imgproc.hpp>

#include "peer.hpp"
#include "sequence/sequence.hpp"

namespace dot::bench {

/// For cars: 20 m between two frames, 80 m of depth.
inline Peer::Limits street_limits() { return {80, 0.5, 20, 30}; }

/// What the peer takes of a frame: grey, and depth in metres with NaN where there is none.
struct PeerImages {
  cv::Mat grey, depth;

  explicit PeerImages(const runner::SequenceFrame& frame) {
    if (frame.image.channels() == 1)
      grey = frame.image;
    else
      cv::cvtColor(frame.image, grey, frame.image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
    frame.depth.convertTo(depth, CV_32F, frame.depth.type() == CV_16UC1 ? 1 / frame.depth_units_per_metre : 1);
    depth.setTo(std::numeric_limits<float>::quiet_NaN(), depth <= 0);
  }
};

}  // namespace dot::bench
