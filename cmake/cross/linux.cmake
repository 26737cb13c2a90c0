# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT

# Toolchain of Debian's cross compilers, included by the files of the machines, which set CMAKE_SYSTEM_PROCESSOR,
# cross_architecture (Debian's name), cross_triplet and cross_emulator. `./dev.sh cross` makes the sysroot.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSROOT "${CMAKE_CURRENT_LIST_DIR}/../../build/sysroot-${cross_architecture}")
set(CMAKE_C_COMPILER ${cross_triplet}-gcc)
set(CMAKE_CXX_COMPILER ${cross_triplet}-g++)
set(CMAKE_LIBRARY_ARCHITECTURE ${cross_triplet})
set(CMAKE_CROSSCOMPILING_EMULATOR "${cross_emulator};-L;${CMAKE_SYSROOT}")

# Programs are the host's; what is compiled and linked is the sysroot's alone.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_FIND_USE_PACKAGE_REGISTRY OFF)
set(CMAKE_FIND_USE_CMAKE_ENVIRONMENT_PATH OFF)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${CMAKE_SYSROOT}")
set(ENV{PKG_CONFIG_LIBDIR} "${CMAKE_SYSROOT}/usr/lib/${cross_triplet}/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig")
