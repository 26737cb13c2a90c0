// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "depth_source.hpp"

namespace runner {

std::optional<dot::DepthSource> depth_source_by_name(const std::string& name) {
  if (name == "stereo") return dot::DepthSource::Stereo;
  if (name == "rgbd") return dot::DepthSource::Rgbd;
  if (name == "lidar") return dot::DepthSource::Lidar;
  if (name == "unknown") return dot::DepthSource::Unknown;
  return std::nullopt;
}

const char* to_string(dot::DepthSource source) {
  if (source == dot::DepthSource::Stereo) return "stereo";
  if (source == dot::DepthSource::Rgbd) return "RGB-D";
  if (source == dot::DepthSource::Lidar) return "lidar";
  return "unknown sensor";
}

}  // namespace runner
