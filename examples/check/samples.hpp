// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

#include "sequence/recording.hpp"

namespace check {

/// One frame in memory.
struct Sample {
  std::size_t index = 0;  ///< in the recording
  bool follows = false;   ///< the sample before it is the frame before it
  cv::Mat grey;           ///< CV_8UC1
  cv::Mat depth;  ///< CV_16UC1 as in the file but 65535, which is none, or CV_32FC1 in metres from the stereo pair; of
                  ///< any size
  cv::Mat right;  ///< CV_8UC1 of the image's size, or empty
  cv::Mat ids;    ///< one channel, of any size; empty: no segmentation
};

/// A recording and as many of its frames as memory and patience allow: all, or runs of consecutive ones spread over it.
struct Samples {
  runner::Recording recording;
  std::vector<Sample> frames;
  bool depth_from_pair = false;  ///< there are no depth images
};

/// Reads what there is, of whatever size and values.
/// @throws FileError naming a file that is missing or cannot be read.
Samples read_samples(const runner::SequenceOptions& options);

/// Metres, CV_32FC1, 0 = none.
cv::Mat metres(const Samples& samples, const Sample& frame);

/// Whether a frame's depth has the image's size; other sizes are a fault of their own.
bool has_depth(const Sample& frame);
/// Likewise of the masks.
bool has_masks(const Sample& frame);

}  // namespace check
