// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

/// @file
/// The views that the library's interfaces use instead of an image class: a pointer, a size and a stride.

namespace dot {

/// A view of rows of `T`, `stride` bytes apart; it owns nothing. `T` may be const.
template <typename T>
struct ImageView {
  T* data = nullptr;          ///< top left pixel
  int width = 0;              ///< pixels
  int height = 0;             ///< pixels
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next

  /// The first pixel of row y.
  T* row(int y) const {
    using Byte = std::conditional_t<std::is_const_v<T>, const unsigned char, unsigned char>;
    return reinterpret_cast<T*>(reinterpret_cast<Byte*>(data) + y * stride);
  }
  /// The pixel in column x, row y, which must be inside.
  T& operator()(int x, int y) const { return row(y)[x]; }
  /// Whether it has no pixels.
  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
  /// Whether column x, row y is inside.
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  /// The same pixels, read only.
  operator ImageView<const T>() const { return {data, width, height, stride}; }
};

/// The format of the pixels of an ImageRef.
enum class PixelFormat : std::uint8_t {
  Grey8,     ///< one byte a pixel
  Bgr8,      ///< three bytes a pixel, blue first (OpenCV's order)
  Rgb8,      ///< three bytes a pixel, red first
  Bgra8,     ///< four bytes a pixel, blue first, alpha ignored
  DepthF32,  ///< float, metres
  DepthU16,  ///< 16 bit, metres = value / depth_units_per_metre; 65535 = no measurement
  Id8,       ///< 8-bit instance ids, 0 = none
  Id16,      ///< 16-bit instance ids, 0 = none
  Id32       ///< 32-bit instance ids, 0 = none
};

/// An image of the caller, in one of the formats that a Frame accepts. Borrowed for the duration of one call.
struct ImageRef {
  const void* data = nullptr;               ///< top left pixel, aligned to its number type
  int width = 0;                            ///< pixels
  int height = 0;                           ///< pixels
  std::ptrdiff_t stride = 0;                ///< bytes from one row to the next
  PixelFormat format = PixelFormat::Grey8;  ///< what the pixels mean
  double depth_units_per_metre = 1000;      ///< DepthU16 only: 1000 for RGB-D cameras, 256 for KITTI files

  /// Whether it has no pixels.
  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
};

/// Bytes that one pixel of `format` takes.
constexpr int bytes_per_pixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::Grey8:
    case PixelFormat::Id8: return 1;
    case PixelFormat::DepthU16:
    case PixelFormat::Id16: return 2;
    case PixelFormat::Bgr8:
    case PixelFormat::Rgb8: return 3;
    case PixelFormat::Bgra8:
    case PixelFormat::DepthF32:
    case PixelFormat::Id32: return 4;
  }
  return 0;
}

/// Bytes of the number type of a pixel of `format`. Data and stride are aligned to it.
constexpr int bytes_per_element(PixelFormat format) {
  const bool bytes = format == PixelFormat::Bgr8 || format == PixelFormat::Rgb8 || format == PixelFormat::Bgra8;
  return bytes ? 1 : bytes_per_pixel(format);
}

}  // namespace dot
