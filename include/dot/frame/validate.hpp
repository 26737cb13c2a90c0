// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

#include "dot/abi.hpp"
#include "dot/frame/field_name.hpp"
#include "dot/frame/frame.hpp"

DOT_BEGIN_NAMESPACE

/// Throws std::invalid_argument("field: what is wrong").
[[noreturn]] inline void bad_field(const std::string& field, const std::string& what) {
  throw std::invalid_argument(field + ": " + what);
}

/// Formats a number for a message, without trailing zeros, and with a point in any locale.
inline std::string to_text(double value, int digits = 6) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  return text.str();
}

/// Formats a time in seconds for a message: a Unix clock with its microseconds.
inline std::string time_text(double seconds) { return to_text(seconds, 16); }

/// Whether an image given as three-byte pixels, with a stride of four bytes per pixel, looks like four-byte pixels.
/// Then a byte is more similar to the one four positions later, which is of the neighbouring pixel, than to the one
/// three positions later, which may be alpha. Rows may have such a stride for other reasons, as in a crop of a wider
/// image, and black, white or noise may look the same at any distance.
inline bool looks_like_four_channels(const ImageRef& image) {
  if (std::abs(image.stride) != std::ptrdiff_t{4} * image.width) return false;
  constexpr int rows = 32;          // that are tested
  constexpr double kClearly = 0.8;  // of noise both sums are the same; with alpha this is about .6
  std::int64_t three_on = 0, four_on = 0;
  for (int i = 0; i < std::min(rows, image.height); ++i) {
    const int y = static_cast<int>(std::int64_t{i} * image.height / std::min(rows, image.height));
    const auto* row = static_cast<const std::uint8_t*>(image.data) + y * image.stride;
    for (int x = 0; x + 4 < 3 * image.width; ++x) {
      three_on += std::abs(row[x] - row[x + 3]);
      four_on += std::abs(row[x] - row[x + 4]);
    }
  }
  return static_cast<double>(four_on) < kClearly * static_cast<double>(three_on);
}

/// Checks a view: present, one of `formats`, aligned, rows that fit the stride, and of the size width x height (0:
/// any).
inline void validate(const FieldName& field, const ImageRef& image, std::initializer_list<PixelFormat> formats,
                     int width, int height) {
  if (image.data == nullptr) bad_field(field, "is empty (null data)");
  if (image.width <= 0 || image.height <= 0) bad_field(field, "is empty (width or height is 0)");
  bool known = false;
  for (const PixelFormat format : formats) known = known || format == image.format;
  if (!known) bad_field(field, "has a pixel format that is not accepted here");
  if (std::abs(image.stride) < static_cast<std::ptrdiff_t>(image.width) * bytes_per_pixel(image.format))
    bad_field(field, "stride is shorter than a row");
  const int element = bytes_per_element(image.format);
  if (image.stride % element != 0) bad_field(field, "stride is not a multiple of its element's size");
  if (reinterpret_cast<std::uintptr_t>(image.data) % static_cast<std::uintptr_t>(element) != 0)
    bad_field(field, "data is not aligned to its element's size");
  if (width > 0 && (image.width != width || image.height != height))
    bad_field(field, "is " + std::to_string(image.width) + "x" + std::to_string(image.height) + ", expected " +
                         std::to_string(width) + "x" + std::to_string(height));
  if (image.format == PixelFormat::DepthU16 &&
      !(image.depth_units_per_metre >= 1e-3 && image.depth_units_per_metre <= 1e7))
    bad_field(field, "depth_units_per_metre must be 1e-3 to 1e7");
  if (bytes_per_pixel(image.format) == 3 && looks_like_four_channels(image))
    bad_field(field, "has three bytes a pixel, but its rows are four bytes a pixel apart: is it BGRA?");
}

/// @throws std::invalid_argument naming the field of the masks of a frame of this size.
inline void validate(const char* name, const Masks& masks, int width, int height) {
  if (masks.ids.data != nullptr)
    validate({name, ".ids"}, masks.ids, {PixelFormat::Id8, PixelFormat::Id16, PixelFormat::Id32}, width, height);
  for (std::size_t i = 0; i < masks.instances.size; ++i) {
    const auto index = static_cast<std::ptrdiff_t>(i);
    const Instance& instance = masks.instances[i];
    if (instance.mask.data != nullptr)
      validate({name, ".mask", index}, instance.mask, {PixelFormat::Grey8, PixelFormat::Id8}, 0, 0);
    else if (masks.ids.data == nullptr)
      bad_field(FieldName(name, "", index), "has no mask of its own and there is no id image");
  }
}

/// @throws std::invalid_argument naming the field unless T, row-major 3x4, is a rotation and a translation that a
/// camera can make between two frames.
inline void validate(const FieldName& field, const std::array<double, 12>& T) {
  for (const double v : T)
    if (!std::isfinite(v)) bad_field(field, "must be finite");
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = r; c < 3; ++c) {
      double dot = 0;
      for (std::size_t k = 0; k < 3; ++k) dot += T[4 * r + k] * T[4 * c + k];
      if (!(std::abs(dot - (r == c)) <= 1e-3)) bad_field(field, "is not a rotation");
    }
  const double det =
      T[0] * (T[5] * T[10] - T[6] * T[9]) - T[1] * (T[4] * T[10] - T[6] * T[8]) + T[2] * (T[4] * T[9] - T[5] * T[8]);
  if (det < 0) bad_field(field, "is a mirror image, not a rotation");
  constexpr double farthest = 1e4;
  for (const std::size_t i : {std::size_t{3}, std::size_t{7}, std::size_t{11}})
    if (std::abs(T[i]) > farthest)
      bad_field(field, "moves by more than " + to_text(farthest) + " m between two frames");
}

/// @throws std::invalid_argument naming the field unless C, row-major 6x6 of a twist [translation; rotation], is a
/// covariance: symmetric, positive semi-definite up to rounding, and small enough for a motion that is known at all.
inline void validate_covariance(const FieldName& field, const std::array<double, 36>& C) {
  constexpr double largest_translation = 1e6, largest_rotation = 10;  // 1 km and pi, squared
  std::array<double, 6> sigma{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j)
      if (!std::isfinite(C[6 * i + j])) bad_field(field, "must be finite");
    const double variance = C[7 * i], largest = i < 3 ? largest_translation : largest_rotation;
    if (!(variance >= 0 && variance <= largest))
      bad_field(field, "element (" + std::to_string(i) + ", " + std::to_string(i) + ") is " + to_text(variance) +
                           ", must be 0 to " + to_text(largest) + "; give no motion where none is known");
    sigma[i] = std::sqrt(variance);
  }
  // Cholesky decomposition of the correlations. The tolerance `rounding` is added to the pivots.
  constexpr double rounding = 1e-5;
  std::array<double, 36> L{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double scale = sigma[i] * sigma[j];
      if (std::abs(C[6 * i + j] - C[6 * j + i]) > rounding * scale) bad_field(field, "must be symmetric");
      double rest = scale > 0 ? C[6 * i + j] / scale : 0;
      if (!(scale > 0) && C[6 * i + j] != 0) bad_field(field, "must be positive semi-definite");
      for (std::size_t k = 0; k < j; ++k) rest -= L[6 * i + k] * L[6 * j + k];
      if (i != j) {
        L[6 * i + j] = rest / L[7 * j];
      } else {
        if (scale > 0 && rest < -rounding) bad_field(field, "must be positive semi-definite");
        L[7 * i] = std::sqrt(std::max(rest, 0.0) + rounding);
      }
    }
}

/// @throws std::invalid_argument naming the field of the frame; width and height are the camera's.
inline void validate(const Frame& frame, int width, int height, bool has_previous, double previous_timestamp) {
  validate("frame.image", frame.image, {PixelFormat::Grey8, PixelFormat::Bgr8, PixelFormat::Rgb8, PixelFormat::Bgra8},
           width, height);
  validate("frame.depth", frame.depth, {PixelFormat::DepthF32, PixelFormat::DepthU16}, width, height);
  if (!std::isfinite(frame.timestamp)) bad_field("frame.timestamp", "must be finite");
  constexpr double shortest = 1e-7;  // seconds; velocities are finite with it
  if (has_previous && !(frame.timestamp - previous_timestamp >= shortest))
    bad_field("frame.timestamp", "is " + time_text(frame.timestamp) + " s, must be greater than the last frame's, " +
                                     time_text(previous_timestamp) +
                                     " s, by 1e-7 s at least; where time starts again, call reset() first");
  if (frame.masks) validate("frame.masks", *frame.masks, width, height);
  if (frame.camera_prior) validate("frame.camera_prior", *frame.camera_prior);
  if (frame.camera_motion) {
    validate("frame.camera_motion.T_cur_prev", frame.camera_motion->T_cur_prev);
    validate_covariance("frame.camera_motion.covariance", frame.camera_motion->covariance);
  }
}

DOT_END_NAMESPACE
