#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Run by conda build, in the source, with PREFIX, CPU_COUNT and CMAKE_ARGS.
set -euo pipefail

# shellcheck disable=SC2086 # several options
cmake -S . -B build-conda -G Ninja ${CMAKE_ARGS:-} \
  -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DCMAKE_INSTALL_LIBDIR=lib \
  -DBUILD_SHARED_LIBS=ON \
  -DDOT_BUILD_CAPI=ON \
  -DDOT_CAPI_SHARED=ON \
  -DDOT_CAPI_STATIC=OFF \
  -DDOT_BUILD_TESTS=OFF \
  -DDOT_BUILD_BENCH=OFF \
  -DDOT_BUILD_EXAMPLES=OFF \
  -DDOT_INSTALL=ON
cmake --build build-conda --parallel "${CPU_COUNT:-2}"
cmake --install build-conda
