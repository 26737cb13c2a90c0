// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "dot/camera/intrinsics.hpp"
#include "dot/frame/frame.hpp"
#include "dot/image/opencv.hpp"
#include "dot/lie/se3.hpp"
#include "dot/pipeline/options.hpp"

namespace dot::test {

/// The sample sequence with its truth (examples/data/README.md), read into memory at once.
struct Sample {
  struct View {
    double timestamp = 0;
    cv::Mat image, depth, masks;
    cv::Mat instance;  ///< true ids, CV_16UC1
    SE3d T_world_camera;
    std::map<int, double> speed;  ///< by true id, m/s; 0 when parked
  };
  Intrinsics camera;
  std::vector<View> views;

  /// @throws std::runtime_error naming the file that cannot be read.
  explicit Sample(const std::string& folder) {
    open(folder + "/intrinsics.txt") >> camera.fx >> camera.fy >> camera.cx >> camera.cy >> camera.width >>
        camera.height >> camera.baseline;
    std::ifstream times = open(folder + "/times.txt"), poses = open(folder + "/poses.txt");
    View view;
    while (times >> view.timestamp) {
      char name[16];
      std::snprintf(name, sizeof name, "/%06d.png", static_cast<int>(views.size()));
      view.image = read(folder + "/rgb" + name);
      view.depth = read(folder + "/depth" + name);
      view.masks = read(folder + "/masks" + name);
      view.instance = read(folder + "/instance" + name);
      std::array<double, 12> T{};
      for (double& value : T) poses >> value;
      view.T_world_camera = SE3d::from_row_major(T);
      views.push_back(view);
    }
    read_speeds(folder + "/objects.csv");
  }

  int size() const { return static_cast<int>(views.size()); }
  const View& operator[](int i) const { return views[static_cast<std::size_t>(i)]; }

  /// What a tracker may see of a frame; borrows the sample's memory.
  Frame frame(int i, bool with_masks = true) const {
    const View& view = (*this)[i];
    Frame out;
    out.id = static_cast<std::uint64_t>(i);
    out.timestamp = view.timestamp;
    out.image = dot::view(view.image);
    out.depth = depth_view(view.depth, 256);
    if (with_masks) out.masks = Masks{id_view(view.masks), {}};
    return out;
  }

  /// Defaults, with the depth's source stated.
  static Options options() {
    Options out;
    out.depth_noise.source = DepthSource::Stereo;
    return out;
  }

 private:
  static std::ifstream open(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return file;
  }
  static cv::Mat read(const std::string& path) {
    cv::Mat image = cv::imread(path, cv::IMREAD_UNCHANGED);
    if (image.empty()) throw std::runtime_error("cannot read " + path);
    return image;
  }
  void read_speeds(const std::string& path) {  // frame,id,class,moving,speed_mps,...
    std::ifstream file = open(path);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::istringstream in(line);
      std::array<std::string, 5> field;
      for (std::string& text : field) std::getline(in, text, ',');
      const std::size_t i = std::stoul(field[0]);
      if (i < views.size()) views[i].speed[std::stoi(field[1])] = field[3] == "1" ? std::stod(field[4]) : 0.0;
    }
  }
};

}  // namespace dot::test
