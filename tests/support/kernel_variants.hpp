// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dot/kernel/dispatch.hpp"
#include "dot/kernel/portable_kernels.hpp"

namespace dot::test {

/// All the kernels that this machine can run: of a lane alone, portable, compiled.
inline std::vector<const kernel::Kernels*> kernel_variants() {
  static constexpr kernel::Kernels scalar = kernel::kernels_of<ScalarLanes>("scalar");
  std::vector<const kernel::Kernels*> found{&scalar, &portable_kernels()};
  for (const KernelVariant v : {KernelVariant::Avx2, KernelVariant::Avx512, KernelVariant::Neon})
    if (const kernel::Kernels* k = find_kernels(v)) found.push_back(k);
  return found;
}

}  // namespace dot::test
