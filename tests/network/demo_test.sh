#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# When "dev.sh demo network" runs dot_run once more: if the video is what failed, and for nothing else.
# usage: demo_test.sh DEV_SH

set -u
if [ $# -ne 1 ]; then
  echo "usage: $0 DEV_SH" >&2
  exit 2
fi
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0

# A project of its own: nothing is installed or built, and dot_run ends as the test wants it to.
mkdir -p "$work/bin" "$work/build/examples"
cp "$1" "$work/dev.sh"
printf '#!/bin/sh\necho install ok installed\n' > "$work/bin/dpkg-query"
printf '#!/bin/sh\n' > "$work/bin/cmake"
cat > "$work/build/examples/dot_run" << 'SH'
#!/usr/bin/env bash
here=$(dirname "$0")
echo "$*" >> "$here/calls"
for ((i = 1; i <= $#; ++i)); do
  [ "${!i}" = --video ] || continue
  next=$((i + 1))
  printf "$(cat "$here/message")" "${!next}" >&2
  exit "$(cat "$here/status")"
done
exit "$(cat "$here/status_without_video")"
SH
chmod +x "$work/bin/"* "$work/build/examples/dot_run"

# ends WHAT STATUS CALLS: with dot_run ending so: VIDEO_STATUS MESSAGE STATUS_WITHOUT_VIDEO. %s is the video's file.
ends() {
  local what=$1 status=$2 calls=$3 got
  echo "$4" > "$work/build/examples/status"
  printf '%s' "$5" > "$work/build/examples/message"
  echo "$6" > "$work/build/examples/status_without_video"
  : > "$work/build/examples/calls"
  PATH="$work/bin:$PATH" "$work/dev.sh" demo network > "$work/stdout" 2> "$work/stderr"
  got=$?
  [ "$got" -eq "$status" ] && [ "$(wc -l < "$work/build/examples/calls")" -eq "$calls" ] && return
  failures=$((failures + 1))
  echo "FAILED: $what: status $got, expected $status; $calls calls expected of:" >&2
  cat "$work/build/examples/calls" "$work/stdout" "$work/stderr" | sed 's/^/    /' >&2
}

ends "a run without failure" 0 1 0 "" 0
ends "no encoder" 0 2 1 "dot_run: %s: OpenCV has no encoder\n" 0
grep -q "^dot_run: .*run.mp4: OpenCV has no encoder$" "$work/stderr" || { echo "FAILED: the message is not told" >&2; failures=1; }
ends "no encoder, and another failure then" 1 2 1 "dot_run: %s: OpenCV has no encoder\n" 1
ends "no encoder, and Ctrl-C then" 130 2 1 "dot_run: %s: OpenCV has no encoder\n" 130
ends "another failure" 1 1 1 "dot_run: cars.onnx: cannot be read\n" 0
ends "Ctrl-C" 130 1 130 "dot_run: interrupted after 3 frames\n" 0
ends "a crash" 1 1 139 "" 0

if [ "$failures" -gt 0 ]; then
  echo "$failures checks failed" >&2
  exit 1
fi
echo "all checks passed"
