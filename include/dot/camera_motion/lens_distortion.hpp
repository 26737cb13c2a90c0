// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "dot/align/residual_sums.hpp"

DOT_BEGIN_NAMESPACE

/// Notices images with a radial distortion that the camera model lacks, as a host that hands in raw images has them.
///
/// A ray n = (X/Z, Y/Z) is seen where the model expects n (1 + k |n|^2). So a point that is seen at x is at
/// x (1 - k |x|^2), and between two frames it does not move as the model predicts:
///
///     d/dk pi(T X) = J_pi (dn + |n|^2 n),   dn = d/dk n of T X   with   dX/dk = -(x |x|^2, 0)
///
/// Where depth is measured along the ray instead of along the optical axis, points move alike. k is measured from the
/// residuals of the background, with pose, gain and offset eliminated. A lens does not change, so the sums are those of
/// some 64 frames. The alignment has refused what fits worst, and the learnt bias of a stereo pair takes up a part, so
/// that k is mostly too small.
class LensDistortion {
 public:
  /// Adds a frame. @param points of the background. @param image level 0. @param a their alignment to it.
  /// @param covariance_scale CameraSettings::covariance_scale.
  template <typename Camera>
  void add(const PointSet& points, const Image<std::uint8_t>& image, const Camera& camera, const Alignment& a,
           const AlignSettings& settings, double covariance_scale) {
    const auto every = std::max<std::size_t>(1, points.u.size() / kPoints);
    ResidualSums<1> sums;
    visit_fitting(points, every, image, camera, a, settings, [&](const FittingPoint& p) {
      const Vector2<double> x(static_cast<double>(points.x[p.i]), static_cast<double>(points.y[p.i]));
      const Vector3<double> X =
          a.state.T.R * Vector3<double>(x.x(), x.y(), 1) + static_cast<double>(points.q[p.i]) * a.state.T.t;
      const Vector3<double> d_point = -x.squaredNorm() * (a.state.T.R.template leftCols<2>() * x);
      const Vector2<double> n = X.head<2>() / X.z();
      const Vector2<double> dn = (d_point.head<2>() - d_point.z() * n) / X.z();
      Eigen::Matrix<double, 2, 3> J_pi;
      camera.template project<double>(Vector3<double>(n.x(), n.y(), 1), &J_pi);
      const Vector2<double> dpixel = J_pi.template leftCols<2>() * (dn + n.squaredNorm() * n);
      sums.add(p, ResidualSums<1>::Terms::Constant(p.gradient.dot(dpixel)));
    });
    const auto of_frame = sums.marginal();
    information_ = kKept * information_ + of_frame.information(0, 0) / covariance_scale;
    weighted_ = kKept * weighted_ + of_frame.weighted(0) / covariance_scale;
  }

  /// Pixels by which the distortion moves the corner of the image that it moves most, or zero if it may be chance or is
  /// too small to matter.
  template <typename Camera>
  double shift(const Camera& camera) const {
    if (!(std::abs(weighted_) > kSigmas * std::sqrt(information_))) return 0;
    const double k = weighted_ / information_;
    double largest = 0;
    for (const double u : {0.0, camera.width() - 1.0})
      for (const double v : {0.0, camera.height() - 1.0}) {
        const Vector3<double> ray = camera.unproject(Vector2<double>(u, v));
        const Vector2<double> n = ray.head<2>() / ray.z();
        Eigen::Matrix<double, 2, 3> J_pi;
        camera.template project<double>(Vector3<double>(n.x(), n.y(), 1), &J_pi);
        largest = std::max(largest, (J_pi.template leftCols<2>() * (k * n.squaredNorm() * n)).norm());
      }
    return largest > kMatters * camera.width() ? largest : 0;
  }

 private:
  static constexpr std::size_t kPoints = 500;  ///< that are looked at, up to twice as many
  static constexpr double kKept = 63.0 / 64;   ///< share of the sums that a frame keeps
  static constexpr double kSigmas = 5;         ///< beyond them it is no chance
  static constexpr double kMatters = 0.002;    ///< least shift, share of the width of the image

  double information_ = 0;  ///< inverse variance of k
  double weighted_ = 0;     ///< times k
};

DOT_END_NAMESPACE
