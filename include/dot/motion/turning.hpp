// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "dot/motion/estimate.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// The angular velocity of an object, if it turns: a Kalman filter over its fits. Intervals of fits overlap, and their
/// errors with them. So the filter takes only fits whose intervals do not overlap, and it keeps the state before the
/// last one. A new fit is compared with what fits of other times predict.
class Turning {
 public:
  static constexpr double kIndependentSeconds = 0.1;   ///< from here on errors of two fits are independent
  static constexpr double kAccelerationSeconds = 0.1;  ///< duration of an angular acceleration

  /// A state of the filter.
  struct Rate {
    Vector3<double> mean = Vector3<double>::Zero();        ///< rad/s, axes of the newest camera
    Matrix3<double> covariance = Matrix3<double>::Zero();  ///< zero: not known
    double age = 0;                                        ///< seconds from its last fit's end to the newest camera

    /// Whether it contains a fit.
    bool known() const { return covariance(0, 0) > 0; }
  };

  /// Predicts over `dt` seconds, in which the camera turned by R_cur_prev. @param sigma rad/s, of what turns; its
  /// angular acceleration is as much per second.
  void predict(double dt, const Matrix3<double>& R_cur_prev, double sigma) {
    for (Rate* rate : {&newest_, &before_}) {
      rate->age += dt;
      if (!rate->known()) continue;
      const Matrix3<double> grown =
          rate->covariance + sigma * sigma * kAccelerationSeconds * dt * Matrix3<double>::Identity();
      rate->mean = R_cur_prev * rate->mean;
      rate->covariance = R_cur_prev * grown * R_cur_prev.transpose();
    }
  }

  /// What the fits before the interval of a fit predict for it, in the axes of the filter; null: nothing.
  const Rate* before(const MotionEstimate& fit) const {
    for (const Rate* rate : {&newest_, &before_})
      if (rate->known() && ends_before(*rate, fit, fit.span_seconds)) return rate;
    return nullptr;
  }

  /// Updates by a fit in the axes of the filter. A fit that contradicts it starts it anew. @param sigma as for
  /// predict()
  void update(const MotionEstimate& fit, double sigma) {
    if (newest_.known() && !ends_before(newest_, fit, std::max(fit.span_seconds, kIndependentSeconds))) return;
    const Vector3<double>& w = fit.angular_velocity;
    const Matrix3<double>& W = fit.angular_covariance;
    before_ = newest_;
    const Vector3<double> error = w - newest_.mean;
    if (!newest_.known() || error.dot((W + newest_.covariance).ldlt().solve(error)) > chi2::k5SigmaOf1)
      newest_ = {Vector3<double>::Zero(), sigma * sigma * Matrix3<double>::Identity()};
    const Matrix3<double> K = newest_.covariance * (newest_.covariance + W).inverse();
    newest_.mean += K * (w - newest_.mean);
    const Matrix3<double> rest = newest_.covariance - K * newest_.covariance;
    newest_.covariance = 0.5 * (rest + rest.transpose());
    newest_.age = -frame_of(fit);
  }

  /// Whether all of it is finite.
  bool all_finite() const { return newest_.mean.allFinite() && newest_.covariance.allFinite(); }

 private:
  /// A fit ends a frame after the filter's camera, which is that of the fit's last but one image.
  static double frame_of(const MotionEstimate& fit) { return fit.span_seconds / fit.span_frames; }
  /// Whether the last fit in it ended so long before the end of this one. Timestamps are rounded.
  static bool ends_before(const Rate& rate, const MotionEstimate& fit, double seconds) {
    return rate.age + frame_of(fit) >= 0.999 * seconds;
  }

  Rate newest_, before_;
};

DOT_END_NAMESPACE
