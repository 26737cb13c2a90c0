// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Quantiles of the chi-squared distribution. The squared Mahalanobis distance d' S^-1 d of n normal errors is below
/// the quantile with the given probability.

namespace dot::chi2 {

inline constexpr double k99Of3 = 11.345;    ///< 99 %, 3 degrees of freedom
inline constexpr double k3SigmaOf3 = 14.2;  ///< 99.73 %, the probability of three sigma of one error
inline constexpr double k5SigmaOf1 = 25;    ///< five sigma of one error; 99.998 % for 3 degrees of freedom
inline constexpr double k99999Of6 = 33.1;   ///< 99.999 %, 6 degrees of freedom
inline constexpr double k95Of7 = 14.07;     ///< 95 %, 7 degrees of freedom

}  // namespace dot::chi2
