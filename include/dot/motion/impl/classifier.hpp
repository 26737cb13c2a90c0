// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

/// @file
/// Definitions of motion/classifier.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE Decision VelocityClassifier::operator()(Memory& m, const MotionEstimate* fit,
                                                   const Matrix3<double>& R_cur_prev, double dt) const {
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

DOT_INLINE Decision SingleFrameClassifier::operator()(Memory&, const MotionEstimate* fit,
                                                      const Matrix3<double>& R_cur_prev, double) const {
  if (!fit) return {};
  const double v0 = VelocityClassifier{settings}.v0(fit->range);
  const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(fit->covariance);
  const double k2 = chi2::k99Of3;
  Decision d{State::NotObservable, 0.5, R_cur_prev * fit->velocity,
             R_cur_prev * fit->covariance * R_cur_prev.transpose()};
  // Lower bound, along v, of the distance of the ball's nearest point in the metric of the covariance.
  const double speed = fit->velocity.norm();
  const double sigma2 = speed > 0 ? fit->velocity.dot(fit->covariance * fit->velocity) / (speed * speed) : 0;
  if (speed > v0 && (speed - v0) * (speed - v0) > k2 * sigma2) d.state = State::Moving, d.p_moving = 0.99;
  if (speed + std::sqrt(k2 * eigen.eigenvalues()[2]) < v0) d.state = State::Static, d.p_moving = 0.01;
  return d;
}

DOT_INLINE Decision EntropyClassifier::operator()(Memory& m, const MotionEstimate* fit,
                                                  const Matrix3<double>& R_cur_prev, double) const {
  Decision d;
  const bool observable = fit && (literal ? fit->entropy > settings.min_entropy : fit->entropy < settings.max_entropy);
  // The paper keeps the last decision for objects that are not observable any more.
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

DOT_END_NAMESPACE
