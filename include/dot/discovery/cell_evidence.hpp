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
  int cell = 1;                  ///< pixels of a cell
  int x = 0;                     ///< column of the image that the first column is
  int y = 0;                     ///< row of the image that the first row is
  Image<std::uint8_t> belongs;   ///< non-zero: the middle of the cell is in the mask
  Image<float> total;            ///< cost of standing minus cost of moving, summed over the references
  Image<float> intensity;        ///< the part of `total` that is due to the intensity
  Image<float> references;       ///< number of references that could be compared
  Image<std::uint8_t> measured;  ///< non-zero: it belongs to the object and has depth

  /// Covers the box of a mask, without evidence. @param cell_size pixels of a cell.
  void restart(const Mask& mask, int cell_size) {
    cell = cell_size;
    x = mask.x / cell;
    y = mask.y / cell;
    const int width = (mask.x + mask.width() - 1) / cell - x + 1, height = (mask.y + mask.height() - 1) / cell - y + 1;
    for (Image<float>* image : {&total, &intensity, &references}) {
      image->resize(width, height);
      image->fill(0);
    }
    measured.resize(width, height);
    measured.fill(0);
    belongs.resize(width, height);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) belongs(u, v) = mask.at((x + u) * cell + cell / 2, (y + v) * cell + cell / 2);
  }
};

/// Compares the two explanations of an object's cells with one earlier frame: it stands, or it moves by its own motion.
/// The cost of an explanation is that of the depth and that of the intensity at the place where the earlier frame
/// should show the cell. Only a surface that is nearer than the one seen there costs: a farther one is hidden there,
/// and the frame says nothing about the cell. Nor does a place without depth cost anything by its depth. All is
/// borrowed.
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
  float intensity_scale;                         ///< grey values: robust scale of the residuals

  /// Adds the evidence of this reference. @param T_cur_ref motion of the object's points.
  void operator()(const SE3d& T_cur_ref, CellEvidence& out) const {
    const SE3f T_stands = motion.T_cur_ref.inverse().template cast<float>();
    const SE3f T_moves = T_cur_ref.inverse().template cast<float>();
    const int first_x = std::max(1, out.x), end_x = std::min(out.x + out.total.width(), current.q.width() - 1);
    const int first_y = std::max(1, out.y), end_y = std::min(out.y + out.total.height(), current.q.height() - 1);
    for (int y = first_y; y < end_y; ++y)
      for (int x = first_x; x < end_x; ++x) {
        const float q = current.q(x, y);
        const int column = x - out.x, row = y - out.y;
        if (!(q > 0) || !out.belongs(column, row)) continue;
        out.measured(column, row) = 1;
        Moved stands, moves;
        if (!test.warp(camera, T_stands, x, y, q, stands) || !test.warp(camera, T_moves, x, y, q, moves)) continue;
        const float du = stands.u - moves.u, dv = stands.v - moves.v;
        if (du * du + dv * dv < kLeastShift * kLeastShift) continue;
        if (is_hidden(stands) || is_hidden(moves)) continue;
        const float intensity = intensity_cost(stands, x, y) - intensity_cost(moves, x, y);
        out.intensity(column, row) += intensity;
        out.total(column, row) += intensity + depth_cost(stands) - depth_cost(moves);
        out.references(column, row) += 1;
      }
  }

 private:
  using Moved = typename CellWarp<Camera>::Moved;

  static int nearest(float place) { return static_cast<int>(place + 0.5f); }
  float sigma(const Moved& m) const { return test.sigma(noise, m.q, motion); }

  /// Whether the reference shows something nearer there.
  bool is_hidden(const Moved& m) const { return m.q < reference.farthest(nearest(m.u), nearest(m.v)) - 2 * sigma(m); }
  float depth_cost(const Moved& m) const {
    const float seen = reference.nearest(nearest(m.u), nearest(m.v));
    if (!(seen > 0)) return 0;
    const float d = std::max(0.f, (m.q - seen) / sigma(m));
    return std::min(kMostCost, d * d);
  }
  float intensity_cost(const Moved& m, int x, int y) const {
    constexpr float kGradientNoise = InconsistencyTest<Camera, Noise>::kGradientNoise;
    const float r = static_cast<float>(current.grey(x, y)) - static_cast<float>(motion.offset) -
                    static_cast<float>(motion.gain) * bilinear(reference.grey, m.u, m.v);
    const float scale = std::max(kLeastContrast, intensity_scale);
    const float variance = scale * scale + kGradientNoise * kGradientNoise * current.gradient(x, y).squaredNorm();
    return std::min(kMostCost, r * r / variance);
  }
};

DOT_END_NAMESPACE
