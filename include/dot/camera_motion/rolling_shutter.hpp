// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "dot/camera_motion/residual_sums.hpp"
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
/// differ by some pixels. T_c takes up a part of y as a translation, and its covariance from the residuals does not say
/// so. What stands then seems to move. So y is measured from the residuals of the background, together with the pose.
/// If it is beyond chance, the part in T_c and the turn of single rows are added to the covariance.
/// A moving object in the background that no mask shows can imitate such a turn; the covariance is too large then.
struct RollingShutter {
  Vector3<double> turn = Vector3<double>::Zero();        ///< y, radians; zero if it may be chance
  Matrix6<double> covariance = Matrix6<double>::Zero();  ///< to be added to that of the left twist of T_c

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
    const Vector3<double> y = marginal.information.ldlt().solve(marginal.weighted);
    RollingShutter out;
    if (!y.allFinite() || !(y.dot(marginal.weighted) > covariance_scale * chi2::k3SigmaOf3)) return out;
    constexpr double kMeanSquareRow = 1.0 / 12;  // of h
    const Vector6<double> in_motion = (marginal.missing_in_state * y).template head<6>();
    out.turn = y;
    out.covariance = in_motion * in_motion.transpose();
    out.covariance.bottomRightCorner<3, 3>() += kMeanSquareRow * y * y.transpose();
    return out;
  }

 private:
  static constexpr std::size_t kPoints = 1000;  ///< that are looked at, up to twice as many
  static constexpr double kLargest = 0.1;       ///< radians, prior sigma of y: few rows tell nothing of it
};

DOT_END_NAMESPACE
