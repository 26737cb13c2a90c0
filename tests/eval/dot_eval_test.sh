#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# dot_eval as a program: what it writes on the sample, that it goes on after a sequence that fails, and bad input.
# usage: dot_eval_test.sh DOT_EVAL DOT_RUN SAMPLE_DIR WORK_DIR
# WORK_DIR/eval.json and eval.html are left for eval_output.cmake.

set -u
if [ $# -ne 4 ]; then
  echo "usage: $0 DOT_EVAL DOT_RUN SAMPLE_DIR WORK_DIR" >&2
  exit 2
fi
dot_eval=$1
dot_run=$2
sample=$3
work=$4
rm -rf "$work"
mkdir -p "$work" || exit 1
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $1" >&2
  sed 's/^/    /' "$work/stderr" >&2
}

# ends WHAT STATUS TEXT ARGUMENT...: the program ends with STATUS and says TEXT on one of its outputs.
ends() {
  local what=$1 status=$2 text=$3 got
  shift 3
  "$dot_eval" "$@" > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq "$status" ] || fail "$what: status $got, expected $status"
  cat "$work/stdout" "$work/stderr" | grep -qF -- "$text" || fail "$what: nothing says '$text'"
}

# short N FOLDER: the sample's first N frames.
short() {
  local folder i
  mkdir -p "$2"
  cp "$sample"/{intrinsics.txt,objects.csv,object_poses.txt} "$2"
  head -n "$1" "$sample/times.txt" > "$2/times.txt"
  head -n "$1" "$sample/poses.txt" > "$2/poses.txt"
  for folder in rgb depth masks instance; do
    mkdir "$2/$folder"
    for ((i = 0; i < $1; ++i)); do cp "$sample/$folder/$(printf %06d "$i").png" "$2/$folder"; done
  done
}
short 6 "$work/first"
short 5 "$work/other"

# --- The sample, and a sequence that is not there: it is a row, and the exit status.

ends "sample" 1 "FAILED: $work/none: no such folder" "$sample" "$work/none" --rates 1,4 --html "$work/eval.html" \
  --json "$work/eval.json" --hide-movers
grep -q '^POOLED ' "$work/stdout" || fail "no pooled row"

# --- Starts.

ends "starts" 1 "POOLED" "$sample" "$work/none" --starts 8 --drop-largest 3
grep -q '^mini  *3 ' "$work/stdout" || fail "not three starts in 24 frames"
ends "too short for a start" 1 "has fewer frames than --start-frames 8" "$work/other" --starts 1
ends "starts with a page" 2 "--html cannot be combined with --starts" "$sample" --starts 8 --html "$work/no.html"
ends "a mover dropped without starts" 2 "--drop-largest needs --starts" "$sample" --drop-largest 3

# --- Masks as late as a network's.

ends "late masks" 1 "FAILED: $work/none: no such folder" "$sample" "$work/none" --network-delay 0,250 --plot "$work/late.svg"
grep -q '^ *with frame ' "$work/stdout" || fail "no row of masks with their frame"
# 24 frames of 0.1 s: each frame but the last; at 250 ms frames 0, 2, 4, 7, 9, 12, 14, 17 and 19.
grep -q '^ *0  *23/24  *0 ' "$work/stdout" || fail "without a delay not every mask was used"
grep -q '^ *250  *9/24  *0 ' "$work/stdout" || fail "a network of 250 ms has not segmented 9 frames in time"
[ "$(grep -c '<polyline' "$work/late.svg")" -eq 3 ] || fail "the plot has not three lines"
cp "$work/late.svg" "$work/late_once.svg"
ends "late masks side by side" 1 "with frame" "$sample" "$work/none" --network-delay 0,250 --plot "$work/late.svg" --jobs 3
cmp -s "$work/late.svg" "$work/late_once.svg" || fail "the plot differs with --jobs"
ends "a plot of nothing" 2 "--plot needs --network-delay" "$sample" --plot "$work/late.svg"
ends "delays in words" 2 "--network-delay" "$sample" --network-delay soon
ends "delays and rates" 2 "--network-delay takes one rate" "$sample" --network-delay 50 --rates 1,2

# --- Beside the rules of published systems.

"$dot_eval" "$work/first" --compare > "$work/stdout" 2> "$work/stderr"
if grep -q "video module" "$work/stderr"; then
  ends "compared without optical flow" 2 "--compare needs OpenCV's video module" "$work/first" --compare
else
  ends "compared" 1 "FAILED: $work/none: no such folder" "$sample" "$work/none" --compare
  cp "$work/stdout" "$work/compare.txt"
  for rule in dot "VDO-SLAM, paper" "VDO-SLAM, program" "DS-SLAM, program" "DynaSLAM, geometry"; do
    [ "$(grep -c "^$rule  " "$work/compare.txt")" -eq 2 ] || fail "no rows of $rule"
  done
  # Everything moves: each standing object-frame is called moving, and none is missed for want of an answer.
  grep -Eq '^everything moves +[0-9]+ +0\.[0-9]+ +0\.[0-9]+ +1\.000 +1\.000 +1\.000 +0\.000 ' "$work/compare.txt" ||
    fail "everything moves, but the table has it otherwise"
  # The tracker's row is that of the plain table.
  "$dot_eval" "$sample" > "$work/plain.txt" 2> "$work/stderr" || fail "the plain table"
  [ "$(awk '$1 == "POOLED" { print $3, $4, $5, $6, $7, $8, $9, $10 }' "$work/plain.txt")" = \
    "$(awk '$1 == "dot" { print $2, $3, $4, $5, $6, $7, $8, $9; exit }' "$work/compare.txt")" ] ||
    fail "the tracker is not measured as without --compare"
fi
ends "compared with a page" 2 "--html cannot be combined with --compare" "$sample" --compare --html "$work/no.html"

# --- With --out the files are those of dot_run.

ends "output" 0 "first" "$work/first" --rates 2 --out "$work/out"
"$dot_run" "$work/first" --mask-every 2 --out "$work/run" > /dev/null || fail "dot_run failed"
for file in camera.txt objects.csv labels/000005.png instances/000005.png; do
  cmp -s "$work/run/$file" "$work/out/first-every2/$file" || fail "$file differs from dot_run's"
done
[ "$(wc -l < "$work/out/first-every2/timing.csv")" -eq 7 ] || fail "timing.csv has not a line a frame"

mv "$work/out/first-every2/labels/000005.png" "$work/out/first-every2/labels/000009.png"
ends "output again" 0 "first" "$work/first" --rates 2 --out "$work/out"
[ "$(ls "$work/out/first-every2/labels")" = "$(ls "$work/run/labels")" ] || fail "a second run leaves files of the first"

# --- Side by side the results are the same, in the same order; times apart.

figures() { grep -v -e '_ms' -e '"ms_per_frame"' -e '"image"' -e '"camera": [0-9]' -e '"masks"' -e '"objects"' \
  -e '"label"' -e '"points"' -e '"total"' "$1"; }
ends "one job" 0 "other" "$work/first" "$work/other" --rates 1,3 --json "$work/one.json" --jobs 1
ends "three jobs" 0 "other" "$work/first" "$work/other" --rates 1,3 --json "$work/three.json" --jobs 3
[ "$(figures "$work/one.json")" = "$(figures "$work/three.json")" ] || fail "--jobs changes the figures"

# --- Truth that is absent in part.

cp -r "$work/first" "$work/posesonly"
rm -r "$work/posesonly/instance"
ends "camera truth alone" 0 "posesonly" "$work/posesonly" --html "$work/posesonly.html" --json "$work/posesonly.json"
rm "$work/posesonly/poses.txt"
ends "no truth" 1 "has no ground truth" "$work/posesonly"

# --- Command line.

ends "help" 0 "--hide-movers" --help
if [ -e /dev/full ]; then
  "$dot_eval" --help > /dev/full 2> "$work/stderr"
  [ $? -eq 1 ] && grep -q "standard output: cannot be written" "$work/stderr" || fail "output that is lost is not told"
fi
ends "no sequence" 2 "no sequence" --rates 1
ends "rate 0" 2 "--rates" "$sample" --rates 0,1
ends "rate twice" 2 "--rates" "$sample" --rates 2,2
ends "the same sequence twice" 2 "given twice" "$work/first" "$work/out/../first"
ends "a camera for two" 2 "--camera" "$work/first" "$work/other" --camera "$work/first/poses.txt"
ends "negative speed" 2 "--min-speed" "$sample" --min-speed -1
ends "unknown option" 2 "--no-such" "$sample" --no-such
ends "too many threads" 2 "--threads needs a whole number from 1 to 256" "$sample" --threads 100000
ends "too many threads in the settings" 1 ":1: threads" "$sample" --config <(echo "threads = 100000")
ends "unknown setting" 1 "velocity.v1" "$sample" --config <(echo "velocity.v1 = 1")
ends "page into a folder that is not there" 1 "$work/none/x.html" "$work/first" --html "$work/none/x.html"

if [ "$failures" -gt 0 ]; then
  echo "$failures checks failed" >&2
  exit 1
fi
echo "all checks passed"
