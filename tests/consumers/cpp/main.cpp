// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A host that uses both tiers at once, dot::Tracker and Dot<>, on a sequence: host SEQUENCE OUT. It writes what each of
// them says, for compare.cpp; with TRACKER_ONLY, the first alone. Eigen code of its own and a large stack of aligned
// matrices stand for a SLAM system's.

#include <Eigen/Dense>
#include <opencv2/imgcodecs.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#ifndef TRACKER_ONLY
#include "dot/dot.hpp"
#endif
#include "dot/image/opencv.hpp"
#include "dot/tracker.hpp"

namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 24;  // the whole sample

cv::Mat read(const fs::path& path) {
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  if (image.empty()) throw std::runtime_error("cannot read " + path.string());
  return image;
}

/// One tracker's answers: label pixels and the objects' states.
class Record {
 public:
  Record(const fs::path& out, const std::string& name)
      : labels_(out / (name + "_labels.bin"), std::ios::binary), states_(out / (name + "_states.txt")) {}

  void add(const dot::Result& result) {
    for (int y = 0; y < result.labels.height; ++y) {
      labels_.write(reinterpret_cast<const char*>(result.labels.row(y)), result.labels.width);
    }
    for (const dot::ObjectResult& object : result.objects) {
      states_ << result.frame_id << ' ' << object.id << ' ' << dot::to_string(object.state) << '\n';
      decided_ += object.state == dot::State::Moving || object.state == dot::State::Static;
    }
  }
  int decided() const { return decided_; }

 private:
  std::ofstream labels_;
  std::ofstream states_;
  int decided_ = 0;
};

/// Dynamic and fixed-size Eigen code like that inside the library: what a linker could merge with it.
double host_algebra(int seed) {
  std::vector<Eigen::Matrix4d, Eigen::aligned_allocator<Eigen::Matrix4d>> poses(16, Eigen::Matrix4d::Identity());
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Identity();
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Constant(40, 6, 0.01 * seed);
  information.noalias() += jacobian.transpose() * jacobian;
  const Eigen::Matrix<double, 6, 1> step = information.ldlt().solve(Eigen::Matrix<double, 6, 1>::Ones());
  return step.sum() + poses.back().trace();
}

void run(const fs::path& sequence, const fs::path& out) {
  dot::Intrinsics camera;
  std::ifstream intrinsics(sequence / "intrinsics.txt");
  double fps = 0;
  intrinsics >> camera.fx >> camera.fy >> camera.cx >> camera.cy >> camera.width >> camera.height >> camera.baseline >>
      fps;
  if (!intrinsics) throw std::runtime_error("cannot read " + (sequence / "intrinsics.txt").string());

  dot::Tracker tracker(camera);
  fs::create_directories(out);
  Record compiled(out, "tracker");
#ifndef TRACKER_ONLY
  dot::Dot<> pipeline{dot::Pinhole(camera)};
  Record templates(out, "dot");
#endif
  double sum = 0;

  for (int i = 0; i < kFrames; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "%06d.png", i);
    const cv::Mat image = read(sequence / "rgb" / name);
    const cv::Mat depth = read(sequence / "depth" / name);
    const cv::Mat masks = read(sequence / "masks" / name);

    dot::Frame frame;
    frame.id = static_cast<std::uint64_t>(i);
    frame.timestamp = i / fps;
    frame.image = dot::view(image);
    frame.depth = dot::depth_view(depth, 256);
    frame.masks = dot::Masks{};
    frame.masks->ids = dot::id_view(masks);

    compiled.add(tracker.track(frame));
    sum += host_algebra(i);
#ifndef TRACKER_ONLY
    templates.add(pipeline.track(frame));
#endif
  }
  if (compiled.decided() == 0) throw std::runtime_error("the tracker never decided on an object");
  std::cout << compiled.decided() << " decided object-frames (" << sum << ")\n";
#ifndef TRACKER_ONLY
  if (templates.decided() == 0) throw std::runtime_error("the templates never decided on an object");
  std::cout << templates.decided() << " of the templates\n";
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: host SEQUENCE OUT\n";
    return 2;
  }
  try {
    run(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
