// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <opencv2/core.hpp>

#include "dot/tracker.hpp"
#include "real_time/clock.hpp"
#include "real_time/late_segmentation.hpp"

namespace real_time::test {

constexpr int width = 96;
constexpr int height = 64;

inline dot::Intrinsics camera() { return {80, 80, 47.5, 31.5, width, height, 0}; }

/// A wall with texture, 4 m away, seen by a camera that stands; a part of it is an instance.
inline runner::SequenceFrame wall(int number) {
  runner::SequenceFrame frame;
  frame.number = number;
  frame.timestamp = 0.1 * number;
  frame.image.create(height, width, CV_8UC1);
  cv::RNG random(1);
  random.fill(frame.image, cv::RNG::UNIFORM, 0, 256);
  frame.depth = cv::Mat(height, width, CV_16UC1, cv::Scalar(4 * 256));
  frame.ids = cv::Mat(height, width, CV_8UC1, cv::Scalar(0));
  frame.ids(cv::Rect(30, 20, 30, 24)).setTo(7);
  return frame;
}

inline FramePtr wall_ptr(int number) { return std::make_shared<const runner::SequenceFrame>(wall(number)); }

/// Time passes when somebody waits, and takes no time.
class FakeClock : public Clock {
 public:
  double now() const override { return now_; }
  bool sleep_until(double seconds, const std::atomic<bool>& stop) override {
    double before = now_;
    while (before < seconds && !now_.compare_exchange_weak(before, seconds)) {
    }
    return !stop;
  }

 private:
  std::atomic<double> now_{100};
};

}  // namespace real_time::test
