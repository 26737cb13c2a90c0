// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/lie/se3.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "support/numeric_jacobian.hpp"

template struct dot::SE3<float>;
template struct dot::SE3<double>;

namespace {

using dot::Matrix3;
using dot::Matrix6;
using dot::SE3;
using dot::SE3d;
using dot::SE3f;
using dot::Vector3;
using dot::Vector6;
using dot::test::jacobian_matches;
using dot::test::JacobianCheck;
using dot::test::matrices_match;
namespace se3 = dot::se3;
namespace so3 = dot::so3;

constexpr double pi = 3.14159265358979323846;

template <typename S>
constexpr S tolerance = std::is_same_v<S, double> ? S(1e-12) : S(1e-5);

template <typename S>
Vector3<S> random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vector3<S> v;
  for (int i = 0; i < 3; ++i) v(i) = static_cast<S>(uniform(random));
  return v;
}

template <typename S>
Vector6<S> twist(const Vector3<S>& rho, const Vector3<S>& phi) {
  Vector6<S> xi;
  for (int i = 0; i < 3; ++i) {  // block assignment makes gcc 12 warn of Eigen's own code (-Warray-bounds)
    xi(i) = rho(i);
    xi(3 + i) = phi(i);
  }
  return xi;
}

/// Twists: zero, tiny, both sides of the switch from series to closed form, random, and near pi; translations of
/// zero, tiny and metres.
template <typename S>
std::vector<Vector6<S>> samples() {
  std::mt19937 random(17);
  std::vector<Vector6<S>> all{Vector6<S>::Zero(), Vector6<S>::Constant(S(1e-8))};
  for (const double angle : {0.0, 1e-8, 1e-4, 1e-2, 0.5, 0.999, 1.001, 2.0, 3.0, pi - 1e-3, pi - 1e-5, pi - 1e-8})
    for (const double length : {0.0, 1e-8, 3.0})
      for (int i = 0; i < 3; ++i)
        all.push_back(twist<S>(static_cast<S>(length) * random_vector<S>(random),
                               static_cast<S>(angle) * random_vector<S>(random).normalized()));
  for (int i = 0; i < 30; ++i)
    all.push_back(twist<S>(S(3) * random_vector<S>(random), S(1.7) * random_vector<S>(random)));
  return all;
}

/// The rotations by nearly pi for which rounding may pick the other axis.
template <typename S>
bool is_half_turn(const Vector6<S>& xi) {
  return xi.template tail<3>().norm() > S(pi) - S(100) * Eigen::NumTraits<S>::epsilon();
}

template <typename S>
::testing::AssertionResult same(const SE3<S>& actual, const SE3<S>& expected, S bound = tolerance<S>) {
  Eigen::Matrix<S, 3, 4> a;
  Eigen::Matrix<S, 3, 4> b;
  a << actual.R, actual.t;
  b << expected.R, expected.t;
  return matrices_match(a, b, bound);
}

template <typename S>
class Se3 : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Se3, Scalars);

TYPED_TEST(Se3, DefaultIsTheIdentity) {
  using S = TypeParam;
  const SE3<S> identity;
  EXPECT_EQ(identity.R, Matrix3<S>::Identity());
  EXPECT_EQ(identity.t, Vector3<S>::Zero());
  EXPECT_EQ(identity.log(), Vector6<S>::Zero());
  EXPECT_TRUE(same(SE3<S>::exp(Vector6<S>::Zero()), identity, S(0)));
}

TYPED_TEST(Se3, MapsPoints) {
  using S = TypeParam;
  const SE3<S> T{so3::exp(Vector3<S>(0, 0, S(pi / 2))), Vector3<S>(10, 20, 30)};
  EXPECT_TRUE(matrices_match(T * Vector3<S>(1, 2, 3), Vector3<S>(8, 21, 33), tolerance<S>));
  EXPECT_EQ(SE3<S>::translation(Vector3<S>(1, 2, 3)) * Vector3<S>(1, 1, 1), Vector3<S>(2, 3, 4));
}

TYPED_TEST(Se3, IsAGroupThatActsOnPoints) {
  using S = TypeParam;
  const SE3<S> identity;
  const auto all = samples<S>();
  for (std::size_t i = 0; i + 2 < all.size(); ++i) {
    const SE3<S> A = SE3<S>::exp(all[i]);
    const SE3<S> B = SE3<S>::exp(all[i + 1]);
    const SE3<S> C = SE3<S>::exp(all[i + 2]);
    const Vector3<S> X(S(0.3), S(-1), S(4));
    EXPECT_TRUE(same((A * B) * C, A * (B * C)));
    EXPECT_TRUE(same(A * identity, A));
    EXPECT_TRUE(same(identity * A, A));
    EXPECT_TRUE(same(A * A.inverse(), identity));
    EXPECT_TRUE(same(A.inverse() * A, identity));
    EXPECT_TRUE(same((A * B).inverse(), B.inverse() * A.inverse()));
    EXPECT_TRUE(matrices_match((A * B) * X, A * (B * X), tolerance<S>));
  }
}

TYPED_TEST(Se3, HatAndVee) {
  using S = TypeParam;
  Vector6<S> xi;
  xi << 1, 2, 3, 4, 5, 6;
  Eigen::Matrix<S, 4, 4> expected;
  expected << 0, -6, 5, 1, 6, 0, -4, 2, -5, 4, 0, 3, 0, 0, 0, 0;
  EXPECT_EQ(se3::hat(xi), expected);
  EXPECT_EQ(se3::vee(se3::hat(xi)), xi);
  EXPECT_EQ(se3::hat(S(2) * xi), se3::hat(Vector6<S>(S(2) * xi)));
}

TYPED_TEST(Se3, ExpIsTheMatrixExponential) {
  using S = TypeParam;
  for (const Vector6<S>& xi : samples<S>()) {
    const Eigen::Matrix4d X = se3::hat(xi.template cast<double>());
    Eigen::Matrix4d power = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d sum = power;
    for (int k = 1; k < 40; ++k) sum += power = power * X / k;
    const SE3d expected{sum.topLeftCorner<3, 3>(), sum.topRightCorner<3, 1>()};
    EXPECT_TRUE(same(SE3<S>::exp(xi).template cast<double>(), expected, double{tolerance<S>})) << xi.transpose();
  }
}

TYPED_TEST(Se3, LogInvertsExp) {
  using S = TypeParam;
  for (const Vector6<S>& xi : samples<S>()) {
    if (is_half_turn(xi)) continue;
    EXPECT_TRUE(matrices_match(SE3<S>::exp(xi).log(), xi, tolerance<S>)) << xi.transpose();
  }
}

TYPED_TEST(Se3, ExpInvertsLog) {
  using S = TypeParam;
  for (const Vector6<S>& xi : samples<S>()) {
    const SE3<S> T = SE3<S>::exp(S(1.5) * xi);
    EXPECT_TRUE(same(SE3<S>::exp(T.log()), T)) << xi.transpose();
    EXPECT_LE(T.log().template tail<3>().norm(), S(pi) + tolerance<S>);
  }
}

TYPED_TEST(Se3, LogKeepsTheDigitsOfTinyMotions) {
  using S = TypeParam;
  std::mt19937 random(23);
  for (int i = 0; i < 10; ++i) {
    const Vector6<S> xi = S(1e-8) * twist<S>(random_vector<S>(random), random_vector<S>(random));
    const Vector6<S> back = SE3<S>::exp(xi).log();
    EXPECT_LE((back - xi).norm(), S(20) * Eigen::NumTraits<S>::epsilon() * xi.norm()) << xi.transpose();
  }
}

TYPED_TEST(Se3, AdjointCarriesATwistAcross) {
  using S = TypeParam;
  std::mt19937 random(29);
  for (const Vector6<S>& at : samples<S>()) {
    const SE3<S> T = SE3<S>::exp(at);
    const Vector6<S> xi = twist<S>(random_vector<S>(random), random_vector<S>(random));
    EXPECT_TRUE(same(T * SE3<S>::exp(xi) * T.inverse(), SE3<S>::exp(T.adjoint() * xi), S(5) * tolerance<S>));
  }
}

TYPED_TEST(Se3, AdjointOfAProduct) {
  using S = TypeParam;
  const auto all = samples<S>();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const SE3<S> A = SE3<S>::exp(all[i]);
    const SE3<S> B = SE3<S>::exp(all[i + 1]);
    EXPECT_TRUE(matrices_match((A * B).adjoint(), A.adjoint() * B.adjoint(), tolerance<S>));
    EXPECT_TRUE(matrices_match(A.inverse().adjoint() * A.adjoint(), Matrix6<S>::Identity(), S(5) * tolerance<S>));
  }
}

TYPED_TEST(Se3, LeftJacobianIsTheDerivativeOfExp) {
  using S = TypeParam;
  JacobianCheck<S> check;
  if (std::is_same_v<S, float>) check.tolerance = S(5e-3);
  for (const Vector6<S>& xi : samples<S>()) {
    const SE3<S> back = SE3<S>::exp(xi).inverse();
    const auto motion = [&](const Vector6<S>& d) { return (SE3<S>::exp(xi + d) * back).log(); };
    EXPECT_TRUE(jacobian_matches(se3::left_jacobian(xi), motion, Vector6<S>(Vector6<S>::Zero()), check))
        << xi.transpose();
  }
}

TYPED_TEST(Se3, LeftJacobianCarriesAnIncrementToTheLeft) {
  using S = TypeParam;
  std::mt19937 random(31);
  const S size = std::is_same_v<S, double> ? S(1e-7) : S(1e-3);
  for (const Vector6<S>& xi : samples<S>()) {
    const Vector6<S> d = size * twist<S>(random_vector<S>(random), random_vector<S>(random));
    const SE3<S> moved = SE3<S>::exp(se3::left_jacobian(xi) * d) * SE3<S>::exp(xi);
    EXPECT_TRUE(same(moved, SE3<S>::exp(xi + d), S(10) * size * size + tolerance<S>)) << xi.transpose();
  }
}

/// The left Jacobian is the mean of Ad(exp(a xi)) over a from 0 to 1; Gauss-Legendre sums give that mean to the last
/// digits, without any of the closed forms of the Jacobian.
TYPED_TEST(Se3, LeftJacobianIsTheMeanAdjoint) {
  using S = TypeParam;
  const double nodes[] = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683, 0.906179845938664};
  const double weights[] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                            0.236926885056189};
  const int panels = 8;
  for (const Vector6<S>& xi : samples<S>()) {
    Matrix6<double> mean = Matrix6<double>::Zero();
    for (int panel = 0; panel < panels; ++panel)
      for (int i = 0; i < 5; ++i) {
        const double a = (panel + 0.5 * (1 + nodes[i])) / panels;
        mean += 0.5 / panels * weights[i] * SE3d::exp(a * xi.template cast<double>()).adjoint();
      }
    const Matrix6<double> J = se3::left_jacobian(xi).template cast<double>();
    EXPECT_TRUE(matrices_match(J, mean, double{tolerance<S>})) << xi.transpose();
  }
}

TYPED_TEST(Se3, LeftJacobianInverseIsTheInverse) {
  using S = TypeParam;
  for (const Vector6<S>& xi : samples<S>()) {
    const Matrix6<S> product = se3::left_jacobian(xi) * se3::left_jacobian_inverse(xi);
    EXPECT_TRUE(matrices_match(product, Matrix6<S>::Identity(), S(5) * tolerance<S>)) << xi.transpose();
  }
}

TYPED_TEST(Se3, InterpolationMeetsItsEnds) {
  using S = TypeParam;
  const auto all = samples<S>();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const SE3<S> A = SE3<S>::exp(all[i]);
    const SE3<S> B = SE3<S>::exp(all[i + 1]);
    EXPECT_TRUE(same(se3::interpolate(A, B, 0), A));
    EXPECT_TRUE(same(se3::interpolate(A, B, 1), B, S(5) * tolerance<S>));
  }
}

TYPED_TEST(Se3, InterpolationKeepsTheTwistConstant) {
  using S = TypeParam;
  const SE3<S> A = SE3<S>::exp(twist<S>(Vector3<S>(1, 2, 3), Vector3<S>(S(0.5), S(-0.2), S(0.1))));
  const Vector6<S> xi = twist<S>(Vector3<S>(S(0.4), S(-0.3), 2), Vector3<S>(S(0.3), S(0.8), S(-0.6)));
  const SE3<S> B = A * SE3<S>::exp(xi);
  const int steps = 10;
  for (int k = -2; k < steps + 2; ++k) {
    const SE3<S> from = se3::interpolate(A, B, S(k) / S(steps));
    const SE3<S> to = se3::interpolate(A, B, S(k + 1) / S(steps));
    EXPECT_TRUE(matrices_match((from.inverse() * to).log(), xi / S(steps), S(2) * tolerance<S>)) << k;
  }
}

TYPED_TEST(Se3, RowMajorRoundTrip) {
  using S = TypeParam;
  const std::array<double, 12> rows{0, -1, 0, 4, 1, 0, 0, 5, 0, 0, 1, 6};
  const SE3<S> T = SE3<S>::from_row_major(rows);
  EXPECT_TRUE(matrices_match(T.R, so3::exp(Vector3<S>(0, 0, S(pi / 2))), tolerance<S>));
  EXPECT_EQ(T.t, Vector3<S>(4, 5, 6));
  EXPECT_EQ(T.row_major(), rows);
  for (const Vector6<S>& xi : samples<S>()) {
    const SE3<S> moved = SE3<S>::exp(xi);
    EXPECT_TRUE(same(SE3<S>::from_row_major(moved.row_major()), moved, S(0)));
  }
}

TYPED_TEST(Se3, NormalizedMendsTheRotation) {
  using S = TypeParam;
  for (const Vector6<S>& xi : samples<S>()) {
    const SE3<S> T = SE3<S>::exp(xi);
    EXPECT_TRUE(same(T.normalized(), T));
    SE3<S> bent = T;
    bent.R += S(1e-3) * Matrix3<S>(so3::hat(Vector3<S>(1, 2, 3)).cwiseAbs());
    ASSERT_FALSE(matrices_match(bent.R * bent.R.transpose(), Matrix3<S>::Identity(), S(1e-4)));
    const SE3<S> mended = bent.normalized();
    EXPECT_TRUE(matrices_match(mended.R * mended.R.transpose(), Matrix3<S>::Identity(), tolerance<S>));
    EXPECT_GT(mended.R.determinant(), S(0));
    EXPECT_TRUE(matrices_match(mended.R, T.R, S(2e-2)));
    EXPECT_EQ(mended.t, T.t);
  }
}

TYPED_TEST(Se3, LongProductsStayRotations) {
  using S = TypeParam;
  std::mt19937 random(37);
  SE3<S> T;
  for (int i = 0; i < 20000; ++i)
    T = (T * SE3<S>::exp(twist<S>(random_vector<S>(random), random_vector<S>(random)))).normalized();
  EXPECT_TRUE(matrices_match(T.R * T.R.transpose(), Matrix3<S>::Identity(), tolerance<S>));
}

TEST(Se3Cast, GoesThroughFloatAndBack) {
  const SE3d T = SE3d::exp(twist<double>({1, -2, 3}, {0.1, 0.7, -0.4}));
  const SE3f single = T.cast<float>();
  EXPECT_TRUE(same(single.cast<double>(), T, 1e-7));
  EXPECT_TRUE(same(T.cast<double>(), T, 0.0));
}

}  // namespace
