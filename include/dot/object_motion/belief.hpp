// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/motion/classifier.hpp"
#include "dot/motion/known_velocity.hpp"
#include "dot/motion/velocity_trust.hpp"
#include "dot/object_motion/fit.hpp"

DOT_BEGIN_NAMESPACE

/// The belief about one object's motion. `now` is the newest frame that the object was followed to.
struct ObjectBelief {
  bool always_dynamic = false;                             ///< the caller says that it moves, whatever is measured
  State state = State::NotObservable;                      ///< after that frame
  State last_decided = State::NotObservable;               ///< the last that was Static or Moving
  double p_moving = 0.5;                                   ///< probability that it moves, after that frame
  Vector3<double> velocity_now = Vector3<double>::Zero();  ///< fused, m/s, axes of that frame's camera
  Matrix3<double> velocity_covariance = Matrix3<double>::Zero();  ///< in the same axes; zero: no velocity
  VelocityTrust trust;                                            ///< in `velocity_now`
  double last_fit = 0;  ///< timestamp of the last fit that the velocity agrees with

  /// Compares a fit of the last interval, in the axes of `velocity_now`, with the velocity. Must be called before
  /// `adopt`.
  /// @param timestamp of the frame that the fit leads to. @param dt seconds since the frame before.
  void check_velocity(const ObjectFit& fit, double max_acceleration, double timestamp, double dt) {
    if (fit.ok()) {
      const KnownVelocity before{velocity_now, velocity_covariance, timestamp - last_fit};
      const bool agrees = has_velocity() && !before.contradicts(fit.motion, max_acceleration);
      if (trust.accept(agrees, dt)) last_fit = timestamp;
    } else if (fit.reason == Reason::Implausible) {
      trust.refuse(dt);
    }
  }

  /// Adopts the classifier's decision.
  void adopt(const Decision& d) {
    state = always_dynamic ? State::Moving : d.state;
    p_moving = always_dynamic ? 1 : d.p_moving;
    velocity_now = d.velocity;
    velocity_covariance = d.covariance;
    if (state != State::NotObservable) last_decided = state;
  }

  /// Takes the caller's word whether it moves, whatever is measured.
  void declare(bool moves) {
    always_dynamic = moves;
    if (moves) state = last_decided = State::Moving, p_moving = 1;
  }

  /// Forgets all that was measured. An object that the caller says moves goes on moving.
  void forget() {
    const bool moves = always_dynamic;
    *this = {};
    declare(moves);
  }

  /// Whether the classifier gives a velocity. Some classifiers give none after a frame without a fit.
  bool has_velocity() const { return velocity_covariance.trace() > 0; }

  /// Whether the velocity is known well enough to refuse a fit that contradicts it.
  bool knows_velocity() const { return trust.known() && !always_dynamic && has_velocity(); }

  /// m/s, axes of `now`. Zero unless the object more probably moves than stands.
  Vector3<double> expected_velocity() const {
    return state == State::Moving || p_moving > 0.5 ? velocity_now : Vector3<double>(Vector3<double>::Zero());
  }

  /// Its motion over the next interval at constant velocity: T_o, axes of `now`.
  SE3d expected_motion(double seconds) const { return SE3d::translation(expected_velocity() * seconds); }

  /// Whether it moves, and its velocity alone predicts its place to a tenth of `size`, metres (one standard deviation).
  bool dead_reckoning_is_reliable(double size, double timestamp) const {
    constexpr double kSmallShare = 0.1;
    return state == State::Moving && has_velocity() &&
           std::sqrt(velocity_covariance.trace()) * (timestamp - last_fit) < kSmallShare * size;
  }
};

DOT_END_NAMESPACE
