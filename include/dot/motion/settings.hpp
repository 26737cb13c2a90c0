// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace dot {

/// Which rule turns motion into a state.
enum class ClassifierKind : std::uint8_t {
  Velocity,       ///< belief over the velocities of the object's points (default)
  Entropy,        ///< the paper's rule, gate as H < H_max
  EntropyLiteral  ///< the paper's rule as printed, H > H_min; for comparison
};

/// The velocity test. Near objects are slow and precisely measured, far ones are vehicles. So some settings are limits
/// that are reached at some range, and less before.
struct VelocitySettings {
  double v0 = 0.5;  ///< m/s: faster objects count as moving
  /// 1/(m s): v0 of near objects is this times the square of their range. The depth's error, and with it a map's, grows
  /// in the same way.
  double v0_per_square_metre = 0.005;
  double photometric_scale = 3;            ///< largest inflation of Sigma_x: residuals of close points are correlated
  double rotation_scale = 3;               ///< further inflation of the rotation's covariance
  double floor = 0.03;                     ///< m/s per axis, smallest sigma
  double floor_per_square_metre = 0.0007;  ///< 1/(m s): the floor of near objects, likewise
  double decide = 0.90;                    ///< probability at which a state is reached
  double keep = 0.80;                      ///< probability down to which it is kept
  double switch_rate = 0.04;               ///< 1/s: how often objects start or stop moving
  double prior_speed = 6;                  ///< m/s per axis, sigma: speed of movers
  double prior_speed_per_metre = 0.6;      ///< 1/s: that of near movers is this times their range
  double prior_turn = 1;                   ///< rad/s per axis, sigma: angular velocity of movers that turn
  double most_turning = 0.5;               ///< largest probability that a mover turns; 0: turning is not looked at
  double acceleration = 3;                 ///< m/s^2, of movers
  double acceleration_per_metre = 0.8;     ///< 1/s^2: that of near movers, likewise; for the choice of references
  double tail_share = 0.2;                 ///< share of fits that are worse than their covariance
  double tail_variance = 6;                ///< variance of these, factor on their covariance
  double outliers = 0.02;                  ///< share of fits that are wrong
  double max_evidence_rate = 60;           ///< 1/s, log odds gained per time at most
  double max_evidence = 6;                 ///< log odds gained by one fit at most, because it may be wrong
  double max_log_odds = 6;  ///< the belief stays within this: an object's state can change in a bounded time

  /// v0 at a range in metres, m/s.
  double v0_at(double range) const { return std::max(1e-3, std::min(v0, v0_per_square_metre * range * range)); }
  /// `floor` at a range in metres, m/s.
  double floor_at(double range) const { return std::min(floor, floor_per_square_metre * range * range); }
  /// Share of `acceleration` that traffic mostly uses.
  static constexpr double kUsualShare = 0.3;
  /// Acceleration that movers mostly have at a range in metres, m/s^2. Hands, which move near things, use all of
  /// `acceleration`, traffic `kUsualShare`.
  double usual_acceleration_at(double range) const { return acceleration * std::clamp(5 / range, kUsualShare, 1.0); }
  /// `acceleration` at a range in metres, m/s^2.
  double acceleration_at(double range) const { return std::min(acceleration, acceleration_per_metre * range); }
  /// `prior_speed` at a range in metres, m/s.
  double prior_speed_at(double range) const { return std::min(prior_speed, prior_speed_per_metre * range); }
};

/// The paper's rule.
struct EntropySettings {
  double max_entropy = -14;    ///< nats: not observable above
  double min_entropy = -25;    ///< nats: the literal rule's bound
  double min_disparity = 1.0;  ///< px
  double noise_factor = 3;     ///< k in f(H) = max(d_min, k d_noise)
};

}  // namespace dot
