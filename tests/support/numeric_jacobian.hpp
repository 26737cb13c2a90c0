// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <type_traits>

namespace dot::test {

/// Step and tolerance of a numeric derivative. The defaults suit functions whose arguments and curvature are of order
/// one; the tolerance is relative to the largest entry of the derivative, or absolute where that is below one.
template <typename S>
struct JacobianCheck {
  static_assert(std::is_same_v<S, float> || std::is_same_v<S, double>);
  S step = std::is_same_v<S, double> ? S(1e-5) : S(1e-2);
  S tolerance = std::is_same_v<S, double> ? S(1e-8) : S(2e-3);
};

/// Central differences of `function`, a map from Cols to Rows numbers, at x.
template <int Rows, typename S, int Cols, typename Function>
Eigen::Matrix<S, Rows, Cols> numeric_jacobian(const Function& function, const Eigen::Matrix<S, Cols, 1>& x, S step) {
  Eigen::Matrix<S, Rows, Cols> J;
  for (int i = 0; i < Cols; ++i) {
    Eigen::Matrix<S, Cols, 1> ahead = x;
    Eigen::Matrix<S, Cols, 1> behind = x;
    ahead(i) += step;
    behind(i) -= step;
    const Eigen::Matrix<S, Rows, 1> rise = function(ahead) - function(behind);
    // The step that was taken differs from the one asked for by rounding, which is much for float.
    J.col(i) = rise / (ahead(i) - behind(i));
  }
  return J;
}

/// Whether two matrices of the same shape are finite and agree within `tolerance`, relative to the largest entry of
/// `expected` where that exceeds one. Prints both otherwise.
template <typename Actual, typename Expected, typename S>
::testing::AssertionResult matrices_match(const Eigen::MatrixBase<Actual>& actual,
                                          const Eigen::MatrixBase<Expected>& expected, S tolerance) {
  const typename Actual::PlainObject a = actual;
  const typename Expected::PlainObject e = expected;
  const auto largest = e.cwiseAbs().maxCoeff();
  const auto difference = (a - e).cwiseAbs().maxCoeff();
  if (a.allFinite() && e.allFinite() && difference <= tolerance * (largest > 1 ? largest : 1))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "largest difference " << difference << ", tolerance " << tolerance
                                       << "\nactual\n"
                                       << a << "\nexpected\n"
                                       << e << "\n";
}

/// Whether `analytic` is the derivative of `function` at x.
template <typename S, int Rows, int Cols, typename Function>
::testing::AssertionResult jacobian_matches(const Eigen::Matrix<S, Rows, Cols>& analytic, const Function& function,
                                            const Eigen::Matrix<S, Cols, 1>& x, JacobianCheck<S> check = {}) {
  return matrices_match(analytic, numeric_jacobian<Rows>(function, x, check.step), check.tolerance);
}

}  // namespace dot::test
