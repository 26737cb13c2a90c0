// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace page {

/// Text with the characters that mean something to HTML replaced.
std::string escaped(const std::string& text);

}  // namespace page
