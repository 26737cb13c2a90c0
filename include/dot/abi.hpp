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
#ifndef DOT_ABI_TAG
#if EIGEN_MAX_ALIGN_BYTES >= 64
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
