// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "dot/lie/so3.hpp"

/// @file
/// Rigid motions. Twists are [translation; rotation], metres and radians, and act from the left: T <- exp(xi) T.
/// Formulas: T. Barfoot, "State Estimation for Robotics", chapter 7.

DOT_BEGIN_NAMESPACE

/// A twist [translation; rotation], metres and radians.
template <typename S>
using Vector6 = Eigen::Matrix<S, 6, 1>;
/// Covariance or information of a twist.
template <typename S>
using Matrix6 = Eigen::Matrix<S, 6, 6>;

/// A rigid motion X -> R X + t. As a pose T_a_b it maps coordinates of b to those of a.
/// Eigen does not align members of these sizes, so SE3 may be stored in any container.
template <typename S>
struct SE3 {
  using Scalar = S;  ///< the number type

  Matrix3<S> R = Matrix3<S>::Identity();  ///< rotation
  Vector3<S> t = Vector3<S>::Zero();      ///< metres

  /// [exp([phi]x), J(phi) rho; 0, 1] for xi = [rho; phi], J the left Jacobian of SO(3).
  static SE3 exp(const Vector6<S>& xi) {
    const Vector3<S> rho = xi.template head<3>();
    const Vector3<S> phi = xi.template tail<3>();
    return {so3::exp(phi), so3::left_jacobian(phi) * rho};
  }

  /// The twist, with rotation angle 0 to pi, whose `exp` is this motion.
  Vector6<S> log() const {
    const Vector3<S> phi = so3::log(R);
    Vector6<S> xi;
    xi.template head<3>() = so3::left_jacobian_inverse(phi) * t;
    xi.template tail<3>() = phi;
    return xi;
  }

  /// Moves by `v`, metres, without a rotation.
  static SE3 translation(const Vector3<S>& v) { return {Matrix3<S>::Identity(), v}; }

  /// The motion back.
  SE3 inverse() const { return {R.transpose(), -(R.transpose() * t)}; }
  /// The composition: first `other`, then this.
  SE3 operator*(const SE3& other) const { return {R * other.R, R * other.t + t}; }
  /// The point X after the motion.
  Vector3<S> operator*(const Vector3<S>& X) const { return R * X + t; }

  /// Ad with T exp(xi) T^-1 = exp(Ad xi):
  ///
  ///     [ R  [t]x R ]
  ///     [ 0    R    ]
  Matrix6<S> adjoint() const {
    Matrix6<S> ad;
    ad << R, so3::hat(t) * R, Matrix3<S>::Zero(), R;
    return ad;
  }

  /// The same in another number type.
  template <typename S2>
  SE3<S2> cast() const {
    return {R.template cast<S2>(), t.template cast<S2>()};
  }

  /// The same motion with R orthonormalised by the unit quaternion. Corrects the rounding errors of long products.
  SE3 normalized() const { return {Eigen::Quaternion<S>(R).normalized().toRotationMatrix(), t}; }

  /// From the rows of the 3x4 matrix [R t]. The numbers are not changed.
  static SE3 from_row_major(const std::array<double, 12>& m) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> Rt(m.data());
    return {Rt.template leftCols<3>().template cast<S>(), Rt.col(3).template cast<S>()};
  }

  /// The rows of the 3x4 matrix [R t].
  std::array<double, 12> row_major() const {
    std::array<double, 12> m{};
    Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> Rt(m.data());
    Rt << R.template cast<double>(), t.template cast<double>();
    return m;
  }
};

using SE3d = SE3<double>;  ///< for poses
using SE3f = SE3<float>;   ///< for points

static_assert(alignof(SE3d) == alignof(double) && alignof(SE3f) == alignof(float), "SE3 must need no alignment");

namespace se3 {

/// The 4x4 matrix [[phi]x, rho; 0, 0] of xi = [rho; phi]; SE3::exp is its matrix exponential.
template <typename Derived>
Eigen::Matrix<typename Derived::Scalar, 4, 4> hat(const Eigen::MatrixBase<Derived>& xi) {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 6);
  using S = typename Derived::Scalar;
  Eigen::Matrix<S, 4, 4> m = Eigen::Matrix<S, 4, 4>::Zero();
  m.template topLeftCorner<3, 3>() = so3::hat(xi.template tail<3>());
  m.template topRightCorner<3, 1>() = xi.template head<3>();
  return m;
}

/// Inverse of `hat`.
template <typename Derived>
Vector6<typename Derived::Scalar> vee(const Eigen::MatrixBase<Derived>& m) {
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Derived, 4, 4);
  using S = typename Derived::Scalar;
  Vector6<S> xi;
  xi << m.template topRightCorner<3, 1>(), so3::vee(m.template topLeftCorner<3, 3>());
  return xi;
}

namespace detail {

/// The upper right block of the left Jacobian (Barfoot, equation 7.86), for xi = [rho; phi], with P = [rho]x and
/// W = [phi]x.
template <typename S>
Matrix3<S> q_block(const Vector6<S>& xi) {
  const Matrix3<S> P = so3::hat(xi.template head<3>());
  const Matrix3<S> W = so3::hat(xi.template tail<3>());
  const so3::detail::Coefficients<S> c(xi.template tail<3>().squaredNorm());
  const Matrix3<S> WP = W * P;
  const Matrix3<S> PW = P * W;
  const Matrix3<S> WPW = WP * W;
  return S(0.5) * P + c.s3 * (WP + PW + WPW) + c.s4 * (W * WP + PW * W - S(3) * WPW) +
         S(0.5) * (c.s4 - S(3) * c.s5) * (WPW * W + W * WPW);
}

}  // namespace detail

/// J(xi) with exp(xi + d) = exp(J d) exp(xi) to first order; J3 is the left Jacobian of SO(3):
///
///     [ J3(phi)     Q    ]
///     [   0      J3(phi) ]
template <typename Derived>
Matrix6<typename Derived::Scalar> left_jacobian(const Eigen::MatrixBase<Derived>& xi) {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 6);
  using S = typename Derived::Scalar;
  const Vector6<S> x = xi;
  const Matrix3<S> J3 = so3::left_jacobian(x.template tail<3>());
  Matrix6<S> J;
  J << J3, detail::q_block(x), Matrix3<S>::Zero(), J3;
  return J;
}

/// Inverse of `left_jacobian`, for rotation angles below 2 pi:
///
///     [ J3^-1  -J3^-1 Q J3^-1 ]
///     [   0         J3^-1     ]
template <typename Derived>
Matrix6<typename Derived::Scalar> left_jacobian_inverse(const Eigen::MatrixBase<Derived>& xi) {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 6);
  using S = typename Derived::Scalar;
  const Vector6<S> x = xi;
  const Matrix3<S> K = so3::left_jacobian_inverse(x.template tail<3>());
  Matrix6<S> J;
  J << K, -(K * detail::q_block(x) * K), Matrix3<S>::Zero(), K;
  return J;
}

/// A exp(alpha log(A^-1 B)): A at alpha = 0, B at alpha = 1, with a constant twist in between and beyond.
template <typename S>
SE3<S> interpolate(const SE3<S>& A, const SE3<S>& B, typename SE3<S>::Scalar alpha) {
  return A * SE3<S>::exp(alpha * (A.inverse() * B).log());
}

}  // namespace se3

DOT_END_NAMESPACE
