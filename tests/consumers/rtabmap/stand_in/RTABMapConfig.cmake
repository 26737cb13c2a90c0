# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
add_library(rtabmap::core INTERFACE IMPORTED)
set_target_properties(rtabmap::core PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}")
