// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/export.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/kernel/settings.hpp"

/// @file
/// Choice of the kernels in the compiled tier (target dot::dot).

namespace dot {

/// The kernels of a variant, or null if this build or this machine does not have it. `Auto` is never null: it is the
/// variant named by the environment variable DOT_KERNEL (portable, avx2, avx512, neon) if this machine has it, else the
/// widest variant of this machine. The choice changes only the last digits of the results.
DOT_EXPORT const kernel::Kernels* find_kernels(KernelVariant variant = KernelVariant::Auto);

}  // namespace dot
