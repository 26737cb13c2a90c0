// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "dot/abi.hpp"

/// @file
/// Rotations of three-space. A rotation is a 3x3 matrix R with R'R = I and det R = 1; its logarithm w is a rotation
/// vector in radians: unit axis times angle. Functions take any fixed-size Eigen expression of float or double.
/// Formulas: T. Barfoot, "State Estimation for Robotics", chapter 7.

DOT_BEGIN_NAMESPACE

/// A point, direction or rotation vector.
template <typename S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
/// A rotation, or the covariance of three values.
template <typename S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

namespace so3 {

namespace detail {

/// s_m(x) = sum over k of (-x)^k / (2k + m)!, where x is the squared angle:
/// s1 = sin t / t, s2 = (1 - cos t) / t^2, s3 = (t - sin t) / t^3, s4 = (t^2/2 - 1 + cos t) / t^4, and so on.
/// They obey s_(m+2) = (1/m! - s_m) / x. For small x this recursion loses digits upwards in m and gains them downwards.
/// So for small angles it starts at the largest m, from the series; for large ones at the smallest, from sine and
/// cosine.
template <typename S>
struct Coefficients {
  S s1, s2, s3, s4, s5;

  explicit Coefficients(S x) {
    if (x < S(1)) {
      s4 = series(x, 4) / S(24);
      s5 = series(x, 5) / S(120);
      s3 = S(1) / S(6) - x * s5;
      s2 = S(1) / S(2) - x * s4;
      s1 = S(1) - x * s3;
    } else {
      const S angle = std::sqrt(x);
      s1 = std::sin(angle) / angle;
      s2 = (S(1) - std::cos(angle)) / x;
      s3 = (S(1) - s1) / x;
      s4 = (S(1) / S(2) - s2) / x;
      s5 = (S(1) / S(6) - s3) / x;
    }
  }

 private:
  /// m! s_m(x) by Horner's rule; eight terms reach double precision for x < 1 and m >= 4.
  static S series(S x, int m) {
    S sum = 1;
    for (int k = 7; k >= 1; --k) sum = S(1) - x * (S(1) / static_cast<S>((2 * k + m) * (2 * k + m - 1))) * sum;
    return sum;
  }
};

}  // namespace detail

/// The matrix [w]x with [w]x v = w x v.
template <typename Derived>
Matrix3<typename Derived::Scalar> hat(const Eigen::MatrixBase<Derived>& w) {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 3);
  using S = typename Derived::Scalar;
  const Vector3<S> v = w;
  Matrix3<S> m;
  m << S(0), -v.z(), v.y(), v.z(), S(0), -v.x(), -v.y(), v.x(), S(0);
  return m;
}

/// Inverse of `hat`. For a matrix that is not antisymmetric, the vector of its antisymmetric part.
template <typename Derived>
Vector3<typename Derived::Scalar> vee(const Eigen::MatrixBase<Derived>& m) {
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Derived, 3, 3);
  using S = typename Derived::Scalar;
  const Matrix3<S> M = m;
  return S(0.5) * Vector3<S>(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1));
}

/// Rotation by the vector w: R = I + s1 [w]x + s2 [w]x^2 (Rodrigues), for any angle.
template <typename Derived>
Matrix3<typename Derived::Scalar> exp(const Eigen::MatrixBase<Derived>& w) {
  using S = typename Derived::Scalar;
  const Matrix3<S> W = hat(w);
  const detail::Coefficients<S> c(w.squaredNorm());
  return Matrix3<S>::Identity() + c.s1 * W + c.s2 * (W * W);
}

/// The rotation vector of R, of angle 0 to pi; at pi either of the two axes. It is computed from the quaternion, which
/// has full precision both near zero, where the trace does not, and near pi, where R - R' does not.
template <typename Derived>
Vector3<typename Derived::Scalar> log(const Eigen::MatrixBase<Derived>& R) {
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Derived, 3, 3);
  using S = typename Derived::Scalar;
  const Eigen::Quaternion<S> q{Matrix3<S>(R)};
  // q and -q are the same rotation. The one with w >= 0 has an angle of at most pi.
  const S sign = q.w() < S(0) ? S(-1) : S(1);
  const S cosine = sign * q.w();
  const S squared = q.vec().squaredNorm();
  if (squared < Eigen::NumTraits<S>::epsilon()) return (sign * S(2) / cosine) * q.vec();
  const S sine = std::sqrt(squared);
  return (sign * S(2) * std::atan2(sine, cosine) / sine) * q.vec();
}

/// J(w) with exp(w + d) = exp(J d) exp(w) to first order: J = I + s2 [w]x + s3 [w]x^2.
template <typename Derived>
Matrix3<typename Derived::Scalar> left_jacobian(const Eigen::MatrixBase<Derived>& w) {
  using S = typename Derived::Scalar;
  const Matrix3<S> W = hat(w);
  const detail::Coefficients<S> c(w.squaredNorm());
  return Matrix3<S>::Identity() + c.s2 * W + c.s3 * (W * W);
}

/// Inverse of `left_jacobian`: I - [w]x / 2 + (s3/2 - s4) / s2 [w]x^2. For angles below 2 pi, where J is singular.
template <typename Derived>
Matrix3<typename Derived::Scalar> left_jacobian_inverse(const Eigen::MatrixBase<Derived>& w) {
  using S = typename Derived::Scalar;
  const Matrix3<S> W = hat(w);
  const detail::Coefficients<S> c(w.squaredNorm());
  return Matrix3<S>::Identity() - S(0.5) * W + ((S(0.5) * c.s3 - c.s4) / c.s2) * (W * W);
}

}  // namespace so3

DOT_END_NAMESPACE
