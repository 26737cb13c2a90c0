// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// mapping SEQUENCE: what reaches RTAB-Map of the sample's depth.

#include <memory>
#include <sstream>
#include <string>

#include "DotInput.h"
#include "truth.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: mapping SEQUENCE" << std::endl;
    return 2;
  }
  const Truth truth(argv[1]);
  const rtabmap::CameraModel model(362.5, 362.5, 309.5, 93.5, cv::Size(620, 188));
  DotInput input(model, dot::DepthSource::Rgbd);
  const auto odometry = std::make_unique<rtabmap::Odometry>();
  rtabmap::Rtabmap rtabmap;

  double all[3] = {0, 0, 0}, kept[3] = {0, 0, 0};  // pixels with depth: elsewhere, on parked cars, on movers
  for (int i = 0; i < FRAMES; ++i) {
    const double seconds = 1.7e9 + 0.1 * i;
    const cv::Mat image = Read(cv::format("%s/rgb/%06d.png", argv[1], i));
    const cv::Mat fine = Read(cv::format("%s/depth/%06d.png", argv[1], i));  // metres * 256
    cv::Mat depth, instances;
    fine.convertTo(depth, CV_16U, 1000.0 / 256);
    const cv::Mat whole = depth.clone();
    if (i % 2 == 0) instances = Read(cv::format("%s/masks/%06d.png", argv[1], i));
    // snippet: rtabmap_loop
    // end of snippet
    if (cv::countNonZero(depth != whole) != 0) {
      std::cerr << "the caller's depth was changed" << std::endl;
      return 1;
    }
    const cv::Mat kinds = truth.Kinds(i);
    for (int kind = 0; kind < 3 && i >= 8; ++kind) {
      all[kind] += cv::countNonZero((kinds == kind) & (depth > 0));
      kept[kind] += cv::countNonZero((kinds == kind) & (rtabmap.depth > 0));
    }
  }
  std::cout << "depth kept from the ninth frame on: " << kept[0] / all[0] << " elsewhere, " << kept[1] / all[1]
            << " on parked cars, " << kept[2] / all[2] << " on movers" << std::endl;

  // Times in milliseconds: one line, not one with every frame.
  std::ostringstream said;
  std::streambuf* const terminal = std::cerr.rdbuf(said.rdbuf());
  const cv::Mat view = Read(cv::format("%s/rgb/000000.png", argv[1]));
  for (int i = 0; i < 20; ++i)
    input.take(view, cv::Mat(188, 620, CV_16UC1, cv::Scalar(3000)), cv::Mat(), 2e9 + 100 * i);
  std::cerr.rdbuf(terminal);
  const std::string text = said.str();
  std::cout << text;
  const bool told = text.find("dot: implausible_times (100 s)") == 0 && text.find('\n') + 1 == text.size();

  // What is wrong with one frame leaves its depth as it is, and the next one goes on.
  const cv::Mat image(188, 620, CV_8UC1, cv::Scalar(9)), depth(188, 620, CV_16UC1, cv::Scalar(3000));
  const bool survives =
      cv::countNonZero(input.take(image, depth, cv::Mat(10, 10, CV_8UC1, cv::Scalar(1)), 3e9).depthRaw() != depth) == 0;
  return kept[0] > 0.9 * all[0] && kept[1] > 0.9 * all[1] && kept[2] < 0.05 * all[2] && told && survives ? 0 : 1;
}
