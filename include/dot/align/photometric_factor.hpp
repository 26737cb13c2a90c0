// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/align/align_state.hpp"
#include "dot/camera/concept.hpp"
#include "dot/image/pyramid.hpp"

DOT_BEGIN_NAMESPACE

/// The photometric residual of a point p (eq. 3), r = I_i(p') - a I_j(p) - b.
template <typename Scalar>
struct PhotometricFactor {
  Scalar r;                   ///< grey values
  Vector3<Scalar> dr_dpoint;  ///< derivative by the moved point X~
  Scalar dr_dq;               ///< by its inverse depth: dX~/dq = t
  Scalar extra;               ///< variance of r besides sigma_I^2: (dr/dq sigma_q)^2 + (gradient_noise |grad I|)^2
};

/// Computes the factors of points with the motion and the change of brightness of `state`.
template <typename Scalar>
class PhotometricModel {
 public:
  /// @param gradient_noise pixels, AlignSettings::gradient_noise.
  PhotometricModel(const AlignState& state, double gradient_noise)
      : t_(state.T.t.cast<Scalar>()),
        gain_(static_cast<Scalar>(state.gain)),
        offset_(static_cast<Scalar>(state.offset)),
        gradient_variance_(static_cast<Scalar>(gradient_noise) * static_cast<Scalar>(gradient_noise)) {}

  /// @param s the new image at p', with the gradient to use. @param J_pi of the projection at the moved point.
  /// @param reference I_j(p). @param sigma_q of the point's inverse depth, 1/m.
  PhotometricFactor<Scalar> operator()(const Sample& s, const Eigen::Matrix<float, 2, 3>& J_pi, Scalar reference,
                                       Scalar sigma_q) const {
    PhotometricFactor<Scalar> f;
    f.r = static_cast<Scalar>(s.value) - gain_ * reference - offset_;
    f.dr_dpoint = (J_pi.transpose() * Vector2<float>(s.gx, s.gy)).template cast<Scalar>();
    f.dr_dq = f.dr_dpoint.dot(t_);
    const Scalar by_depth = f.dr_dq * sigma_q;
    f.extra = by_depth * by_depth + gradient_variance_ * static_cast<Scalar>(s.gx * s.gx + s.gy * s.gy);
    return f;
  }

 private:
  Vector3<Scalar> t_;
  Scalar gain_, offset_, gradient_variance_;
};

DOT_END_NAMESPACE
