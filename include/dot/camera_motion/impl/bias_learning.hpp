// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

/// @file
/// Definitions of camera_motion/bias_learning.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE DepthBias DepthBiasLearning::bias() const {
  DepthBias out;
  if (!(prior > 0)) return out;
  const Information total = information_ + Information::Identity() / (prior * prior);
  out.coefficients = total.ldlt().solve(weighted_);
  const double size = out.coefficients.dot(weighted_);
  out.coefficients *= size > chi2::k95Of7 ? 1 - chi2::k95Of7 / size : 0;
  return out;
}

DOT_INLINE double DepthBiasLearning::Variation::share_of_noise() const {
  const Information terms = sums_.topLeftCorner<kTerms, kTerms>();
  const Terms mixed = sums_.topRightCorner<kTerms, 1>();
  const double variation = sums_(kTerms, kTerms) - mixed.dot(Eigen::LDLT<Information>(terms).solve(mixed));
  return variation > noise_ ? noise_ / variation : 1;
}

DOT_INLINE void DepthBiasLearning::add(const ResidualSums<kTerms>& sums, const DepthBias& taken) {
  const auto marginal = sums.marginal();
  const Information information = marginal.information / kCorrelated;
  const Terms step = marginal.weighted / kCorrelated;
  if (!information.allFinite() || !step.allFinite()) return;
  information_ += information;
  weighted_ += step + information * taken.coefficients;
}

DOT_END_NAMESPACE
