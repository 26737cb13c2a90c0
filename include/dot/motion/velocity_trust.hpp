// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Whether a velocity is known: once fits in a row agreed on it, and until as many in a row contradict it. One wrong
/// fit is no reason to give it up, and a wrong velocity must not shut out those that are right for good.
struct VelocityTrust {
  static constexpr int kFits = 3;
  int agreeing = 0;       ///< fits
  int contradicting = 0;  ///< of a velocity that is known, in a row

  bool known() const { return agreeing >= kFits; }

  /// A fit that was accepted. @return whether the velocity follows it; if not, it goes on as it was.
  bool accept(bool agrees) {
    if (!agrees && known()) refuse();
    if (!agrees && known()) return false;
    agreeing = agrees ? agreeing + 1 : 1;
    contradicting = 0;
    return true;
  }

  /// A fit that was refused for contradicting it.
  void refuse() {
    if (++contradicting >= kFits) agreeing = 0;
  }
};

DOT_END_NAMESPACE
