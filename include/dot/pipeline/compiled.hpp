// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/pipeline/dot.hpp"

/// @file
/// The default pipeline and its stages, where the compiled library has them. A pipeline with a policy of one's own
/// still takes from there the stages that do not depend on it.
#ifdef DOT_USES_COMPILED_PIPELINE

DOT_BEGIN_NAMESPACE

extern template class CameraTracker<Pinhole, DepthNoise, DirectAligner<>>;
extern template class Discovery<Pinhole, DepthNoise>;
extern template struct ObjectTracker<Pinhole, DepthNoise, DirectAligner<>>;
extern template class Tracks<Pinhole, VelocityClassifier, DepthNoise, DirectAligner<>>;
extern template class Labeller<Pinhole, DepthNoise>;
extern template class LateMasks<Pinhole, VelocityClassifier, DepthNoise, DirectAligner<>>;
extern template class Dot<>;

DOT_END_NAMESPACE

#endif
