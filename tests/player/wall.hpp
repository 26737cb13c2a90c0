// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>

#include "dot/pipeline/result.hpp"
#include "sequence/sequence.hpp"
#include "support/hand_made_result.hpp"

namespace player {

inline const cv::Size frame_size(120, 80);
inline const dot::Intrinsics camera{100, 100, 59.5, 39.5, 120, 80, 0};

/// A noisy frame 10 m before a wall.
inline runner::SequenceFrame wall(int number) {
  runner::SequenceFrame frame;
  frame.number = number;
  frame.timestamp = 0.1 * number;
  frame.image.create(frame_size, CV_8UC3);
  cv::RNG random(1);
  random.fill(frame.image, cv::RNG::UNIFORM, 0, 255);
  frame.depth = cv::Mat(frame_size, CV_16UC1, cv::Scalar(2560));
  return frame;
}

/// A measured object that covers `area`.
inline dot::ObjectResult& add_measured(HandMadeResult& hand_made, std::uint32_t id, dot::State state,
                                       const cv::Rect& area) {
  dot::ObjectResult& object = hand_made.add(id, state, area);
  object.area = area.area();
  object.box = {area.x, area.y, area.width, area.height};
  object.reason = dot::Reason::None;
  object.last_decided = state;
  object.velocity = {2, 0, 0};
  object.speed = 2;
  object.velocity_covariance = {0.01, 0, 0, 0, 0.04, 0, 0, 0, 1};
  object.range = 10;
  object.phi = 0.95;
  object.p_moving = 0.97;
  object.n_points = 100;
  object.n_inliers = 80;
  return object;
}

/// With a camera that stands, a tenth of a second after the frame before.
inline dot::Result tracked(const HandMadeResult& hand_made) {
  dot::Result result = hand_made.result();
  result.camera.status = dot::CameraStatus::Tracked;
  result.interval = 0.1;
  return result;
}

}  // namespace player
