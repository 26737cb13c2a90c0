#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# dot_run with a network and in real time: on the sample, bad input, and stopped in the middle.
# usage: dot_run_test.sh DOT_RUN SAMPLE_DIR CARS_ONNX MODEL_DIR

set -u
if [ $# -ne 4 ]; then
  echo "usage: $0 DOT_RUN SAMPLE_DIR CARS_ONNX MODEL_DIR" >&2
  exit 2
fi
dot_run=$1
sample=$2
cars=$3
models=$4
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $1" >&2
  cat "$work/stdout" "$work/stderr" | sed 's/^/    /' >&2
}

# accepts WHAT OUT ARGUMENT...: a run over the sample ends with 0 and complains of nothing.
accepts() {
  local what=$1 out=$2 got
  shift 2
  "$dot_run" "$sample" --out "$work/$out" "$@" > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq 0 ] || fail "$what: status $got, expected 0"
  [ ! -s "$work/stderr" ] || fail "$what: says something on standard error"
}

# says WHAT TEXT: on standard output.
says() { grep -qF -- "$2" "$work/stdout" || fail "$1: does not say '$2'"; }

# rejects WHAT STATUS TEXT ARGUMENT...: ends with STATUS and says TEXT in one line.
rejects() {
  local what=$1 status=$2 text=$3 got
  shift 3
  "$dot_run" "$sample" --out "$work/rejected" "$@" > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq "$status" ] || fail "$what: status $got, expected $status"
  grep -qF -- "$text" "$work/stderr" || fail "$what: the message does not contain '$text'"
  [ "$(wc -l < "$work/stderr")" -eq 1 ] || fail "$what: the message is not one line"
}

# large STATE PIXELS: objects of that state with so many pixels, in frame 16 of the run with_frame.
large() {
  awk -F, -v state="$1" -v least="$2" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "pixels") pixels = i }
    $1 == 16 && $3 == state && $pixels >= least { ++count }
    END { print count + 0 }' "$work/with_frame/objects.csv"
}

# --- With its frame: the cars that move are found, the masks of the sample are not read.

accepts "network" with_frame --network "$cars"
says "network" "masks     in 24 of 24 frames"
says "network" "network   $cars: ids, input 620x188, O" # OpenCV or ONNX Runtime
# In frame 16 the car that comes towards the camera has 5,745 pixels, the van 2,006, and the nearest parked car 15,880.
[ "$(large moving 1500)" -eq 2 ] || fail "frame 16 has not two large movers"
[ "$(large static 10000)" -eq 1 ] || fail "frame 16 does not have the parked car as static"
if grep -qF "ONNX Runtime" "$work/stdout"; then
  accepts "OpenCV" opencv --network "$cars" --network-backend opencv
  says "OpenCV" "ids, input 620x188, OpenCV"
  diff -r -x timing.csv "$work/with_frame" "$work/opencv" > "$work/stderr" || fail "OpenCV and ONNX Runtime differ"
fi
accepts "every fourth frame" every --network "$cars" --mask-every 4
says "every fourth frame" "masks     in 6 of 24 frames"
accepts "format" format --network "$cars" --network-format ids --network-size 620x188
diff -r -x timing.csv "$work/with_frame" "$work/format" > "$work/stderr" || fail "the format that was guessed differs"

# --- Later, in the time of the sequence: the same at each run.

accepts "delay" delay1 --network "$cars" --network-delay 150
says "delay" "masks of 17 frames: 15 used, 0 too late, 2 not done at the end; 7 frames skipped by the network"
accepts "delay again" delay2 --network "$cars" --network-delay 150
diff -r -x timing.csv "$work/delay1" "$work/delay2" > "$work/stderr" || fail "a delayed run differs from the one before"
accepts "the sequence's masks with a delay" delay3 --network-delay 250
! grep -q '^[012],' "$work/delay3/objects.csv" || fail "masks of frame 0 show before 250 ms"
grep -q '^3,' "$work/delay3/objects.csv" || fail "masks of frame 0 do not show after 250 ms"
accepts "too slow a network" delay4 --network-delay 1500
says "too slow a network" "0 used, 1 too late"

# The time of a frame is that of the tracker's stages alone: the network takes about as long again. A busy machine may
# stop the program between two clocks, but not in most frames.
accepts "the time of a frame" timed --network "$cars" --network-delay 0
awk -F, 'NR > 1 { stages = 0; for (i = 2; i < NF; ++i) stages += $i; longer += $NF > 1.25 * stages }
  END { exit !(NR == 25 && longer < 12) }' "$work/timed/timing.csv" || fail "the frame's time has that of the network"

# --- In real time.

accepts "real time" real --network "$cars" --real-time 30
says "real time" "real time 24 frames came"
says "real time" "from frame to masks median"
[ "$(tail -n 1 "$work/real/timing.csv" | cut -d , -f 1)" = 23 ] || fail "the last frame was not tracked"
accepts "real time without a network" real2 --real-time=50 --network-delay 40
accepts "real time by the timestamps" real3 --real-time

# --- With a page: one list of outputs, in each way of running.

frames_of() { grep -c 'class="frame"' "$1"; }
accepts "page, masks with their frame" page1 --network "$cars" --player "$work/page1.html"
[ "$(frames_of "$work/page1.html")" -eq 24 ] || fail "the page has not 24 frames"
diff -r -x timing.csv "$work/with_frame" "$work/page1" > "$work/stderr" || fail "the results differ with a page"
accepts "page, delay" page2 --network-delay 150 --player "$work/page2.html"
[ "$(frames_of "$work/page2.html")" -eq 24 ] || fail "the page of the delay has not 24 frames"
accepts "page, real time" page3 --network "$cars" --real-time 30 --player "$work/page3.html"
tracked=$(($(wc -l < "$work/page3/timing.csv") - 1))
[ "$(frames_of "$work/page3.html")" -eq "$tracked" ] || fail "the page of real time has not the $tracked frames of the tables"

# --- Stopped in the middle: no table has its name, and the program says so.

"$dot_run" "$sample" --out "$work/stopped" --player "$work/stopped.html" --network "$cars" --real-time 2 > "$work/stdout" 2> "$work/stderr" &
run=$!
# The wait is long for a slow machine alone.
for ((i = 0; i < 600; ++i)); do
  grep -qs '^1,' "$work/stopped/timing.csv.partial" && break
  sleep 0.1
done
kill -INT "$run"
wait "$run"
[ $? -eq 130 ] || fail "stopped: the status is not 130"
grep -q '^dot_run: interrupted after [0-9]* frames$' "$work/stderr" || fail "stopped: does not say so"
[ ! -e "$work/stopped/timing.csv" ] && [ -s "$work/stopped/timing.csv.partial" ] || fail "stopped: the table looks complete"
ls "$work"/stopped.html* > /dev/null 2>&1 && fail "stopped: there is a page"
! grep -q 'stopped.html' "$work/stdout" || fail "stopped: names a page that is not there"

# --- Bad input.

rejects "no file" 1 "$work/none.onnx: cannot be read" --network "$work/none.onnx"
rejects "a folder" 1 "$models: cannot be read" --network "$models"
rejects "no network" 1 "times.txt: is no ONNX model" --network "$sample/times.txt"
rejects "a layer that is not supported" 1 'of type "Det"' --network "$models/unsupported.onnx" --network-backend opencv
rejects "another format" 1 "cars.onnx: has no output of shape 1xMxN (boxes, scores and coefficients), only 'ids' 1x1x47x155" \
  --network "$cars" --network-format yolo-seg
rejects "another number of classes" 1 "expected 1x86xN (YOLOv8, YOLO11)" --network "$models/yolo_v8.onnx"
rejects "a failure beside the tracker" 1 "expected 1x86xN (YOLOv8, YOLO11)" --network "$models/yolo_v8.onnx" --real-time
rejects "a failure with a delay" 1 "no_ids.onnx: output 'ids' is 0.5" --network "$models/no_ids.onnx" --network-delay 50
rejects "another size" 1 "and --network-size says 640x640" --network "$cars" --network-size 640x640
rejects "no size" 2 "--network-size needs WxH" --network "$cars" --network-size 640
for size in x12 12x 640x0 640x384x3 x; do
  rejects "size $size" 2 "--network-size needs WxH, as 640x384, each from 1 to 16384, not '$size'" --network "$cars" --network-size "$size"
done
rejects "unknown format" 2 "--network-format must be one of yolo-seg, mask-rcnn, ids" --network "$cars" --network-format rle
rejects "unknown backend" 2 "--network-backend must be one of opencv, onnxruntime" --network "$cars" --network-backend cuda
rejects "score of 0" 2 "--network-score" --network "$cars" --network-score 0
rejects "score over 1" 2 "--network-score needs a number over 0 and at most 1, not '1.5'" --network "$cars" --network-score 1.5
rejects "score of ids" 2 "--network-score: an image of ids has no scores" --network "$cars" --network-score 0.5
rejects "dynamic classes of ids" 2 "--always-dynamic: an image of ids has no classes" --network "$cars" --always-dynamic car
rejects "option without a network" 2 "--network-size needs --network" --network-size 640x640
rejects "classes of ids" 2 "--network-classes" --network "$cars" --network-classes "$sample/times.txt"
rejects "masks of two sources" 2 "--mask-dir does not go with --network" --network "$cars" --mask-dir masks2
rejects "two delays" 2 "--mask-delay does not go with" --mask-delay 1 --network-delay 100
rejects "delay in words" 2 "--network-delay needs a whole number" --network-delay soon
rejects "too high a rate" 2 "--real-time needs a number over 0 and at most 1000, not '2000'" --real-time 2000
rejects "a rate of 0" 2 "--real-time needs a number over 0" --real-time 0
rejects "a rate in words" 2 "--real-time needs a number over 0" --real-time=fast

if [ "$failures" -gt 0 ]; then
  echo "$failures checks failed" >&2
  exit 1
fi
echo "all checks passed"
