// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "finding.hpp"
#include "samples.hpp"

/// @file
/// What is measured of a recording: one function and one file a subject. Each says all that it looked at, whether fine,
/// faulty or not measurable.

namespace check {

Findings check_clock(const Samples& samples);             ///< time-unit, time-order, frames-dropped
Findings check_repeats(const Samples& samples);           ///< images-repeated, depth-repeated
Findings check_amounts(const Samples& samples);           ///< depth-sparse, texture-low
Findings check_registration(const Samples& samples);      ///< depth-size, depth-lag, depth-offset
Findings check_depth_scale(const Samples& samples);       ///< depth-unit, focal-baseline
Findings check_depth_inverse(const Samples& samples);     ///< depth-inverse
Findings check_depth_saturation(const Samples& samples);  ///< depth-saturated
Findings check_principal_point(const Samples& samples);   ///< principal-point
Findings check_pair(const Samples& samples);              ///< pair-rows, depth-unit, focal-baseline, disparity-bias
Findings check_masks(const Samples& samples);             ///< masks-size, masks-values, masks-lag
Findings check_masks_cover(const Samples& samples);       ///< masks-cover
Findings check_missing_masks(const Samples& samples);     ///< masks-missing
Findings check_exposure(const Samples& samples);          ///< exposure-jumps, brightness-bands
Findings check_blur(const Samples& samples);              ///< motion-blur
Findings check_fixed_parts(const Samples& samples);       ///< fixed-part

}  // namespace check
