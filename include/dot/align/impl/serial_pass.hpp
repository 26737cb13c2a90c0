// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "dot/align/photometric_factor.hpp"

/// @file
/// What SerialReduction does with each point, see align/impl/serial_reduction.hpp.

DOT_BEGIN_NAMESPACE

/// One pass of SerialReduction over the points, at one state. Borrows all arguments.
template <typename Camera>
class SerialPass {
 public:
  /// A point that is inside the image, and not hidden.
  struct Seen {
    Vector3<float> X;                 ///< X~, where it moves to
    float q;                          ///< its inverse depth there, 1/m: q / Z~
    float value;                      ///< I_i(p')
    bool has_depth;                   ///< whether its depth there was measured
    float r_depth;                    ///< measured minus predicted inverse depth, 1/m; 0 without measurement
    PhotometricFactor<float> factor;  ///< its residual
  };

  SerialPass(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
             const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth)
      : points_(points),
        level_(static_cast<std::size_t>(level)),
        camera_(camera),
        image_(image),
        noise_(noise),
        depth_(depth),
        R_(state.T.R.cast<float>()),
        t_(state.T.t.cast<float>()),
        gain_(static_cast<float>(state.gain)),
        factor_(state, noise.gradient_noise),
        to_depth_(std::ldexp(1.f, level - depth.level)),
        to_base_(std::ldexp(1.f, level)),
        u_end_(static_cast<float>(image.width() - 3)),
        v_end_(static_cast<float>(image.height() - 3)) {}

  /// Calls on_seen(k, Seen) or on_occluded(k) for the points inside the image that are not excluded.
  template <typename OnSeen, typename OnOccluded>
  void run(const std::uint8_t* excluded, OnSeen&& on_seen, OnOccluded&& on_occluded) const {
    Eigen::Matrix<float, 2, 3> J_pi;
    for (std::size_t k = 0, n = static_cast<std::size_t>(points_.size()); k < n; ++k) {
      if (excluded && excluded[k]) continue;
      Seen seen;
      Vector2<float> pixel;
      if (!move(k, seen, pixel, J_pi)) continue;
      if (!measure_depth(pixel, seen)) {
        on_occluded(k);
        continue;
      }
      const Sample s = sample_at(k, pixel, seen.X.z());
      seen.value = s.value;
      seen.factor = factor_(s, J_pi, points_.intensity[level_][k], points_.sigma_q[k]);
      on_seen(k, seen);
    }
  }

 private:
  /// Moves a point to the new camera. @return whether its place in the image can be sampled.
  bool move(std::size_t k, Seen& seen, Vector2<float>& pixel, Eigen::Matrix<float, 2, 3>& J_pi) const {
    const float q = points_.q[k];
    const Vector3<float> ray = R_ * Vector3<float>(points_.x[k], points_.y[k], 1.f);
    seen.X = ray + q * t_;
    if (seen.X.z() < 1e-3f) return false;
    seen.q = q / seen.X.z();
    pixel = camera_.template project<float>(seen.X, &J_pi);
    return pixel.x() >= 1 && pixel.y() >= 1 && pixel.x() < u_end_ && pixel.y() < v_end_;
  }

  /// Compares with the measured depth at the pixel. @return false if something nearer hides the point.
  bool measure_depth(const Vector2<float>& pixel, Seen& seen) const {
    seen.has_depth = false, seen.r_depth = 0;
    if (depth_.inverse_depth.data == nullptr) return true;
    const float left = pixel.x() + 0.5f, top = pixel.y() + 0.5f;  // distances from the image's edges
    const int u = static_cast<int>(left * to_depth_), v = static_cast<int>(top * to_depth_);
    if (!depth_.inverse_depth.contains(u, v)) return true;
    const float measured = depth_.inverse_depth(u, v);
    const float difference = measured - seen.q;
    const bool nearer = measured > 0 && difference > std::max(depth_.occlusion_relative * seen.q,
                                                              depth_.occlusion_sigmas * depth_.sigma);
    const bool occluded = depth_.occluders.data != nullptr &&
                          depth_.occluders(static_cast<int>(left * to_base_), static_cast<int>(top * to_base_));
    if (nearer || occluded) return false;
    if (measured > 0) seen.has_depth = true, seen.r_depth = difference;
    return true;
  }

  /// The image at a pixel, with the gradient to use.
  Sample sample_at(std::size_t k, const Vector2<float>& pixel, float z) const {
    Sample s = sample(image_, pixel.x(), pixel.y());
    if (noise_.gradient != GradientSource::Image) {
      // A small piece of surface appears 1 / Z~ times as large as in the reference, so its gradient is Z~ times as
      // large. Its rotation about the optical axis and its shear are neglected.
      const float scale = gain_ * z, own = noise_.gradient == GradientSource::Mean ? 0.5f : 0;
      s.gx = own * s.gx + (1 - own) * scale * points_.gu[level_][k];
      s.gy = own * s.gy + (1 - own) * scale * points_.gv[level_][k];
    }
    return s;
  }

  const PointSet& points_;
  std::size_t level_;
  const Camera& camera_;
  const Image<std::uint8_t>& image_;
  const ResidualNoise& noise_;
  const DepthTerm& depth_;
  Matrix3<float> R_;
  Vector3<float> t_;
  float gain_;
  PhotometricModel<float> factor_;
  float to_depth_, to_base_;  ///< from pixels of this level to those of the depth, and of level 0
  float u_end_, v_end_;       ///< least coordinates that cannot be sampled any more
};

DOT_END_NAMESPACE
