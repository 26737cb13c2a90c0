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

DOT_INLINE void DepthBiasLearning::add(const Sums& sums, const DepthBias& taken) {
  const Eigen::Matrix<double, kPose, 1> g_pose = sums.col(kPose + kTerms).head<kPose>();
  const Terms g = sums.col(kPose + kTerms).segment<kTerms>(kPose);
  Matrix8 pose = sums.topLeftCorner<kPose, kPose>();
  pose.diagonal() += 1e-7 * pose.diagonal() + Vector8::Constant(1e-9);
  const Eigen::LDLT<Matrix8> solver(pose);
  const Eigen::Matrix<double, kPose, kTerms> mixed = sums.block<kPose, kTerms>(0, kPose);
  const Eigen::Matrix<double, kTerms, kPose> eliminate = solver.solve(mixed).transpose();
  const Information information = (sums.block<kTerms, kTerms>(kPose, kPose) - eliminate * mixed) / kCorrelated;
  const Terms step = (eliminate * g_pose - g) / kCorrelated;
  if (!information.allFinite() || !step.allFinite()) return;
  information_ += information;
  weighted_ += step + information * taken.coefficients;
}

DOT_END_NAMESPACE
