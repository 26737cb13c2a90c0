// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/photometric.hpp"

/// @file
/// The one signature of the kernels, portable or compiled.

namespace dot::kernel {

/// A set of kernels for one kind of machine. Reentrant; results depend on the arguments alone, and differ between the
/// sets by no more than float rounding.
struct Kernels {
  const char* name;
  void (*residuals)(const Input& in, const Residuals& out);
  void (*linearize)(const Input& in, Sums& out);       ///< pose, gain and offset
  void (*linearize_pose)(const Input& in, Sums& out);  ///< pose alone
};

}  // namespace dot::kernel
