// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/settings.hpp"

namespace dot {

/// The photometric Gauss-Newton aligner.
struct AlignSettings {
  int max_levels = 5;                               ///< of the image pyramid; fewer are used for small images
  int max_iterations = 12;                          ///< per level
  double huber = 1.345;                             ///< in sigma
  double tukey = 4.685;                             ///< in sigma: redescending cost that ranks local minima
  double gradient_noise = 0.06;                     ///< px: interpolation and model error, times the gradient
  double min_intensity_sigma = 0.8;                 ///< grey values, floor of the residual scale
  double outlier = 3.5;                             ///< in sigma, distance to the fitted line between intensities
  GradientSource gradient = GradientSource::Image;  ///< which gradients the derivatives of the residual use
  KernelVariant kernel = KernelVariant::Auto;       ///< for dot::Tracker; for tests and comparisons
};

}  // namespace dot
