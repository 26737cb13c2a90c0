// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Whether a velocity is known: once fits in a row agreed on it for a while, and until others in a row contradict it
/// for as long. One wrong fit is no reason to give it up, and a wrong velocity must not shut out those that are right
/// for good.
class VelocityTrust {
 public:
  /// Seconds from the first fit of a row to the last: three fits at 10 Hz, as long at any other rate.
  static constexpr double kSeconds = 0.15;
  static constexpr int kFits = 2;  ///< of a row, at least

  bool known() const { return known_; }

  /// A fit that was accepted. @param dt seconds since the frame before.
  /// @return whether the velocity follows it; if not, it goes on as it was.
  bool accept(bool agrees, double dt) {
    if (!agrees && known_) refuse(dt);
    if (!agrees && known_) return false;
    agreeing_ = agrees ? agreeing_.next(dt) : Row{1, 0};
    contradicting_ = {};
    known_ = known_ || agreeing_.lasts();
    return true;
  }

  /// A fit that was refused for contradicting it. @param dt seconds since the frame before.
  void refuse(double dt) {
    contradicting_ = contradicting_.next(dt);
    if (!contradicting_.lasts()) return;
    agreeing_ = {};
    known_ = false;
  }

 private:
  /// Fits of one kind in a row.
  struct Row {
    int fits = 0;
    double seconds = 0;  ///< since the first
    Row next(double dt) const { return {fits + 1, fits > 0 ? seconds + dt : 0}; }
    bool lasts() const { return fits >= kFits && seconds >= kSeconds; }
  };
  Row agreeing_, contradicting_;
  bool known_ = false;
};

DOT_END_NAMESPACE
