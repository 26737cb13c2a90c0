// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "dot/abi.hpp"
#include "dot/pipeline/field_name.hpp"
#include "dot/pipeline/frame.hpp"
#include "dot/pipeline/options.hpp"

DOT_BEGIN_NAMESPACE

/// Throws std::invalid_argument("field: what is wrong").
[[noreturn]] inline void bad_field(const std::string& field, const std::string& what) {
  throw std::invalid_argument(field + ": " + what);
}

/// @throws std::invalid_argument naming the setting that is not finite or out of range.
inline void validate(const Options& options) {
  for_each_option(options, [](const char* name, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      if (!std::isfinite(value)) bad_field(std::string("options.") + name, "must be finite");
  });
  const auto positive = [](const char* name, double value) {
    if (!(value > 0)) bad_field(std::string("options.") + name, "must be > 0");
  };
  positive("selection.background_points", options.selection.background_points);
  positive("selection.object_points", options.selection.object_points);
  positive("selection.max_depth", options.selection.max_depth);
  positive("align.max_levels", options.align.max_levels);
  positive("align.max_iterations", options.align.max_iterations);
  positive("align.huber", options.align.huber);
  positive("align.tukey", options.align.tukey);
  positive("align.min_intensity_sigma", options.align.min_intensity_sigma);
  positive("depth_noise.stereo_sigma_px", options.depth_noise.stereo_sigma_px);
  positive("depth_noise.unknown_relative", options.depth_noise.unknown_relative);
  positive("motion_prior.rotation", options.motion_prior.rotation);
  positive("motion_prior.velocity", options.motion_prior.velocity);
  positive("motion_prior.gain", options.motion_prior.gain);
  positive("motion_prior.offset", options.motion_prior.offset);
  positive("object.max_acceleration", options.object.max_acceleration);
  positive("velocity.v0", options.velocity.v0);
  positive("velocity.prior_speed", options.velocity.prior_speed);
  positive("max_gap", options.max_gap);
  for_each_option(options, [](const char* name, const auto& value) {
    const std::string_view setting = name;  // an entropy, in nats, and a direction may be negative
    if (static_cast<double>(value) < 0 && setting.rfind("entropy.", 0) != 0 &&
        setting.rfind("motion_prior.up_", 0) != 0)
      bad_field(std::string("options.") + name, "must be >= 0");
  });
  if (options.threads < 1 || options.threads > 256) bad_field("options.threads", "must be 1 to 256");
  if (options.selection.window_radius < 1 || options.selection.window_radius > 50)
    bad_field("options.selection.window_radius", "must be 1 to 50 pixels");
  if (!(options.velocity.decide > 0.5 && options.velocity.decide < 1))
    bad_field("options.velocity.decide", "must be between 0.5 and 1");
  if (!(options.velocity.keep >= 0.5 && options.velocity.keep <= options.velocity.decide))
    bad_field("options.velocity.keep", "must be between 0.5 and velocity.decide");
}

/// Checks a view: present, one of `formats`, rows that fit the stride, and of the size width x height (0: any).
inline void validate(const FieldName& field, const ImageRef& image, std::initializer_list<PixelFormat> formats,
                     int width, int height) {
  if (image.data == nullptr) bad_field(field, "is empty (null data)");
  if (image.width <= 0 || image.height <= 0) bad_field(field, "is empty (width or height is 0)");
  bool known = false;
  for (const PixelFormat format : formats) known = known || format == image.format;
  if (!known) bad_field(field, "has a pixel format that is not accepted here");
  if (std::abs(image.stride) < static_cast<std::ptrdiff_t>(image.width) * bytes_per_pixel(image.format))
    bad_field(field, "stride is shorter than a row");
  if (width > 0 && (image.width != width || image.height != height))
    bad_field(field, "is " + std::to_string(image.width) + "x" + std::to_string(image.height) + ", expected " +
                         std::to_string(width) + "x" + std::to_string(height));
  if (image.format == PixelFormat::DepthU16 &&
      !(std::isfinite(image.depth_units_per_metre) && image.depth_units_per_metre > 0))
    bad_field(field, "depth_units_per_metre must be finite and > 0");
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

/// @throws std::invalid_argument naming the field unless T, row-major 3x4, is a rotation and a translation.
inline void validate(const FieldName& field, const std::array<double, 12>& T) {
  for (const double v : T)
    if (!std::isfinite(v)) bad_field(field, "must be finite");
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = r; c < 3; ++c) {
      double dot = 0;
      for (std::size_t k = 0; k < 3; ++k) dot += T[4 * r + k] * T[4 * c + k];
      if (std::abs(dot - (r == c)) > 1e-3) bad_field(field, "is not a rotation");
    }
  const double det =
      T[0] * (T[5] * T[10] - T[6] * T[9]) - T[1] * (T[4] * T[10] - T[6] * T[8]) + T[2] * (T[4] * T[9] - T[5] * T[8]);
  if (det < 0) bad_field(field, "is a mirror image, not a rotation");
}

/// @throws std::invalid_argument naming the field of the frame; width and height are the camera's.
inline void validate(const Frame& frame, int width, int height, bool has_previous, double previous_timestamp) {
  validate("frame.image", frame.image, {PixelFormat::Grey8, PixelFormat::Bgr8, PixelFormat::Rgb8, PixelFormat::Bgra8},
           width, height);
  validate("frame.depth", frame.depth, {PixelFormat::DepthF32, PixelFormat::DepthU16}, width, height);
  if (!std::isfinite(frame.timestamp)) bad_field("frame.timestamp", "must be finite");
  if (has_previous && frame.timestamp <= previous_timestamp)
    bad_field("frame.timestamp",
              "must be greater than the last frame's (" + std::to_string(previous_timestamp) + " s)");
  if (frame.masks) validate("frame.masks", *frame.masks, width, height);
  if (frame.camera_prior) validate("frame.camera_prior", *frame.camera_prior);
  if (frame.camera_motion) {
    validate("frame.camera_motion.T_cur_prev", frame.camera_motion->T_cur_prev);
    for (const double v : frame.camera_motion->covariance)
      if (!std::isfinite(v)) bad_field("frame.camera_motion.covariance", "must be finite");
  }
}

DOT_END_NAMESPACE
