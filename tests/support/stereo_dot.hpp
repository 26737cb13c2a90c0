// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/dot.hpp"
#include "support/synthetic_scene.hpp"

namespace dot::test {

/// The default pipeline for `small_camera`, told that its depth is of stereo.
inline Dot<> stereo_dot(Options options = {}) {
  options.depth_noise.source = DepthSource::Stereo;
  return Dot<>(Pinhole(small_camera()), options);
}

}  // namespace dot::test
