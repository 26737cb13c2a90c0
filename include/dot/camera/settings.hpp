// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace dot {

/// The source of the depth. It determines the form of the noise (camera/depth_noise.hpp).
enum class DepthSource : std::uint8_t {
  Unknown,  ///< noise is a share of the inverse depth
  Stereo,   ///< noise is constant in disparity; needs Intrinsics::baseline
  Rgbd,     ///< noise grows with the square of the depth
  Lidar     ///< noise is constant in range, with a share for the interpolation between the beams
};

/// Priors of the depth noise. The size of the noise is estimated online and starts from these.
struct DepthNoiseSettings {
  DepthSource source = DepthSource::Unknown;  ///< where the depth comes from
  double stereo_sigma_px = 0.3;               ///< disparity noise of one pixel
  double stereo_shared_px = 0.2;              ///< disparity error that an object's pixels share
  /// Prior, pixels, of a disparity error that depends only on the place in the image, due to a slightly wrong
  /// calibration. The error is learnt from the background and subtracted from the depth. 0: no such error is assumed.
  double stereo_bias_px = 0.3;
  double rgbd_sigma = 0.002;       ///< metres at 1 m; grows with the square of the depth
  double rgbd_shared = 0.001;      ///< metres at 1 m, shared by an object's pixels
  double lidar_sigma = 0.03;       ///< metres
  double lidar_relative = 0.01;    ///< share of the inverse depth: interpolation between the beams
  double lidar_shared = 0.01;      ///< metres, shared
  double unknown_relative = 0.01;  ///< share of the inverse depth (per pixel), until measured
};

}  // namespace dot
