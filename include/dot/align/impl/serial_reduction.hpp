// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "dot/align/impl/serial_pass.hpp"
#include "dot/align/robust.hpp"

/// @file
/// Definitions of align/reduction.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

/// H += w J J' (lower triangle), g += w r J.
inline void add(const float (&J)[8], float w, float r, NormalEquations& sums) {
  for (int c = 0; c < 8; ++c) {
    const double wJ = static_cast<double>(w * J[c]);
    sums.g[c] += wJ * static_cast<double>(r);
    for (int row = c; row < 8; ++row) sums.H(row, c) += wJ * static_cast<double>(J[row]);
  }
}

template <typename Camera>
kernel::Costs SerialReduction::costs(const PointSet& points, int level, const Camera& camera,
                                     const Image<std::uint8_t>& image, const Quads*, const AlignState& state,
                                     const ResidualNoise& noise, const DepthTerm& depth, PointResiduals& scratch) {
  residuals(points, level, camera, image, state, noise, depth, scratch);
  const float s2 = noise.sigma_intensity * noise.sigma_intensity;
  kernel::Costs sums;
  for (std::size_t i = 0; i < scratch.size(); ++i) {
    if (!scratch.seen(i)) continue;
    ++sums.seen;
    sums.sum += static_cast<double>(tukey_cost(scratch.r[i] / std::sqrt(s2 + scratch.extra[i]), noise.tukey));
    if (scratch.has_depth(i) && depth.weight > 0)
      sums.sum += static_cast<double>(depth.weight * tukey_cost(scratch.r_depth[i] / depth.sigma, noise.tukey));
  }
  return sums;
}

template <typename Camera>
kernel::Moments SerialReduction::moments(const PointSet& points, int level, const Camera& camera,
                                         const Image<std::uint8_t>& image, const Quads*, const AlignState& state,
                                         PointResiduals& scratch) {
  residuals(points, level, camera, image, state, {}, {}, scratch);
  const std::vector<float>& reference = points.intensity[static_cast<std::size_t>(level)];
  kernel::Moments m;
  for (std::size_t i = 0; i < scratch.size(); ++i) {
    const float seen = scratch.seen(i), x = seen * (reference[i] - 128), y = seen * (scratch.value[i] - 128);
    m.seen += scratch.seen(i), m.x += x, m.y += y, m.xx += x * x, m.xy += x * y, m.yy += y * y;
  }
  return m;
}

/// The linear modes of a depth error: u and v about the middle of the points, over their half extents.
struct LinearModes {
  float u0 = 0, v0 = 0;          ///< the middle
  float u_half = 1, v_half = 1;  ///< half extents

  /// Those of all points.
  explicit LinearModes(const PointSet& points) {
    if (points.size() == 0) return;
    const auto [u_lo, u_hi] = std::minmax_element(points.u.begin(), points.u.end());
    const auto [v_lo, v_hi] = std::minmax_element(points.v.begin(), points.v.end());
    u0 = 0.5f * (*u_lo + *u_hi), v0 = 0.5f * (*v_lo + *v_hi);
    u_half = std::max(1.f, 0.5f * (*u_hi - *u_lo)), v_half = std::max(1.f, 0.5f * (*v_hi - *v_lo));
  }
};

template <typename Camera>
void SerialReduction::residuals(const PointSet& points, int level, const Camera& camera,
                                const Image<std::uint8_t>& image, const AlignState& state, const ResidualNoise& noise,
                                const DepthTerm& depth, PointResiduals& out) {
  out.resize(static_cast<std::size_t>(points.size()));
  for (Buffer<float>* a : {&out.r, &out.extra, &out.value, &out.r_depth}) std::fill(a->begin(), a->end(), 0.f);
  std::fill(out.visibility.begin(), out.visibility.end(), std::uint8_t{0});
  SerialPass<Camera>(points, level, camera, image, state, noise, depth)
      .run(
          nullptr,
          [&](std::size_t k, const auto& seen) {
            out.r[k] = seen.factor.r, out.extra[k] = seen.factor.extra;
            out.value[k] = seen.value, out.r_depth[k] = seen.r_depth;
            out.visibility[k] = seen.has_depth ? kernel::kSeen | kernel::kHasDepth : kernel::kSeen;
          },
          [&](std::size_t k) { out.visibility[k] = kernel::kOccluded; });
}

template <typename Camera>
NormalEquations SerialReduction::linearize(const PointSet& points, int level, const Camera& camera,
                                           const Image<std::uint8_t>& image, const AlignState& state,
                                           const ResidualNoise& noise, const DepthTerm& depth,
                                           const std::uint8_t* excluded, const Vector3<double>& centre) {
  const bool use_depth = depth.inverse_depth.data != nullptr;
  const std::optional<LinearModes> linear = use_depth ? std::optional<LinearModes>(points) : std::nullopt;
  const std::vector<float>& reference = points.intensity[static_cast<std::size_t>(level)];
  const Vector3<float> about = centre.cast<float>();
  const float s2_intensity = noise.sigma_intensity * noise.sigma_intensity;
  NormalEquations sums;
  const auto add_seen = [&](std::size_t k, const auto& seen) {
    const PhotometricFactor<float>& f = seen.factor;
    const float q = points.q[k];
    const Vector3<float> arm = seen.X - q * about;
    const Vector3<float> turn = arm.cross(f.dr_dpoint);
    const float J[8] = {
        q * f.dr_dpoint.x(), q * f.dr_dpoint.y(), q * f.dr_dpoint.z(), turn.x(), turn.y(), turn.z(), -reference[k], -1};
    const float s2 = s2_intensity + f.extra;
    const float e = f.r / std::sqrt(s2);
    const float w = huber_weight(e, noise.huber) / s2;
    ++sums.seen;
    sums.cost += static_cast<double>(huber_cost(e, noise.huber));
    add(J, w, f.r, sums);
    if (!linear) return;
    const float mode[3] = {1, (points.u[k] - linear->u0) / linear->u_half, (points.v[k] - linear->v0) / linear->v_half};
    for (std::size_t m = 0; m < 3; ++m)
      for (int c = 0; c < 8; ++c) sums.modes[m][c] += static_cast<double>(w * f.dr_dq * mode[m] * J[c]);
    if (!seen.has_depth || !(depth.weight > 0)) return;
    // r_depth = measured - q / Z~; the predicted q' = q / Z~ moves by -q' dZ~ / Z~.
    const float per_z = seen.q / seen.X.z();
    const float Jq[8] = {0, 0, per_z * q, per_z * arm.y(), -per_z * arm.x(), 0, 0, 0};
    const float eq = seen.r_depth / depth.sigma;
    const float wq = depth.weight * huber_weight(eq, noise.huber) / (depth.sigma * depth.sigma);
    add(Jq, wq, seen.r_depth, sums);
    sums.cost += static_cast<double>(depth.weight * huber_cost(eq, noise.huber));
    for (int c = 2; c < 5; ++c) sums.modes[3][c] += static_cast<double>(wq * Jq[c]);
  };
  SerialPass<Camera>(points, level, camera, image, state, noise, depth).run(excluded, add_seen, [&](std::size_t) {
    ++sums.occluded;
  });
  for (int c = 0; c < 8; ++c)
    for (int row = c + 1; row < 8; ++row) sums.H(c, row) = sums.H(row, c);
  sums.inside = sums.seen + sums.occluded;
  sums.cost = sums.seen ? sums.cost / sums.seen : 0;
  return sums;
}

DOT_END_NAMESPACE
