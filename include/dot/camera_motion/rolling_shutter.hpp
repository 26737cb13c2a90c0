// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "dot/align/residual_sums.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// What one motion for all rows leaves out if a rolling shutter reads them one after another.
///
/// If the readout takes t seconds, and the camera turns by w at one frame and by w' at the next, in its own axes, then
/// between the two the points in row v move by exp(h y) T_c, with
///
///     y = t (w - w'),   h = (v + 1/2) / height - 1/2
///
/// At a constant turn y is zero. What points that change rows add then, and the translation during the readout, are
/// small and left out. A hand that shakes, or a robot that vibrates, gives the first and the last row motions that
/// differ by some pixels. The alignment takes up a part G y of it, as a translation mostly, and its covariance from the
/// residuals does not say so. What stands then seems to move. So y is measured from the residuals of the background,
/// together with the pose. Beyond chance it widens the covariance. A moving object in the background that no mask shows
/// can imitate it, so it corrects the motion only if most of the last frames had such a turn.
struct RollingShutter {
  Vector3<double> turn = Vector3<double>::Zero();        ///< y, radians; zero if it may be chance
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< of y
  Eigen::Matrix<double, 6, 3> in_motion = Eigen::Matrix<double, 6, 3>::Zero();  ///< G: left twist of T_c by y
  bool is_usual = false;  ///< most of the last frames had such a turn

  /// @param points of the background. @param image level 0. @param a their alignment to it. @param covariance_scale
  /// CameraSettings::covariance_scale.
  template <typename Camera>
  static RollingShutter measure(const PointSet& points, const Image<std::uint8_t>& image, const Camera& camera,
                                const Alignment& a, const AlignSettings& settings, double covariance_scale) {
    const auto every = std::max<std::size_t>(1, points.u.size() / kPoints);
    ResidualSums<3> sums;
    visit_fitting(points, every, image, camera, a, settings, [&](const FittingPoint& p) {
      const double h = (static_cast<double>(p.pixel.y()) + 0.5) / image.height() - 0.5;
      sums.add(p, h * p.dr_dstate.template segment<3>(3));
    });
    auto marginal = sums.marginal();
    marginal.information.diagonal().array() += covariance_scale / (kLargest * kLargest);
    const Eigen::LDLT<Matrix3<double>> information(marginal.information);
    const Vector3<double> y = information.solve(marginal.weighted);
    RollingShutter out;
    if (!y.allFinite() || !(y.dot(marginal.weighted) > covariance_scale * chi2::k3SigmaOf3)) return out;
    out.turn = y;
    out.covariance = covariance_scale * information.solve(Matrix3<double>::Identity());
    out.in_motion = marginal.missing_in_state.template topRows<6>();
    return out;
  }

  /// Left twist from the T_c of the alignment to that of a row. @param h of the row, -1/2 to 1/2.
  Vector6<double> twist(double h) const { return by_turn(h) * turn; }
  /// To be added to the covariance of the alignment for the T_c of a row: the error of y, and that of the model, which
  /// assumes an even acceleration.
  Matrix6<double> covariance_of_row(double h) const {
    return by_turn(h) * covariance * by_turn(h).transpose() + kUneven * kUneven * covariance_of_all();
  }
  /// The same for the T_c of the alignment, as that of all rows.
  Matrix6<double> covariance_of_all() const {
    constexpr double kMeanSquareRow = 1.0 / 12;  // of h
    const Vector6<double> x = in_motion * turn;
    Matrix6<double> out = x * x.transpose();
    out.bottomRightCorner<3, 3>() += kMeanSquareRow * turn * turn.transpose();
    return out;
  }

 private:
  static constexpr std::size_t kPoints = 1000;  ///< that are looked at, up to twice as many
  static constexpr double kLargest = 0.1;       ///< radians, prior sigma of y: few rows tell nothing of it
  static constexpr double kUneven = 0.3;        ///< error of the model, share of what it corrects

  /// The left twist from the T_c of the alignment to that of a row, by y.
  Eigen::Matrix<double, 6, 3> by_turn(double h) const {
    Eigen::Matrix<double, 6, 3> out = -in_motion;
    out.bottomRows<3>().diagonal().array() += h;
    return out;
  }
};

DOT_END_NAMESPACE
