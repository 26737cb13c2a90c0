// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dot/dot.h"
#include "dot/pipeline/options.hpp"
#include "fuzz/input.hpp"
#include "fuzz/views.hpp"

/// @file
/// Cameras and options, most of them fit for small pictures, some of them wrong.

namespace fuzz {

constexpr std::size_t kCameraBytes = 5, kOptionBytes = 13;

inline dot_camera read_camera(Input in) {
  constexpr int widths[] = {48, 64, 40, 80, 33, 96, 200, 1}, heights[] = {36, 48, 40, 30, 64, 17, 120, 1};
  const int size = in.byte(), width = in.byte(), height = in.byte(), fault = in.byte(), value = in.byte();
  dot_camera camera = DOT_CAMERA_INIT;
  camera.width = size < 224 ? widths[size & 7] : 1 + width % 128;
  camera.height = size < 224 ? heights[size >> 3 & 7] : 1 + height % 96;
  camera.fx = camera.fy = 0.9 * camera.width + 8;
  camera.cx = 0.5 * camera.width;
  camera.cy = 0.5 * camera.height;
  camera.baseline = (size & 64) != 0 ? 0.5 : 0;
  double* const numbers[] = {&camera.fx, &camera.fy, &camera.cx, &camera.cy, &camera.baseline};
  if (fault >= 192) *numbers[fault % 5] = odd_number(value);
  if (fault >= 160 && fault < 192) camera.struct_size = odd_size(camera.struct_size, value);
  if (fault == 159) camera.width = -camera.width;
  if (fault == 158) camera.reserved = 1;
  return camera;
}

/// Names and defaults of all settings.
inline const std::vector<std::pair<std::string, double>>& all_settings() {
  static const std::vector<std::pair<std::string, double>> all = [] {
    std::vector<std::pair<std::string, double>> out;
    dot::Options options;
    dot::for_each_option(options, [&out](const char* name, auto& value) { out.emplace_back(name, value); });
    return out;
  }();
  return all;
}

/// Some way from the default, or nowhere near it.
inline double setting_value(double standard, int choice) {
  if (choice < 64) return odd_number(choice);
  if (choice < 128) return std::floor(standard * (choice - 64) / 16);
  if (choice < 192) return standard * (choice - 128) / 16;
  return choice < 224 ? choice - 192 : -standard * (choice - 224);
}

/// Options and what they point to.
struct Setup {
  dot_options options = DOT_OPTIONS_INIT;
  std::vector<dot_setting> settings;

  explicit Setup(Input in) {
    const int kinds = in.byte(), form = in.byte();
    options.classifier = static_cast<std::uint32_t>(kinds % 3);
    options.depth_source = static_cast<std::uint32_t>(kinds / 3 % 4);
    options.background_points = (form & 1) != 0 ? 1500 : 300;
    options.object_points = (form & 2) != 0 ? 300 : 80;
    if ((form & 12) != 0) set("threads", 1 + (form >> 2 & 3));
    if ((form & 16) != 0) set("discover_unknown", 1);
    if ((form & 32) == 0) {  // what a small picture has
      set("selection.min_object_pixels", 20);
      set("object.min_points", 12);
      set("object.min_inliers", 8);
      set("camera.min_points", 30);
      set("camera.min_inliers", 0.2);
    }
    if ((form & 64) != 0) set("motion_prior.ground_vehicle", 1);
    if ((form & 128) == 0) {  // for more frames a second
      set("camera.search_speed", 4);
      set("camera.search_turn", 0.3);
      set("object.search_speed", 8);
    }
    for (int i = 0; i < 4; ++i) {
      const int which = in.byte(), value = in.byte();
      if (which > 0) set_odd(static_cast<std::size_t>(which - 1), value);
    }
    damage(in.byte(), in.byte());
    options.setting_count = static_cast<std::uint32_t>(settings.size());
  }

 private:
  void set(const char* name, double value) { settings.push_back({name, value}); }

  void set_odd(std::size_t which, int choice) {
    const auto& [name, standard] = all_settings()[which % all_settings().size()];
    const double value = setting_value(standard, choice);
    // Legal, and as slow as they say: a minute finds nothing that a second does not.
    if (name == "threads" && value > 8) return;
    if (name == "align.max_iterations" && value > 1000) return;
    set(name.c_str(), value);
  }

  void damage(int fault, int value) {
    if (fault >= 240) options.v0 = odd_number(value);
    if (fault >= 224 && fault < 240) options.stereo_sigma_px = odd_number(value);
    if (fault >= 208 && fault < 224) options.background_points = odd_integer(value);
    if (fault >= 192 && fault < 208) options.object_points = odd_integer(value);
    if (fault >= 176 && fault < 192) options.struct_size = odd_size(options.struct_size, value);
    if (fault == 175) options.classifier = static_cast<std::uint32_t>(value);
    if (fault == 174) options.depth_source = static_cast<std::uint32_t>(value);
    if (fault == 173) set("no.such", 1);
    if (fault == 172) set(nullptr, 1);
  }
};

}  // namespace fuzz
