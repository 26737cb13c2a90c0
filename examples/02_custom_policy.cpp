// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// A classifier of your own in the pipeline. It decides when an object counts as moving; everything else stays.
/// usage: example_custom_policy SEQUENCE      (try examples/data/mini)

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "dot/dot.hpp"
#include "dot/image/opencv.hpp"

namespace {

/// Moving after `streak` fits in a row that are faster than `limit` with `sigmas` certainty, static after as many that
/// are slower with it; between the two, the last decision stands. The concept is in dot/motion/classifier.hpp.
struct StreakClassifier {
  double limit = 1.0;  ///< m/s
  double sigmas = 2;
  int streak = 3;  ///< frames

  /// One for each object, kept by the pipeline.
  struct Memory {
    int faster = 0;
    int slower = 0;
    dot::State state = dot::State::NotObservable;
  };

  dot::Decision operator()(Memory& memory, const dot::MotionEstimate* fit, const dot::Matrix3<double>& R_cur_prev,
                           double /*dt*/) const {
    dot::Decision decision;
    if (fit != nullptr) {
      const double speed = fit->velocity.norm();
      // Sigma of the speed: the covariance along the velocity.
      const dot::Vector3<double> along = fit->velocity / std::max(speed, 1e-9);
      const double sigma = std::sqrt(along.dot(fit->covariance * along));
      memory.faster = speed - sigmas * sigma > limit ? memory.faster + 1 : 0;
      memory.slower = speed + sigmas * sigma < limit ? memory.slower + 1 : 0;
      if (memory.faster >= streak) memory.state = dot::State::Moving;
      if (memory.slower >= streak) memory.state = dot::State::Static;
      decision.velocity = R_cur_prev * fit->velocity;
      decision.covariance = R_cur_prev * fit->covariance * R_cur_prev.transpose();
    }
    decision.state = memory.state;
    decision.p_moving = memory.state == dot::State::Moving ? 1 : memory.state == dot::State::Static ? 0 : 0.5;
    return decision;
  }
};

}  // namespace

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
  dot::Dot<dot::Pinhole, StreakClassifier> tracker(dot::Pinhole(intrinsics), options);
  tracker.classifier.limit = 0.8;

  std::map<std::uint32_t, std::string> history;  // a letter a frame for each object
  constexpr int frames = 10;
  for (int i = 0; i < frames; ++i) {
    const std::string name = "/00000" + std::to_string(i) + ".png";
    const cv::Mat image = cv::imread(folder + "/rgb" + name, cv::IMREAD_UNCHANGED);
    const cv::Mat depth = cv::imread(folder + "/depth" + name, cv::IMREAD_UNCHANGED);
    const cv::Mat masks = cv::imread(folder + "/masks" + name, cv::IMREAD_UNCHANGED);

    dot::Frame frame;
    frame.timestamp = i / fps;
    frame.image = dot::view(image);
    frame.depth = dot::depth_view(depth, 256);
    if (!masks.empty()) frame.masks = dot::Masks{dot::id_view(masks), {}};

    for (const dot::ObjectResult& object : tracker.track(frame).objects) {
      std::string& letters = history[object.id];
      letters.resize(static_cast<std::size_t>(i), ' ');
      letters += object.state == dot::State::Moving ? 'M' : object.state == dot::State::Static ? 's' : '.';
    }
  }
  std::printf("%d frames, M = moving, s = static, . = not observable\n", frames);
  for (const auto& [id, letters] : history) std::printf("object %2u  %s\n", id, letters.c_str());
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
