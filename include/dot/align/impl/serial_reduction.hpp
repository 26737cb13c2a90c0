// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/align/photometric_factor.hpp"
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

template <typename Camera>
void SerialReduction::run(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                          const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                          const std::uint8_t* excluded, const Vector3<double>& centre, PointResiduals* out,
                          NormalEquations* sums) {
  using Vector3f = Eigen::Matrix<float, 3, 1>;
  const int n = points.size();
  const Matrix3<float> R = state.T.R.cast<float>();
  const Vector3f t = state.T.t.cast<float>(), about = centre.cast<float>();
  const float gain = static_cast<float>(state.gain);
  const PhotometricModel<float> factor(state, noise.gradient_noise);
  // From pixels of this level to those of the depth, and of level 0.
  const float to_depth = std::ldexp(1.f, level - depth.level), to_base = std::ldexp(1.f, level);
  const float u_max = static_cast<float>(image.width() - 3), v_max = static_cast<float>(image.height() - 3);
  const float s2_intensity = noise.sigma_intensity * noise.sigma_intensity;
  const bool use_depth = depth.inverse_depth.data != nullptr;
  const std::vector<float>& reference = points.intensity[static_cast<std::size_t>(level)];

  // Half extents of the region, for the linear modes.
  float u0 = 0, v0 = 0, u_half = 1, v_half = 1;
  if (sums && use_depth && n > 0) {
    const auto [u_lo, u_hi] = std::minmax_element(points.u.begin(), points.u.end());
    const auto [v_lo, v_hi] = std::minmax_element(points.v.begin(), points.v.end());
    u0 = 0.5f * (*u_lo + *u_hi), v0 = 0.5f * (*v_lo + *v_hi);
    u_half = std::max(1.f, 0.5f * (*u_hi - *u_lo)), v_half = std::max(1.f, 0.5f * (*v_hi - *v_lo));
  }

  int seen = 0;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (out) {
      for (Buffer<float>* a : {&out->r, &out->extra, &out->value, &out->r_depth}) (*a)[k] = 0;
      out->visibility[k] = 0;
    }
    if (excluded && excluded[i]) continue;
    const float q = points.q[k];
    const Vector3f ray = R * Vector3f(points.x[k], points.y[k], 1.f);
    const Vector3f X = ray + q * t;
    if (X.z() < 1e-3f) continue;
    const float qi = q / X.z();
    Eigen::Matrix<float, 2, 3> J_pi;
    const Eigen::Matrix<float, 2, 1> pixel = camera.template project<float>(X, &J_pi);
    if (!(pixel.x() >= 1 && pixel.y() >= 1 && pixel.x() < u_max && pixel.y() < v_max)) continue;

    bool has_depth = false;
    float r_depth = 0;
    if (use_depth) {
      const float left = pixel.x() + 0.5f, top = pixel.y() + 0.5f;  // distances from the image's edges
      const int u = static_cast<int>(left * to_depth), v = static_cast<int>(top * to_depth);
      if (depth.inverse_depth.contains(u, v)) {
        const float measured = depth.inverse_depth(u, v);
        const float difference = measured - qi;
        const bool nearer =
            measured > 0 && difference > std::max(depth.occlusion_relative * qi, depth.occlusion_sigmas * depth.sigma);
        const bool occluded = depth.occluders.data != nullptr &&
                              depth.occluders(static_cast<int>(left * to_base), static_cast<int>(top * to_base));
        if (nearer || occluded) {
          if (out) out->visibility[k] = kernel::kOccluded;
          if (sums) ++sums->occluded;
          continue;
        }
        if (measured > 0) has_depth = true, r_depth = difference;
      }
    }

    Sample s = sample(image, pixel.x(), pixel.y());
    if (noise.gradient != GradientSource::Image) {
      // A small piece of surface appears 1 / Z~ times as large as in the reference, so its gradient is Z~ times as
      // large. Its rotation about the optical axis and its shear are neglected.
      const auto l = static_cast<std::size_t>(level);
      const float scale = gain * X.z(), own = noise.gradient == GradientSource::Mean ? 0.5f : 0;
      s.gx = own * s.gx + (1 - own) * scale * points.gu[l][k];
      s.gy = own * s.gy + (1 - own) * scale * points.gv[l][k];
    }
    const auto [r, dr_dX, dr_dq, extra] = factor(s, J_pi, reference[k], points.sigma_q[k]);
    ++seen;
    if (out) {
      out->r[k] = r, out->extra[k] = extra, out->value[k] = s.value, out->r_depth[k] = r_depth;
      out->visibility[k] = has_depth ? kernel::kSeen | kernel::kHasDepth : kernel::kSeen;
    }

    if (sums) {
      const Vector3f arm = X - q * about;
      const Vector3f turn = arm.cross(dr_dX);
      const float J[8] = {q * dr_dX.x(), q * dr_dX.y(), q * dr_dX.z(), turn.x(), turn.y(), turn.z(), -reference[k], -1};
      const float s2 = s2_intensity + extra;
      const float e = r / std::sqrt(s2);
      const float w = huber_weight(e, noise.huber) / s2;
      sums->cost += static_cast<double>(huber_cost(e, noise.huber));
      add(J, w, r, *sums);
      if (use_depth) {
        const float mode[3] = {1, (points.u[k] - u0) / u_half, (points.v[k] - v0) / v_half};
        for (std::size_t m = 0; m < 3; ++m)
          for (int c = 0; c < 8; ++c) sums->modes[m][c] += static_cast<double>(w * dr_dq * mode[m] * J[c]);
        if (has_depth && depth.weight > 0) {
          // r_depth = measured - q / Z~; the predicted q' = q / Z~ moves by -q' dZ~ / Z~.
          const float f = qi / X.z();
          const float Jq[8] = {0, 0, f * q, f * arm.y(), -f * arm.x(), 0, 0, 0};
          const float eq = r_depth / depth.sigma;
          const float wq = depth.weight * huber_weight(eq, noise.huber) / (depth.sigma * depth.sigma);
          add(Jq, wq, r_depth, *sums);
          sums->cost += static_cast<double>(depth.weight * huber_cost(eq, noise.huber));
          for (int c = 2; c < 5; ++c) sums->modes[3][c] += static_cast<double>(wq * Jq[c]);
        }
      }
    }
  }
  if (sums) {
    for (int c = 0; c < 8; ++c)
      for (int row = c + 1; row < 8; ++row) sums->H(c, row) = sums->H(row, c);
    sums->seen = seen;
    sums->inside = seen + sums->occluded;
    sums->cost = seen ? sums->cost / seen : 0;
  }
}

DOT_END_NAMESPACE
