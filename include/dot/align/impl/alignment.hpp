// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

/// @file
/// Definitions of align/alignment.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE bool has_covariance(const Alignment& a) {
  return a.covariance.allFinite() &&
         Eigen::LLT<Matrix6<double>>(a.covariance.topLeftCorner<6, 6>()).info() == Eigen::Success;
}

DOT_END_NAMESPACE
