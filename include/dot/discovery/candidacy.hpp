// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/motion/classifier.hpp"
#include "dot/object_motion/belief.hpp"
#include "dot/object_motion/object_motion.hpp"

DOT_BEGIN_NAMESPACE

/// A discovered object is a candidate until its fits confirm that it moves. Candidates are not shown in the results.
struct Candidacy {
  static constexpr int kMost = 6;                      ///< candidates that are followed at a time
  static constexpr double kConfirmedSeconds = 0.05;    ///< seconds of agreeing fits after which a discovery is shown
  static constexpr double kMaxConfirmedSeconds = 0.5;  ///< upper limit of `confirmed`
  static constexpr double kMinSupport = 0.5;           ///< least support of an object that is shown
  static constexpr double kSupportSeconds = 0.3;       ///< time constant of the support
  static constexpr double kSeconds = 0.25;             ///< an unconfirmed candidate must be seen again within
  static constexpr double kTrialSeconds = 1;           ///< with fits, after which an unconfirmed candidate is rejected

  bool is_candidate = false;  ///< it does not count as moving now, and is not shown
  bool was_reported = false;  ///< it was shown before: results go on to name it, as hidden, until it is dropped
  double tried = 0;           ///< seconds with fits since it was last confirmed
  double confirmed = 0;       ///< seconds with fits that agreed with earlier ones, minus seconds with others
  bool is_examined = false;   ///< whether there was any evidence for `support`
  double support = 0;         ///< how sure it is that its pixels do not stand, 0 to 1; smoothed

  /// Whether its motion was confirmed for long enough to report it.
  bool was_confirmed() const { return confirmed >= kConfirmedSeconds; }
  /// Whether its motion was not confirmed for too long.
  bool has_failed() const { return is_candidate && tried > kTrialSeconds && !was_confirmed(); }

  /// Judges this frame's fit. Must be called before the belief takes the fit. A region that is not one rigid object, or
  /// that has repetitive texture, also gets a motion, but a different one each time. A fit confirms a motion if it
  /// excludes speeds up to v0 and agrees with the velocity fused so far, both at 99 %.
  /// @param dt seconds since the frame before.
  void confirm(const ObjectStep& step, const ObjectBelief& belief, const VelocitySettings& settings, double dt);

  /// Takes this frame's evidence that its pixels do not stand. The fits alone can be wrong for long, because a uniform
  /// wall correlates with itself when shifted.
  /// @param certainty 0 to 1. @param dt seconds since the frame before.
  void examine(double certainty, double dt) {
    support = is_examined ? support + (certainty - support) * std::min(1.0, dt / kSupportSeconds) : certainty;
    is_examined = true;
  }

  /// Decides whether it is shown: while its belief is *moving*, fits confirm it, and its pixels do not stand.
  void decide(State state) { is_candidate = state != State::Moving || support < kMinSupport || !was_confirmed(); }
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/discovery/impl/candidacy.hpp"
#endif
