// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "dot/pipeline/options.hpp"
#include "dot/pipeline/result.hpp"

namespace player {

/// Why an object has no motion estimate in a frame, as the end of a sentence; "measured" for Reason::None.
const char* in_words(dot::Reason reason);

/// What is known of the camera's motion in a frame, a sentence.
const char* in_words(dot::CameraStatus status);

/// Why an object has the state that it has in this frame, in a few sentences: what was measured and what that means by
/// the rule of `options.classifier`.
std::string explanation(const dot::ObjectResult& object, const dot::Options& options);

/// Standard deviation of the length of `v`, same unit: that of its component along `v`.
double sigma_of_length(const std::array<double, 3>& v, const std::array<double, 9>& covariance);

}  // namespace player
