// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "dot/frame/frame.hpp"
#include "structs.hpp"

/// @file
/// Converts a frame of a C caller to one of the C++ interface. Errors name its fields.

namespace dot_c {

/// One line of the table of formats that a caller may use.
struct Format {
  std::uint32_t value;
  dot::PixelFormat format;
  const char* name;
};

constexpr Format formats[] = {
    {DOT_FORMAT_GREY8, dot::PixelFormat::Grey8, "GREY8"},
    {DOT_FORMAT_BGR8, dot::PixelFormat::Bgr8, "BGR8"},
    {DOT_FORMAT_RGB8, dot::PixelFormat::Rgb8, "RGB8"},
    {DOT_FORMAT_BGRA8, dot::PixelFormat::Bgra8, "BGRA8"},
    {DOT_FORMAT_DEPTH_F32, dot::PixelFormat::DepthF32, "DEPTH_F32"},
    {DOT_FORMAT_DEPTH_U16, dot::PixelFormat::DepthU16, "DEPTH_U16"},
    {DOT_FORMAT_ID8, dot::PixelFormat::Id8, "ID8"},
    {DOT_FORMAT_ID16, dot::PixelFormat::Id16, "ID16"},
    {DOT_FORMAT_ID32, dot::PixelFormat::Id32, "ID32"},
};

inline const Format& find_format(std::uint32_t value, std::initializer_list<std::uint32_t> allowed,
                                 const FieldName& name) {
  const auto allows = [&allowed](const Format& format) {
    return std::find(allowed.begin(), allowed.end(), format.value) != allowed.end();
  };
  for (const Format& format : formats)
    if (format.value == value && allows(format)) return format;
  std::string list;
  for (const Format& format : formats)
    if (allows(format)) list += std::string(list.empty() ? "" : ", ") + "DOT_FORMAT_" + format.name;
  invalid(name + ".format is " + std::to_string(value) + ", must be one of " + list);
}

/// Checks all that could cause reads outside the caller's memory, and all that exists only in C. dot::Tracker checks
/// the rest.
inline dot::ImageRef read_image(const dot_image* in, std::initializer_list<std::uint32_t> allowed,
                                const FieldName& name) {
  const dot_image image = read(in, name);
  const Format& format = find_format(image.format, allowed, name);
  if (image.data == nullptr) invalid(name + ".data is NULL");
  if (image.width <= 0) invalid(name + ".width is " + std::to_string(image.width) + ", must be > 0");
  if (image.height <= 0) invalid(name + ".height is " + std::to_string(image.height) + ", must be > 0");
  const std::int64_t row = static_cast<std::int64_t>(image.width) * dot::bytes_per_pixel(format.format);
  if (image.stride_bytes < row || image.stride_bytes > std::numeric_limits<std::ptrdiff_t>::max() / image.height)
    invalid(name + ".stride_bytes is " + std::to_string(image.stride_bytes) + ", a row takes " + std::to_string(row));
  const int element = dot::bytes_per_element(format.format);
  if (image.stride_bytes % element != 0) invalid(name + ".stride_bytes is not a multiple of its element's size");
  if (reinterpret_cast<std::uintptr_t>(image.data) % static_cast<std::uintptr_t>(element) != 0)
    invalid(name + ".data is not aligned to its element's size");
  dot::ImageRef ref;
  ref.data = image.data;
  ref.width = image.width;
  ref.height = image.height;
  ref.stride = static_cast<std::ptrdiff_t>(image.stride_bytes);
  ref.format = format.format;
  ref.depth_units_per_metre = image.depth_units_per_metre;
  return ref;
}

/// @param masks the name of the masks that contain the instance.
inline dot::Instance read_instance(const dot_instance* in, bool has_ids, const char* masks, std::ptrdiff_t index) {
  const FieldName name(masks, "", index);
  const dot_instance instance = read(in, name);
  check_flags(instance.flags, DOT_INSTANCE_ALWAYS_DYNAMIC, name);
  check_reserved(instance.reserved, name);
  if (instance.mask == nullptr && !has_ids) invalid(name + ".mask is NULL and " + masks + ".ids too");
  dot::Instance out;
  out.id = instance.id;
  if (instance.mask != nullptr)
    out.mask = read_image(instance.mask, {DOT_FORMAT_GREY8, DOT_FORMAT_ID8}, {masks, ".mask", index});
  out.x = instance.x;
  out.y = instance.y;
  out.class_id = instance.class_id;
  out.score = instance.score;
  out.always_dynamic = (instance.flags & DOT_INSTANCE_ALWAYS_DYNAMIC) != 0;
  return out;
}

inline dot::Masks read_masks(const dot_masks* in, const char* name, std::vector<dot::Instance>& instances) {
  const dot_masks masks = read(in, name);
  dot::Masks out;
  if (masks.ids != nullptr)
    out.ids = read_image(masks.ids, {DOT_FORMAT_ID8, DOT_FORMAT_ID16, DOT_FORMAT_ID32}, {name, ".ids"});
  instances.clear();
  if (masks.instance_count > 0) {
    if (masks.instances == nullptr) invalid(FieldName(name) + ".instances is NULL, instance_count is not 0");
    // The caller's elements may be shorter than ours, so the step is their own size.
    const std::uint32_t step = masks.instances->struct_size;
    const auto* bytes = reinterpret_cast<const unsigned char*>(masks.instances);
    for (std::size_t i = 0; i < masks.instance_count; ++i) {
      const auto* instance = reinterpret_cast<const dot_instance*>(bytes + i * step);
      const auto index = static_cast<std::ptrdiff_t>(i);
      instances.push_back(read_instance(instance, masks.ids != nullptr, name, index));
      if (instance->struct_size != step)
        invalid(FieldName(name, "", index) + ".struct_size differs from that of element 0");
    }
  }
  out.instances = {instances.data(), instances.size()};
  return out;
}

inline dot::CameraMotion read_motion(const dot_camera_motion* in) {
  const dot_camera_motion motion = read(in, "frame.camera_motion");
  check_reserved(motion.reserved, "frame.camera_motion");
  dot::CameraMotion out;
  std::copy_n(motion.T_cur_prev, 12, out.T_cur_prev.begin());
  std::copy_n(motion.covariance, 36, out.covariance.begin());
  return out;
}

inline dot::Frame read_frame(const dot_frame* in, std::vector<dot::Instance>& instances) {
  const dot_frame frame = read(in, "frame");
  check_reserved(frame.reserved, "frame");
  dot::Frame out;
  out.id = frame.id;
  out.timestamp = frame.timestamp;
  out.image =
      read_image(frame.image, {DOT_FORMAT_GREY8, DOT_FORMAT_BGR8, DOT_FORMAT_RGB8, DOT_FORMAT_BGRA8}, "frame.image");
  out.depth = read_image(frame.depth, {DOT_FORMAT_DEPTH_F32, DOT_FORMAT_DEPTH_U16}, "frame.depth");
  if (frame.masks != nullptr) out.masks = read_masks(frame.masks, "frame.masks", instances);
  if (frame.camera_motion != nullptr) out.camera_motion = read_motion(frame.camera_motion);
  if (frame.camera_prior != nullptr) std::copy_n(frame.camera_prior, 12, out.camera_prior.emplace().begin());
  return out;
}

}  // namespace dot_c
