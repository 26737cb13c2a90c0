// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/kernel/dispatch.hpp"

#include <cstdlib>
#include <cstring>

#include "dot/kernel/portable_kernels.hpp"
#include "variants.hpp"

namespace dot {

namespace {

constexpr KernelVariant variants[] = {KernelVariant::Avx512, KernelVariant::Avx2, KernelVariant::Neon,
                                      KernelVariant::Portable};

const kernel::Kernels* available(KernelVariant variant) {
  switch (variant) {
#if defined(DOT_X86_KERNELS)
    case KernelVariant::Avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                     __builtin_cpu_supports("avx512dq")
                 ? &kernel::avx512
                 : nullptr;
    case KernelVariant::Avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &kernel::avx2 : nullptr;
#endif
#if defined(DOT_NEON_KERNELS)
    case KernelVariant::Neon: return &kernel::neon;
#endif
    case KernelVariant::Portable: return &portable_kernels();
    default: return nullptr;
  }
}

const kernel::Kernels* choose() {
  const char* name = std::getenv("DOT_KERNEL");
  const kernel::Kernels* widest = nullptr;
  for (const KernelVariant variant : variants) {
    const kernel::Kernels* found = available(variant);
    if (found && name && std::strcmp(name, found->name) == 0) return found;
    if (found && !widest) widest = found;
  }
  return widest;
}

}  // namespace

const kernel::Kernels* find_kernels(KernelVariant variant) {
  return variant == KernelVariant::Auto ? choose() : available(variant);
}

}  // namespace dot
