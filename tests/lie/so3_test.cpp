// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/lie/so3.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "support/numeric_jacobian.hpp"

namespace {

using dot::Matrix3;
using dot::Vector3;
using dot::test::jacobian_matches;
using dot::test::matrices_match;
namespace so3 = dot::so3;

constexpr double pi = 3.14159265358979323846;

template <typename S>
constexpr S tolerance = std::is_same_v<S, double> ? S(1e-12) : S(5e-6);

template <typename S>
Vector3<S> random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vector3<S> v;
  for (int i = 0; i < 3; ++i) v(i) = static_cast<S>(uniform(random));
  return v;
}

/// Rotation vectors: zero, tiny, both sides of the switch from series to closed form, random, and near pi.
template <typename S>
std::vector<Vector3<S>> samples() {
  std::mt19937 random(7);
  std::vector<Vector3<S>> all{Vector3<S>::Zero(), Vector3<S>(S(pi), 0, 0), Vector3<S>(0, S(-pi), 0)};
  const double angles[] = {1e-12,    1e-8, 1e-5,   1e-4, 1e-3,      1e-2,      0.1,       0.5,       0.999,
                           1 + 1e-9, 1.5,  pi / 2, 2.5,  pi - 1e-2, pi - 1e-3, pi - 1e-5, pi - 1e-7, pi - 1e-9};
  for (const double angle : angles)
    for (int i = 0; i < 6; ++i) all.push_back(static_cast<S>(angle) * random_vector<S>(random).normalized());
  for (int i = 0; i < 50; ++i) all.push_back(S(1.7) * random_vector<S>(random));
  return all;
}

template <typename S>
class So3 : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(So3, Scalars);

TYPED_TEST(So3, HatIsTheCrossProductAndVeeItsInverse) {
  using S = TypeParam;
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Vector3<S> a = random_vector<S>(random);
    const Vector3<S> b = random_vector<S>(random);
    EXPECT_TRUE(matrices_match(so3::hat(a) * b, a.cross(b), tolerance<S>));
    EXPECT_EQ(so3::vee(so3::hat(a)), a);
  }
  const Matrix3<S> symmetric = Vector3<S>(1, 2, 3) * Vector3<S>(1, 2, 3).transpose();
  EXPECT_EQ(so3::vee(so3::hat(Vector3<S>(4, 5, 6)) + symmetric), Vector3<S>(4, 5, 6));
}

TYPED_TEST(So3, TakesExpressions) {
  using S = TypeParam;
  Eigen::Matrix<S, 6, 1> xi;
  xi << 1, 2, 3, S(0.1), S(0.2), S(0.3);
  const Vector3<S> w = xi.template tail<3>();
  const Vector3<S> doubled = S(2) * w;
  EXPECT_EQ(so3::hat(xi.template tail<3>()), so3::hat(w));
  EXPECT_TRUE(matrices_match(so3::exp(xi.template tail<3>()), so3::exp(w), tolerance<S>));
  EXPECT_TRUE(matrices_match(so3::left_jacobian(S(2) * w), so3::left_jacobian(doubled), tolerance<S>));
  EXPECT_TRUE(matrices_match(so3::left_jacobian_inverse(S(2) * w), so3::left_jacobian_inverse(doubled), tolerance<S>));
  const Matrix3<S> R = so3::exp(w);
  EXPECT_TRUE(matrices_match(so3::log(R.transpose()), -w, tolerance<S>));
}

TYPED_TEST(So3, ExpIsTheMatrixExponential) {
  using S = TypeParam;
  for (const Vector3<S>& w : samples<S>()) {
    const Matrix3<double> W = so3::hat(w.template cast<double>());
    Matrix3<double> power = Matrix3<double>::Identity();
    Matrix3<double> sum = power;
    for (int k = 1; k < 40; ++k) sum += power = power * W / k;
    EXPECT_TRUE(matrices_match(so3::exp(w).template cast<double>(), sum, double{tolerance<S>})) << w.transpose();
  }
}

TYPED_TEST(So3, ExpIsARotation) {
  using S = TypeParam;
  for (const Vector3<S>& w : samples<S>()) {
    const Matrix3<S> R = so3::exp(w);
    EXPECT_TRUE(matrices_match(R * R.transpose(), Matrix3<S>::Identity(), tolerance<S>)) << w.transpose();
    EXPECT_NEAR(R.determinant(), S(1), tolerance<S>);
    EXPECT_TRUE(matrices_match(R * w, w, tolerance<S>)) << w.transpose();
    EXPECT_TRUE(matrices_match(so3::exp(-w), R.transpose(), tolerance<S>)) << w.transpose();
  }
}

TYPED_TEST(So3, QuarterTurnAboutZTakesXToY) {
  using S = TypeParam;
  const Matrix3<S> R = so3::exp(Vector3<S>(0, 0, S(pi / 2)));
  EXPECT_TRUE(matrices_match(R * Vector3<S>::UnitX(), Vector3<S>::UnitY(), tolerance<S>));
}

TYPED_TEST(So3, LogInvertsExp) {
  using S = TypeParam;
  for (const Vector3<S>& w : samples<S>()) {
    const Vector3<S> back = so3::log(so3::exp(w));
    // At pi the two axes are one rotation; rounding decides between them.
    const bool at_pi = w.norm() > S(pi) - S(100) * Eigen::NumTraits<S>::epsilon();
    const S sign = at_pi && back.dot(w) < 0 ? S(-1) : S(1);
    EXPECT_TRUE(matrices_match(sign * back, w, tolerance<S>)) << w.transpose();
  }
}

TYPED_TEST(So3, LogKeepsTheDigitsOfTinyRotations) {
  using S = TypeParam;
  std::mt19937 random(3);
  for (const double angle : {1e-12, 1e-8, 1e-5}) {
    const Vector3<S> w = static_cast<S>(angle) * random_vector<S>(random).normalized();
    const Vector3<S> back = so3::log(so3::exp(w));
    EXPECT_LE((back - w).norm(), S(10) * Eigen::NumTraits<S>::epsilon() * w.norm()) << w.transpose();
  }
}

TYPED_TEST(So3, ExpInvertsLogAndLogIsAtMostPi) {
  using S = TypeParam;
  for (const Vector3<S>& w : samples<S>())
    for (const S factor : {S(1), S(1.9)}) {
      const Matrix3<S> R = so3::exp(factor * w);
      const Vector3<S> log = so3::log(R);
      EXPECT_LE(log.norm(), S(pi) + tolerance<S>);
      EXPECT_TRUE(matrices_match(so3::exp(log), R, tolerance<S>)) << w.transpose();
    }
}

TYPED_TEST(So3, LogOfHalfTurnsAboutEveryAxis) {
  using S = TypeParam;
  for (int axis = 0; axis < 3; ++axis) {
    Vector3<S> diagonal = Vector3<S>::Constant(-1);
    diagonal(axis) = 1;
    const Vector3<S> log = so3::log(Matrix3<S>(diagonal.asDiagonal()));
    EXPECT_TRUE(matrices_match(log.cwiseAbs(), S(pi) * Vector3<S>::Unit(axis), tolerance<S>));
  }
}

TYPED_TEST(So3, LogOfMatricesWhoseRowsAreSlightlyOff) {
  using S = TypeParam;
  const Vector3<S> w(S(0.3), S(-0.2), S(0.4));
  EXPECT_TRUE(matrices_match(so3::log(S(1.0001) * so3::exp(w)), w, S(2e-4)));
}

TYPED_TEST(So3, LeftJacobianIsTheDerivativeOfExp) {
  using S = TypeParam;
  for (const Vector3<S>& w : samples<S>()) {
    const Matrix3<S> R = so3::exp(w);
    const auto rotation = [&](const Vector3<S>& d) { return so3::log(so3::exp(w + d) * R.transpose()); };
    EXPECT_TRUE(jacobian_matches(so3::left_jacobian(w), rotation, Vector3<S>(Vector3<S>::Zero()))) << w.transpose();
  }
}

TYPED_TEST(So3, LeftJacobianCarriesAnIncrementToTheLeft) {
  using S = TypeParam;
  std::mt19937 random(11);
  const S size = std::is_same_v<S, double> ? S(1e-7) : S(1e-3);
  for (const Vector3<S>& w : samples<S>()) {
    const Vector3<S> d = size * random_vector<S>(random);
    const Matrix3<S> moved = so3::exp(so3::left_jacobian(w) * d) * so3::exp(w);
    EXPECT_TRUE(matrices_match(moved, so3::exp(w + d), S(2) * size * size + tolerance<S>)) << w.transpose();
  }
}

TYPED_TEST(So3, LeftJacobianInverseIsTheInverse) {
  using S = TypeParam;
  for (const Vector3<S>& w : samples<S>()) {
    const Matrix3<S> product = so3::left_jacobian(w) * so3::left_jacobian_inverse(w);
    EXPECT_TRUE(matrices_match(product, Matrix3<S>::Identity(), tolerance<S>)) << w.transpose();
  }
}

TYPED_TEST(So3, JacobiansAreContinuousWhereTheSeriesEnds) {
  using S = TypeParam;
  const Vector3<S> axis = Vector3<S>(1, -2, 3).normalized();
  const S step = S(4) * Eigen::NumTraits<S>::epsilon();
  const Vector3<S> below = (S(1) - step) * axis;
  const Vector3<S> above = (S(1) + step) * axis;
  const S bound = S(50) * Eigen::NumTraits<S>::epsilon();
  EXPECT_TRUE(matrices_match(so3::exp(below), so3::exp(above), bound));
  EXPECT_TRUE(matrices_match(so3::left_jacobian(below), so3::left_jacobian(above), bound));
  EXPECT_TRUE(matrices_match(so3::left_jacobian_inverse(below), so3::left_jacobian_inverse(above), bound));
}

}  // namespace
