// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "evaluate.hpp"
#include "page/json.hpp"
#include "pool.hpp"

namespace eval {

using page::Json;

/// All figures; docs/evaluation.md lists the names.
Json report(const Arguments& arguments, const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled);

}  // namespace eval
