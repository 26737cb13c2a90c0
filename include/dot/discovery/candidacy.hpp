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
  static constexpr double kConfirmedSeconds = 0.05;    ///< of fits that agree, from which on a discovery is shown
  static constexpr double kMaxConfirmedSeconds = 0.5;  ///< beyond which no more are counted
  static constexpr double kMinSupport = 0.15;          ///< of a discovered object, share of its mask
  static constexpr double kSupportSeconds = 0.3;       ///< over which it is smoothed
  static constexpr double kSeconds = 0.25;             ///< what was never confirmed must be seen again by then

  bool is_candidate = false;  ///< it does not count as moving at present, and is not shown
  double confirmed = 0;       ///< seconds with fits that agreed with the ones before, less those with others
  double support = 0;         ///< share of the mask that contradicts a standing scene; smoothed

  bool was_confirmed() const { return confirmed >= kConfirmedSeconds; }

  /// Weighs this frame's fit, before the belief does. A region that is not one rigid thing, or matches itself
  /// elsewhere, also finds a motion, but another one each time. A fit confirms when it excludes speeds up to v0 and
  /// agrees with the velocity fused so far, both at 99 %.
  /// @param dt seconds since the frame before.
  void confirm(const ObjectStep& step, const ObjectBelief& belief, const VelocitySettings& settings, double dt);

  /// Decides whether it is shown: while its belief is *moving* and the pixels under its mask go on contradicting a
  /// standing scene. The fits alone can be wrong for long: a wall that slides along itself correlates with itself.
  /// @param share of the mask that does so in this frame. @param dt seconds since the frame before.
  void decide(State state, double share, double dt) {
    support += (share - support) * std::min(1.0, dt / kSupportSeconds);
    is_candidate = state != State::Moving || support < kMinSupport || !was_confirmed();
  }
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/discovery/impl/candidacy.hpp"
#endif
