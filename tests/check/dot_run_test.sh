#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# dot_run --check as a program: its status and outputs, on the sample, with faults put into it, and on bad input.
#
# usage: dot_run_test.sh DOT_RUN SEQUENCE
set -Eeuo pipefail
readonly dot_run=$1 sample=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}

# expect STATUS TEXT ARGUMENT...: the program ends so and says so.
expect() {
  local status=0 said
  said=$("$dot_run" "${@:3}" 2>&1) || status=$?
  [ "$status" -eq "$1" ] || fail "status $status instead of $1 for ${*:3}: $said"
  grep -qF -- "$2" <<<"$said" || fail "no '$2' for ${*:3}: $said"
}

expect 0 'no fault found' "$sample" --check
expect 0 '"faults": 0' "$sample" --check --json --html "$work/check.html"
grep -q '</html>' "$work/check.html" || fail "the page is not complete"

cp -r "$sample" "$work/seq"
chmod -R u+w "$work/seq"
awk '{ printf "%.3f\n", 1000 * $1 }' "$sample/times.txt" >"$work/seq/times.txt"
expect 3 'milliseconds' "$work/seq" --check
awk '{ printf "%.0f\n", 1e9 * (1700000000 + $1) }' "$sample/times.txt" >"$work/seq/times.txt"
expect 3 'nanoseconds' "$work/seq" --check # which a run refuses to read

cp -r "$sample" "$work/half"
chmod -R u+w "$work/half"
awk 'NR == 1 { for (i = 1; i <= 4; ++i) $i /= 2 } 1' "$sample/intrinsics.txt" >"$work/half/intrinsics.txt"
expect 3 'principal-point' "$work/half" --check

# The background as an instance: a run leads to the check of the same masks, and the check names them.
cp -r "$sample" "$work/cover"
chmod -R u+w "$work/cover"
{
  read -r _ _ _ _ width height _ <"$sample/intrinsics.txt"
  images='' annotations='' number=0
  for image in "$sample"/rgb/*; do
    number=$((number + 1))
    images+=",{\"id\":$number,\"file_name\":\"${image##*/}\",\"width\":$width,\"height\":$height}"
    annotations+=",{\"id\":$number,\"image_id\":$number,\"category_id\":1,\"segmentation\":"
    annotations+="[[0,0,$width,0,$width,$height,0,$height]],\"iscrowd\":0}"
  done
  printf '{"images":[%s],"annotations":[%s],"categories":[{"id":1,"name":"all"}]}' "${images#,}" "${annotations#,}"
} >"$work/cover/all.json"
expect 0 "$work/cover --mask-dir all.json --check" "$work/cover" --mask-dir all.json --out "$work/out"
expect 3 'masks-cover' "$work/cover" --mask-dir all.json --check

cp -r "$sample" "$work/lens"
chmod -R u+w "$work/lens"
echo 'distortion radtan -0.3 0.1 0 0' >>"$work/lens/intrinsics.txt"
said=$("$dot_run" "$work/lens" --check) || true
[ "$(grep -c 'a pair must be rectified' <<<"$said")" -eq 2 ] || fail "a distorted pair is compared: $said"
expect 1 'needs images without distortion' "$work/lens" --check --stereo

: >"$work/seq/depth/000003.png"
expect 1 '000003.png' "$work/seq" --check
rm "$work/seq/depth/000003.png"
expect 1 '000003.png' "$work/seq" --check
expect 1 'no such' "$work/nothing" --check
expect 2 '--html needs --check' "$sample" --html "$work/a.html"
expect 2 '--html' "$sample" --check --html "$work/a.txt"
if [ -e /dev/full ]; then
  status=0
  "$dot_run" "$sample" --check --json >/dev/full 2>"$work/stderr" || status=$?
  [ "$status" -eq 1 ] && grep -q 'standard output: cannot be written' "$work/stderr" || fail "a report that is lost has status $status"
fi
