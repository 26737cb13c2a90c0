// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dot/align/robust.hpp"
#include "dot/camera/pinhole.hpp"
#include "dot/camera/radtan.hpp"
#include "support/numeric_jacobian.hpp"

namespace {

using dot::AlignState;
using dot::DepthTerm;
using dot::Image;
using dot::Matrix8;
using dot::NormalEquations;
using dot::PointResiduals;
using dot::PointSet;
using dot::ResidualNoise;
using dot::SE3d;
using dot::SerialReduction;
using dot::Vector2;
using dot::Vector6;
using dot::Vector8;
using dot::test::matrices_match;
using dot::test::numeric_jacobian;

/// A ramp, on which interpolated values and gradients are exact everywhere: what remains is the geometry.
Image<std::uint8_t> ramp() {
  Image<std::uint8_t> image(96, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 96; ++x) image(x, y) = static_cast<std::uint8_t>(10 + x + 2 * y);
  return image;
}

const dot::Intrinsics intrinsics{90, 85, 46, 33, 96, 64, 0};
const dot::Pinhole pinhole(intrinsics);
const dot::RadTan radtan(intrinsics, {-0.2, 0.06, 0.004, -0.003, 0.01});
// Nothing is beyond Huber's bound and nothing but sigma_I and sigma_q adds variance.
const ResidualNoise plain{5, 0, 1e6f};

/// Motion at which derivatives are taken; not small, so that their frame matters.
const SE3d motion = SE3d::exp((Vector6<double>() << 0.08, -0.05, 0.12, 0.03, -0.04, 0.15).finished());

AlignState moved(const AlignState& state, const Vector8& x) {
  return {SE3d::exp(x.head<6>()) * state.T, state.gain + x[6], state.offset + x[7]};
}

/// Residuals and normal equations at a state.
template <typename Camera>
NormalEquations linearize(const PointSet& points, const Camera& camera, const Image<std::uint8_t>& image,
                          const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                          PointResiduals& out) {
  SerialReduction::residuals(points, 0, camera, image, state, noise, depth, out);
  return SerialReduction::linearize(points, 0, camera, image, state, noise, depth, nullptr);
}

template <typename Camera>
PointSet one_point(const Camera& camera, float u, float v, float q, float intensity) {
  PointSet points;
  const auto ray = camera.unproject(Vector2<float>(u, v));
  points.push(u, v, ray.x(), ray.y(), q, 0.01f);
  points.levels = 1;
  points.intensity[0] = {intensity};
  return points;
}

template <typename Camera>
class ReductionOf : public ::testing::Test {
 public:
  static const Camera& camera() {
    if constexpr (std::is_same_v<Camera, dot::Pinhole>)
      return pinhole;
    else
      return radtan;
  }
  /// Calls visit(points) for single points over the image, near and far.
  template <typename Visit>
  static void for_points(Visit&& visit) {
    for (const float q : {0.05f, 0.25f, 1.f})
      for (float v = 14; v < 56; v += 13)
        for (float u = 16; u < 86; u += 17) visit(one_point(camera(), u, v, q, 40 + 0.5f * u));
  }
};
using Cameras = ::testing::Types<dot::Pinhole, dot::RadTan>;
TYPED_TEST_SUITE(ReductionOf, Cameras);

TYPED_TEST(ReductionOf, PhotometricDerivativesAreThoseOfTheResidual) {
  const Image<std::uint8_t> image = ramp();
  const AlignState state{motion, 1.1, -3};
  int checked = 0;
  this->for_points([&](const PointSet& points) {
    PointResiduals out;
    const auto residual = [&](const Vector8& x) {
      SerialReduction::residuals(points, 0, this->camera(), image, moved(state, x), plain, {}, out);
      return Eigen::Matrix<double, 1, 1>(static_cast<double>(out.r[0]));
    };
    const NormalEquations sums = linearize(points, this->camera(), image, state, plain, {}, out);
    if (!sums.seen) return;
    ++checked;
    const double r = static_cast<double>(out.r[0]);
    // r falls by one with the offset, so the last entry of H is the weight, and the last row is -weight J.
    const double weight = sums.H(7, 7);
    EXPECT_NEAR(weight, 1 / (25 + static_cast<double>(out.extra[0])), 1e-6);
    const Vector8 J = -sums.H.col(7) / weight;
    // Steps of a hundredth are a pixel or so; the residual is float.
    const auto numeric = numeric_jacobian<1>(residual, Vector8(Vector8::Zero()), 2e-3);
    EXPECT_TRUE(matrices_match(J, Vector8(numeric.transpose()), 2e-3));
    EXPECT_TRUE(matrices_match(sums.g, Vector8(weight * r * J), 1e-5));
    EXPECT_TRUE(matrices_match(sums.H, Matrix8(weight * J * J.transpose()), 1e-5));
    EXPECT_NEAR(sums.cost, 0.5 * weight * r * r, 1e-4 * sums.cost);
  });
  EXPECT_GT(checked, 30);
}

TYPED_TEST(ReductionOf, DepthErrorEntersByItsDerivative) {
  const Image<std::uint8_t> image = ramp();
  const AlignState state{motion, 1, 0};
  Image<float> nothing(96, 64);
  nothing.fill(0);
  DepthTerm depth;  // present, without a measurement: it makes the error modes be summed
  depth.inverse_depth = nothing.view();
  int checked = 0;
  this->for_points([&](const PointSet& points) {
    PointResiduals out;
    const auto residual = [&](const Eigen::Matrix<double, 1, 1>& dq) {
      PointSet changed = points;
      changed.q[0] += static_cast<float>(dq[0]);
      SerialReduction::residuals(changed, 0, this->camera(), image, state, plain, depth, out);
      return Eigen::Matrix<double, 1, 1>(static_cast<double>(out.r[0]));
    };
    const NormalEquations sums = linearize(points, this->camera(), image, state, plain, depth, out);
    if (!sums.seen) return;
    ++checked;
    const double extra = static_cast<double>(out.extra[0]);
    const double dr_dq = numeric_jacobian<1>(residual, Eigen::Matrix<double, 1, 1>(0.0), 5e-3)(0, 0);
    const double scale = std::max(1.0, std::abs(dr_dq));
    EXPECT_NEAR(std::sqrt(extra) / 0.01, std::abs(dr_dq), 5e-3 * scale);
    // The mode "all depths too large by one" is w J dr/dq, and J[7] = -1.
    EXPECT_NEAR(-sums.modes[0][7] / sums.H(7, 7), dr_dq, 5e-3 * scale);
    EXPECT_TRUE(matrices_match(sums.modes[0], Vector8(-dr_dq * sums.H.col(7)), 5e-3));
  });
  EXPECT_GT(checked, 30);
}

TYPED_TEST(ReductionOf, DepthResidualHasItsDerivatives) {
  const Image<std::uint8_t> image = ramp();
  const AlignState state{motion, 1, 0};
  int checked = 0;
  this->for_points([&](const PointSet& points) {
    Image<float> measured(96, 64);
    measured.fill(0.95f * points.q[0]);
    DepthTerm depth;
    depth.inverse_depth = measured.view();
    depth.sigma = 0.1f * points.q[0];
    depth.weight = 0.3f;
    depth.occlusion_relative = 10;
    DepthTerm without = depth;
    without.weight = 0;
    PointResiduals out;
    const auto residual = [&](const Vector6<double>& x) {
      const AlignState at{SE3d::exp(x) * state.T, 1, 0};
      SerialReduction::residuals(points, 0, this->camera(), image, at, plain, depth, out);
      return Eigen::Matrix<double, 1, 1>(static_cast<double>(out.r_depth[0] / points.q[0]));
    };
    const NormalEquations photometric = linearize(points, this->camera(), image, state, plain, without, out);
    const NormalEquations both = linearize(points, this->camera(), image, state, plain, depth, out);
    if (!both.seen) return;
    ++checked;
    ASSERT_TRUE(out.has_depth(0));
    // Predicted is q / (T X).z of the point's homogeneous form.
    const double q = static_cast<double>(points.q[0]);
    const dot::Vector3<double> X = motion * dot::Vector3<double>(points.x[0] / q, points.y[0] / q, 1 / q);
    EXPECT_NEAR(out.r_depth[0], 0.95 * q - 1 / X.z(), 1e-5);
    // In units of q, so that far points are as well conditioned as near ones.
    const double w = 0.3 / (0.1 * 0.1), r = static_cast<double>(out.r_depth[0]) / q;
    const Vector6<double> J = numeric_jacobian<1>(residual, Vector6<double>(Vector6<double>::Zero()), 2e-3).transpose();
    const Vector8 g = both.g - photometric.g;
    const Matrix8 H = both.H - photometric.H;
    EXPECT_TRUE(matrices_match(g.head<6>(), Vector6<double>(w * r * J), 3e-3));
    EXPECT_TRUE(matrices_match(H.topLeftCorner<6, 6>(), dot::Matrix6<double>(w * J * J.transpose()), 3e-3));
    EXPECT_EQ(g.tail<2>().norm(), 0);
    EXPECT_EQ(H.bottomRows<2>().norm(), 0);
    EXPECT_NEAR(both.cost - photometric.cost, 0.5 * w * r * r, 1e-3);
    // A change of the depth error between the frames adds to the residual as it is (here in 1/m).
    EXPECT_TRUE(matrices_match(both.modes[3].head<6>(), Vector6<double>(w * J / q), 3e-3));
  });
  EXPECT_GT(checked, 30);
}

TYPED_TEST(ReductionOf, TwistMayBeAboutAnyPoint) {
  const Image<std::uint8_t> image = ramp();
  const AlignState state{motion, 1, 0};
  const dot::Vector3<double> centre(0.4, -0.7, 3);
  // T <- Tr(c) exp(xi) Tr(-c) T = exp(Ad(Tr(c)) xi) T.
  Matrix8 Ad = Matrix8::Identity();
  Ad.topLeftCorner<6, 6>() = SE3d::translation(centre).adjoint();
  Image<float> measured(96, 64);
  int checked = 0;
  this->for_points([&](const PointSet& points) {
    measured.fill(0.95f * points.q[0]);
    DepthTerm depth;
    depth.inverse_depth = measured.view();
    depth.sigma = 0.1f * points.q[0];
    depth.weight = 0.3f;
    depth.occlusion_relative = 10;
    const auto about = [&](const dot::Vector3<double>& c) {
      return SerialReduction::linearize(points, 0, this->camera(), image, state, plain, depth, nullptr, c);
    };
    const NormalEquations origin = about(dot::Vector3<double>::Zero()), moved = about(centre);
    if (!moved.seen) return;
    ++checked;
    EXPECT_TRUE(matrices_match(moved.H, Matrix8(Ad.transpose() * origin.H * Ad), 1e-4));
    EXPECT_TRUE(matrices_match(moved.g, Vector8(Ad.transpose() * origin.g), 1e-4));
    for (std::size_t m = 0; m < 4; ++m)
      EXPECT_TRUE(matrices_match(moved.modes[m], Vector8(Ad.transpose() * origin.modes[m]), 1e-4));
    EXPECT_EQ(moved.cost, origin.cost);
  });
  EXPECT_GT(checked, 30);
}

TEST(Reduction, TheReferencesGradientStandsForTheImages) {
  const Image<std::uint8_t> image = ramp();  // its gradient is (1, 2) everywhere
  const AlignState state{SE3d::translation({0.1, -0.2, 0.9}), 1.2, -3};
  int checked = 0;
  ReductionOf<dot::Pinhole>::for_points([&](PointSet points) {
    // The motion takes the point from 1 / q to 1 / q + 0.9 metres: what the image shows there is as much smaller.
    const float larger = 1 + 0.9f * points.q[0];
    points.gu[0] = {1 / (1.2f * larger)};
    points.gv[0] = {2 / (1.2f * larger)};
    const auto by = [&](dot::GradientSource gradient) {
      ResidualNoise noise = plain;
      noise.gradient = gradient;
      return SerialReduction::linearize(points, 0, pinhole, image, state, noise, {}, nullptr);
    };
    const NormalEquations forward = by(dot::GradientSource::Image), reference = by(dot::GradientSource::Reference);
    if (!forward.seen) return;
    ++checked;
    EXPECT_TRUE(matrices_match(reference.H, forward.H, 1e-5));
    EXPECT_TRUE(matrices_match(reference.g, forward.g, 1e-5));
    points.gu[0][0] = points.gv[0][0] = 0;
    const NormalEquations none = by(dot::GradientSource::Reference), half = by(dot::GradientSource::Mean);
    EXPECT_EQ(none.g.head<6>().norm(), 0);
    EXPECT_NEAR(half.H(0, 0) * forward.H(7, 7), 0.25 * forward.H(0, 0) * half.H(7, 7), 1e-5 * forward.H(0, 0));
  });
  EXPECT_GT(checked, 30);
}

TEST(Reduction, HuberBoundsTheGradient) {
  const Image<std::uint8_t> image = ramp();
  PointResiduals out;
  const PointSet points = one_point(pinhole, 40, 30, 0.25f, 20);  // 90 grey values off
  const ResidualNoise noise{2, 0, 1.345f};
  const NormalEquations sums = linearize(points, pinhole, image, {}, noise, {}, out);
  const double e = static_cast<double>(out.r[0]) / 2;
  EXPECT_GT(e, 10);
  EXPECT_NEAR(-sums.g[7], 1.345 / 2, 1e-4);  // w r / s^2 = k / s
  EXPECT_NEAR(sums.cost, dot::huber_cost(static_cast<float>(e), 1.345f), 1e-3);
}

TEST(Reduction, GradientNoiseAddsVariance) {
  const Image<std::uint8_t> image = ramp();
  PointResiduals out;
  const PointSet points = one_point(pinhole, 40, 30, 0.25f, 100);
  SerialReduction::residuals(points, 0, pinhole, image, {}, {5, 0.1f, 1}, {}, out);
  EXPECT_NEAR(out.extra[0], 0.01 * (1 + 4), 1e-5);  // the ramp's gradient is (1, 2)
}

TEST(Reduction, SumsOverThePoints) {
  const Image<std::uint8_t> image = ramp();
  PointSet all;
  all.levels = 1;
  Matrix8 H = Matrix8::Zero();
  Vector8 g = Vector8::Zero();
  Matrix8 only = Matrix8::Zero();  // of one point that is seen
  std::size_t seventh = 0;
  int seen = 0;
  PointResiduals out;
  ReductionOf<dot::Pinhole>::for_points([&](const PointSet& p) {
    all.push(p.u[0], p.v[0], p.x[0], p.y[0], p.q[0], p.sigma_q[0]);
    all.intensity[0].push_back(p.intensity[0][0]);
    const NormalEquations one = linearize(p, pinhole, image, {motion, 1, 0}, plain, {}, out);
    H += one.H;
    g += one.g;
    if (one.seen && ++seen == 7) only = one.H, seventh = all.u.size() - 1;
  });
  const NormalEquations sums = linearize(all, pinhole, image, {motion, 1, 0}, plain, {}, out);
  EXPECT_TRUE(matrices_match(sums.H, H, 1e-12));
  EXPECT_TRUE(matrices_match(sums.g, g, 1e-12));
  EXPECT_EQ(static_cast<int>(out.size()), all.size());
  // Excluding all but one leaves that one.
  std::vector<std::uint8_t> excluded(out.size(), 1);
  excluded[seventh] = 0;
  const NormalEquations alone =
      SerialReduction::linearize(all, 0, pinhole, image, {motion, 1, 0}, plain, {}, excluded.data());
  EXPECT_EQ(alone.seen, 1);
  EXPECT_TRUE(matrices_match(alone.H, only, 1e-12));
}

}  // namespace
