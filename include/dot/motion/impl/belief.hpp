// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

/// @file
/// Definitions of motion/belief.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE void Belief::predict(double dt, const Matrix3<double>& R_cur_prev, const VelocitySettings& s) {
  const double p = p_moving(), change = std::min(0.5, s.switch_rate * dt);
  const double q = p + 2 * change * (kPrior - p);
  log_odds = std::log(q / (1 - q));
  turning.predict(dt, R_cur_prev, s.prior_turn);
  reference_error.predict(dt, R_cur_prev);
  if (!has_velocity()) return;
  // Accelerations a last for tau, so the variance grows by a^2 tau per second.
  covariance += Matrix3<double>::Identity() * sq(s.usual_acceleration_at(range)) * kAccelerationSeconds * dt;
  velocity = R_cur_prev * velocity;
  covariance = R_cur_prev * covariance * R_cur_prev.transpose();
}

DOT_INLINE void Belief::update(const MotionEstimate& e, double v0, const VelocitySettings& s) {
  const bool has_interval = e.span_seconds > 0 && std::isfinite(e.span_seconds) && e.span_frames > 0;
  if (!has_interval || !std::isfinite(e.range) || !e.velocity.allFinite() || !e.angular_velocity.allFinite() ||
      !e.covariance.allFinite() || !e.depth_covariance.allFinite() || !e.angular_covariance.allFinite() ||
      !e.inertia.allFinite())
    return;
  Belief after = *this;
  after.weigh(e, v0, s);
  if (std::isfinite(after.log_odds) && after.velocity.allFinite() && after.covariance.allFinite() &&
      after.turning.all_finite() && after.reference_error.all_finite())
    *this = after;
}

DOT_INLINE void Belief::weigh(const MotionEstimate& e, double v0, const VelocitySettings& s) {
  // Fits over the same time carry the same information. So a fit over `span_seconds` counts only by its frame's share.
  const double frame = e.span_seconds / e.span_frames;
  const double share = std::min(1.0, frame / std::sqrt(kIndependentSeconds * e.span_seconds));
  const double speed2 = sq(std::max(v0, s.prior_speed_at(e.range)));
  double moves_or_stands = translates_or_stands(e, v0, speed2, s);
  if (e.inertia.trace() > 0 && s.most_turning > 0) {
    // What moves translates without turning, turns on the spot, or does both. What stands does not turn.
    const double turns = std::min(kMost, turns_or_not(e, v0, s) * (0.5 + 0.5 * moves_or_stands));
    moves_or_stands = (1 - p_turning) * moves_or_stands + p_turning * turns;
    p_turning = std::clamp(p_turning * std::pow(turns / moves_or_stands, share),
                           std::min(kLeastTurning, s.most_turning), s.most_turning);
    turning.update(e, s.prior_turn);
  }
  const double cap = std::min(s.max_evidence_rate * frame, s.max_evidence);
  const double evidence = share * std::log(moves_or_stands);
  const double before = log_odds, undecided = std::log(s.decide / (1 - s.decide)) - kRounding;
  log_odds = std::clamp(log_odds + std::clamp(evidence, -cap, cap), -s.max_log_odds, s.max_log_odds);
  if (e.is_doubtful && !agrees(e)) log_odds = std::min(log_odds, std::max(before, undecided));
  filter(e, speed2);
  reference_error.update(e);
}

/// Bayes factor of a velocity against standing.
DOT_INLINE double Belief::translates_or_stands(const MotionEstimate& e, double v0, double speed2,
                                               const VelocitySettings& s) const {
  const Vector3<double>& v = e.velocity;
  const Matrix3<double> V = e.covariance;
  const Matrix3<double> I = Matrix3<double>::Identity();
  const double outlier = s.outliers * density(v, V + kOutlierVariance * speed2 * I);

  const Vector3<double> zero = Vector3<double>::Zero();
  const Matrix3<double> drift = sq(kDrift * v0) * I;
  // Errors that last: those of the object's depth, D, and then a drift besides. The fits before tell of both.
  const Matrix3<double> D = kLastingDepth * e.depth_covariance;
  const Gaussian fits{velocity, covariance}, of_depth = drift_given(fits, D), lasting = drift_given(fits, D + drift);
  const Vector3<double> weakest = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(V).eigenvectors().col(2);
  const std::optional<ReferenceError::Known> known = reference_error.before(e);
  const auto standing = [&](const Matrix3<double>& S, const ReferenceError::Known& of_reference) {
    const Vector3<double> rest = v - of_reference.error;
    const Matrix3<double> own = S - of_reference.less - D, usual = own + of_depth.covariance;
    return kNewDrift * density(rest - of_depth.mean, usual + drift) +
           kLastingDrift * density(rest - lasting.mean, own + lasting.covariance) +
           (1 - kNewDrift - kLastingDrift) * density(rest - of_depth.mean, usual);
  };
  // Both hypotheses, with the errors of the covariance and with those of a bad fit.
  double stands = 0, moves = 0;
  for (const auto& [share, S] : {std::pair<double, Matrix3<double>>{1 - s.tail_share, V},
                                 std::pair<double, Matrix3<double>>{s.tail_share, s.tail_variance * V}}) {
    double still = density(v, S + drift);
    if (has_velocity()) {
      still = standing(S, {});
      if (known) still = (1 - kOfReference) * still + kOfReference * standing(S, *known);
    }
    stands += share * still;
    double fresh = 0;
    for (const double scale : {1.0, kFastVariance}) {
      const Matrix3<double> any = scale * speed2 * I;
      const Matrix3<double> along_weakest_axis = scale * speed2 * weakest * weakest.transpose() + sq(v0) * I;
      fresh += 0.25 * (hypothesis(v, S, zero, any, v0) + hypothesis(v, S, zero, along_weakest_axis, v0));
    }
    moves += share * (has_velocity() ? mixed(hypothesis(v, S, velocity, covariance, v0), fresh) : fresh);
  }
  stands = (1 - s.outliers) * stands + outlier;
  moves = (1 - s.outliers) * moves + outlier;
  return (moves + kTiny) / (stands + kTiny);
}

/// Bayes factor of an angular velocity against none. It compares the speeds that the turning gives to the points,
/// J^(1/2) w, because they have the units of v0. They are wrong by errors of the depth, which grow with the square of
/// the range without an end, and which stay: what does not turn is wrong by what the fits before say of this drift.
DOT_INLINE double Belief::turns_or_not(const MotionEstimate& e, double v0, const VelocitySettings& s) const {
  const Matrix3<double> L = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(e.inertia).operatorSqrt();
  const Vector3<double> u = L * e.angular_velocity;
  const Matrix3<double> U = L * e.angular_covariance * L;
  const Matrix3<double> drift =
      sq(kTurnDrift * s.v0_per_square_metre * e.range * e.range) * Matrix3<double>::Identity();
  const Matrix3<double> prior = sq(s.prior_turn) * e.inertia;
  const double outlier = s.outliers * density(u, U + drift + kOutlierVariance * prior);

  const Turning::Rate* predicted = turning.before(e);
  const Vector3<double> zero = Vector3<double>::Zero();
  Gaussian before, lasting;
  if (predicted) {
    before = {L * predicted->mean, L * predicted->covariance * L};
    lasting = drift_given(before, drift);
  }
  double turns = 0, not_turns = 0;
  for (const auto& [share, S] : {std::pair<double, Matrix3<double>>{1 - s.tail_share, U},
                                 std::pair<double, Matrix3<double>>{s.tail_share, s.tail_variance * U}}) {
    // Either hypothesis allows that the fits before were wrong.
    double still = density(u, S + drift), turn = hypothesis(u, S + drift, zero, prior, v0);
    if (predicted) {
      still = mixed(density(u - lasting.mean, S + lasting.covariance), still);
      turn = mixed(hypothesis(u, S + drift, before.mean, before.covariance, v0), turn);
    }
    not_turns += share * still;
    turns += share * turn;
  }
  return ((1 - s.outliers) * turns + outlier + kTiny) / ((1 - s.outliers) * not_turns + outlier + kTiny);
}

/// Whether there is a velocity, from which a fit differs by no more than their errors.
DOT_INLINE bool Belief::agrees(const MotionEstimate& e) const {
  const Vector3<double> d = e.velocity - velocity;
  return has_velocity() && d.dot((e.covariance + covariance).ldlt().solve(d)) <= chi2::k5SigmaOf1;
}

/// Kalman update of the velocity. The filter is restarted if fits contradict it.
DOT_INLINE void Belief::filter(const MotionEstimate& e, double speed2) {
  const Vector3<double>& v = e.velocity;
  const Matrix3<double> V = e.covariance;
  const Matrix3<double> I = Matrix3<double>::Identity();
  const double frame = e.span_seconds / e.span_frames;
  range = e.range;
  const bool expected = agrees(e);
  if (!trust.accept(expected, frame)) return;
  if (!expected) velocity.setZero(), covariance = kFastVariance * speed2 * I;
  const Matrix3<double> K = covariance * (covariance + std::max(1.0, kIndependentSeconds / frame) * V).inverse();
  velocity += K * (v - velocity);
  covariance = (I - K) * covariance;
  covariance = 0.5 * (covariance + covariance.transpose()).eval();
}

/// What fits tell of a drift of N(0, D): N(K m, D - K D), K = D (D + P)^-1. @param fits their mean m, wrong by N(0, P).
DOT_INLINE Belief::Gaussian Belief::drift_given(const Gaussian& fits, const Matrix3<double>& D) {
  const Matrix3<double> K = Matrix3<double>((D + fits.covariance).ldlt().solve(D)).transpose();  // zero without D
  return {K * fits.mean, D - K * D};
}

DOT_INLINE double Belief::density(const Vector3<double>& x, const Matrix3<double>& S) {
  const Eigen::LDLT<Matrix3<double>> ldlt(S);
  const double log_det = ldlt.vectorD().array().max(1e-300).log().sum();
  return std::exp(-0.5 * (x.dot(ldlt.solve(x)) + log_det + 3 * std::log(2 * 3.14159265358979323846)));
}

/// Density of v if the velocity is of N(m, S) and greater than v0: that of the Gaussian times
/// P(|velocity| > v0 | v) / P(|velocity| > v0). The ball is approximated by the cube of the same volume along the axes
/// of each covariance.
DOT_INLINE double Belief::hypothesis(const Vector3<double>& v, const Matrix3<double>& V, const Vector3<double>& m,
                                     const Matrix3<double>& S, double v0) {
  const Matrix3<double> K = S * (S + V).inverse();
  const double prior = 1 - inside(m, S, v0);
  const double posterior = 1 - inside(m + K * (v - m), S - K * S, v0);
  return density(v - m, V + S) * std::max(posterior, 1e-12) / std::max(prior, 1e-3);
}

DOT_INLINE double Belief::inside(const Vector3<double>& mean, const Matrix3<double>& S, double v0) {
  const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(S);
  const Vector3<double> c = eigen.eigenvectors().transpose() * mean;
  const double half = 0.806 * v0;
  double p = 1;
  for (int i = 0; i < 3; ++i) {
    const double sigma = std::sqrt(std::max(eigen.eigenvalues()[i], 1e-12)) * 1.41421356237309505;
    p *= 0.5 * (std::erf((half - c[i]) / sigma) - std::erf((-half - c[i]) / sigma));
  }
  return p;
}

DOT_END_NAMESPACE
