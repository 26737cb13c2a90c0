// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "dot/camera/intrinsics.hpp"
#include "dot/camera/settings.hpp"

namespace dot {

/// Noise of the depth as variance of *inverse depth* q at a point (policy of the pipeline; replace it by any struct with
/// these functions). An error has a part of each pixel and a part that all pixels of an object share, which no
/// number of pixels averages out. The settings are priors; `learn` scales them with what the background shows.
struct DepthNoise {
  DepthNoiseSettings settings;
  double focal_baseline = 0;  ///< f b, pixel metres
  double pixel_scale = 1;     ///< learned factors on the priors
  double common_scale = 1;    ///< error shared by an object, one interval
  double change_scale = 1;    ///< change of the shared error between the frames of a fit

  DepthNoise() = default;
  DepthNoise(const DepthNoiseSettings& prior, const Intrinsics& camera)
      : settings(prior), focal_baseline(0.5 * (camera.fx + camera.fy) * camera.baseline) {
    if (focal_baseline <= 0 && settings.source == DepthSource::Stereo) settings.source = DepthSource::Unknown;
  }

  /// Standard deviation of one pixel's inverse depth, 1/m.
  double pixel(double q) const { return pixel_scale * prior_pixel(q); }
  /// Standard deviation of the error that an object's pixels share, 1/m.
  double common(double q) const { return common_scale * prior_common(q); }
  /// Standard deviation of that error's change from one frame of a fit to the other, 1/m.
  double change(double q) const { return change_scale * prior_common(q); }

  double prior_pixel(double q) const {
    switch (settings.source) {
      case DepthSource::Stereo: return settings.stereo_sigma_px / focal_baseline;
      case DepthSource::Rgbd: return settings.rgbd_sigma + 1e-3 * q;
      case DepthSource::Lidar: return (settings.lidar_sigma * q + settings.lidar_relative) * q;
      case DepthSource::Unknown: break;
    }
    return settings.unknown_relative * q;
  }
  double prior_common(double q) const {
    switch (settings.source) {
      case DepthSource::Stereo: return settings.stereo_common_px / focal_baseline;
      case DepthSource::Rgbd: return settings.rgbd_common + 5e-4 * q;
      case DepthSource::Lidar: return (settings.lidar_common * q + 0.2 * settings.lidar_relative) * q;
      case DepthSource::Unknown: break;
    }
    return 0.5 * settings.unknown_relative * q;
  }
};

}  // namespace dot
