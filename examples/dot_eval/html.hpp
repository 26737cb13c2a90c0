// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "evaluate.hpp"
#include "pool.hpp"

namespace eval {

/// One page with everything in it: tables, plots, pictures; it needs no other file and no network.
std::string html_page(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled);

}  // namespace eval
