// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "dot/abi.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/camera/settings.hpp"

DOT_BEGIN_NAMESPACE

/// @file
/// Depth noise, a policy of the pipeline. It is any struct with the following const members. Each returns a standard
/// deviation in 1/m for an inverse depth q in 1/m. It must not decrease with q.
///
///     double pixel_sigma(double q);          // of one pixel
///     double shared_sigma(double q);         // of the error that an object's pixels share
///     double shared_drift_sigma(double q);   // of that error's change between the two frames of a fit
///     double prior_pixel_sigma(double q);    // of one pixel, before anything was learnt
///     double prior_shared_sigma(double q);   // shared, before anything was learnt

/// Noise of the depth as standard deviation of *inverse depth* q at a point. An error has a part of each pixel and a
/// part that all pixels of an object share. The mean over many pixels does not reduce the shared part. The settings are
/// priors. The pipeline scales them by the noise that it learns from the background (camera_motion/depth_learning.hpp).
struct DepthNoise {
  DepthNoiseSettings settings;    ///< the priors
  double focal_baseline = 0;      ///< f b, pixel metres
  double pixel_scale = 1;         ///< learned factors on the priors
  double shared_scale = 1;        ///< of the shared error
  double shared_drift_scale = 1;  ///< of the shared error's change from frame to frame

  DepthNoise() = default;
  /// With the form of noise that `prior.source` names. Stereo without a baseline is treated as Unknown.
  DepthNoise(const DepthNoiseSettings& prior, const Intrinsics& camera)
      : settings(prior), focal_baseline(0.5 * (camera.fx + camera.fy) * camera.baseline) {
    if (focal_baseline <= 0 && settings.source == DepthSource::Stereo) settings.source = DepthSource::Unknown;
  }

  /// Forgets what was learnt.
  void forget_scales() { pixel_scale = shared_scale = shared_drift_scale = 1; }

  /// Standard deviation of one pixel's inverse depth, 1/m.
  double pixel_sigma(double q) const { return pixel_scale * prior_pixel_sigma(q); }
  /// Standard deviation of the error that an object's pixels share, 1/m.
  double shared_sigma(double q) const { return shared_scale * prior_shared_sigma(q); }
  /// Standard deviation of that error's change between the two frames of a fit, 1/m.
  double shared_drift_sigma(double q) const { return shared_drift_scale * prior_shared_sigma(q); }

  /// Prior of `pixel_sigma`: from the settings alone, 1/m. @param q inverse depth, 1/m.
  double prior_pixel_sigma(double q) const {
    switch (settings.source) {
      case DepthSource::Stereo: return settings.stereo_sigma_px / focal_baseline;
      case DepthSource::Rgbd: return settings.rgbd_sigma + 1e-3 * q;
      case DepthSource::Lidar: return (settings.lidar_sigma * q + settings.lidar_relative) * q;
      case DepthSource::Unknown: break;
    }
    return settings.unknown_relative * q;
  }
  /// Prior of `shared_sigma`, 1/m. @param q inverse depth, 1/m.
  double prior_shared_sigma(double q) const {
    switch (settings.source) {
      case DepthSource::Stereo: return settings.stereo_shared_px / focal_baseline;
      case DepthSource::Rgbd: return settings.rgbd_shared + 5e-4 * q;
      case DepthSource::Lidar: return (settings.lidar_shared * q + 0.2 * settings.lidar_relative) * q;
      case DepthSource::Unknown: break;
    }
    return 0.5 * settings.unknown_relative * q;
  }
};

namespace depth_noise_concept {
/// Whether T has the functions of the concept.
template <typename T, typename = void>
inline constexpr bool holds_v = false;
template <typename T>
inline constexpr bool holds_v<T, std::void_t<decltype(double(std::declval<const T&>().pixel_sigma(1.0)) +
                                                      double(std::declval<const T&>().shared_sigma(1.0)) +
                                                      double(std::declval<const T&>().shared_drift_sigma(1.0)) +
                                                      double(std::declval<const T&>().prior_pixel_sigma(1.0)) +
                                                      double(std::declval<const T&>().prior_shared_sigma(1.0)))>> =
    true;
}  // namespace depth_noise_concept

/// Whether T satisfies the concept above.
template <typename T>
inline constexpr bool is_depth_noise_v = depth_noise_concept::holds_v<T>;

DOT_END_NAMESPACE
