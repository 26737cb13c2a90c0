// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "dot/discovery/inconsistency.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// How much better its own motion explains the cells of an object than standing does. Each explanation has a cost in
/// squared sigma, see CellComparison.
struct CellEvidence {
  int x = 0;                     ///< column of the image that the first column is
  int y = 0;                     ///< row of the image that the first row is
  Image<float> total;            ///< cost of standing minus cost of moving, summed over the references
  Image<float> intensity;        ///< the part of `total` that is due to the intensity
  Image<float> references;       ///< number of references that could be compared
  Image<std::uint8_t> measured;  ///< non-zero: a cell of the object, with depth

  /// Covers the box of a mask. All is zero. @param cell pixels of a cell.
  void restart(const Mask& mask, int cell) {
    x = mask.x / cell;
    y = mask.y / cell;
    const int width = (mask.x + mask.width() - 1) / cell - x + 1, height = (mask.y + mask.height() - 1) / cell - y + 1;
    for (Image<float>* image : {&total, &intensity, &references}) {
      image->resize(width, height);
      image->fill(0);
    }
    measured.resize(width, height);
    measured.fill(0);
  }
};

/// Compares the two explanations of an object's cells with one earlier frame: it stands, or it moves by its own motion.
/// The cost of an explanation is that of the depth and that of the intensity at the place where the earlier frame
/// should show the cell. Only a surface that is nearer than the one seen there costs: a farther one is hidden there,
/// and the frame says nothing about the cell. All is borrowed.
template <typename Camera, typename Noise>
struct CellComparison {
  static constexpr float kMostCost = 9;       ///< squared sigma, of depth and of intensity each
  static constexpr float kLeastShift = 1;     ///< cells between the places of the two explanations
  static constexpr float kLeastContrast = 3;  ///< grey values: least sigma; less than that may be glare or shading

  const Camera& camera;                          ///< of the cells' level
  const Noise& noise;                            ///< of the depth
  const InconsistencyTest<Camera, Noise>& test;  ///< prepared for this camera
  const CellFrame& current;                      ///< the new frame
  const CellFrame& reference;                    ///< the earlier frame
  const CellMotion& motion;                      ///< of a standing scene

  /// Adds the evidence of this reference. @param T_cur_ref motion of the object's points.
  /// @param belongs (x, y) -> bool: whether a cell of the image belongs to the object.
  template <typename Belongs>
  void operator()(const SE3d& T_cur_ref, Belongs&& belongs, CellEvidence& out) const {
    const SE3f T_stands = motion.T_cur_ref.inverse().template cast<float>();
    const SE3f T_moves = T_cur_ref.inverse().template cast<float>();
    const int first_x = std::max(1, out.x), end_x = std::min(out.x + out.total.width(), current.q.width() - 1);
    const int first_y = std::max(1, out.y), end_y = std::min(out.y + out.total.height(), current.q.height() - 1);
    for (int y = first_y; y < end_y; ++y)
      for (int x = first_x; x < end_x; ++x) {
        const float q = current.q(x, y);
        if (!(q > 0) || !belongs(x, y)) continue;
        const int column = x - out.x, row = y - out.y;
        out.measured(column, row) = 1;
        Moved stands, moves;
        if (!test.warp(camera, T_stands, x, y, q, stands) || !test.warp(camera, T_moves, x, y, q, moves)) continue;
        const float du = stands.u - moves.u, dv = stands.v - moves.v;
        if (du * du + dv * dv < kLeastShift * kLeastShift) continue;
        Cost of_standing, of_moving;
        if (!find_cost(stands, x, y, of_standing) || !find_cost(moves, x, y, of_moving)) continue;
        const float intensity = of_standing.intensity - of_moving.intensity;
        out.intensity(column, row) += intensity;
        out.total(column, row) += intensity + of_standing.depth - of_moving.depth;
        out.references(column, row) += 1;
      }
  }

 private:
  using Moved = typename CellWarp<Camera>::Moved;
  struct Cost {
    float depth = 0, intensity = 0;  // squared sigma
  };

  /// @return whether the reference can show cell (x, y) at `m`.
  bool find_cost(const Moved& m, int x, int y, Cost& out) const {
    const int u = static_cast<int>(m.u + 0.5f), v = static_cast<int>(m.v + 0.5f);
    if (const float nearest = reference.nearest(u, v); nearest > 0) {
      const float s = test.sigma(noise, m.q, motion);
      if (m.q < reference.farthest(u, v) - 2 * s) return false;
      const float d = std::max(0.f, (m.q - nearest) / s);
      out.depth = std::min(kMostCost, d * d);
    }
    constexpr float kGradientNoise = InconsistencyTest<Camera, Noise>::kGradientNoise;
    const float gx = 0.5f * static_cast<float>(current.grey(x + 1, y) - current.grey(x - 1, y));
    const float gy = 0.5f * static_cast<float>(current.grey(x, y + 1) - current.grey(x, y - 1));
    const float r = static_cast<float>(current.grey(x, y)) - static_cast<float>(motion.offset) -
                    static_cast<float>(motion.gain) * bilinear(reference.grey, m.u, m.v);
    const float scale = std::max(kLeastContrast, test.intensity_scale);
    const float variance = scale * scale + kGradientNoise * kGradientNoise * (gx * gx + gy * gy);
    out.intensity = std::min(kMostCost, r * r / variance);
    return true;
  }
};

DOT_END_NAMESPACE
