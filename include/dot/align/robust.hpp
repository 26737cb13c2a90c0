// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "dot/abi.hpp"
#include "dot/image/buffer.hpp"
#include "dot/kernel/impl/tukey.hpp"
#include "dot/kernel/lanes.hpp"
#include "dot/statistics/median.hpp"

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

/// Tukey's biweight cost, c^2/6 (1 - (1 - (e/c)^2)^3), constant beyond c. Large outliers cost no more than other
/// outliers, so a minority that agrees perfectly cannot outweigh a majority (Beaton and Tukey 1974).
inline float tukey_cost(float e, float c) {
  const float s = e / c;
  if (std::abs(s) >= 1) return c * c / 6;
  const float k = 1 - s * s;
  return c * c / 6 * (1 - k * k * k);
}

/// Tukey's cost of each of `n` residuals r with the variances s2 + extra.
inline void tukey_costs(const float* r, const float* extra, std::size_t n, float s2, float c, float* costs) {
  using Lanes = PortableLanes;
  constexpr std::size_t W = Lanes::W;
  const Lanes::F one = Lanes::set(1), sigma2 = Lanes::set(s2), most = Lanes::set(c * c / 6);
  std::size_t i = 0;
  for (; i + W <= n; i += W) {
    const Lanes::F v = Lanes::add(sigma2, Lanes::load(extra + i));
    const Lanes::F kept = kernel::tukey_kept<Lanes>(Lanes::load(r + i), v, c);
    Lanes::store(costs + i, Lanes::mul(most, Lanes::sub(one, kept)));
  }
  for (; i < n; ++i) costs[i] = tukey_cost(r[i] / std::sqrt(s2 + extra[i]), c);
}

/// The median of values >= 0, the upper of the two middle ones; 0 if there are none. `values` is reordered or
/// shortened.
///
/// The bits of such floats are in the order of their values. The values are counted by their leading bits (eight bins
/// an octave), so that only the few values of one bin must be sorted.
inline float median_of_magnitudes(Buffer<float>& values) {
  if (values.empty()) return 0;
  std::size_t rank = values.size() / 2;
  if (values.size() > 100) {
    constexpr std::size_t kBins = 1 << 11, kGroup = 1 << 5;
    const auto bin_of = [](float value) {
      std::uint32_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      return (bits >> 20) & (kBins - 1);
    };
    std::array<std::uint32_t, kBins> counts{};
    std::array<std::uint32_t, kBins / kGroup> groups{};
    for (const float value : values) ++counts[bin_of(value)], ++groups[bin_of(value) / kGroup];
    std::uint32_t bin = 0;
    for (std::uint32_t g = 0; rank >= groups[g]; bin += kGroup) rank -= groups[g++];
    while (rank >= counts[bin]) rank -= counts[bin++];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const float value = values[i];
      values[kept] = value;
      kept += bin_of(value) == bin;
    }
    values.resize(kept);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Standard deviation from the median absolute residual about zero. `scratch` is reordered or shortened.
inline float mad_sigma(Buffer<float>& scratch) {
  return static_cast<float>(kSigmaOfMedian) * median_of_magnitudes(scratch);
}

DOT_END_NAMESPACE
