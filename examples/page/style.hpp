// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace page {

/// The file style.css, embedded by CMake.
extern const std::string_view style_css;

}  // namespace page
