// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace network {
namespace {

cv::Mat to_bgr(const cv::Mat& image) {
  if (image.channels() == 3) return image;
  cv::Mat bgr;
  cv::cvtColor(image, bgr, image.channels() == 1 ? cv::COLOR_GRAY2BGR : cv::COLOR_BGRA2BGR);
  return bgr;
}

/// The pixels of the input that show the image.
cv::Rect inside(const Placement& p) {
  return {static_cast<int>(p.offset_x), static_cast<int>(p.offset_y),
          static_cast<int>(std::lround(p.scale_x * p.image.width)),
          static_cast<int>(std::lround(p.scale_y * p.image.height))};
}

}  // namespace

cv::Rect2d Placement::to_image(double x1, double y1, double x2, double y2) const {
  const auto x = [&](double u) { return std::clamp((u - offset_x) / scale_x, 0.0, 1.0 * image.width); };
  const auto y = [&](double v) { return std::clamp((v - offset_y) / scale_y, 0.0, 1.0 * image.height); };
  return {x(x1), y(y1), x(x2) - x(x1), y(y2) - y(y1)};
}

Placement place(cv::Size image, cv::Size input, bool letterbox) {
  cv::Size size = input;
  if (letterbox) {
    const double scale = std::min(1.0 * input.width / image.width, 1.0 * input.height / image.height);
    size.width = std::clamp(static_cast<int>(std::lround(scale * image.width)), 1, input.width);
    size.height = std::clamp(static_cast<int>(std::lround(scale * image.height)), 1, input.height);
  }
  Placement placement{image, input};
  placement.scale_x = 1.0 * size.width / image.width;
  placement.scale_y = 1.0 * size.height / image.height;
  const cv::Point corner((input.width - size.width) / 2, (input.height - size.height) / 2);
  placement.offset_x = corner.x;
  placement.offset_y = corner.y;
  return placement;
}

Tensor make_input(const cv::Mat& image, const Placement& placement, const InputForm& form) {
  constexpr int border = 114;  // grey value around the image with which YOLO is trained
  const cv::Rect inner = inside(placement);
  cv::Mat canvas(placement.input, CV_8UC3, cv::Scalar::all(border));
  cv::Mat part = canvas(inner);
  cv::resize(to_bgr(image), part, inner.size(), 0, 0, cv::INTER_LINEAR);

  const cv::Mat blob = cv::dnn::blobFromImage(canvas, form.scale, {}, {}, form.rgb);
  const auto* first = blob.ptr<float>();
  return {"", {1, 3, canvas.rows, canvas.cols}, {first, first + blob.total()}};
}

}  // namespace network
