// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "check/finding.hpp"
#include "check/samples.hpp"

namespace check_test {

constexpr int width = 320, height = 160;

/// Boxes 4 m away before a wall 20 m away, with a texture of their own each; they pass by, each at its own speed.
struct Scene {
  cv::Mat wall = cv::Mat(height, width, CV_8U), boxes = cv::Mat(height, 2 * width, CV_8U);

  Scene() {
    cv::RNG random(7);
    random.fill(wall, cv::RNG::UNIFORM, 60, 120);
    random.fill(boxes, cv::RNG::UNIFORM, 130, 230);
    cv::GaussianBlur(wall, wall, {}, 1);
    cv::GaussianBlur(boxes, boxes, {}, 1);
  }

  /// Box `k` in a frame.
  static cv::Rect box(int k, int frame) {
    const int speed[] = {7, -9, 5};
    const int x = ((40 + 110 * k + speed[k] * frame) % width + width) % width;
    return cv::Rect(x, 15 + 45 * k, 50, 40) & cv::Rect(0, 0, width, height);
  }

  check::Sample frame(int i) const {
    check::Sample sample;
    sample.index = static_cast<std::size_t>(i);
    sample.follows = i > 0;
    sample.grey = wall.clone();
    sample.depth = cv::Mat(height, width, CV_16U, cv::Scalar(20 * 256));
    sample.ids = cv::Mat::zeros(height, width, CV_8U);
    for (int k = 0; k < 3; ++k) {
      const cv::Rect at = box(k, i);
      boxes(cv::Rect(100 * k, 0, at.width, at.height)).copyTo(sample.grey(at));
      sample.depth(at) = cv::Scalar(4 * 256);
      sample.ids(at) = cv::Scalar(k + 1);
    }
    cv::RNG noise(static_cast<std::uint64_t>(i) + 1);
    cv::Mat more(sample.grey.size(), CV_8U);
    noise.fill(more, cv::RNG::UNIFORM, 0, 4);
    sample.grey += more;
    return sample;
  }
};

/// That scene over `count` frames, 10 a second.
inline check::Samples made_samples(int count = 24) {
  const Scene scene;
  check::Samples samples;
  samples.recording.intrinsics = {300, 300, 159.5, 79.5, width, height, 0};
  samples.recording.depth_source = dot::DepthSource::Rgbd;
  samples.recording.entries.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    samples.recording.entries[static_cast<std::size_t>(i)].number = i;
    samples.recording.entries[static_cast<std::size_t>(i)].timestamp = 0.1 * i;
    samples.frames.push_back(scene.frame(i));
  }
  return samples;
}

/// The finding of this name; one that says nothing if there is none.
inline check::Finding find(const check::Findings& findings, const std::string& fault) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const check::Finding& f) { return f.fault == fault; });
  return found == findings.end() ? check::unknown("no such finding: " + fault, "") : *found;
}

}  // namespace check_test
