#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# dot_run --list: many sequences, killed in the middle and started again.
# usage: dot_run_list_test.sh DOT_RUN SAMPLE_DIR docs/datasets.md

set -u
if [ $# -ne 3 ]; then
  echo "usage: $0 DOT_RUN SAMPLE_DIR DOCS" >&2
  exit 2
fi
dot_run=$1
sample=$2
docs=$3
work=$(mktemp -d) || exit 1
runner=
trap '[ -z "$runner" ] || kill -KILL "$runner" 2>/dev/null; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $1" >&2
  sed 's/^/    /' "$work/stderr" >&2
}

# ends WHAT STATUS TEXT ARGUMENT...: the runner ends with STATUS and says TEXT.
ends() {
  local what=$1 status=$2 text=$3 got
  shift 3
  "$dot_run" "$@" > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq "$status" ] || fail "$what: status $got, expected $status"
  cat "$work/stdout" "$work/stderr" | grep -qF -- "$text" || fail "$what: nothing says '$text'"
}

# short FIRST N FOLDER: N of the sample's frames.
short() {
  local folder i
  mkdir -p "$3"
  cp "$sample/intrinsics.txt" "$3"
  for folder in rgb depth masks; do
    mkdir "$3/$folder"
    for ((i = $1; i < $1 + $2; ++i)); do cp "$sample/$folder/$(printf %06d "$i").png" "$3/$folder"; done
  done
}

# same FOLDER FOLDER: the results are the same, but for times.
untimed() {
  (
    cd "$1" || exit 1
    find . -type f ! -name timing.csv ! -name run.log ! -name run.html ! -name complete.txt ! -name 'summary*' -exec sha256sum {} + | sort -k 2
    find . -name complete.txt -exec sed 's/^\(figures.*\) [^ ]*$/\1/' {} + | sort
    find . -name timing.csv -exec wc -l {} + | sort
    cut -d , -f 1-8,10 summary.csv
  )
}
same() { [ "$(untimed "$1")" = "$(untimed "$2")" ] || fail "$3: $2 differs from $1"; }

# status NAME FOLDER: as in the summary.
status() { awk -F , -v name="$1" '$1 == name { print $3 }' "$2/summary.csv"; }

# wait_until COMMAND...: at most a minute.
wait_until() {
  local i
  for ((i = 0; i < 1200; ++i)); do
    "$@" && return
    sleep 0.05
  done
  fail "waited in vain for: $*"
}

short 0 5 one/clone
short 4 5 two/clone
short 8 6 held
short 2 4 "with a space, and a comma"
short 10 5 last
cat > list.txt <<'TXT'
# five sequences
one/clone
two/clone/

held
with a space, and a comma
last
TXT

# --- In one go, one after the other and side by side.

ends "in one go" 0 "sequences 5: 5 complete (0 of them before)" --list list.txt --out go --mask-every 2 --player run.html
[ "$(wc -l < go/summary.csv)" -eq 6 ] || fail "the summary has not a line a sequence"
[ "$(cut -d , -f 1 go/summary.csv | head -n 4 | tr '\n' ' ')" = "name one-clone two-clone held " ] || fail "names in the summary"
for name in one-clone two-clone held last; do
  [ -s "go/$name/objects.csv" ] && [ -s "go/$name/run.html" ] || fail "$name has no results"
  [ "$(status "$name" go)" = complete ] || fail "$name is not complete"
done
"$dot_run" one/clone --out single --mask-every 2 > stdout 2> stderr || fail "a single run"
for file in camera.txt objects.csv labels/000003.png instances/000003.png; do
  cmp -s "single/$file" "go/one-clone/$file" || fail "$file is not that of a single run"
done
ends "side by side" 0 "5 complete" --list list.txt --out side --mask-every 2 --player run.html --jobs 3
same go side "side by side"
ends "nothing left to do" 0 "5 complete (5 of them before)" --list list.txt --out side --mask-every 2 --player run.html --resume
same go side "nothing left to do"

# --- Stopped in the third sequence: its third image is a pipe, at which the run waits.

hold() {
  mv held/rgb/000010.png kept.png && mkfifo held/rgb/000010.png
  set -m # in a group of its own
  "$dot_run" --list list.txt --out "$1" --mask-every 2 --player run.html > stdout 2> stderr &
  runner=$!
  set +m
  wait_until [ -e "$1/held/labels/000009.png" ]
}
release() { rm -f held/rgb/000010.png && mv kept.png held/rgb/000010.png; }
inodes() { stat -c '%i %Y %n' "$1"/*-clone/complete.txt "$1"/*-clone/labels/*; }

hold killed
kill -KILL "$runner"
wait "$runner" 2> /dev/null
[ -s killed/one-clone/complete.txt ] && [ -s killed/two-clone/complete.txt ] || fail "two sequences should be complete"
[ ! -e killed/held/complete.txt ] || fail "the third sequence should not be complete"
[ ! -e killed/last ] || fail "the last sequence should not have begun"
[ ! -e killed/summary.csv ] || fail "a killed run has no summary"
release
before=$(inodes killed)
ends "killed, started again" 0 "5 complete (2 of them before)" --list list.txt --out killed --mask-every 2 --player run.html --resume --jobs 2
same go killed "killed, started again"
[ "$before" = "$(inodes killed)" ] || fail "what was complete was done again"

hold stopped
ends "a single run into its folder" 1 "stopped/held/run.log: another run is writing to this folder" last --out stopped/held
kill -TERM -- "-$runner" # to all of the group, as a batch system does
wait_until grep -q "waiting for the frames of 1 sequences" stderr
timeout 60 cp kept.png held/rgb/000010.png || fail "stopped: held waits for no frame" # it comes, and is the last one
wait "$runner"
got=$?
runner=
[ "$got" -eq 130 ] || fail "stopped: status $got, expected 130"
[ "$(status held stopped)$(status last stopped)" = interruptedinterrupted ] || fail "stopped: the summary does not say so"
[ "$(awk -F , '$1 == "held" { print $NF }' stopped/summary.csv)" = "" ] || fail "stopped: held did not end by itself"
[ -e stopped/held/labels/000010.png ] || fail "stopped: held did not end its frame"
[ -e stopped/held/timing.csv.partial ] && [ ! -e stopped/held/complete.txt ] || fail "stopped: held is complete"
release
ends "stopped, started again" 0 "5 complete (2 of them before)" --list list.txt --out stopped --mask-every 2 --player run.html --resume
same go stopped "stopped, started again"

# --- Other settings are not mixed with those of before, whatever their place on the command line.

ends "settings in another order" 0 "(5 of them before)" --resume --player=run.html --mask-every=2 --out go --list list.txt --threads 2
ends "another setting" 2 "was made with '--mask-every 2', and now '--mask-every 4' is asked for" \
  --list list.txt --out go --mask-every 4 --player run.html --resume
[ "$(wc -l < go/summary.csv)" -eq 6 ] || fail "what is refused destroys the summary"
ends "one setting less" 2 "was made with '--player run.html', and now nothing else is asked for" \
  --list list.txt --out go --mask-every 2 --resume
echo "velocity.v0 = 0.4" > settings.txt
ends "settings from a file" 0 "5 complete" --list list.txt --out config --config settings.txt
ends "the same file" 0 "(5 of them before)" --list list.txt --out config --config "$work/settings.txt" --resume
echo "velocity.v0 = 0.3" > settings.txt
ends "another content" 2 "'--config " --list list.txt --out config --config settings.txt --resume
ends "all again" 0 "5 complete (0 of them before)" --list list.txt --out config --config settings.txt
mkdir elsewhere && cp -r last elsewhere
echo elsewhere/last > other.txt
ends "another sequence of that name" 2 "elsewhere/last/' is asked for" --list other.txt --out config --config settings.txt --resume
cut -c 1-100 go/last/complete.txt | head -n 1 > cut.txt && mv cut.txt go/last/complete.txt
ends "a damaged mark" 0 "5 complete (4 of them before)" --list list.txt --out go --mask-every 2 --player run.html --resume
same side go "a damaged mark"
"$dot_run" last --out go/last > stdout 2> stderr || fail "a single run into one of the folders"
[ ! -e go/last/complete.txt ] || fail "results of other settings count as complete"
ends "one of them made otherwise" 0 "5 complete (4 of them before)" --list list.txt --out go --mask-every 2 --player run.html --resume
same side go "one of them made otherwise"

# --- What fails does not end the others.

short 0 3 cut
head -c 300 cut/rgb/000001.png > cut.png && mv cut.png cut/rgb/000001.png
printf '%s\n' cut none one/clone > failing.txt
ends "failures" 1 "sequences 3: 1 complete (0 of them before), 2 failed" --list failing.txt --out failing
grep -q '^cut,cut,failed,,,,,,,cut/rgb/000001.png: the file is cut short$' failing/summary.csv || fail "the reason of cut"
grep -q '^none,none,failed,,,,,,,none: no such folder$' failing/summary.csv || fail "the reason of none"
[ "$(status clone failing)" = complete ] || fail "what follows a failure is not complete"
cp "$sample/rgb/000001.png" cut/rgb/000001.png
ends "failures mended" 1 "2 complete (1 of them before), 1 failed" --list failing.txt --out failing --resume
mkdir blocked && touch blocked/none
ends "a file in the way" 1 "blocked/none" --list failing.txt --out blocked

# --- Parts, as the documentation has them.

# snippet NAME: the block of the documentation that is marked so.
snippet() { awk -v mark="<!-- run: $1 -->" '$0 == mark { found = 1 } found && /^```$/ { exit } on { print } found && /^```sh$/ { on = 1 }' "$docs"; }
mkdir -p machine/build/examples
ln -s "$dot_run" machine/build/examples/dot_run
sed "s|^[^#]|$work/&|" list.txt | sed '/^$/d' > machine/sequences.txt
cd machine || exit 1
"$dot_run" --list sequences.txt --out go > ../stdout 2> ../stderr || fail "all parts at once"
snippet slurm > array.sh
[ -s array.sh ] || fail "no Slurm script in $docs"
for part in 3 1 2; do
  SLURM_CPUS_PER_TASK=2 SLURM_ARRAY_TASK_ID=$part SLURM_ARRAY_TASK_COUNT=3 sh array.sh > ../stdout 2> ../stderr ||
    fail "part $part of the array"
done
[ "$(cat results/summary-?-of-3.csv | grep -c ,complete,)" -eq 5 ] || fail "the parts of the array are not the whole"
"$dot_run" --list sequences.txt --out results --resume | grep -qF "(5 of them before)" || fail "the array left something"
same go results "a Slurm array"
if command -v parallel > /dev/null; then
  mv results array
  echo : > machines.txt
  snippet parallel > parallel.sh
  [ -s parallel.sh ] || fail "no commands for GNU parallel in $docs"
  PARALLEL_HOME=$work sh -e parallel.sh < /dev/null > ../stdout 2> ../stderr || fail "GNU parallel"
  [ "$(cat results/summary-?-of-3.csv | grep -c ,complete,)" -eq 5 ] || fail "the parts of GNU parallel are not the whole"
  same go results "GNU parallel"
else
  echo "no GNU parallel: not tried with it"
fi
cd "$work" || exit 1

# --- Command line.

touch empty.txt
printf 'last\n./last/\n' > twice.txt
mkdir -p data && cp -r last data/last && echo mine | tee data/last/complete.txt data/last/run.log > data/summary.csv
printf 'held\ndata/last/\n' > data.txt
ends "results among the sequences" 2 "--out must not be the folder that holds a sequence" --list data.txt --out data
[ "$(cat data/last/complete.txt data/last/run.log data/summary.csv)" = "$(printf 'mine\nmine\nmine')" ] ||
  fail "results among the sequences: their files were changed"
[ ! -e data/held ] || fail "results among the sequences: one was run"
ends "no such list" 1 "nolist.txt: cannot be read" --list nolist.txt --out no
ends "an empty list" 1 "empty.txt: lists no sequence" --list empty.txt --out no
ends "a sequence twice" 1 "twice.txt: last is given twice" --list twice.txt --out no
ends "no folder for results" 2 "--list needs --out" --list list.txt
ends "a list and a sequence" 2 "--list and a sequence: 'last'" last --list list.txt --out no
ends "resume of one sequence" 2 "--resume needs --list" last --out no --resume
ends "a part that is none" 2 "--shard needs I/N" --list list.txt --out no --shard 4/3
ends "one camera for all" 2 "--camera belongs to one sequence" --list list.txt --out no --camera x.txt
ends "one page for all" 2 "--player is within the folder of each sequence" --list list.txt --out no --player "$work/x.html"
ends "real time side by side" 2 "--jobs does not go with --real-time" --list list.txt --out no --jobs 2 --real-time
echo "velocity.v1 = 1" > settings.txt
ends "a wrong setting is told at once" 1 "settings.txt:1: unknown option 'velocity.v1'" --list list.txt --out no --config settings.txt
ends "settings that can be read once" 1 "a regular file is needed" --list list.txt --out no --config <(echo "threads = 1")
[ ! -e no ] || fail "what is refused leaves a folder"

if [ "$failures" -gt 0 ]; then
  echo "$failures checks failed" >&2
  exit 1
fi
echo "all checks passed"
