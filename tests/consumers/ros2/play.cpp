// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Publishes the sample, and looks at the masks that the node publishes: the movers are in them, the parked cars are
// not.

#include <cstdio>
#include <cstdlib>

#include "cv_bridge/cv_bridge.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "truth.h"

namespace {

using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::Image;

constexpr int start = 1700000000;  // seconds of a Unix clock

std_msgs::msg::Header header(int frame) {
  std_msgs::msg::Header h;
  h.stamp.sec = start + frame / 10;
  h.stamp.nanosec = static_cast<std::uint32_t>(frame % 10 * 100000000);
  return h;
}

void publish(const char* topic, int frame, const char* encoding, const cv::Mat& image) {
  rclcpp::Publisher<Image>{topic}.publish(*cv_bridge::CvImage(header(frame), encoding, image).toImageMsg());
}

}  // namespace

void rclcpp::play(const std::string& sequence) {
  const Truth truth(sequence);
  int masks = 0;
  double all[3] = {0, 0, 0}, excluded[3] = {0, 0, 0};  // pixels elsewhere, on parked cars, on movers
  topics<Image>()["exclusion_mask"] = [&](const Image::ConstSharedPtr& message) {
    const int frame =
        (message->header.stamp.sec - start) * 10 + static_cast<int>(message->header.stamp.nanosec / 100000000);
    const cv::Mat kinds = truth.Kinds(frame), mask = cv_bridge::toCvShare(message)->image;
    ++masks;
    for (int kind = 0; kind < 3 && frame >= 8; ++kind) {
      all[kind] += cv::countNonZero(kinds == kind);
      excluded[kind] += cv::countNonZero((kinds == kind) & (mask == 255));
    }
  };

  CameraInfo info;
  Publisher<CameraInfo>{"camera_info"}.publish(info);  // not calibrated: an error in the log, no more
  info.width = 620, info.height = 188;
  info.p = {362.5, 0, 309.5, 0, 0, 362.5, 93.5, 0, 0, 0, 1, 0};
  Publisher<CameraInfo>{"camera_info"}.publish(info);

  for (int pass = 0; pass < 2; ++pass) {  // the second time stamps jump back
    for (int i = 0; i < FRAMES; ++i) {
      cv::Mat depth;
      Read(cv::format("%s/depth/%06d.png", sequence.c_str(), i)).convertTo(depth, CV_16U, 1000.0 / 256);
      const cv::Mat image = Read(cv::format("%s/rgb/%06d.png", sequence.c_str(), i));
      const cv::Mat instances = Read(cv::format("%s/masks/%06d.png", sequence.c_str(), i));
      if (i % 4 == 0) publish("instances", i, "8UC1", instances);
      publish("depth", i, "16UC1", depth);
      publish("image", i, "bgr8", image);
      if (i % 4 == 2) publish("instances", i, "8UC1", instances);  // late: the frame was tracked already
    }
    for (int i = 100; i < 115; ++i) publish("instances", i, "8UC1", cv::Mat(188, 620, CV_8UC1));  // of no frame at all
  }
  std::printf("%d masks; excluded from the ninth frame on: %.3f elsewhere, %.3f of parked cars, %.3f of movers\n",
              masks, excluded[0] / all[0], excluded[1] / all[1], excluded[2] / all[2]);
  const bool good =
      masks == 2 * FRAMES && excluded[0] < 0.1 * all[0] && excluded[1] < 0.1 * all[1] && excluded[2] > 0.9 * all[2];

  // Depth in floats that are millimetres by mistake.
  topics<Image>().erase("exclusion_mask");
  const int before = warnings();
  for (int i = FRAMES; i < 2 * FRAMES; ++i) {
    publish("depth", i, "32FC1", cv::Mat(188, 620, CV_32FC1, cv::Scalar(5000)));
    publish("image", i, "bgr8", Read(cv::format("%s/rgb/%06d.png", sequence.c_str(), i - FRAMES)));
  }
  const int told = warnings() - before;
  std::exit(good && told == 1 ? 0 : 1);
}
