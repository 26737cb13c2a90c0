// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fuzz/input.hpp"

/// @file
/// What the tracker is shown: a textured wall and ground with up to three textured plates before them, which the camera
/// sees exactly as the geometry says. That is what takes an input behind the first checks, into fits and beliefs.

namespace fuzz {

/// One frame, before it is packed into the formats of the interface.
struct Picture {
  int width = 0, height = 0;
  std::vector<float> grey;        // 0 to 255
  std::vector<float> depth;       // metres
  std::vector<std::uint8_t> ids;  // 1 to 3: the plates
};

struct Plate {
  double x = 0, y = 0, z = 0;                  // metres: the centre
  double half_width = 0.5, half_height = 0.5;  // metres
  double velocity_x = 0, velocity_z = 0;       // m/s
  bool hidden = false;
};

constexpr std::size_t kSceneBytes = 17;

class Scene {
 public:
  static constexpr int kPlates = 3;

  std::array<Plate, kPlates> plates;
  double wall = 9;                            // metres
  double camera_x = 0, camera_z = 0;          // metres
  double yaw = 0;                             // radians
  double speed_x = 0, speed_z = 0, turn = 0;  // m/s, radians a second
  int noise = 0;                              // grey values
  bool flat = false;                          // no texture anywhere

  /// Zeros give one parked plate, two that may drive, and a camera that moves slowly.
  Scene(Input in, double focal, int width, int height) : focal_(focal), width_(width), height_(height) {
    wall = in.between(9, 3);
    set_speed(in);
    const int look = in.byte();
    noise = look & 7;
    flat = (look & 0xf0) == 0xf0;
    for (int k = 0; k < kPlates; ++k) {
      Plate& p = plates[static_cast<std::size_t>(k)];
      const int place = in.byte(), size = in.byte();
      p.z = 4 + k - (place & 3);
      const double reach = 0.5 * width / focal * p.z;  // metres: what half the image shows at that distance
      p.x = reach * (-0.55 + 0.5 * k + (place >> 2 & 7) * 0.15);
      p.y = reach * (0.2 - (place >> 5) * 0.1);
      p.half_width = reach * (0.28 + (size & 15) * 0.02);
      p.half_height = reach * (0.3 + (size >> 4) * 0.02);
      p.velocity_x = (k == 1 ? 1 : 0) + in.about_zero(8);
      p.velocity_z = in.about_zero(8);
    }
  }

  /// Other speeds, another place for the camera, plates that appear and vanish.
  void change(Input& in) {
    const int shown = in.byte();
    set_speed(in);
    camera_x += in.about_zero(2);
    Plate& p = plates[static_cast<std::size_t>(in.choice(kPlates))];
    p.velocity_x = in.about_zero(8);
    for (int k = 0; k < kPlates; ++k) plates[static_cast<std::size_t>(k)].hidden = (shown >> k & 1) != 0;
    flat = (shown & 0xf8) == 0xf8;
  }

  void advance(double seconds) {
    before_ = {camera_x, camera_z, yaw};
    camera_x += seconds * speed_x;
    camera_z += seconds * speed_z;
    yaw += seconds * turn;
    for (Plate& p : plates) {
      p.x += seconds * p.velocity_x;
      p.z += seconds * p.velocity_z;
    }
    ++frame_;
  }

  /// T_cur_prev, row-major 3x4, of the last `advance`.
  std::array<double, 12> motion() const {
    const double turned = yaw - before_[2], c = std::cos(turned), s = std::sin(turned);
    const double x = before_[0] - camera_x, z = before_[1] - camera_z;
    return {c, 0, -s, std::cos(yaw) * x - std::sin(yaw) * z, 0, 1, 0, 0,
            s, 0, c,  std::sin(yaw) * x + std::cos(yaw) * z};
  }

  Picture render() const {
    Picture out;
    out.width = width_;
    out.height = height_;
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    out.grey.resize(pixels);
    out.depth.resize(pixels);
    out.ids.resize(pixels);
    std::uint32_t random = 2166136261u + static_cast<std::uint32_t>(frame_);
    std::size_t i = 0;
    for (int v = 0; v < height_; ++v)
      for (int u = 0; u < width_; ++u, ++i) {
        const Hit hit = cast((u - 0.5 * width_) / focal_, (v - 0.5 * height_) / focal_);
        random = random * 1664525u + 1013904223u;
        const int scatter =
            noise > 0 ? static_cast<int>((random >> 16) % static_cast<unsigned>(2 * noise + 1)) - noise : 0;
        out.grey[i] = static_cast<float>(flat ? 100 : hit.grey + scatter);
        out.depth[i] = static_cast<float>(hit.depth);
        out.ids[i] = static_cast<std::uint8_t>(hit.id);
      }
    return out;
  }

 private:
  void set_speed(Input& in) {
    speed_x = 0.2 + in.about_zero(2);
    speed_z = 0.3 + in.about_zero(3);
    turn = in.about_zero(0.4);
  }

  struct Hit {
    double depth, grey;
    int id;
  };

  /// What the ray (x, y, 1) of the camera meets first.
  Hit cast(double x, double y) const {
    const double ray_x = std::cos(yaw) * x + std::sin(yaw), ray_z = std::cos(yaw) - std::sin(yaw) * x;
    const double to_wall = (wall - camera_z) / ray_z;
    Hit out{to_wall > 0 ? to_wall : 1000, 0, 0};
    out.grey = texture(0, camera_x + out.depth * ray_x, out.depth * y, 4 * wall / focal_);
    constexpr double ground = 1.5;  // metres below the camera
    if (y > 0 && ground / y < out.depth) {
      out.depth = ground / y;
      out.grey = texture(1, camera_x + out.depth * ray_x, camera_z + out.depth * ray_z, 20 / focal_);
    }
    for (int k = 0; k < kPlates; ++k) {
      const Plate& p = plates[static_cast<std::size_t>(k)];
      const double depth = (p.z - camera_z) / ray_z;
      if (p.hidden || !(depth > 0.05) || depth >= out.depth) continue;
      const double on_x = camera_x + depth * ray_x - p.x, on_y = depth * y - p.y;
      if (std::abs(on_x) > p.half_width || std::abs(on_y) > p.half_height) continue;
      out = {depth, texture(2 + k, on_x, on_y, 12 / focal_), k + 1};
    }
    return out;
  }

  /// Two octaves of noise on a grid of `pitch` metres. 40 to 215.
  static double texture(int surface, double x, double y, double pitch) {
    return 128 + 55 * noise_at(surface, x / pitch, y / pitch) +
           32 * noise_at(surface + 8, 2.3 * x / pitch, 2.3 * y / pitch);
  }
  /// -1 to 1, continuous.
  static double noise_at(int seed, double x, double y) {
    const double left = std::floor(x), top = std::floor(y), a = x - left, b = y - top;
    const auto corner = [&](double dx, double dy) {
      auto h = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::fmod(left + dx, 4096)) * 374761393 +
                                          static_cast<std::int64_t>(std::fmod(top + dy, 4096)) * 668265263 + seed * 97);
      h = (h ^ (h >> 13)) * 1274126177u;
      return ((h ^ (h >> 16)) & 0xffffu) / 32767.5 - 1;
    };
    return (corner(0, 0) * (1 - a) + corner(1, 0) * a) * (1 - b) + (corner(0, 1) * (1 - a) + corner(1, 1) * a) * b;
  }

  double focal_;
  int width_, height_;
  int frame_ = 0;
  std::array<double, 3> before_{};
};

}  // namespace fuzz
