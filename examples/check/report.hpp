// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "check.hpp"

namespace check {

/// For a terminal.
std::string text_report(const Report& report);
/// A page of its own.
std::string html_report(const Report& report);
/// One object: folder, frames, looked_at, faults, hints, findings.
std::string json_report(const Report& report);

}  // namespace check
