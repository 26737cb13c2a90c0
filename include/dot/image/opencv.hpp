// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/core/check.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "dot/image/view.hpp"

/// @file
/// The only conversions between cv::Mat and the library's views. No pixels are copied in either direction. The views
/// borrow the memory of the cv::Mat, the cv::Mat headers borrow that of the view. Neither may outlive its owner.

namespace dot {

/// OpenCV's type for pixels of `T`; 32-bit ids are CV_32SC1, since OpenCV has no unsigned 32-bit type.
template <typename T>
constexpr int opencv_type() {
  using Pixel = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Pixel, std::uint8_t>) {
    return CV_8UC1;
  } else if constexpr (std::is_same_v<Pixel, std::uint16_t>) {
    return CV_16UC1;
  } else if constexpr (std::is_same_v<Pixel, float>) {
    return CV_32FC1;
  } else {
    static_assert(std::is_same_v<Pixel, std::uint32_t> || std::is_same_v<Pixel, std::int32_t>,
                  "no OpenCV type for pixels of T, see dot/image/opencv.hpp");
    return CV_32SC1;
  }
}

/// A cv::Mat header over the memory of `view`; empty for an empty view.
///
/// OpenCV has no read-only header, so constness is cast away. The result for a view of const pixels is for input to
/// OpenCV and must not be written to.
/// @throws std::invalid_argument if the stride is less than a row, which cv::Mat cannot express.
template <typename T>
cv::Mat mat(ImageView<T> view) {
  if (view.empty()) return {};
  if (view.stride < view.width * static_cast<std::ptrdiff_t>(sizeof(T)))
    throw std::invalid_argument("view.stride must be at least one row of pixels");
  auto* data = const_cast<std::remove_const_t<T>*>(view.data);
  return cv::Mat(view.height, view.width, opencv_type<T>(), data, static_cast<std::size_t>(view.stride));
}

/// Result::labels and exclusion masks as a CV_8UC1 header, to be read only; `clone()` it to keep it.
inline cv::Mat to_mat(ImageView<const std::uint8_t> labels) { return mat(labels); }

/// Result::ids as a CV_32SC1 header, to be read only; `clone()` it to keep it.
inline cv::Mat to_mat(ImageView<const std::uint32_t> ids) { return mat(ids); }

namespace detail {

inline ImageRef image_ref(const cv::Mat& image, PixelFormat format, double depth_units_per_metre = 1000) {
  return {image.data, image.cols,           image.rows, static_cast<std::ptrdiff_t>(image.step[0]),
          format,     depth_units_per_metre};
}

[[noreturn]] inline void throw_unsupported(const char* what, const cv::Mat& image, const char* accepted) {
  throw std::invalid_argument(std::string(what) + " is " + (image.dims > 2 ? "not two-dimensional, " : "") +
                              std::string(cv::typeToString(image.type())) + ", must be " + accepted);
}

}  // namespace detail

/// A colour or grey image for Frame::image: CV_8UC1, CV_8UC3 (blue first) or CV_8UC4 (blue first, alpha ignored). An
/// empty cv::Mat gives an empty view, which `track` then reports as an error.
/// @throws std::invalid_argument for any other type.
inline ImageRef view(const cv::Mat& image) {
  if (image.empty()) return {};
  if (image.dims == 2 && image.type() == CV_8UC1) return detail::image_ref(image, PixelFormat::Grey8);
  if (image.dims == 2 && image.type() == CV_8UC3) return detail::image_ref(image, PixelFormat::Bgr8);
  if (image.dims == 2 && image.type() == CV_8UC4) return detail::image_ref(image, PixelFormat::Bgra8);
  detail::throw_unsupported("image", image, "CV_8UC1, CV_8UC3 or CV_8UC4");
}

/// Depth for Frame::depth: CV_32FC1 in metres, or CV_16UC1 with `units_per_metre` (1000 for RGB-D cameras, 256 for
/// KITTI files). An empty cv::Mat gives an empty view.
/// @throws std::invalid_argument for any other type.
inline ImageRef depth_view(const cv::Mat& depth, double units_per_metre = 1000) {
  if (depth.empty()) return {};
  if (depth.dims == 2 && depth.type() == CV_32FC1) return detail::image_ref(depth, PixelFormat::DepthF32);
  if (depth.dims == 2 && depth.type() == CV_16UC1)
    return detail::image_ref(depth, PixelFormat::DepthU16, units_per_metre);
  detail::throw_unsupported("depth", depth, "CV_32FC1 or CV_16UC1");
}

/// An instance id image for Masks::ids: CV_8UC1, CV_16UC1 or CV_32SC1. An empty cv::Mat gives an empty view.
/// @throws std::invalid_argument for any other type.
inline ImageRef id_view(const cv::Mat& ids) {
  if (ids.empty()) return {};
  if (ids.dims == 2 && ids.type() == CV_8UC1) return detail::image_ref(ids, PixelFormat::Id8);
  if (ids.dims == 2 && ids.type() == CV_16UC1) return detail::image_ref(ids, PixelFormat::Id16);
  if (ids.dims == 2 && ids.type() == CV_32SC1) return detail::image_ref(ids, PixelFormat::Id32);
  detail::throw_unsupported("ids", ids, "CV_8UC1, CV_16UC1 or CV_32SC1");
}

}  // namespace dot
