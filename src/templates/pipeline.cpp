// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// @file
/// The default pipeline for users of the header tier: see pipeline/compiled.hpp and abi.hpp.
// Uses Eigen's own alignments on most machines, whatever the flags of the build are. Hosts with other alignments
// compile the pipeline themselves.
#undef EIGEN_DONT_ALIGN
#undef EIGEN_DONT_ALIGN_STATICALLY
#undef EIGEN_MAX_ALIGN_BYTES
#undef EIGEN_MAX_STATIC_ALIGN_BYTES
#undef DOT_ABI_TAG
#define EIGEN_MAX_ALIGN_BYTES 16
#define EIGEN_MAX_STATIC_ALIGN_BYTES 16
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
