// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error \
    "dot's templates need NaN and infinity: no -ffast-math or -Ofast here, or -fno-finite-math-only after it. \
dot/tracker.hpp and the C library may be used with these flags."
#endif

/// @file
/// The inline namespace of everything whose layout or code depends on Eigen.
///
/// Compiler flags such as `-march=native` change the alignment of Eigen's fixed-size types (16, 32 or 64 bytes) and the
/// way that Eigen allocates. Without this namespace, two translation units with different flags would give two layouts
/// the same name, and the linker would not notice. All headers that use Eigen open their namespace with
/// DOT_BEGIN_NAMESPACE, whose inline namespace is named after the alignment. Units with different flags then have
/// different symbols of ours, and do not link if one hands a type to the other. Eigen's own functions have one name
/// with any flags: all units of a program that use Eigen need the same.
///
/// A build that must not share code with its host can set DOT_ABI_TAG to another name, as our compiled tier does.

/// @def DOT_ABI_TAG
/// Name of the inline namespace: eigen16, eigen32, eigen64, eigen0 or eigen_unaligned, after Eigen's alignment in
/// bytes. With -D_GLIBCXX_DEBUG, which changes the layout of containers, _debug is added to it.
#ifdef DOT_ABI_TAG
#define DOT_HAS_OWN_ABI_TAG
#else
#ifdef _GLIBCXX_DEBUG
#define DOT_ABI_TAG_OF(alignment) alignment##_debug  ///< tag of an alignment
#else
#define DOT_ABI_TAG_OF(alignment) alignment  ///< tag of an alignment
#endif
#if EIGEN_MAX_STATIC_ALIGN_BYTES == 0 && EIGEN_MAX_ALIGN_BYTES > 0
#define DOT_ABI_TAG DOT_ABI_TAG_OF(eigen_unaligned)
#elif EIGEN_MAX_ALIGN_BYTES >= 64
#define DOT_ABI_TAG DOT_ABI_TAG_OF(eigen64)
#elif EIGEN_MAX_ALIGN_BYTES >= 32
#define DOT_ABI_TAG DOT_ABI_TAG_OF(eigen32)
#elif EIGEN_MAX_ALIGN_BYTES >= 16
#define DOT_ABI_TAG DOT_ABI_TAG_OF(eigen16)
#else
#define DOT_ABI_TAG DOT_ABI_TAG_OF(eigen0)
#endif
#endif

/// Opens the namespace `dot` and the inline namespace in it.
#define DOT_BEGIN_NAMESPACE \
  namespace dot {           \
  inline namespace DOT_ABI_TAG {
/// Closes them.
#define DOT_END_NAMESPACE \
  }                       \
  }

/// @def DOT_USES_COMPILED_PIPELINE
/// The static library contains the compiled default pipeline, `Dot<>`: its stages, and all functions marked DOT_INLINE.
/// A unit that links the library uses them and does not compile them again. The unit's types must have the same layout:
/// the same version of Eigen, Eigen's own alignments (no -march=native, no alignment macros), and standard containers
/// without debug checks. All other units compile what they use.
#if defined(DOT_COMPILED_PIPELINE) && !defined(DOT_HAS_OWN_ABI_TAG) && !defined(_GLIBCXX_DEBUG) && \
    !defined(EIGEN_DEFAULT_TO_ROW_MAJOR)
#if EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16 && \
    DOT_COMPILED_PIPELINE == EIGEN_WORLD_VERSION * 10000 + EIGEN_MAJOR_VERSION * 100 + EIGEN_MINOR_VERSION
#define DOT_USES_COMPILED_PIPELINE
#endif
#endif

/// @def DOT_INLINE
/// Marks functions that are not templates. They are compiled into the library, or are `inline` in each unit.
#if defined(DOT_BUILDS_PIPELINE) || defined(DOT_USES_COMPILED_PIPELINE)
#define DOT_INLINE
#else
#define DOT_INLINE inline
#endif
