// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/export.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/kernel/settings.hpp"

/// @file
/// Which kernels run, in the compiled tier (target dot::dot).

namespace dot {

/// The kernels of a variant, or null where this build or this machine has no such. `Auto` is never null: the variant
/// that the environment variable DOT_KERNEL names (portable, avx2, avx512), if that is one of this machine, else the
/// widest of this machine. It changes no more than the last digits.
DOT_EXPORT const kernel::Kernels* find_kernels(KernelVariant variant = KernelVariant::Auto);

}  // namespace dot
