// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/align/aligner.hpp"
#include "dot/motion/estimate.hpp"
#include "dot/motion/settings.hpp"
#include "dot/object_motion/reference.hpp"

DOT_BEGIN_NAMESPACE

/// V dt^2: photometric + depth errors that the object's points share, propagated through the fit (constant over the
/// object, linear over it in u and v, and changing between the frames) + the camera's. An object whose measured depth
/// scatters more about the prediction than the noise says has worse depth than the background that taught it: its
/// depth errors are scaled by that.
/// @param moved the centroid, where the fit moves it, axes of the reference's camera.
template <typename Noise>
Matrix3<double> displacement_covariance(const ReferencePair& pair, const Alignment& a, const Vector3<double>& moved,
                                        const VelocitySettings& settings, const Noise& noise) {
  constexpr double kSteadySeconds = 0.25;  // for which depth errors change less than they are large
  constexpr double kScatterOfFit = 1.2;    // of measured depths about a good fit, over the noise of one pixel
  constexpr double kMostExcess = 4;        // times as noisy as the background that an object's depth may be
  // Variances of the modes, by which standing objects are most likely (docs/decisions.md, covariance of the velocity):
  // paint and glass have worse depth than the background.
  constexpr double kConstantMode = 1.6, kSlopeModes = 0.06;  // of the shared variance
  constexpr int kIndependentPixels = 60;                     // of an area that say what one without correlation would
  const ObjectReference& reference = pair.reference;
  const double q = 1 / std::max(0.05, reference.centroid.z());
  const double excess = std::clamp(a.depth_scatter / (kScatterOfFit * noise.pixel_sigma(q)), 1.0, kMostExcess);
  const double common = excess * noise.shared_sigma(q), pixel = excess * noise.pixel_sigma(q);
  const double change =
      pair.seconds > kSteadySeconds ? std::max(common, noise.shared_drift_sigma(q)) : noise.shared_drift_sigma(q);
  Matrix3<double> V = settings.photometric_scale * a.covariance.topLeftCorner<3, 3>();
  const auto add = [&](const Vector8& mode, double variance) {
    const Vector3<double> x = mode.head<3>();
    V += variance * x * x.transpose();
  };
  add(a.depth_modes[0], kConstantMode * common * common +
                            kIndependentPixels * pixel * pixel / std::max(kIndependentPixels, reference.area));
  add(a.depth_modes[1], kSlopeModes * common * common);
  add(a.depth_modes[2], kSlopeModes * common * common);
  add(a.depth_modes[3], change * change);
  return V +
         camera_share(pair.camera.covariance, pair.camera.T_now_ref, Vector3<double>(pair.camera.T_now_ref * moved));
}

DOT_END_NAMESPACE
