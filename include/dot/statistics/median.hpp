// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <iterator>
#include <type_traits>

#include "dot/abi.hpp"
#include "dot/statistics/nth.hpp"

DOT_BEGIN_NAMESPACE

/// Standard deviation of a normal over the median of its absolute value.
inline constexpr double kSigmaOfMedian = 1.4826;

/// The value for which that share of the others is smaller, the lower one of two. The values are reordered.
/// @pre first != last, 0 <= share <= 1.
template <typename Iterator>
auto quantile(Iterator first, Iterator last, double share) {
  const auto nth = static_cast<std::ptrdiff_t>(share * static_cast<double>(std::distance(first, last) - 1));
  sort_nth(first, first + nth, last);
  return first[nth];
}

/// The middle value, the lower one of two. The values are reordered. @pre first != last.
template <typename Iterator>
auto lower_median(Iterator first, Iterator last) {
  return quantile(first, last, 0.5);
}

/// Range of the majority of some values.
template <typename Value>
struct Spread {
  Value low;     ///< quantile of .2
  Value middle;  ///< median
  Value high;    ///< quantile of .8
};

/// Computes the spread at little more than the cost of a median. The values are reordered: those below the middle come
/// first.
/// @pre first != last.
template <typename Iterator>
auto spread(Iterator first, Iterator last) {
  const auto at = [&](double share) {
    return first + static_cast<std::ptrdiff_t>(share * static_cast<double>(std::distance(first, last) - 1));
  };
  const Iterator low = at(0.2), middle = at(0.5), high = at(0.8);
  sort_nth(first, middle, last);
  sort_nth(first, low, middle);
  if (high != middle) sort_nth(middle + 1, high, last);
  return Spread<std::decay_t<decltype(*first)>>{*low, *middle, *high};
}

/// The middle value, the upper one of two. The values are reordered. @pre first != last.
template <typename Iterator>
auto median(Iterator first, Iterator last) {
  const auto half = std::distance(first, last) / 2;
  sort_nth(first, first + half, last);
  return first[half];
}

DOT_END_NAMESPACE
