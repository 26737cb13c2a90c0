#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# What ./dev.sh cross does, after it installed the compiler and the emulator: builds for another machine in
# build-MACHINE, runs its tests under the emulator, and compares its run of the sample with those of this machine.
#
#     tests/cross/run.sh arm64 DOT_RUN JOBS    DOT_RUN: of this machine
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
machine=$1 dot_run=$2 jobs=$3
case $machine in
  arm64) triplet=aarch64-linux-gnu emulator=qemu-aarch64-static kernels=(portable neon) ;;
  *) echo "run.sh: $machine: only arm64" >&2; exit 2 ;;
esac
sysroot=$PWD/build/sysroot-$machine build=$PWD/build-$machine out=$PWD/out/cross sample=examples/data/mini
say() { printf '\n== %s (%s s)\n' "$*" "$SECONDS"; }

say "sysroot of $machine in $sysroot"
cmake/cross/sysroot.sh "$machine" "$triplet" "$sysroot" libc6-dev libopencv-dev libeigen3-dev libgtest-dev libbenchmark-dev

say "building for $machine in $build"
cmake -S . -B "$build" -G Ninja --toolchain "cmake/cross/$machine.cmake" -DCMAKE_BUILD_TYPE=Release -DDOT_INSTALL=OFF -DDOT_TEST_TIMEOUT=1200
modules=(lie kernel image points align motion)
capi=(tests/capi/*.c)
capi=("${capi[@]##*/}") capi=("${capi[@]%.c}")
nice cmake --build "$build" --parallel "$jobs" --target "${modules[@]/#/test_}" "${capi[@]/#/test_}" test_identity \
  test_core_layout test_core_shared example_c dot_run dot_bench

say "testing under $emulator"
nice ctest --test-dir "$build" --output-on-failure -j"$jobs" \
  -R "^($(IFS='|' && echo "${modules[*]}")|capi|core)\\.|^runner\\.sample|^example\\.c\$"

say "the sample, here and under $emulator"
rm -rf "$out"
runs=()
for kernel in avx2 avx512 portable; do # one that this machine lacks is its widest again
  DOT_KERNEL=$kernel "$dot_run" "$sample" --out "$out/here-$kernel" >/dev/null
  runs+=("$out/here-$kernel")
done
for kernel in "${kernels[@]}"; do
  DOT_KERNEL=$kernel nice "$emulator" -L "$sysroot" "$build/examples/dot_run" "$sample" --out "$out/$machine-$kernel" >/dev/null
  runs+=("$out/$machine-$kernel")
done
python=python3
"$python" -c 'import numpy, cv2' 2>/dev/null || python=/usr/bin/python3
"$python" tests/cross/compare_runs.py "$out/here-portable" "${runs[@]}"

say "instructions of the kernels"
nice bench/instructions_arm64.sh "$build" "$sysroot"
