// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Whether a velocity is known. It becomes known when consecutive fits agree on it for a while, and unknown when
/// consecutive fits contradict it for as long. So one wrong fit does not discard it, and a wrong velocity does not
/// refuse correct fits forever.
class VelocityTrust {
 public:
  /// Seconds from the first fit of a row to the last: three fits at 10 Hz, the same time at any other rate.
  static constexpr double kSeconds = 0.15;
  static constexpr int kFits = 2;  ///< least number in a row

  /// Whether the velocity is known well enough to be used.
  bool known() const { return known_; }

  /// Counts an accepted fit. @param dt seconds since the frame before.
  /// @return whether the fit may update the velocity. If not, the velocity is kept.
  bool accept(bool agrees, double dt) {
    if (!agrees && known_) refuse(dt);
    if (!agrees && known_) return false;
    agreeing_ = agrees ? agreeing_.next(dt) : Row{1, 0};
    contradicting_ = {};
    known_ = known_ || agreeing_.lasts();
    return true;
  }

  /// Counts a fit that was refused because it contradicts the velocity. @param dt seconds since the frame before.
  void refuse(double dt) {
    contradicting_ = contradicting_.next(dt);
    if (!contradicting_.lasts()) return;
    agreeing_ = {};
    known_ = false;
  }

 private:
  /// Consecutive fits of one kind.
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
