# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
macro(ament_package)
endmacro()
