// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/motion/classifier.hpp"
#include "dot/motion/known_velocity.hpp"
#include "dot/motion/velocity_trust.hpp"
#include "dot/object_motion/fit.hpp"

DOT_BEGIN_NAMESPACE

/// What is believed of one object's motion. `now` is the newest frame that it was followed to.
struct ObjectBelief {
  bool always_dynamic = false;  ///< said to move, whatever is measured
  State state = State::NotObservable;
  State last_decided = State::NotObservable;  ///< the last that was Static or Moving
  double p_moving = 0.5;
  Vector3<double> velocity_now = Vector3<double>::Zero();         ///< fused, m/s, axes of that frame's camera
  Matrix3<double> velocity_covariance = Matrix3<double>::Zero();  ///< in the same axes; zero: no velocity
  VelocityTrust trust;                                            ///< in that velocity
  double last_fit = 0;                                            ///< timestamp of the last that it follows

  /// Holds a fit of the last interval, in the axes of `velocity_now`, against the velocity: before `take`.
  /// @param timestamp of the frame that the fit leads to. @param dt seconds since the one before.
  void check_velocity(const ObjectFit& fit, double max_acceleration, double timestamp, double dt) {
    if (fit.ok()) {
      const KnownVelocity before{velocity_now, velocity_covariance, timestamp - last_fit};
      const bool agrees = has_velocity() && !before.contradicts(fit.motion, max_acceleration);
      if (trust.accept(agrees, dt)) last_fit = timestamp;
    } else if (fit.reason == Reason::Implausible) {
      trust.refuse(dt);
    }
  }

  /// Takes over what the classifier says.
  void take(const Decision& d) {
    state = always_dynamic ? State::Moving : d.state;
    p_moving = always_dynamic ? 1 : d.p_moving;
    velocity_now = d.velocity;
    velocity_covariance = d.covariance;
    if (state != State::NotObservable) last_decided = state;
  }

  /// Whether the classifier tells a velocity; some have none after a frame without a fit.
  bool has_velocity() const { return velocity_covariance.trace() > 0; }

  /// Whether it is known well enough to hold a fit against it.
  bool knows_velocity() const { return trust.known() && !always_dynamic && has_velocity(); }

  /// m/s, axes of `now`; zero unless it rather moves than stands.
  Vector3<double> expected_velocity() const {
    return state == State::Moving || p_moving > 0.5 ? velocity_now : Vector3<double>(Vector3<double>::Zero());
  }

  /// Its motion over the next interval at constant velocity: T_o, axes of `now`.
  SE3d expected_motion(double seconds) const { return SE3d::translation(expected_velocity() * seconds); }

  /// Whether it moves, and by its velocity alone would now be where it is but for a tenth of its size, metres.
  bool dead_reckoning_is_reliable(double size, double timestamp) const {
    constexpr double kSmallShare = 0.1;
    return state == State::Moving && has_velocity() &&
           std::sqrt(velocity_covariance.trace()) * (timestamp - last_fit) < kSmallShare * size;
  }
};

DOT_END_NAMESPACE
