// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/photometric_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dot/camera/pinhole.hpp"

namespace {

using dot::AlignState;
using dot::Sample;
using dot::Vector2;
using dot::Vector3;

/// A smooth image without an interpolation's own error: grey values and gradient anywhere.
Sample image(const Vector2<double>& p) {
  const double a = 0.05, b = 0.07;
  return {static_cast<float>(120 + 60 * std::sin(a * p.x()) * std::cos(b * p.y())),
          static_cast<float>(60 * a * std::cos(a * p.x()) * std::cos(b * p.y())),
          static_cast<float>(-60 * b * std::sin(a * p.x()) * std::sin(b * p.y()))};
}

class PhotometricFactor : public testing::Test {
 protected:
  const dot::Pinhole camera_{{300, 310, 160, 120, 320, 240, 0}};
  AlignState state_;
  const Vector3<double> ray_{0.2, -0.1, 1};
  static constexpr double kInverseDepth = 0.2, kReference = 90;

  void SetUp() override {
    state_.T = {dot::so3::exp(Vector3<double>(0.02, -0.05, 0.01)), Vector3<double>(0.3, -0.1, 0.4)};
    state_.gain = 1.1, state_.offset = -4;
  }
  Vector3<double> moved(double q) const { return state_.T.R * ray_ + q * state_.T.t; }
  double residual(const Vector3<double>& X) const {
    return static_cast<double>(image(camera_.project<double>(X)).value) - state_.gain * kReference - state_.offset;
  }
  dot::PhotometricFactor<double> factor(double sigma_q, double gradient_noise) const {
    const Vector3<float> X = moved(kInverseDepth).cast<float>();
    Eigen::Matrix<float, 2, 3> J_pi;
    const Vector2<float> p = camera_.project<float>(X, &J_pi);
    return dot::PhotometricModel<double>(state_, gradient_noise)(image(p.cast<double>()), J_pi, kReference, sigma_q);
  }
};

TEST_F(PhotometricFactor, DerivativesAreThoseOfTheResidual) {
  const auto f = factor(0, 0);
  const Vector3<double> X = moved(kInverseDepth);
  EXPECT_NEAR(f.r, residual(X), 1e-3);
  constexpr double h = 1e-3;  // grey values are floats
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> d = h * Vector3<double>::Unit(i);
    const double numeric = (residual(X + d) - residual(X - d)) / (2 * h);
    EXPECT_NEAR(f.dr_dpoint[i], numeric, 0.01 * f.dr_dpoint.norm()) << i;
  }
  const double numeric = (residual(moved(kInverseDepth + h)) - residual(moved(kInverseDepth - h))) / (2 * h);
  EXPECT_NEAR(f.dr_dq, numeric, 0.01 * std::abs(numeric));
}

TEST_F(PhotometricFactor, VarianceIsOfDepthAndOfGradient) {
  const double sigma_q = 0.01, noise = 0.06;
  const auto depth = factor(sigma_q, 0), gradient = factor(0, noise), both = factor(sigma_q, noise);
  EXPECT_NEAR(depth.extra, std::pow(depth.dr_dq * sigma_q, 2), 1e-9);
  const Sample s = image(camera_.project<double>(moved(kInverseDepth)));
  EXPECT_NEAR(gradient.extra, noise * noise * static_cast<double>(s.gx * s.gx + s.gy * s.gy), 1e-4);
  EXPECT_NEAR(both.extra, depth.extra + gradient.extra, 1e-9);
}

}  // namespace
