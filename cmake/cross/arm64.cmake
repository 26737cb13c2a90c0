# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(cross_architecture arm64)
set(cross_triplet aarch64-linux-gnu)
set(cross_emulator qemu-aarch64-static)
include("${CMAKE_CURRENT_LIST_DIR}/linux.cmake")
