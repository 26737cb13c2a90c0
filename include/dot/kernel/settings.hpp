// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace dot {

/// The machine that the kernels are for, see kernel/dispatch.hpp.
enum class KernelVariant {
  Auto,      ///< the best for the machine that the program runs on
  Portable,  ///< any machine
  Avx2,      ///< x86-64 with AVX2 and FMA
  Avx512,    ///< x86-64 with AVX-512
  Neon       ///< AArch64
};

/// The source of the gradients in the derivatives of the residual.
enum class GradientSource {
  Image,      ///< the new image's at the moved point: forward, the paper's
  Reference,  ///< the reference's, sampled once: the idea of inverse composition (Baker and Matthews 2004)
  Mean        ///< of both: efficient second-order minimisation (Malis 2004)
};

}  // namespace dot
