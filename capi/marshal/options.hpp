// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "dot/pipeline/exclusion.hpp"
#include "dot/pipeline/options.hpp"
#include "structs.hpp"

/// @file
/// Converts camera, options and policy of a C caller to those of the C++ interface. Errors name their fields.

namespace dot_c {

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

/// What to add for a name that is no setting because dot_options has a field for it: the value is one of a list.
inline std::string hint(const std::string& name) {
  if (name == "classifier") return "; set options.classifier instead";
  if (name == "depth_source" || name == "depth_noise.source") return "; set options.depth_source instead";
  return "";
}

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
    if (!setter.found) invalid(setter.field + ".name is unknown: " + setter.setting.name + hint(setter.setting.name));
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

// The _INIT macros repeat the defaults, which are defined by the C++ structs.
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

}  // namespace dot_c
