// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/kernels_of.hpp"
#include "dot/kernel/lanes.hpp"

DOT_BEGIN_NAMESPACE

/// The kernels of a build without the compiled tier. They run on any machine.
inline const kernel::Kernels& portable_kernels() {
  static constexpr kernel::Kernels kernels = kernel::kernels_of<PortableLanes>("portable");
  return kernels;
}

DOT_END_NAMESPACE
