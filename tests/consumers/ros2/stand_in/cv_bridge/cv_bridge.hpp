// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <map>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "sensor_msgs/msg/image.hpp"

// What the guide uses of cv_bridge, written anew.
namespace cv_bridge {

inline int type_of(const std::string& encoding) {
  static const std::map<std::string, int> types = {{"mono8", CV_8UC1},  {"8UC1", CV_8UC1},   {"bgr8", CV_8UC3},
                                                   {"16UC1", CV_16UC1}, {"32FC1", CV_32FC1}, {"32SC1", CV_32SC1}};
  const auto found = types.find(encoding);
  if (found == types.end()) throw std::runtime_error("cv_bridge: encoding '" + encoding + "'");
  return found->second;
}

class CvImage {
 public:
  CvImage() = default;
  CvImage(const std_msgs::msg::Header& h, const std::string& e, const cv::Mat& i) : header(h), encoding(e), image(i) {}

  sensor_msgs::msg::Image::SharedPtr toImageMsg() const {
    auto message = std::make_shared<sensor_msgs::msg::Image>();
    message->header = header;
    message->encoding = encoding;
    message->height = static_cast<std::uint32_t>(image.rows);
    message->width = static_cast<std::uint32_t>(image.cols);
    message->step = static_cast<std::uint32_t>(image.cols * image.elemSize());
    for (int y = 0; y < image.rows; ++y)
      message->data.insert(message->data.end(), image.ptr(y), image.ptr(y) + message->step);
    return message;
  }

  std_msgs::msg::Header header;
  std::string encoding;
  cv::Mat image;
};
using CvImageConstPtr = std::shared_ptr<const CvImage>;

/// The image of a message, which it may share memory with; converted where another encoding is asked for.
inline CvImageConstPtr toCvShare(const sensor_msgs::msg::Image::ConstSharedPtr& message,
                                 const std::string& encoding = "") {
  const cv::Mat shared(static_cast<int>(message->height), static_cast<int>(message->width), type_of(message->encoding),
                       const_cast<std::uint8_t*>(message->data.data()), message->step);
  auto out = std::make_shared<CvImage>(message->header, message->encoding, shared);
  if (encoding.empty() || encoding == message->encoding) return out;
  if (encoding != "mono8" || shared.type() != CV_8UC3) throw std::runtime_error("cv_bridge: no such conversion");
  cv::cvtColor(shared, out->image, cv::COLOR_BGR2GRAY);
  out->encoding = encoding;
  return out;
}

}  // namespace cv_bridge
