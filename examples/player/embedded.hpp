// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace player {

/// Files of this folder, embedded by CMake.
extern const std::string_view player_html;
extern const std::string_view player_css;
extern const std::string_view player_js;  ///< all its .js files

}  // namespace player
