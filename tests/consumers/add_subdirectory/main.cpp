// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host without Eigen or OpenCV in its own code: one grey frame goes in, a label image of its size comes out.

#include <cstdint>
#include <cstdio>
#include <vector>

#include "dot/tracker.hpp"

int main() {
  dot::Intrinsics camera;
  camera.fx = camera.fy = 100;
  camera.cx = 79.5;
  camera.cy = 59.5;
  camera.width = 160;
  camera.height = 120;

  const std::vector<std::uint8_t> grey(160 * 120, 100);
  const std::vector<float> metres(160 * 120, 5.0F);
  dot::Frame frame;
  frame.image = {grey.data(), 160, 120, 160, dot::PixelFormat::Grey8};
  frame.depth = {metres.data(), 160, 120, 160 * sizeof(float), dot::PixelFormat::DepthF32};

  dot::Tracker tracker(camera);
  const dot::Result& result = tracker.track(frame);
  std::printf("%d x %d labels, %s\n", result.labels.width, result.labels.height, to_string(result.camera.status));
  return result.labels.width == 160 && result.labels.height == 120 ? 0 : 1;
}
