// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/kernels.hpp"

/// @file
/// The variants that a build contains. Each may be called only on a machine that has its instructions.

namespace dot::kernel {

extern const Kernels avx2;
extern const Kernels avx512;
extern const Kernels neon;

}  // namespace dot::kernel
