# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
add_library(cv_bridge::cv_bridge INTERFACE IMPORTED)
set_target_properties(cv_bridge::cv_bridge PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CMAKE_CURRENT_LIST_DIR}")
