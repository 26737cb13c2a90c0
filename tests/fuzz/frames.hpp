// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "dot/dot.h"
#include "fuzz/input.hpp"
#include "fuzz/masks.hpp"
#include "fuzz/scene.hpp"
#include "fuzz/setup.hpp"
#include "fuzz/views.hpp"

/// @file
/// A frame for dot_track, with at most one mistake in it.

namespace fuzz {

/// Pixels that a camera or a stereo matcher may well deliver, and some that none should. Nothing for choices below 128.
inline void spoil(Picture& p, int choice) {
  constexpr float depths[] = {
      0,      -1,    std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f,
      1e-30f, 1e-3f, std::numeric_limits<float>::denorm_min()};
  if (choice < 128) return;
  const int where = choice >> 3 & 15;
  for (std::size_t i = 0; i < p.depth.size(); ++i) {
    const bool stripe = i / 5 % 3 == 0, scattered = (i * 2654435761u >> 8) % 8 == 0, upper = i < p.depth.size() / 2;
    if (where < 4 ? stripe : where < 8 ? scattered : where < 10 ? upper : where < 12) p.depth[i] = depths[choice & 7];
    if (where == 12) p.grey[i] = static_cast<float>(32 * (choice & 7));
    if (where == 13) p.grey[i] = p.grey[i] * 0.5f + static_cast<float>(16 * (choice & 7));
    if (where == 14 && scattered) p.grey[i] = 255;
    if (where == 15) p.grey[i] = 255 - p.grey[i];
  }
}

/// What the bytes of a record say of its frame.
struct FrameChoice {
  int mask_kind, mask_detail, step, motion, pixels, fault, value;

  explicit FrameChoice(Input& in)
      : mask_kind(in.byte() + 2),
        mask_detail(in.byte()),
        step(in.byte()),
        motion(in.byte()),
        pixels(in.byte()),
        fault(in.byte() - 128),
        value(in.byte()) {}

  bool has_fault() const { return fault >= 0; }
  /// Seconds since the frame before.
  double interval() const {
    constexpr double steps[] = {0.1, 0.1, 0.1, 0.033, 0.02, 0.2, 0.5, 0.9, 1.1, 3, 1e-3, 1e-6, 0.05, 0.3, 0.01, 1e9};
    return steps[step & 15];
  }
};

/// A motion of the camera: the true one, one that is a little off, or one that cannot be.
inline void write_motion(const Scene& scene, int choice, int value, double* T) {
  const std::array<double, 12> truth = scene.motion();
  std::copy(truth.begin(), truth.end(), T);
  switch (choice & 3) {
    case 1: T[3] += 0.002 * (value - 128); break;
    case 2: T[11] += 0.01 * (value - 128); break;
    case 3: T[value % 12] = odd_number(value / 7); break;
    default: break;
  }
}

/// Good, large, indefinite, or not a covariance at all.
inline void write_covariance(int choice, int value, double* covariance) {
  for (int i = 0; i < 6; ++i) covariance[7 * i] = 1e-6;
  const int row = value % 6, column = value % 36 / 6;
  switch (choice & 3) {
    case 1:
      for (int i = 0; i < 6; ++i) covariance[7 * i] = std::pow(10.0, value / 8.0 - 16);
      break;
    case 2: covariance[7 * row] = odd_number(value / 6); break;
    case 3: covariance[6 * row + column] = covariance[6 * column + row] = odd_number(value / 6); break;
    default: break;
  }
}

/// The frame of a picture. @param fault -1: none
inline dot_frame* make_frame(Arena& arena, const Scene& scene, const Picture& picture, const FrameChoice& c,
                             std::uint64_t id, double timestamp, int fault) {
  enum {
    kSize,
    kReserved,
    kTime,
    kBack,
    kNoImage,
    kNoDepth,
    kSwapped,
    kHost = 8,
    kPrior = 12,
    kHostReserved,
    kHostSize
  };
  constexpr int first_of_image = 16, first_of_depth = first_of_image + kImageFaults,
                first_of_masks = first_of_depth + kImageFaults;
  constexpr std::uint32_t formats[] = {DOT_FORMAT_GREY8, DOT_FORMAT_BGR8, DOT_FORMAT_RGB8, DOT_FORMAT_BGRA8};
  const int padding = (c.step & 128) != 0 ? 12 : 0;
  const int in_image = fault < first_of_depth ? fault - first_of_image : -1;
  const int in_depth = fault < first_of_masks ? fault - first_of_depth : -1;
  const int in_masks = fault < first_of_masks ? -1 : (fault - first_of_masks) % kMaskFaults;
  dot_frame frame = DOT_FRAME_INIT;
  frame.id = id;
  frame.timestamp = timestamp;
  frame.image = grey_or_colour(arena, picture, formats[c.step >> 4 & 3], padding, in_image, c.value);
  frame.depth = depth_image(arena, picture, (c.step & 64) != 0, padding, in_depth, c.value);
  frame.masks = make_masks(arena, picture, c.mask_kind, c.mask_detail, {in_masks, c.value});

  const bool wrong_host = (fault >= kHost && fault < kPrior) || fault == kHostReserved || fault == kHostSize;
  if (wrong_host || (c.motion & 3) == 3) {
    dot_camera_motion host = DOT_CAMERA_MOTION_INIT;
    write_motion(scene, wrong_host && fault < kPrior ? fault : 0, c.value, host.T_cur_prev);
    write_covariance(wrong_host && fault < kPrior ? c.motion >> 4 : 0, c.value, host.covariance);
    host.reserved = fault == kHostReserved ? 1 : 0;
    frame.camera_motion = arena.place(host, fault == kHostSize ? odd_size(sizeof host, c.value) : sizeof host);
  }
  if (fault == kPrior || (c.motion & 12) == 12) {
    double prior[12];
    write_motion(scene, fault == kPrior ? c.motion >> 4 : 0, c.value, prior);
    frame.camera_prior = reinterpret_cast<double*>(std::memcpy(arena.take(sizeof prior), prior, sizeof prior));
  }

  switch (fault) {
    case kReserved: frame.reserved = 1; break;
    case kTime: frame.timestamp = odd_number(c.value); break;
    case kBack: frame.timestamp -= 0.01 * c.value; break;
    case kNoImage: frame.image = nullptr; break;
    case kNoDepth: frame.depth = nullptr; break;
    case kSwapped: std::swap(frame.image, frame.depth); break;
    default: break;
  }
  return arena.place(frame, fault == kSize ? odd_size(sizeof frame, c.value) : sizeof frame);
}

}  // namespace fuzz
