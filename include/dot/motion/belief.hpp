// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "dot/motion/estimate.hpp"
#include "dot/motion/reference_error.hpp"
#include "dot/motion/settings.hpp"
#include "dot/motion/turning.hpp"
#include "dot/motion/velocity_trust.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Belief over time that an object moves: the log odds of *moves* against *stands*, and a Kalman filter of the velocity
/// under *moves*.
///
///     stands: v ~ N(b + d, V - D). The object's depth causes the error b ~ N(0, D), which lasts. Mostly d = 0. Or d
///             is a drift, N(0, (0.35 v0)^2), which is new in each fit, or which lasts
///     moves:  v ~ N(m, P + V), the filter's prediction, mixed with a fresh prior of any velocity
///
/// D is a share of what errors of the depth add to V (MotionEstimate::depth_covariance): 0.1, because other frames have
/// others. What the fits before say of an error that lasts, the next should say again. Without it, *moves* alone would
/// profit from a small wrong velocity that stays the same. Successive fits often have the same reference, and share its
/// error: under *stands* it is learnt, too (ReferenceError). The filter expects the usual accelerations, not the
/// largest. Otherwise *moves* would expect so many velocities that those of a slow mover are better explained by
/// standing.
///
/// The errors of real fits have heavy tails. One fit in five is worse than its covariance, because of reflections, half
/// hidden outlines or a slope in the depth's error. So V stands for the mixture 0.8 V + 0.2 (6 V) in both hypotheses.
/// Both include a small share of a broad outlier class. The fresh prior is a mixture: slow and fast, in any direction,
/// and along the direction that the fit determines least. Without the last part, an object whose sideways velocity is
/// precisely zero would count as standing although it may come straight towards the camera, as traffic does. The
/// prior's share of speeds |v| <= v0 is removed, because such an object does not move. If the velocity is poorly
/// measured, a ratio of maximum likelihoods drifts to *moves*. A Bayes factor of proper densities does not.
///
/// A rigid object may also turn on the spot. So *moves* consists of translating and of turning, with the probability
/// `p_turning` of the latter, which has a memory of its own:
///
///     moves : stands = (1 - p) B_v + p B_w (1 + B_v) / 2
///
/// B_v is the Bayes factor of the velocity above. B_w is that of the rotation: the speed that it gives to the points,
/// u = J^(1/2) w (MotionEstimate), is N(0, U) without turning. With turning it is predicted by the fits before
/// (Turning), mixed with a fresh N(0, U + prior_turn^2 J). An object that does not turn thus loses nothing by the
/// second hypothesis.
///
/// The belief depends on time, not on the number of frames. Fits of frames in close succession share most of their
/// errors. So the fits of kIndependentSeconds together count as one, and the belief is the same at any frame rate.
/// A doubtful fit that agrees with none before raises the probability to `decide` at most. Values that are not finite
/// do not change a belief.
struct Belief {
  /// From here on errors of two fits are independent.
  static constexpr double kIndependentSeconds = Turning::kIndependentSeconds;
  static constexpr double kAccelerationSeconds = 0.1;  ///< duration of an acceleration
  static constexpr double kPrior = 0.45;               ///< probability that an object moves of which nothing is known
  static constexpr double kDrift = 0.35;               ///< share of v0: velocity sigma of a drift under *stands*
  static constexpr double kTurnDrift = 0.1;            ///< the same of u, share of v0_per_square_metre times range^2
  static constexpr double kNewDrift = 0.15;            ///< share of fits under *stands* with a drift of their own
  static constexpr double kLastingDrift = 0.2;         ///< and of those with one that lasts
  static constexpr double kLastingDepth = 0.1;         ///< share of the variance of the object's depth error that lasts
  static constexpr double kOfReference = 0.5;          ///< share of fits that have the error learnt of their reference
  static constexpr double kFreshShare = 0.1;           ///< share of a new motion beside the prediction
  static constexpr double kFastVariance = 25;          ///< of motorway speeds, over ordinary speeds
  static constexpr double kOutlierVariance = 36;       ///< of a wrong fit's velocity, over ordinary speeds

  double log_odds = std::log(kPrior / (1 - kPrior));     ///< of *moves* over *stands*
  double p_turning = 0.01;                               ///< that it turns, if it moves
  Vector3<double> velocity = Vector3<double>::Zero();    ///< under *moves*; m/s, axes of the newest camera
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< zero: no filter yet
  VelocityTrust trust;                                   ///< in the filter
  double range = 0;                                      ///< of the last fit, metres
  Turning turning;                                       ///< its angular velocity, if it turns
  ReferenceError reference_error;                        ///< of the last fit, if it stands

  /// Probability that it moves, 0 to 1.
  double p_moving() const { return 1 / (1 + std::exp(-log_odds)); }
  /// Whether it was measured once, so that `velocity` means something.
  bool has_velocity() const { return covariance(0, 0) > 0; }

  /// Predicts over `dt` seconds: objects start and stop, velocities change, and the camera turned by R_cur_prev.
  void predict(double dt, const Matrix3<double>& R_cur_prev, const VelocitySettings& s);

  /// Updates by a velocity in the axes of the belief. @param v0 m/s, for the object's range.
  void update(const MotionEstimate& e, double v0, const VelocitySettings& s);

 private:
  /// A velocity and its error.
  struct Gaussian {
    Vector3<double> mean = Vector3<double>::Zero();        ///< m/s
    Matrix3<double> covariance = Matrix3<double>::Zero();  ///< (m/s)^2
  };

  static double sq(double x) { return x * x; }

  static constexpr double kLeastTurning = 0.001;          ///< least probability that it turns, if it moves
  static constexpr double kRounding = 1e-9;               ///< of log odds
  static constexpr double kTiny = 1e-300, kMost = 1e100;  ///< of a density and of a Bayes factor

  void weigh(const MotionEstimate& e, double v0, const VelocitySettings& s);
  double translates_or_stands(const MotionEstimate& e, double v0, double speed2, const VelocitySettings& s) const;
  double turns_or_not(const MotionEstimate& e, double v0, const VelocitySettings& s) const;
  bool agrees(const MotionEstimate& e) const;
  void filter(const MotionEstimate& e, double speed2);
  static double mixed(double expected, double fresh) { return (1 - kFreshShare) * expected + kFreshShare * fresh; }
  static Gaussian drift_given(const Gaussian& fits, const Matrix3<double>& D);
  static double density(const Vector3<double>& x, const Matrix3<double>& S);
  static double hypothesis(const Vector3<double>& v, const Matrix3<double>& V, const Vector3<double>& m,
                           const Matrix3<double>& S, double v0);
  static double inside(const Vector3<double>& mean, const Matrix3<double>& S, double v0);
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/motion/impl/belief.hpp"
#endif
