// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

/// @file
/// The inline namespace of everything whose layout or code depends on Eigen.
///
/// `-march=native` moves the alignment of Eigen's fixed-size types (16, 32 or 64 bytes) and the way Eigen allocates.
/// Two translation units built with different flags would then disagree silently about the same name. Headers that use
/// Eigen open their namespace with DOT_BEGIN_NAMESPACE, which carries that alignment, so such units get different
/// symbols: they work side by side, or fail to link, and never corrupt memory.
///
/// A build that must never share code with its host (our compiled tier) may set DOT_ABI_TAG to a name of its own.
#ifdef DOT_ABI_TAG
#define DOT_HAS_OWN_ABI_TAG
#else
#if EIGEN_MAX_STATIC_ALIGN_BYTES == 0 && EIGEN_MAX_ALIGN_BYTES > 0
#define DOT_ABI_TAG eigen_unaligned
#elif EIGEN_MAX_ALIGN_BYTES >= 64
#define DOT_ABI_TAG eigen64
#elif EIGEN_MAX_ALIGN_BYTES >= 32
#define DOT_ABI_TAG eigen32
#elif EIGEN_MAX_ALIGN_BYTES >= 16
#define DOT_ABI_TAG eigen16
#else
#define DOT_ABI_TAG eigen0
#endif
#endif

#define DOT_BEGIN_NAMESPACE \
  namespace dot {           \
  inline namespace DOT_ABI_TAG {
#define DOT_END_NAMESPACE \
  }                       \
  }

/// @def DOT_USES_COMPILED_PIPELINE
/// The static library has the default pipeline, `Dot<>`, compiled: its stages, and all functions marked DOT_INLINE. A
/// unit that links it takes them from there instead of compiling them again, provided that its types have the same
/// layout: the same version of Eigen, with the alignments that Eigen has by itself and the namespace that comes of
/// them, and containers without checks. All other units compile what they use.
#if defined(DOT_COMPILED_PIPELINE) && !defined(DOT_HAS_OWN_ABI_TAG) && !defined(_GLIBCXX_DEBUG) && \
    !defined(EIGEN_DEFAULT_TO_ROW_MAJOR)
#if EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16 && \
    DOT_COMPILED_PIPELINE == EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION
#define DOT_USES_COMPILED_PIPELINE
#endif
#endif

/// @def DOT_INLINE
/// Of functions that are no templates and are compiled either into the library or into each unit.
#if defined(DOT_BUILDS_PIPELINE) || defined(DOT_USES_COMPILED_PIPELINE)
#define DOT_INLINE
#else
#define DOT_INLINE inline
#endif
