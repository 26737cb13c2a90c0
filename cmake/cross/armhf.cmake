# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

set(CMAKE_SYSTEM_PROCESSOR arm)
set(cross_architecture armhf)
set(cross_triplet arm-linux-gnueabihf)
set(cross_emulator qemu-arm-static)
include("${CMAKE_CURRENT_LIST_DIR}/linux.cmake")
