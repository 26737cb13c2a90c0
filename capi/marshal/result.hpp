// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "dot/pipeline/exclusion.hpp"
#include "dot/pipeline/result.hpp"
#include "structs.hpp"

/// @file
/// Converts results to structs of dot.h, and copies images to a C caller's buffers.

namespace dot_c {

constexpr std::uint32_t to_c(dot::State state) { return static_cast<std::uint32_t>(state); }
constexpr std::uint32_t to_c(dot::Reason reason) { return static_cast<std::uint32_t>(reason); }
constexpr std::uint32_t to_c(dot::CameraStatus status) { return static_cast<std::uint32_t>(status); }
constexpr std::uint32_t to_c(dot::Suspicion suspicion) { return static_cast<std::uint32_t>(suspicion); }

// The C values are fixed. These checks prevent that a change of the C++ values changes them.
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
static_assert(to_c(dot::Suspicion::None) == DOT_SUSPICION_NONE);
static_assert(to_c(dot::Suspicion::ImplausibleTimes) == DOT_SUSPICION_IMPLAUSIBLE_TIMES);
static_assert(to_c(dot::Suspicion::RepeatedImages) == DOT_SUSPICION_REPEATED_IMAGES);
static_assert(to_c(dot::Suspicion::TooLittleDepth) == DOT_SUSPICION_TOO_LITTLE_DEPTH);
static_assert(to_c(dot::Suspicion::TooLittleTexture) == DOT_SUSPICION_TOO_LITTLE_TEXTURE);
static_assert(to_c(dot::Suspicion::ImplausibleDepth) == DOT_SUSPICION_IMPLAUSIBLE_DEPTH);
static_assert(to_c(dot::Suspicion::DepthOutOfStep) == DOT_SUSPICION_DEPTH_OUT_OF_STEP);
static_assert(to_c(dot::Suspicion::MasksCoverImage) == DOT_SUSPICION_MASKS_COVER_IMAGE);
static_assert(to_c(dot::Suspicion::SaturatedDepth) == DOT_SUSPICION_SATURATED_DEPTH);
static_assert(to_c(dot::Suspicion::FixedPart) == DOT_SUSPICION_FIXED_PART);
static_assert(to_c(dot::Suspicion::RollingShutter) == DOT_SUSPICION_ROLLING_SHUTTER);
static_assert(to_c(dot::Suspicion::UnsteadyScale) == DOT_SUSPICION_UNSTEADY_SCALE);
static_assert(to_c(dot::Suspicion::HostMotion) == DOT_SUSPICION_HOST_MOTION);
static_assert(to_c(dot::Suspicion::LensDistortion) == DOT_SUSPICION_LENS_DISTORTION);

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
  std::copy(object.angular_velocity.begin(), object.angular_velocity.end(), out.angular_velocity);
  std::copy(object.angular_covariance.begin(), object.angular_covariance.end(), out.angular_covariance);
  out.point_speed = object.point_speed;
  out.point_speed_sigma = object.point_speed_sigma;
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
  out.normalised_variance = camera.reduced_chi2;
  out.masked_share = dot::masked_share(result);
  out.small_instances = result.small_instances;
  out.suspicion = to_c(result.diagnosis.reason);
  out.suspicion_figure = result.diagnosis.figure;
  return out;
}

inline dot_camera_revision to_c(const dot::CameraRevision& revision) {
  dot_camera_revision out{};
  out.frame_id = revision.frame_id;
  out.timestamp = revision.timestamp;
  std::copy(revision.T_cur_prev.begin(), revision.T_cur_prev.end(), out.T_cur_prev);
  std::copy(revision.covariance.begin(), revision.covariance.end(), out.covariance);
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
