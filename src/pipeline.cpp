// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// @file
/// The default pipeline for those who use the header tier: see pipeline/compiled.hpp and abi.hpp.
#define DOT_BUILDS_PIPELINE
#include "dot/dot.hpp"

DOT_BEGIN_NAMESPACE

template class CameraTracker<Pinhole, DepthNoise, DirectAligner<>>;
template class Discovery<Pinhole, DepthNoise>;
template struct ObjectTracker<Pinhole, DepthNoise, DirectAligner<>>;
template class Tracks<Pinhole, VelocityClassifier, DepthNoise, DirectAligner<>>;
template class Labeller<Pinhole, DepthNoise>;
template class LateMasks<Pinhole, VelocityClassifier, DepthNoise, DirectAligner<>>;
template class Dot<>;

DOT_END_NAMESPACE
