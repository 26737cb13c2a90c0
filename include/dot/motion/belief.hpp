// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "dot/motion/estimate.hpp"
#include "dot/motion/settings.hpp"
#include "dot/motion/velocity_trust.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Belief that an object moves, over time: the log odds of *moves* against *stands*, and a Kalman filter of the
/// velocity that the object has if it moves.
///
///     stands: v ~ N(0, V + (0.35 v0)^2)
///     moves:  v ~ N(m, P + V), the filter's prediction, mixed with a fresh prior of any velocity
///
/// The errors of real fits have tails: one in five is worse than its covariance says, by reflections, half hidden
/// outlines or a slope in the depth's error. So V stands for the mixture 0.8 V + 0.2 (6 V) in both. Both carry a small
/// share of a broad outlier class. The fresh prior is a mixture: slow and fast, in any direction, and along the
/// direction that the fit determines least. Without the last, an object whose sideways velocity is well measured and
/// zero would count as standing though it may well come straight towards the camera, as traffic does. What the prior
/// credits to speeds inside |v| <= v0 is taken away again: such an object does not move. A Bayes factor of proper
/// densities does not drift to *moves* where the velocity is poorly measured, which a ratio of maximum likelihoods
/// does.
///
/// Time counts, not frames. Fits of frames that follow each other closely share most of their errors: those of
/// kIndependentSeconds say together what one says, so that the same second gives the same belief at any frame rate.
/// Nothing that is not finite changes a belief.
struct Belief {
  static constexpr double kIndependentSeconds = 0.1;   ///< after which the errors of two fits are independent
  static constexpr double kAccelerationSeconds = 0.1;  ///< for which an acceleration lasts
  static constexpr double kDrift = 0.35;               ///< of v0: sigma of the velocity of what stands
  static constexpr double kFreshShare = 0.1;           ///< of a new velocity, beside the filter's prediction
  static constexpr double kFastVariance = 25;          ///< of motorway speeds, over that of ordinary ones
  static constexpr double kOutlierVariance = 36;       ///< of a wrong fit's velocity, over that of ordinary speeds

  double log_odds = 0;
  Vector3<double> velocity = Vector3<double>::Zero();    ///< if it moves; m/s, axes of the newest camera
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< zero: no filter yet
  VelocityTrust trust;                                   ///< in the filter

  double p_moving() const { return 1 / (1 + std::exp(-log_odds)); }
  bool has_velocity() const { return covariance(0, 0) > 0; }

  /// Lets time pass: things start and stop, velocities change, and the camera turned by R_cur_prev.
  void predict(double dt, const Matrix3<double>& R_cur_prev, const VelocitySettings& s);

  /// Weighs a velocity in the axes of the belief. @param v0 m/s, of the object's range.
  void update(const MotionEstimate& e, double v0, const VelocitySettings& s);

 private:
  static double sq(double x) { return x * x; }

  void weigh(const MotionEstimate& e, double v0, const VelocitySettings& s);
  static double density(const Vector3<double>& x, const Matrix3<double>& S);
  static double hypothesis(const Vector3<double>& v, const Matrix3<double>& V, const Vector3<double>& m,
                           const Matrix3<double>& S, double v0);
  static double inside(const Vector3<double>& mean, const Matrix3<double>& S, double v0);
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/motion/impl/belief.hpp"
#endif
