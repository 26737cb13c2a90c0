#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Instructions, which unlike times are the same on a busy machine: of each kernel for a result (a point, a pixel or a
# plane), of `track` for a frame.
#
#     bench/instructions.sh BUILD SEQUENCE    BUILD has dot_bench and dot_run; needs valgrind, whose processor has no
#                                             AVX-512: `track` takes the AVX2 kernels
set -euo pipefail
build=$1 sequence=$2
for program in "$build/bench/dot_bench" "$build/examples/dot_run"; do
  [ -x "$program" ] || { echo "instructions.sh: no $program" >&2; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# collected FUNCTIONS COMMAND...: instructions inside these functions, in all
collected() {
  local functions=$1
  shift
  valgrind --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no --toggle-collect="$functions" "$@" \
    2>&1 >/dev/null | sed -n 's/.*Collected : *//p'
}

# kernels.txt: each benchmark of a kernel, its results (points, pixels, planes), the function. So short a time that there
# is one iteration.
for variant in portable avx2; do
  while read -r kernel results function; do
    n=$(collected "void dot::kernel::$function<*" "$build/bench/dot_bench" \
      --benchmark_filter="BM_Kernel/$variant/$kernel\$" --benchmark_min_time=0.000001)
    printf '%-40s %8.1f\n' "$variant/$kernel" "$(awk "BEGIN { print $n / $results }")"
  done <"$(dirname "$0")/kernels.txt"
done
frames=$(find "$sequence/rgb" -type f | wc -l)
n=$(collected 'dot::Tracker::track*' "$build/examples/dot_run" "$sequence" --out "$work/out")
printf '%-40s %8.1f million a frame\n' "track, $(basename "$sequence")" "$(awk "BEGIN { print $n / $frames / 1e6 }")"
