// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace runner {

/// The q-th percentile, 0 <= q <= 100, linear between the two values next to it; not a number for an empty list.
double percentile(std::vector<double> values, double q);

}  // namespace runner
