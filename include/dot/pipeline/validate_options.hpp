// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include "dot/frame/validate.hpp"
#include "dot/pipeline/options.hpp"

DOT_BEGIN_NAMESPACE

/// @throws std::invalid_argument naming the setting that is out of range.
inline void validate(const Options& options) {
  for_each_option_range(options, [](const char* name, const auto& value, OptionRange range) {
    const double v = static_cast<double>(value);
    if (!(v >= range.low && v <= range.high))
      bad_field(std::string("options.") + name,
                "is " + to_text(v) + ", must be " + to_text(range.low) + " to " + to_text(range.high));
  });
  const VelocitySettings& v = options.velocity;
  if (!(v.decide > 0.5 && v.decide < 1)) bad_field("options.velocity.decide", "must be between 0.5 and 1");
  if (v.keep > v.decide)
    bad_field("options.velocity.keep",
              "is " + to_text(v.keep) + ", must not be above velocity.decide, " + to_text(v.decide));
  const MotionPriorSettings& prior = options.motion_prior;
  if (prior.ground_vehicle && !(std::hypot(prior.up_x, prior.up_y, prior.up_z) > 0))
    bad_field("options.motion_prior.up_y", "must not be 0 like up_x and up_z: which way is up?");
}

DOT_END_NAMESPACE
