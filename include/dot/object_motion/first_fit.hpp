// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "dot/motion/settings.hpp"
#include "dot/object_motion/fit.hpp"

DOT_BEGIN_NAMESPACE

/// How far the first fit of an object is trusted. No expected motion leads it, so it may end in a wrong minimum. A
/// wrong one correlates worse than most right ones. The fit in the other direction hardly ever ends in the same wrong
/// minimum.
struct FirstFit {
  static constexpr double kSurePhi = 0.95;  ///< Pearson correlation from which on it needs no other
  static constexpr double kMostTurn = 3;    ///< sigmas of the prior's rotation that a right one seldom exceeds

  /// Whether nothing speaks against it.
  static bool is_sure(const ObjectFit& first) { return first.phi >= kSurePhi; }

  /// Whether it may be wrong: it is not sure, another minimum costs less or it turns faster than things mostly do, and
  /// the fit of the same interval in the other direction, given forwards, does not agree.
  static bool is_doubtful(const ObjectFit& first, const std::optional<ObjectFit>& backwards,
                          const MotionPriorSettings& prior);
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/object_motion/impl/first_fit.hpp"
#endif
