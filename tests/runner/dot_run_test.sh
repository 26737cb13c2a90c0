#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Bad input of the sequence runner: each case must end with its status and one line that names the file or option.
# usage: dot_run_test.sh DOT_RUN SAMPLE_DIR

set -u
if [ $# -ne 2 ]; then
  echo "usage: $0 DOT_RUN SAMPLE_DIR" >&2
  exit 2
fi
dot_run=$1
sample=$2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0
cases=0

# A fresh copy of the sample's first three frames, at $seq, and an output folder that does not exist yet, at $out.
fresh() {
  cases=$((cases + 1))
  seq=$work/$cases/seq
  out=$work/$cases/out
  mkdir -p "$seq"
  cp "$sample/intrinsics.txt" "$seq"
  head -n 3 "$sample/times.txt" > "$seq/times.txt"
  local folder
  for folder in rgb depth masks right; do
    mkdir "$seq/$folder"
    cp "$sample/$folder"/00000[012].* "$seq/$folder"
  done
}

fail() {
  failures=$((failures + 1))
  echo "FAILED: $1" >&2
  sed 's/^/    /' "$work/stderr" >&2
}

# rejects WHAT STATUS TEXT ARGUMENT...: the runner ends with STATUS and says TEXT in one line.
rejects() {
  local what=$1 status=$2 text=$3 got
  shift 3
  "$dot_run" "$@" > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq "$status" ] || fail "$what: status $got, expected $status"
  grep -qF -- "$text" "$work/stderr" || fail "$what: the message does not contain '$text'"
  [ "$(wc -l < "$work/stderr")" -eq 1 ] || fail "$what: the message is not one line"
}

# accepts WHAT ARGUMENT...: the runner ends with 0 and complains of nothing.
accepts() {
  local what=$1 got
  shift
  "$dot_run" "$@" > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq 0 ] || fail "$what: status $got, expected 0"
  [ ! -s "$work/stderr" ] || fail "$what: says something on standard error"
}

# has FILE...: files that must exist and not be empty.
has() {
  local file
  for file in "$@"; do [ -s "$file" ] || fail "$file is missing or empty"; done
}

truncate_file() { head -c 200 "$1" > "$1.part" && mv "$1.part" "$1"; }

# --- What must work: otherwise the rejections below prove nothing.

fresh
accepts "plain run" "$seq" --out "$out" --overlay --masks-out "$out/masks" --mask-every=2 --threads 1
has "$out"/{labels,instances,overlay,masks/mask_dot,masks/mask_all}/00000{0,1,2}.png
has "$out"/{camera.txt,objects.csv,timing.csv}
[ "$(head -n 1 "$out/camera.txt")" = "1 0 0 0 0 1 0 0 0 0 1 0" ] || fail "camera.txt does not begin with the identity"
accepts "its own camera.txt as --camera" "$seq" --out "$out/2" --camera "$out/camera.txt"
# The digits of a file are rounded, hence the comparison of numbers.
paste -d ' ' "$out/camera.txt" "$out/2/camera.txt" | awk '
  { for (i = 1; i <= 12; ++i) if (($i - $(i + 12)) ^ 2 > 1e-20) bad = 1 } END { exit bad || NR != 3 }' \
  || fail "--camera does not reproduce the poses it was given"

fresh
accepts "stereo" "$seq" --out "$out" --stereo
rm -r "$seq/depth"
accepts "stereo without a depth folder" "$seq" --out "$out"

fresh
rm -r "$seq/masks"
accepts "no masks" "$seq" --out "$out"
[ "$(wc -l < "$out/objects.csv")" -eq 1 ] || fail "objects without any mask"
grep -qF "masks     none: there is no folder $seq/masks" "$work/stdout" || fail "the summary does not say that there were no masks"
fresh
rm "$seq/masks/000000.png"
accepts "no masks in the frames that are wanted" "$seq" --out "$out" --mask-every 3
grep -q '^masks     none in these frames' "$work/stdout" || fail "the summary does not say that no mask was wanted"
accepts "masks in two of three frames" "$seq" --out "$out"
grep -q '^masks     in 2 of 3 frames$' "$work/stdout" || fail "the summary does not count the frames with masks"

fresh
rm "$seq/times.txt"
printf 'depth lidar\n' >> "$seq/intrinsics.txt"
printf '# a comment\nvelocity.v0 = 0.4\nclassifier = entropy\nmotion_prior.ground_vehicle = true\n' > "$seq/config"
accepts "settings" "$seq" --out "$out" --config "$seq/config"
grep -q 'lidar' "$work/stdout" || fail "the depth line of intrinsics.txt is not used"

fresh
{ echo id,class,score; seq -f '%.0f,person,0.9' 1 255; } > "$seq/masks/000001.csv"
accepts "list of instances" "$seq" --out "$out" --always-dynamic person,dog
# value COLUMN FILE: the values of a column, by its name
value() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; if (!c) exit 1 } NR > 1 { print $c }' "$2"; }
value always_dynamic "$out/objects.csv" | grep -q '^1$' || fail "--always-dynamic has no effect"
accepts "list of instances without the option" "$seq" --out "$out/2"
! value always_dynamic "$out/2/objects.csv" | grep -q '^1$' || fail "objects are always dynamic without the option"
fresh
accepts "discovery" "$seq" --out "$out" --discover
value discovered "$out/objects.csv" >/dev/null || fail "objects.csv does not tell what was discovered"
# Frame 0's masks arrive after frame 1 and show in frame 2.
fresh
accepts "delayed masks" "$seq" --out "$out" --mask-every 4 --mask-delay 1
! grep -q '^[01],' "$out/objects.csv" || fail "masks show before they have arrived"
grep -q '^2,' "$out/objects.csv" || fail "masks that arrived late do not show"
# A page or a video needs no other output.
fresh
accepts "player alone" "$seq" --player "$work/run.html"
grep -qF "player    $work/run.html" "$work/stdout" || fail "the summary does not name the player"
[ "$(grep -c 'class="frame"' "$work/run.html")" -eq 3 ] || fail "the player does not have the frames"
accepts "player in the folder of the results" "$seq" --out "$out" --player "$out/run.html" --overlay
accepts "the same again" "$seq" --out "$out" --player="$out/run.html"
has "$out/run.html" "$out/timing.csv"
if "$dot_run" "$seq" --video "$work/run.mp4" > "$work/stdout" 2> "$work/stderr"; then
  has "$work/run.mp4"
  grep -qF "video     $work/run.mp4" "$work/stdout" || fail "the summary does not name the video"
else
  grep -qF "built without OpenCV's module videoio" "$work/stderr" || fail "no video, and not for want of videoio"
fi
accepts "help" --help
grep -q -- '--mask-every' "$work/stdout" || fail "--help does not list the options"

# Frame numbers are those of rgb/, also where the recording's middle is played.
fresh
for folder in rgb depth masks; do rm "$seq/$folder"/000000.*; done
accepts "part of a recording" "$seq" --out "$out"
has "$out"/labels/00000{1,2}.png
[ ! -e "$out/labels/000000.png" ] || fail "a frame that rgb/ does not have was written"
[ "$(sed -n 2p "$out/timing.csv" | cut -d , -f 1)" = 1 ] || fail "timing.csv does not use the frame numbers of rgb/"

# --- Command line.

fresh
rejects "unknown option" 2 "--no-such-option" "$seq" --out "$out" --no-such-option
rejects "no sequence" 2 "sequence" --out "$out"
rejects "no output" 2 "--out" "$seq"
rejects "pictures without a folder for them" 2 "--overlay needs --out" "$seq" --player "$out.html" --overlay
rejects "masks without results" 2 "--masks-out needs --out" "$seq" --player "$out.html" --masks-out "$out"
rejects "player of another kind" 2 "--player needs a name that ends in .html, not 'run.png'" "$seq" --player run.png
rejects "video of another kind" 2 "--video needs a name that ends in .mp4 or .mkv or .avi" "$seq" --video run.html
rejects "player in no folder" 1 "$out/run.html: cannot be written" "$seq" --player "$out/run.html"
rejects "video in no folder" 1 "$out/run.mp4: cannot be written" "$seq" --video "$out/run.mp4"
rejects "option without value" 2 "--out" "$seq" --out
rejects "two sequences" 2 "more than one sequence" "$seq" "$seq" --out "$out"
rejects "mask rate 0" 2 "--mask-every" "$seq" --out "$out" --mask-every 0
rejects "mask rate in words" 2 "--mask-every" "$seq" --out "$out" --mask-every often
rejects "no threads" 2 "--threads" "$seq" --out "$out" --threads 0
rejects "too many threads" 2 "--threads needs a whole number from 1 to 256" "$seq" --out "$out" --threads 257
rejects "threads beyond reason" 2 "--threads" "$seq" --out "$out" --threads 100000
echo "threads = 100000" > "$seq/config"
rejects "threads beyond reason in the settings" 1 "config:1: threads" "$seq" --out "$out" --config "$seq/config"
rejects "unknown classifier" 2 "--classifier" "$seq" --out "$out" --classifier guess
rejects "delay beyond the end" 1 "--mask-delay 3: no mask would arrive" "$seq" --out "$out" --mask-delay 3
echo "mask.late_seconds = 0.05" > "$seq/config"
rejects "delay beyond mask.late_seconds" 1 "--mask-delay 2: frame_id" "$seq" --out "$out" --config "$seq/config" --mask-delay 2
rejects "negative delay" 2 "--mask-delay" "$seq" --out "$out" --mask-delay -1
rejects "output into the sequence" 2 "--out" "$seq" --out "$seq/."
[ ! -e "$seq/objects.csv" ] || fail "the sequence's folder was written to"

# --- Folders and tables of the sequence.

rejects "no such sequence" 1 "$seq/none" "$seq/none" --out "$out"
rejects "no such depth folder" 1 "$seq/none" "$seq" --out "$out" --depth-dir none
rejects "no such mask folder" 1 "$seq/none" "$seq" --out "$out" --mask-dir none
rejects "no configuration" 1 "$seq/none" "$seq" --out "$out" --config "$seq/none"
rejects "no camera file" 1 "$seq/none" "$seq" --out "$out" --camera "$seq/none"

fresh; rm "$seq/intrinsics.txt"
rejects "missing intrinsics" 1 "intrinsics.txt" "$seq" --out "$out"
fresh; : > "$seq/intrinsics.txt"
rejects "empty intrinsics" 1 "intrinsics.txt:1: fx" "$seq" --out "$out"
fresh; echo "362.5 362.5 309.5 93.5 620 188" > "$seq/intrinsics.txt"
rejects "intrinsics without baseline" 1 "intrinsics.txt:1: baseline" "$seq" --out "$out"
fresh; echo "0 362.5 309.5 93.5 620 188 0.53 10" > "$seq/intrinsics.txt"
rejects "focal length 0" 1 "intrinsics.txt:1: fx" "$seq" --out "$out"
fresh; echo "362.5 abc 309.5 93.5 620 188 0.53 10" > "$seq/intrinsics.txt"
rejects "focal length in letters" 1 "intrinsics.txt:1: fy" "$seq" --out "$out"
fresh; echo "362.5 362.5 309.5 93.5 620 188 0.53 0" > "$seq/intrinsics.txt"
rejects "frame rate 0" 1 "intrinsics.txt:1: fps" "$seq" --out "$out"
fresh; echo "362.5 362.5 309.5 93.5 640 480 0.53 10" > "$seq/intrinsics.txt"
rejects "another image size" 1 "rgb/000000.png" "$seq" --out "$out"
fresh; echo "depth sonar" >> "$seq/intrinsics.txt"
rejects "unknown depth source" 1 "intrinsics.txt:2: " "$seq" --out "$out"
fresh; echo "362.5 362.5 309.5 93.5 620 188 0 10" > "$seq/intrinsics.txt"
rejects "stereo without baseline" 1 "intrinsics.txt: baseline" "$seq" --out "$out" --stereo
fresh; rm -r "$seq/right"
rejects "stereo without right images" 1 "$seq/right" "$seq" --out "$out" --stereo
fresh; rm "$seq"/right/000001.*
rejects "missing right image" 1 "right/000001" "$seq" --out "$out" --stereo
fresh; rm -r "$seq/rgb"
rejects "no images" 1 "$seq/rgb" "$seq" --out "$out"
fresh; rm "$seq"/rgb/*
rejects "empty image folder" 1 "$seq/rgb" "$seq" --out "$out"
fresh; cp "$seq/rgb/000001.png" "$seq/rgb/000001.jpg"
rejects "two images of a frame" 1 "rgb/000001" "$seq" --out "$out"
fresh; printf '0\n0.1\n' > "$seq/times.txt"
rejects "too few times" 1 "times.txt" "$seq" --out "$out"
fresh; printf '0\n0.1\n0.1\n' > "$seq/times.txt"
rejects "times that stand still" 1 "times.txt:3:" "$seq" --out "$out"
fresh; printf '0\nnoon\n0.2\n' > "$seq/times.txt"
rejects "times in words" 1 "times.txt:2:" "$seq" --out "$out"

# --- Images.

for file in rgb/000001.png depth/000002.png masks/000001.png; do
  fresh; truncate_file "$seq/$file"
  rejects "truncated $file" 1 "$file" "$seq" --out "$out"
  fresh; : > "$seq/$file"
  rejects "empty $file" 1 "$file" "$seq" --out "$out"
  fresh; echo "this is not an image" > "$seq/$file"
  rejects "text in $file" 1 "$file" "$seq" --out "$out"
done
fresh; rm "$seq/depth/000001.png"
rejects "missing depth" 1 "depth/000001.png" "$seq" --out "$out"
fresh; truncate_file "$seq/right/000001.jpg"
rejects "truncated JPEG" 1 "right/000001.jpg" "$seq" --out "$out" --stereo
fresh; cp "$seq/rgb/000001.png" "$seq/depth/000001.png"
rejects "colour as depth" 1 "depth/000001.png" "$seq" --out "$out"
fresh; cp "$seq/rgb/000001.png" "$seq/masks/000001.png"
rejects "colour as mask" 1 "masks/000001.png" "$seq" --out "$out"
fresh; cp "$seq/depth/000001.png" "$seq/rgb/000001.png"
rejects "depth as image" 1 "rgb/000001.png" "$seq" --out "$out"
fresh; rm "$seq/masks/000001.png"; mkdir "$seq/masks/000001.png"
rejects "folder as mask" 1 "masks/000001.png" "$seq" --out "$out"
fresh; ln -sf nowhere "$seq/masks/000001.png"
rejects "dangling link as mask" 1 "masks/000001.png" "$seq" --out "$out"
fresh; printf '0,car,1\n' > "$seq/masks/000001.csv"
rejects "instance 0" 1 "masks/000001.csv:1:" "$seq" --out "$out"
fresh; printf 'id,class,score\n1\n' > "$seq/masks/000001.csv"
rejects "instance without class" 1 "masks/000001.csv:2:" "$seq" --out "$out"

fresh; rm "$seq"/masks/*
rejects "empty mask folder" 1 "$seq/masks: holds no masks" "$seq" --out "$out"
fresh; rm -r "$seq/masks"; : > "$seq/masks"
rejects "file instead of masks/" 1 "$seq/masks" "$seq" --out "$out"
fresh; for file in "$seq"/masks/*.png; do echo "this is not an image" > "$file"; done
rejects "no mask that can be read" 1 "masks/000000.png" "$seq" --out "$out"

# --- Files named on the command line.

fresh; echo "velocity.v1 = 0.5" > "$seq/config"
rejects "unknown setting" 1 "velocity.v1" "$seq" --out "$out" --config "$seq/config"
fresh; printf '\nvelocity.v0 = fast\n' > "$seq/config"
rejects "setting in words" 1 "config:2: velocity.v0" "$seq" --out "$out" --config "$seq/config"
fresh; echo "align.max_levels = 3.5" > "$seq/config"
rejects "half a level" 1 "align.max_levels" "$seq" --out "$out" --config "$seq/config"
fresh; echo "velocity.v0" > "$seq/config"
rejects "setting without value" 1 "config:1: " "$seq" --out "$out" --config "$seq/config"
fresh; echo "velocity.v0 = -1" > "$seq/config"
rejects "setting out of range" 1 "velocity.v0" "$seq" --out "$out" --config "$seq/config"
fresh; printf '1 0 0 0 0 1 0 0 0 0 1 0\n' > "$seq/poses"
rejects "too few poses" 1 "$seq/poses" "$seq" --out "$out" --camera "$seq/poses"
fresh; printf '1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0\n1 0 0 0 0 1 0 0 0 0 1 0\n' > "$seq/poses"
rejects "short pose" 1 "poses:2:" "$seq" --out "$out" --camera "$seq/poses"
fresh; printf '1 0 0 0 0 1 0 0 0 0 1 0\n2 0 0 0 0 2 0 0 0 0 2 0\n1 0 0 0 0 1 0 0 0 0 1 0\n' > "$seq/poses"
rejects "pose with a scale" 1 "poses:2:" "$seq" --out "$out" --camera "$seq/poses"

# --- Outputs. A file where a folder belongs stops root as well, unlike a missing permission.

fresh; : > "$work/$cases/file"
rejects "output below a file" 1 "$work/$cases/file/out" "$seq" --out "$work/$cases/file/out"
fresh; mkdir -p "$out"; : > "$out/labels"
rejects "file instead of labels/" 1 "$out/labels" "$seq" --out "$out"
fresh; mkdir -p "$out/objects.csv"
rejects "folder instead of objects.csv" 1 "$out/objects.csv" "$seq" --out "$out"
fresh; mkdir -p "$out/labels/000001.png"
rejects "folder instead of a label image" 1 "$out/labels/000001.png" "$seq" --out "$out"
has "$out/labels/000000.png"
fresh; : > "$work/$cases/file"
rejects "masks below a file" 1 "$work/$cases/file/m" "$seq" --out "$out" --masks-out "$work/$cases/file/m"

# --- A second run into the same folder leaves nothing of the first, and nothing else is removed.

# names FOLDER: all files in it.
names() { (cd "$1" && find . -type f | sort); }

fresh
"$dot_run" "$seq" --out "$work/clean" --masks-out "$work/clean/m" > /dev/null
rm "$seq"/{rgb,depth,masks}/000002.png
accepts "a run of two frames" "$seq" --out "$work/two" --masks-out "$work/two/m"
fresh
accepts "a run of three frames" "$seq" --out "$out" --masks-out "$out/m" --overlay
mkdir "$out/labels/000009.png" "$out/plots"
touch "$out/notes.txt" "$out/labels/legend.png" "$out/overlay/00001.png" "$out/m/mask_dot/readme" "$out/plots/000000.png"
rm "$seq"/{rgb,depth,masks}/000002.png
accepts "a run of two frames into its folder" "$seq" --out "$out" --masks-out "$out/m"
expected=$(printf '%s\n' ./labels/legend.png ./m/mask_dot/readme ./notes.txt ./overlay/00001.png ./plots/000000.png)
left=$(comm -13 <(names "$work/two") <(names "$out"))
[ "$left" = "$expected" ] || fail "beside the results of two frames there is: $left"
[ -d "$out/labels/000009.png" ] || fail "a folder was removed"
fresh
accepts "masks in the folder of the results" "$seq" --out "$out" --masks-out "$out"
accepts "no masks the next time" "$seq" --out "$out"
[ ! -e "$out/mask_dot" ] && [ ! -e "$out/mask_all" ] || fail "masks of the run before are left"
fresh
mkdir -p "$out/labels"; touch "$out/labels/000007.png"
rejects "labels of somebody else" 1 "$out/labels/000007.png" "$seq" --out "$out"
[ -f "$out/labels/000007.png" ] || fail "a file of somebody else was removed"
fresh
mkdir -p "$out"; echo "my camera" > "$out/camera.txt"
rejects "camera.txt of somebody else" 1 "$out/camera.txt" "$seq" --out "$out"
[ "$(cat "$out/camera.txt")" = "my camera" ] || fail "camera.txt of somebody else was written to"

# --- A run that ends with an error leaves neither page nor video, nor the half of one.

fresh
rm "$seq/depth/000002.png"
touch "$work/$cases/seq/depth/000002.png"
mkdir "$out"
"$dot_run" "$seq" --player "$out/run.html" > /dev/null 2> "$work/stderr" && fail "an empty depth image is accepted"
"$dot_run" "$seq" --video "$out/run.mp4" > /dev/null 2> "$work/stderr" && fail "an empty depth image is accepted"
[ -z "$(ls "$out")" ] || fail "an error leaves $(ls "$out")"

# --- A run that is killed: no picture is half written, no table has its name; the next run is as any other.

fresh
cp -r "$seq" "$seq.whole"
rm "$seq/depth/000002.png"
mkfifo "$seq/depth/000002.png" # the run waits here for its third frame
"$dot_run" "$seq" --out "$out" --masks-out "$out/m" > /dev/null 2>&1 &
run=$!
# The tables' lines of a frame follow its pictures; the wait is long for a slow machine alone.
for ((i = 0; i < 600; ++i)); do
  grep -qs '^1,' "$out/timing.csv.partial" "$out/timing.csv" && break
  sleep 0.1
done
kill -KILL "$run"
wait "$run" 2> /dev/null
for file in labels instances m/mask_dot m/mask_all; do
  for i in 0 1; do cmp -s "$out/$file/00000$i.png" "$work/clean/$file/00000$i.png" || fail "killed: $file/00000$i.png differs"; done
  [ "$(ls "$out/$file")" = "$(printf '00000%d.png\n' 0 1)" ] || fail "killed: $file/ holds $(ls "$out/$file")"
done
for file in camera.txt objects.csv timing.csv; do
  [ ! -e "$out/$file" ] || fail "killed: $file looks complete"
  [ -s "$out/$file.partial" ] || fail "killed: nothing of $file was kept"
done
cmp -s <(head -n 2 "$work/clean/camera.txt") "$out/camera.txt.partial" || fail "killed: the camera of two frames is not there"
# As if it had been killed while it wrote a picture, too.
head -c 20 "$work/clean/labels/000002.png" > "$out/labels/000002.png.partial"
echo "not ours" > "$out/labels/000002.partial"
accepts "after a killed run" "$seq.whole" --out "$out" --masks-out "$out/m"
rm "$out/labels/000002.partial" || fail "a file that is not ours was removed"
[ "$(names "$out")" = "$(names "$work/clean")" ] || fail "after a killed run the folder holds: $(names "$out")"
diff -r -x timing.csv "$work/clean" "$out" > "$work/stderr" || fail "after a killed run the results differ"

if [ "$failures" -gt 0 ]; then
  echo "$failures checks failed" >&2
  exit 1
fi
echo "all checks passed"
