// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// The shortest complete program: label the objects of a recording's first frames.
/// usage: example_minimal SEQUENCE      (try examples/data/mini)

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "dot/dot.hpp"
#include "dot/image/opencv.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: %s SEQUENCE\n", argv[0]), 2;
  const std::string folder = argv[1];

  dot::Intrinsics intrinsics;
  double fps = 0;
  std::ifstream file(folder + "/intrinsics.txt");
  file >> intrinsics.fx >> intrinsics.fy >> intrinsics.cx >> intrinsics.cy >> intrinsics.width >> intrinsics.height >>
      intrinsics.baseline >> fps;
  if (!file) return std::fprintf(stderr, "cannot read %s/intrinsics.txt\n", folder.c_str()), 1;

  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  dot::Dot<> tracker(dot::Pinhole(intrinsics), options);

  for (int i = 0; i < 6; ++i) {
    const std::string name = "/00000" + std::to_string(i) + ".png";
    const cv::Mat image = cv::imread(folder + "/rgb" + name, cv::IMREAD_UNCHANGED);
    const cv::Mat depth = cv::imread(folder + "/depth" + name, cv::IMREAD_UNCHANGED);
    const cv::Mat masks = cv::imread(folder + "/masks" + name, cv::IMREAD_UNCHANGED);

    dot::Frame frame;
    frame.timestamp = i / fps;
    frame.image = dot::view(image);
    frame.depth = dot::depth_view(depth, 256);
    if (!masks.empty()) frame.masks = dot::Masks{dot::id_view(masks), {}};

    const dot::Result& result = tracker.track(frame);
    std::printf("frame %d\n", i);
    for (const dot::ObjectResult& object : result.objects) {
      std::printf("  object %u  %-12s", object.id, dot::to_string(object.state));
      const Eigen::Map<const Eigen::Vector3d> v(object.velocity.data());
      const Eigen::Map<const Eigen::Matrix3d> V(object.velocity_covariance.data());
      if (object.reason == dot::Reason::None)
        std::printf("  %5.2f m/s, sigma %.2f", object.speed, std::sqrt(v.dot(V * v)) / std::max(v.norm(), 1e-9));
      std::printf("\n");
    }
  }
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
