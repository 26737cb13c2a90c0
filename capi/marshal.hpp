// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "dot/dot.h"
#include "dot/pipeline/exclusion.hpp"
#include "dot/pipeline/field_name.hpp"
#include "dot/tracker.hpp"

/// @file
/// Between the structs of dot.h and those of the C++ interface: sizes checked, fields named in errors.

namespace dot_c {

using dot::FieldName;

[[noreturn]] inline void invalid(const std::string& message) { throw std::invalid_argument(message); }

/// Sizes of a struct in the forms that were published. When a struct grows, the offset of its first new field goes
/// here: any size between would cut a field in half.
template <typename T>
constexpr std::array<std::uint32_t, 1> published_sizes{sizeof(T)};
template <>
inline constexpr std::array<std::uint32_t, 3> published_sizes<dot_camera_result>{
    offsetof(dot_camera_result, masked_share), offsetof(dot_camera_result, small_instances), sizeof(dot_camera_result)};
template <>
inline constexpr std::array<std::uint32_t, 2> published_sizes<dot_frame>{offsetof(dot_frame, camera_prior),
                                                                         sizeof(dot_frame)};

template <typename T>
void check_size(std::uint32_t size, const FieldName& name) {
  for (const std::uint32_t published : published_sizes<T>)
    if (size == published) return;
  invalid(name + ".struct_size is " + std::to_string(size) + ", must be sizeof, " + std::to_string(sizeof(T)) +
          (size > sizeof(T) ? " in this library: is the header newer?" : ""));
}

/// Copies a struct of the caller; fields that its header did not have are zero.
template <typename T>
T read(const T* in, const FieldName& name) {
  static_assert(std::is_trivial_v<T>);
  if (in == nullptr) invalid(name + " is NULL");
  check_size<T>(in->struct_size, name);
  T out{};
  std::memcpy(&out, in, in->struct_size);
  return out;
}

/// Fills in a struct of the caller as far as its header goes.
template <typename T>
void write(const T& value, T* out, const char* name) {
  if (out == nullptr) invalid(std::string(name) + " is NULL");
  check_size<T>(out->struct_size, name);
  const std::uint32_t size = out->struct_size;
  std::memcpy(out, &value, size);
  out->struct_size = size;
}

inline void check_reserved(std::uint32_t value, const FieldName& name) {
  if (value != 0) invalid(name + ".reserved is " + std::to_string(value) + ", must be 0");
}

inline void check_flags(std::uint32_t flags, std::uint32_t known, const FieldName& name) {
  if ((flags & ~known) != 0) invalid(name + ".flags is " + std::to_string(flags) + ", has unknown bits");
}

/// One line of the table of formats that a caller may hand in.
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

/// Checks what could make us read outside the caller's memory, and what only exists in C; dot::Tracker checks the rest.
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

/// @param masks the name of what holds the instance.
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
    // The caller's elements may be shorter than ours: their own size is the step.
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

/// Sets the option that a dot_setting names.
struct Setter {
  const dot_setting& setting;
  std::string field;
  bool found = false;

  void operator()(const char* name, double& value) {
    if (matches(name)) value = setting.value;
  }
  void operator()(const char* name, int& value) {
    if (!matches(name)) return;
    if (setting.value != std::floor(setting.value) || std::abs(setting.value) > std::numeric_limits<int>::max())
      invalid(field + ".value (" + name + ") must be a whole number");
    value = static_cast<int>(setting.value);
  }
  void operator()(const char* name, bool& value) {
    if (!matches(name)) return;
    if (setting.value != 0 && setting.value != 1) invalid(field + ".value (" + name + ") must be 0 or 1");
    value = setting.value == 1;
  }

 private:
  bool matches(const char* name) {
    const bool match = std::strcmp(name, setting.name) == 0;
    found = found || match;
    return match;
  }
};

inline dot::Options read_options(const dot_options* in) {
  dot::Options out;
  if (in == nullptr) return out;
  const dot_options options = read(in, "options");
  switch (options.classifier) {
    case DOT_CLASSIFIER_VELOCITY: out.classifier = dot::ClassifierKind::Velocity; break;
    case DOT_CLASSIFIER_ENTROPY: out.classifier = dot::ClassifierKind::Entropy; break;
    case DOT_CLASSIFIER_ENTROPY_LITERAL: out.classifier = dot::ClassifierKind::EntropyLiteral; break;
    default: invalid("options.classifier is " + std::to_string(options.classifier) + ", unknown");
  }
  switch (options.depth_source) {
    case DOT_DEPTH_UNKNOWN: out.depth_noise.source = dot::DepthSource::Unknown; break;
    case DOT_DEPTH_STEREO: out.depth_noise.source = dot::DepthSource::Stereo; break;
    case DOT_DEPTH_RGBD: out.depth_noise.source = dot::DepthSource::Rgbd; break;
    case DOT_DEPTH_LIDAR: out.depth_noise.source = dot::DepthSource::Lidar; break;
    default: invalid("options.depth_source is " + std::to_string(options.depth_source) + ", unknown");
  }
  if (options.background_points <= 0) invalid("options.background_points must be > 0");
  if (options.object_points <= 0) invalid("options.object_points must be > 0");
  if (!(options.v0 > 0) || !std::isfinite(options.v0)) invalid("options.v0 must be finite and > 0");
  if (!(options.stereo_sigma_px > 0) || !std::isfinite(options.stereo_sigma_px))
    invalid("options.stereo_sigma_px must be finite and > 0");
  out.selection.background_points = options.background_points;
  out.selection.object_points = options.object_points;
  out.velocity.v0 = options.v0;
  out.depth_noise.stereo_sigma_px = options.stereo_sigma_px;

  if (options.setting_count > 0 && options.settings == nullptr)
    invalid("options.settings is NULL, setting_count is not 0");
  for (std::uint32_t i = 0; i < options.setting_count; ++i) {
    Setter setter{options.settings[i], "options.settings[" + std::to_string(i) + "]"};
    if (setter.setting.name == nullptr) invalid(setter.field + ".name is NULL");
    if (!std::isfinite(setter.setting.value))
      invalid(setter.field + ".value (" + setter.setting.name + ") must be finite");
    dot::for_each_option(out, setter);
    if (!setter.found) invalid(setter.field + ".name is unknown: " + setter.setting.name);
  }
  return out;
}

inline dot::Intrinsics read_camera(const dot_camera* in) {
  const dot_camera camera = read(in, "camera");
  check_reserved(camera.reserved, "camera");
  dot::Intrinsics out;
  out.fx = camera.fx;
  out.fy = camera.fy;
  out.cx = camera.cx;
  out.cy = camera.cy;
  out.width = camera.width;
  out.height = camera.height;
  out.baseline = camera.baseline;
  return out;
}

// The _INIT macros repeat the defaults of the C++ structs, which are their home.
constexpr dot_options default_options = DOT_OPTIONS_INIT;
static_assert(default_options.background_points == dot::SelectionSettings{}.background_points);
static_assert(default_options.object_points == dot::SelectionSettings{}.object_points);
static_assert(default_options.v0 == dot::VelocitySettings{}.v0);
static_assert(default_options.stereo_sigma_px == dot::DepthNoiseSettings{}.stereo_sigma_px);
constexpr dot_exclusion_policy default_policy = DOT_EXCLUSION_POLICY_INIT;
static_assert(((default_policy.flags & DOT_EXCLUDE_NOT_OBSERVABLE) != 0) ==
              dot::ExclusionPolicy{}.exclude_not_observable);
static_assert(((default_policy.flags & DOT_EXCLUDE_STATIC) != 0) == dot::ExclusionPolicy{}.exclude_static);
static_assert(default_policy.dilation == dot::ExclusionPolicy{}.dilation);

inline dot::ExclusionPolicy read_policy(const dot_exclusion_policy* in) {
  dot::ExclusionPolicy out;
  if (in == nullptr) return out;
  const dot_exclusion_policy policy = read(in, "policy");
  check_flags(policy.flags, DOT_EXCLUDE_NOT_OBSERVABLE | DOT_EXCLUDE_STATIC | DOT_EXCLUDE_INVERTED, "policy");
  check_reserved(policy.reserved, "policy");
  if (policy.dilation < 0) invalid("policy.dilation is " + std::to_string(policy.dilation) + ", must be >= 0");
  out.exclude_not_observable = (policy.flags & DOT_EXCLUDE_NOT_OBSERVABLE) != 0;
  out.exclude_static = (policy.flags & DOT_EXCLUDE_STATIC) != 0;
  out.dilation = policy.dilation;
  return out;
}

constexpr std::uint32_t to_c(dot::State state) { return static_cast<std::uint32_t>(state); }
constexpr std::uint32_t to_c(dot::Reason reason) { return static_cast<std::uint32_t>(reason); }
constexpr std::uint32_t to_c(dot::CameraStatus status) { return static_cast<std::uint32_t>(status); }

// The C values are pinned; these stop a change of the C++ ones from changing them.
static_assert(to_c(dot::State::Background) == DOT_STATE_BACKGROUND);
static_assert(to_c(dot::State::Static) == DOT_STATE_STATIC);
static_assert(to_c(dot::State::Moving) == DOT_STATE_MOVING);
static_assert(to_c(dot::State::NotObservable) == DOT_STATE_NOT_OBSERVABLE);
static_assert(to_c(dot::Reason::None) == DOT_REASON_NONE);
static_assert(to_c(dot::Reason::New) == DOT_REASON_NEW);
static_assert(to_c(dot::Reason::NoReference) == DOT_REASON_NO_REFERENCE);
static_assert(to_c(dot::Reason::TooFewPixels) == DOT_REASON_TOO_FEW_PIXELS);
static_assert(to_c(dot::Reason::TooLittleDepth) == DOT_REASON_TOO_LITTLE_DEPTH);
static_assert(to_c(dot::Reason::TooLittleTexture) == DOT_REASON_TOO_LITTLE_TEXTURE);
static_assert(to_c(dot::Reason::LeavesImage) == DOT_REASON_LEAVES_IMAGE);
static_assert(to_c(dot::Reason::Occluded) == DOT_REASON_OCCLUDED);
static_assert(to_c(dot::Reason::Diverged) == DOT_REASON_DIVERGED);
static_assert(to_c(dot::Reason::LowCorrelation) == DOT_REASON_LOW_CORRELATION);
static_assert(to_c(dot::Reason::TooFewInliers) == DOT_REASON_TOO_FEW_INLIERS);
static_assert(to_c(dot::Reason::DepthDisagrees) == DOT_REASON_DEPTH_DISAGREES);
static_assert(to_c(dot::Reason::Implausible) == DOT_REASON_IMPLAUSIBLE);
static_assert(to_c(dot::Reason::Hidden) == DOT_REASON_HIDDEN);
static_assert(to_c(dot::Reason::CameraLost) == DOT_REASON_CAMERA_LOST);
static_assert(to_c(dot::Reason::Lost) == DOT_REASON_LOST);
static_assert(to_c(dot::Reason::TooManyObjects) == DOT_REASON_TOO_MANY_OBJECTS);
static_assert(to_c(dot::CameraStatus::FirstFrame) == DOT_CAMERA_FIRST_FRAME);
static_assert(to_c(dot::CameraStatus::Tracked) == DOT_CAMERA_TRACKED);
static_assert(to_c(dot::CameraStatus::FromHost) == DOT_CAMERA_FROM_HOST);
static_assert(to_c(dot::CameraStatus::TooLittleDepth) == DOT_CAMERA_TOO_LITTLE_DEPTH);
static_assert(to_c(dot::CameraStatus::Lost) == DOT_CAMERA_LOST);

inline dot_object to_c(const dot::ObjectResult& object) {
  dot_object out{};
  out.id = object.id;
  out.state = to_c(object.state);
  out.reason = to_c(object.reason);
  out.last_decided = to_c(object.last_decided);
  if (object.always_dynamic) out.flags |= DOT_OBJECT_ALWAYS_DYNAMIC;
  if (object.segmented) out.flags |= DOT_OBJECT_SEGMENTED;
  if (object.discovered) out.flags |= DOT_OBJECT_DISCOVERED;
  out.instance_id = object.instance_id;
  out.class_id = object.class_id;
  out.score = object.score;
  out.area = object.area;
  std::copy(object.box.begin(), object.box.end(), out.box);
  out.n_points = object.n_points;
  out.n_inliers = object.n_inliers;
  out.p_moving = object.p_moving;
  std::copy(object.T_o.begin(), object.T_o.end(), out.T_o);
  std::copy(object.covariance.begin(), object.covariance.end(), out.covariance);
  std::copy(object.velocity.begin(), object.velocity.end(), out.velocity);
  std::copy(object.velocity_covariance.begin(), object.velocity_covariance.end(), out.velocity_covariance);
  out.speed = object.speed;
  out.phi = object.phi;
  out.disparity_px = object.disparity_px;
  out.disparity_noise_px = object.disparity_noise_px;
  out.entropy = object.entropy;
  out.range = object.range;
  out.interval = object.interval;
  std::copy(object.fused_velocity.begin(), object.fused_velocity.end(), out.fused_velocity);
  std::copy(object.fused_covariance.begin(), object.fused_covariance.end(), out.fused_covariance);
  return out;
}

inline dot_camera_result to_c(const dot::Result& result) {
  const dot::CameraResult& camera = result.camera;
  dot_camera_result out{};
  out.status = to_c(camera.status);
  out.n_points = camera.n_points;
  out.n_inliers = camera.n_inliers;
  out.frame_id = result.frame_id;
  out.timestamp = result.timestamp;
  out.interval = result.interval;
  std::copy(camera.T_cur_prev.begin(), camera.T_cur_prev.end(), out.T_cur_prev);
  std::copy(camera.covariance.begin(), camera.covariance.end(), out.covariance);
  out.phi = camera.phi;
  out.gain = camera.gain;
  out.offset = camera.offset;
  out.residual_sigma = camera.residual_sigma;
  out.normalised_variance = camera.normalised_variance;
  out.masked_share = dot::masked_share(result);
  out.small_instances = result.small_instances;
  return out;
}

template <typename T>
dot_image to_c(dot::ImageView<const T> view, std::uint32_t format) {
  dot_image out{};
  out.format = format;
  out.width = view.width;
  out.height = view.height;
  out.stride_bytes = view.stride;
  out.data = view.data;
  return out;
}

/// The caller's buffer for an image like `like`, rows `stride_bytes` apart.
template <typename T>
dot::ImageView<T> read_buffer(T* data, std::int32_t width, std::int32_t height, std::int64_t stride_bytes,
                              dot::ImageView<const std::uint8_t> like) {
  if (data == nullptr) invalid("data is NULL");
  if (width != like.width)
    invalid("width is " + std::to_string(width) + ", the label image has " + std::to_string(like.width));
  if (height != like.height)
    invalid("height is " + std::to_string(height) + ", the label image has " + std::to_string(like.height));
  constexpr std::int64_t pixel = sizeof(T);
  if (stride_bytes < width * pixel || stride_bytes > std::numeric_limits<std::ptrdiff_t>::max() / height)
    invalid("stride_bytes is " + std::to_string(stride_bytes) + ", a row takes " + std::to_string(width * pixel));
  if (stride_bytes % pixel != 0 || reinterpret_cast<std::uintptr_t>(data) % sizeof(T) != 0)
    invalid("data and stride_bytes are not aligned to a pixel's size");
  return {data, width, height, static_cast<std::ptrdiff_t>(stride_bytes)};
}

template <typename T>
void copy_rows(dot::ImageView<const T> from, dot::ImageView<T> to) {
  for (int y = 0; y < from.height; ++y) std::copy_n(from.row(y), from.width, to.row(y));
}

}  // namespace dot_c
