// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Weight of Huber's cost at e (residual over sigma): 1 inside c, c / |e| beyond.
inline float huber_weight(float e, float c) {
  const float a = std::abs(e);
  return a <= c ? 1 : c / a;
}

/// Huber's cost, quadratic inside c and linear beyond; equals e^2 / 2 near zero.
inline float huber_cost(float e, float c) {
  const float a = std::abs(e);
  return a <= c ? 0.5f * a * a : c * (a - 0.5f * c);
}

/// Tukey's biweight cost, c^2/6 (1 - (1 - (e/c)^2)^3), constant beyond c: what is far off weighs no more than what is
/// off, so a minority that agrees perfectly cannot outvote a majority (Beaton and Tukey 1974).
inline float tukey_cost(float e, float c) {
  const float s = e / c;
  if (std::abs(s) >= 1) return c * c / 6;
  const float k = 1 - s * s;
  return c * c / 6 * (1 - k * k * k);
}

/// Standard deviation from the median absolute residual about zero. `scratch` is reordered.
inline float mad_sigma(std::vector<float>& scratch) {
  if (scratch.empty()) return 0;
  const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
  std::nth_element(scratch.begin(), middle, scratch.end());
  return 1.4826f * *middle;
}

DOT_END_NAMESPACE
