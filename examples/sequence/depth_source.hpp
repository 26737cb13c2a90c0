// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "dot/camera/settings.hpp"

namespace runner {

/// stereo, rgbd, lidar or unknown.
std::optional<dot::DepthSource> depth_source_by_name(const std::string& name);

/// Name to show.
const char* to_string(dot::DepthSource source);

}  // namespace runner
