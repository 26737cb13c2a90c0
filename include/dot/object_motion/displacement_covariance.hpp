// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/align/aligner.hpp"
#include "dot/motion/estimate.hpp"
#include "dot/motion/settings.hpp"
#include "dot/object_motion/reference.hpp"

DOT_BEGIN_NAMESPACE

/// Covariance of the twist of T_o about the moved centroid: photometric part + depth errors that the object's points
/// share, propagated through the fit (constant over the object, linear over it in u and v, and changing between the
/// frames) + the camera's part. The noise model was learnt from the background. Where the object's measured depth
/// scatters more about the prediction than the model says, its depth errors are scaled up by that excess. Where all of
/// it is nearer or farther than predicted by more than is explained, the variance along the ray grows by that
/// difference.
/// @param moved the centroid after the fit's motion, axes of the reference's camera.
template <typename Noise>
Matrix6<double> displacement_covariance(const ReferencePair& pair, const Alignment& a, const Vector3<double>& moved,
                                        const VelocitySettings& settings, const Noise& noise) {
  constexpr double kSteadySeconds = 0.25;  // up to here depth errors change less than their size
  constexpr double kScatterOfFit = 1.2;    // scatter of depths about a good fit, over one pixel's noise
  constexpr double kMostExcess = 4;        // largest factor of an object's depth noise over the background's
  // Variances of the modes, fitted to standing objects by maximum likelihood (docs/decisions.md, covariance of the
  // velocity). Paint and glass have worse depth than the background.
  constexpr double kConstantMode = 1.6, kSlopeModes = 0.06;  // of the shared variance
  constexpr int kIndependentPixels = 60;                     // of an area that carry as much as one uncorrelated pixel
  constexpr double kVarianceOfMedian = 1.57;                 // of one value, times their number
  const ObjectReference& reference = pair.reference;
  const double q = 1 / std::max(0.05, reference.centroid.z());
  const double excess = std::clamp(a.depth_scatter / (kScatterOfFit * noise.pixel_sigma(q)), 1.0, kMostExcess);
  const double common = excess * noise.shared_sigma(q), pixel = excess * noise.pixel_sigma(q);
  const double change =
      pair.seconds > kSteadySeconds ? std::max(common, noise.shared_drift_sigma(q)) : noise.shared_drift_sigma(q);
  const double per_area = 1.0 * kIndependentPixels / std::max(kIndependentPixels, reference.area);
  Matrix6<double> V = settings.photometric_scale * a.covariance.topLeftCorner<6, 6>();
  const auto add = [&](const Vector8& mode, double variance) {
    const Vector6<double> x = mode.head<6>();
    V += variance * x * x.transpose();
  };
  add(a.depth_modes[0], kConstantMode * common * common + per_area * pixel * pixel);
  add(a.depth_modes[1], kSlopeModes * common * common);
  add(a.depth_modes[2], kSlopeModes * common * common);
  add(a.depth_modes[3], change * change);
  // The fit may predict another depth than the measured one, by more than all this explains. Then it is wrong along the
  // ray, or the depth is: a change of exposure shifts a fit, a reflection a depth.
  const SE3d& T = pair.camera.T_now_ref;
  const Vector3<double> now = T * moved, per_inverse_depth = T.R.transpose() * now * now.z();
  const Vector3<double> ray = per_inverse_depth / per_inverse_depth.squaredNorm();
  const double of_median = pixel * pixel * std::max(per_area, kVarianceOfMedian / std::max(1, a.with_depth));
  const double explained = ray.dot(V.topLeftCorner<3, 3>() * ray) + change * change + of_median;
  const double unexplained = std::max(0.0, a.depth_shift * a.depth_shift - explained);
  V.topLeftCorner<3, 3>() += unexplained * per_inverse_depth * per_inverse_depth.transpose();
  return V + camera_share(pair.camera.covariance, T, now);
}

DOT_END_NAMESPACE
