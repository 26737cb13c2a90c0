// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/photometric.hpp"

namespace dot::bench {

/// What no iteration over points can do without: read a point, find its pixel by a plane's map, fetch the 4x4 pixels
/// about it, and add up the 21 + 6 products. No weights, no test of visibility, no care at the border (the points must
/// stay inside), no interpolation. Null where the build has no such instructions.
using BareLoop = void (*)(const kernel::Input& in, float (&sums)[27]);
extern const BareLoop bare_avx2, bare_avx512;

}  // namespace dot::bench
