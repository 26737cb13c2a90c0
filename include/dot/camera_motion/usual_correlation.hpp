// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// The correlation of tracked intensities that the last intervals had. After a jolt the alignment from constant
/// velocity ends in a minimum nearby that correlates worse, though far better than the least that is accepted. The
/// highest correlation that the images' noise allows has not changed.
class UsualCorrelation {
 public:
  /// Whether an interval correlates so much worse than those before that its motion may be wrong.
  bool has_dropped(double phi) const { return 1 - phi > kDrop * std::max(kFloor, 1 - phi_); }

  /// Whether a motion leaves so much less unexplained than another that it is taken in its place.
  static bool is_much_better(double phi, double than) { return 1 - phi < (1 - than) / kBetter; }

  /// Takes the correlation of an interval. A lower one counts less: in rain or at dusk it becomes the usual one.
  void add(double phi) { phi_ = phi > phi_ ? phi : phi_ + kAdaption * (phi - phi_); }

 private:
  // Of 1 - phi, the share of the intensities' variance that is not explained.
  static constexpr double kDrop = 3;        ///< over the usual one; undisturbed recordings stay below it
  static constexpr double kFloor = 0.005;   ///< least usual one: among still images it is that of the noise alone
  static constexpr double kBetter = 2;      ///< over that of the better motion
  static constexpr double kAdaption = 0.1;  ///< per interval, to a lower correlation

  double phi_ = 0;  ///< Pearson correlation
};

DOT_END_NAMESPACE
