// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "dot/motion/belief.hpp"
#include "dot/motion/state.hpp"

/// @file
/// Classifiers: policies that turn fits into states. A classifier is a struct with a nested `Memory`, default
/// constructible and copyable, one of which the pipeline keeps for each object, and
///
///     Decision operator()(Memory&, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double dt) const;
///
/// called once a frame for each object, with null where there was no fit. Velocities of the fit are in the previous
/// camera's axes, those of the decision in the current one's. An object that its first mask shows now is fitted to the
/// frame before and classified with that in the current camera's axes: R_cur_prev = 1 and dt = 0.

DOT_BEGIN_NAMESPACE

/// What a classifier says of an object.
struct Decision {
  State state = State::NotObservable;
  double p_moving = 0.5;
  Vector3<double> velocity = Vector3<double>::Zero();    ///< fused, m/s, axes of the current camera
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< zero where there is none
};

namespace classifier_concept {
template <typename T, typename = void>
inline constexpr bool holds_v = false;
template <typename T>
inline constexpr bool holds_v<
    T, std::enable_if_t<std::is_same_v<decltype(std::declval<const T&>()(std::declval<typename T::Memory&>(),
                                                                         std::declval<const MotionEstimate*>(),
                                                                         std::declval<const Matrix3<double>&>(), 0.1)),
                                       Decision>>> = true;
}  // namespace classifier_concept

/// Whether T satisfies the concept above.
template <typename T>
inline constexpr bool is_classifier_v = classifier_concept::holds_v<T>;

/// Default: is the centroid faster than v0? Belief over time, see Belief; won at `decide`, kept down to `keep`.
struct VelocityClassifier {
  VelocitySettings settings;

  struct Memory {
    Belief belief;
    State state = State::NotObservable;
  };

  /// v0 of an object at this range, m/s: near things count as moving at lower speeds.
  double v0(double range) const { return std::max(1e-3, std::min(settings.v0, settings.v0_per_metre * range)); }

  Decision operator()(Memory& m, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double dt) const {
    // The fit is in the previous camera's axes, like the belief before the step.
    if (fit) m.belief.update(*fit, v0(fit->range), settings);
    m.belief.predict(dt, R_cur_prev, settings);
    const double p = m.belief.p_moving();
    if (p > settings.decide || (m.state == State::Moving && p > settings.keep))
      m.state = State::Moving;
    else if (p < 1 - settings.decide || (m.state == State::Static && p < 1 - settings.keep))
      m.state = State::Static;
    else
      m.state = State::NotObservable;
    return {m.state, p, m.belief.velocity, m.belief.covariance};
  }
};

/// The velocity test of a single frame, without memory: moving if the 99 % ellipsoid of v excludes the ball
/// |v| <= v0, static if it lies inside. For comparison.
struct SingleFrameClassifier {
  VelocitySettings settings;
  struct Memory {};

  Decision operator()(Memory&, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double) const {
    if (!fit) return {};
    const double v0 = VelocityClassifier{settings}.v0(fit->range);
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(fit->covariance);
    const double k2 = 11.345;  // 99 % of a chi-square of three degrees
    Decision d{State::NotObservable, 0.5, R_cur_prev * fit->velocity,
               R_cur_prev * fit->covariance * R_cur_prev.transpose()};
    // Distance of the nearest point of the ball in the metric of the covariance, bounded below along v.
    const double speed = fit->velocity.norm();
    const double sigma2 = speed > 0 ? fit->velocity.dot(fit->covariance * fit->velocity) / (speed * speed) : 0;
    if (speed > v0 && (speed - v0) * (speed - v0) > k2 * sigma2) d.state = State::Moving, d.p_moving = 0.99;
    if (speed + std::sqrt(k2 * eigen.eigenvalues()[2]) < v0) d.state = State::Static, d.p_moving = 0.01;
    return d;
  }
};

/// The paper's rule (section 3.5), with the gate as H < H_max: a badly determined pose has *high* entropy, so the
/// printed condition H > H_min would reject the best observed objects first; `literal` applies it as printed.
/// Moving if d_d > f(H) = max(d_min, k d_noise).
struct EntropyClassifier {
  EntropySettings settings;
  bool literal = false;

  struct Memory {
    State state = State::NotObservable;
  };

  Decision operator()(Memory& m, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double) const {
    Decision d;
    const bool observable =
        fit && (literal ? fit->entropy > settings.min_entropy : fit->entropy < settings.max_entropy);
    // The paper keeps the last decision of what is not observable any more.
    if (observable)
      m.state = fit->disparity_px > std::max(settings.min_disparity, settings.noise_factor * fit->disparity_noise_px)
                    ? State::Moving
                    : State::Static;
    d.state = m.state;
    d.p_moving = d.state == State::Moving ? 1 : d.state == State::Static ? 0 : 0.5;
    if (fit) {
      d.velocity = R_cur_prev * fit->velocity;
      d.covariance = R_cur_prev * fit->covariance * R_cur_prev.transpose();
    }
    return d;
  }
};

DOT_END_NAMESPACE
