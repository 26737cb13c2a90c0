// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "dot/align/aligner.hpp"
#include "dot/motion/estimate.hpp"
#include "dot/motion/settings.hpp"
#include "dot/object_motion/reference.hpp"

DOT_BEGIN_NAMESPACE

/// Adds to a covariance of the twist of T_o, about the moved centroid, by how much the measured depth contradicts the
/// fit. Where all of it is nearer or farther than predicted, the fit or the depth is wrong along the ray: a change of
/// exposure shifts a fit, a reflection a depth. Where it scatters much about that, the fit's rotation may be wrong. A
/// rotation that is wrong by t, about an axis across the ray, changes the depth at a lateral distance x from that axis
/// by t x.
/// @param moved the centroid after the fit's motion, axes of the reference's camera. @param depth_sigma of the median
/// of the differences between measured and predicted inverse depth. @param pixel_sigma of one of them.
inline void add_contradicting_depth(const ReferencePair& pair, const Alignment& a, const Vector3<double>& moved,
                                    double depth_sigma, double pixel_sigma, Matrix6<double>& V) {
  constexpr double kWorsePixels = 2;  // largest noise of an object's pixels, over pixel_sigma
  constexpr int kLeastDepths = 10;    // whose scatter tells something
  const auto unexplained = [](double difference, double variance) {
    return std::max(0.0, difference * difference - variance);
  };
  const SE3d& T = pair.camera.T_now_ref;
  const Vector3<double> now = T * moved, ray = T.R.transpose() * now.normalized();
  const double metres = now.norm() * now.z();  // along the ray, for a unit of inverse depth
  const double along = ray.dot(V.topLeftCorner<3, 3>() * ray) / (metres * metres);
  V.topLeftCorner<3, 3>() +=
      unexplained(a.depth_shift, along + depth_sigma * depth_sigma) * metres * metres * ray * ray.transpose();

  const double lateral2 = ray.dot(pair.reference.inertia * ray) / 2;  // mean square from an axis across the ray
  if (a.with_depth < kLeastDepths || lateral2 <= 0) return;
  const double worst = kWorsePixels * pixel_sigma, depth = now.z() * now.z();
  V.bottomRightCorner<3, 3>() += unexplained(a.depth_spread, worst * worst) * depth * depth / lateral2 *
                                 (Matrix3<double>::Identity() - ray * ray.transpose());
}

/// Covariances of the twist of T_o about the moved centroid.
struct DisplacementCovariance {
  Matrix6<double> all = Matrix6<double>::Zero();       ///< all parts together
  Matrix6<double> of_depth = Matrix6<double>::Zero();  ///< the part from the depth errors that the points share
};

/// Their parts: photometric part + depth errors that the object's points
/// share, propagated through the fit (constant over the object, linear over it in u and v, and changing between the
/// frames) + what the measured depth contradicts + the camera's part. The noise model was learnt from the background.
/// Where the object's measured depth scatters more about the prediction than the model says, its depth errors are
/// scaled up by that excess.
/// @param moved the centroid after the fit's motion, axes of the reference's camera.
/// @param sharper factor on the photometric part, see SharperImage.
template <typename Noise>
DisplacementCovariance displacement_covariance(const ReferencePair& pair, const Alignment& a,
                                               const Vector3<double>& moved, const VelocitySettings& settings,
                                               const Noise& noise, double sharper) {
  constexpr double kSteadySeconds = 0.25;  // up to here depth errors change less than their size
  constexpr double kScatterOfFit = 1.2;    // scatter of depths about a good fit, over one pixel's noise
  constexpr double kMostExcess = 4;        // largest factor of an object's depth noise over the background's
  // Variances of the modes, fitted to standing objects by maximum likelihood (docs/decisions.md, covariance of the
  // velocity). Paint and glass have worse depth than the background.
  constexpr double kConstantMode = 1.6, kSlopeModes = 0.06;  // of the shared variance
  constexpr int kIndependentPixels = 60;                     // of an area that carry as much as one uncorrelated pixel
  constexpr double kVarianceOfMedian = 1.57;                 // of one value, times their number
  constexpr double kCorrelatedPixels = 9;                    // that the gradient at a point is taken from
  constexpr double kFarApart = 1.0 / 3;                      // share of the photometric scale where points share none
  const ObjectReference& reference = pair.reference;
  const double q = 1 / std::max(0.05, reference.centroid.z()), of_fit = kScatterOfFit * noise.pixel_sigma(q);
  const double excess = std::clamp(a.depth_scatter / of_fit, 1.0, kMostExcess);
  const double common = excess * noise.shared_sigma(q), pixel = excess * noise.pixel_sigma(q);
  const double change =
      pair.seconds > kSteadySeconds ? std::max(common, noise.shared_drift_sigma(q)) : noise.shared_drift_sigma(q);
  const double per_area = 1.0 * kIndependentPixels / std::max(kIndependentPixels, reference.area);
  const double close = std::min(1.0, kCorrelatedPixels * reference.points.size() / std::max(1, reference.area));
  const auto of_mode = [&](int mode, double variance) -> Matrix6<double> {
    const Vector6<double> x = a.depth_modes[static_cast<std::size_t>(mode)].template head<6>();
    return variance * x * x.transpose();
  };
  DisplacementCovariance out;
  out.of_depth = of_mode(0, kConstantMode * common * common + per_area * pixel * pixel) +
                 of_mode(1, kSlopeModes * common * common + reference.slope_variance) +
                 of_mode(2, kSlopeModes * common * common + reference.slope_variance);
  Matrix6<double>& V = out.all;
  V = sharper * settings.photometric_scale * (kFarApart + (1 - kFarApart) * close) *
          a.covariance.topLeftCorner<6, 6>() +
      out.of_depth + of_mode(3, change * change);
  const double of_median = std::sqrt(std::max(per_area, kVarianceOfMedian / std::max(1, a.with_depth))) * pixel;
  add_contradicting_depth(pair, a, moved, std::hypot(change, of_median), of_fit, V);
  V += camera_share(pair.camera.covariance, pair.camera.T_now_ref, Vector3<double>(pair.camera.T_now_ref * moved));
  return out;
}

DOT_END_NAMESPACE
