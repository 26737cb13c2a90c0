// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "dot/motion/estimate.hpp"
#include "dot/motion/turning.hpp"

DOT_BEGIN_NAMESPACE

/// The error that fits to one reference share while the object stands: that of the reference's depth and image. With
/// R = kShare V, the part of a fit's covariance V that is the reference's, the fit measures
///
///     v = R^(1/2) x + e,   e ~ N(0, V - R)
///
/// where x ~ N(0, I) is the same in all fits to that reference. A reference is known by its age: the seconds that a fit
/// spans grow by one frame if the next fit has the same one.
class ReferenceError {
 public:
  /// R over V, from what stands in the development recordings: the mean product of successive errors, each over its
  /// sigma, is .36 with one reference and .11 with another (bench/error_correlation.py).
  static constexpr double kShare = 0.35;

  /// What the fits before tell of a fit's velocity if the object stands.
  struct Known {
    Vector3<double> error = Vector3<double>::Zero();  ///< mean, m/s
    Matrix3<double> less = Matrix3<double>::Zero();   ///< by which its covariance is smaller, (m/s)^2
  };

  /// Predicts over `dt` seconds, in which the camera turned by R_cur_prev.
  void predict(double dt, const Matrix3<double>& R_cur_prev) {
    if (age_ > 0) age_ += dt;
    x_ = R_cur_prev * x_;
    variance_ = R_cur_prev * variance_ * R_cur_prev.transpose();
  }

  /// For a fit in the axes of the belief. None if it has another reference than the last one.
  std::optional<Known> before(const MotionEstimate& fit) const {
    if (!is_last(fit)) return std::nullopt;
    const Matrix3<double> R = kShare * fit.covariance, root = square_root(R);
    return Known{root * x_, R - root * variance_ * root};
  }

  /// Updates by a fit in the axes of the belief. Fits in close succession share their own errors, too, see Turning.
  void update(const MotionEstimate& fit) {
    if (!is_last(fit)) x_.setZero(), variance_.setIdentity();
    age_ = fit.span_seconds;
    const double together = std::max(1.0, Turning::kIndependentSeconds * fit.span_frames / fit.span_seconds);
    const Matrix3<double> root = square_root(kShare * fit.covariance), C = variance_ * root;
    const Matrix3<double> K = C * (root * C + (1 - kShare) * together * fit.covariance).inverse();
    x_ += K * (fit.velocity - root * x_);
    const Matrix3<double> left = variance_ - K * C.transpose();
    variance_ = 0.5 * (left + left.transpose());
  }

  /// Whether all of it is finite.
  bool all_finite() const { return x_.allFinite() && variance_.allFinite(); }

 private:
  /// Timestamps are rounded.
  bool is_last(const MotionEstimate& fit) const {
    return age_ > 0 && std::abs(fit.span_seconds - age_) < 0.1 * fit.span_seconds / fit.span_frames;
  }
  static Matrix3<double> square_root(const Matrix3<double>& S) {
    return Eigen::SelfAdjointEigenSolver<Matrix3<double>>(S).operatorSqrt();
  }

  Vector3<double> x_ = Vector3<double>::Zero();             ///< mean
  Matrix3<double> variance_ = Matrix3<double>::Identity();  ///< of x
  double age_ = 0;                                          ///< of the last reference, seconds; 0: there is none
};

DOT_END_NAMESPACE
