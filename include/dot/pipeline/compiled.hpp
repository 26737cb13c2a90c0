// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/pipeline/dot.hpp"

/// @file
/// Declares that the compiled library contains the default pipeline and its stages. A pipeline with a user's policy
/// still uses from the library the stages that do not depend on this policy.
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
