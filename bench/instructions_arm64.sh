#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Instructions of each kernel for a result (a point, a pixel or a plane) on AArch64. QEMU lists the instructions of each block of code that it
# translates, and logs each block that it executes.
#
#     bench/instructions_arm64.sh BUILD SYSROOT    both made by ./dev.sh cross arm64
set -euo pipefail
build=$1 sysroot=$2
program=$build/bench/dot_bench
[ -x "$program" ] || { echo "instructions_arm64.sh: no $program" >&2; exit 1; }
emulator=(qemu-aarch64-static -L "$sysroot")
readelf=aarch64-linux-gnu-readelf

base=$("${emulator[@]}" -d page "$program" --benchmark_list_tests 2>&1 >/dev/null | sed -n 's/^start_code *//p')

# ranges LANES: the addresses of all functions of the kernels over these lanes, ADDRESS+SIZE,...
ranges() {
  "$readelf" -sW "$program" | c++filt \
    | awk -v lanes="$1" '$4 == "FUNC" && /dot::kernel::/ && index($0, lanes) { print $2, $3 }' | sort -u \
    | while read -r address size; do printf '0x%x+%d\n' $((base + 16#$address)) "$size"; done | paste -sd,
}

# executed RANGES COMMAND...: instructions at these addresses
executed() {
  "${emulator[@]}" -d exec,nochain,in_asm -dfilter "$1" "${@:2}" 2>&1 >/dev/null | awk '
    /^IN:/ { block = "" }
    /^0x[0-9a-f]+: / {
      if (block == "") { block = substr($1, 3, length($1) - 3); sub(/^0+/, "", block); size[block] = 0 }
      ++size[block]
    }
    /^Trace / { split($0, field, "/"); sub(/^0+/, "", field[2]); sum += size[field[2]] }
    END { print sum + 0 }'
}

for variant in portable:VectorLanes neon:Neon; do
  at=$(ranges "${variant#*:}")
  [ -n "$at" ] || { echo "instructions_arm64.sh: $program has no symbols of ${variant#*:}" >&2; exit 1; }
  while read -r kernel results _; do
    n=$(executed "$at" "$program" --benchmark_filter="BM_Kernel/${variant%:*}/$kernel\$" --benchmark_min_time=0.000001)
    printf '%-40s %8.1f\n' "${variant%:*}/$kernel" "$(awk "BEGIN { print $n / $results }")"
  done <"$(dirname "$0")/kernels.txt"
done
