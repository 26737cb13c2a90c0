#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Everything a developer does, from a plain clone: ./dev.sh help
set -Eeuo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
readonly root=$PWD
readonly build=$root/build
readonly sample=examples/data/mini
jobs=${DOT_JOBS:-$(nproc 2>/dev/null || echo 2)}

usage() {
  cat <<'TXT'
usage: ./dev.sh VERB

  demo       build the runner, run it on the sample sequence, show where the pictures and a page to look at are;
             "demo network": in real time, with a small network that makes the masks, and a video
  test       build everything and run all tests
  player     test the page of dot_run --player in Chromium, which is installed; leave pictures of it in out/player
  bench      build and run the benchmarks, those beside OpenCV's odometry too; with arguments Google Benchmark's
             alone, which get them, e.g. --benchmark_filter=warp
  wheel      build the Python package's wheel, in out/wheel
  format     format all C++ and C files in place
  lint       formatting, clang-tidy, types of the Python package, versions; changes nothing
  versions   check that version.hpp and all that repeats it name the same version
  sanitize   run the tests with the address and undefined-behaviour sanitizers, those of threads with the thread
             sanitizer
  fuzz       hand generated inputs to the C library and to the readers, 60 seconds each or "fuzz SECONDS";
             "fuzz coverage" tells which lines the inputs in tests/fuzz/corpus reach
  docs       make the reference, in out/docs, from the headers and the pages; warnings, names without a description and
             links that lead nowhere are errors; "docs pictures" leaves pictures of some pages in out/docs-pictures
  release    "release VERSION [--draft | --tag]": source archive, checksum, bill of materials (SPDX) and notes of the
             present commit, in out/release; the same bytes in every clone
  abi        compare the binary interfaces with capi/abi and src/abi; "abi accept" writes the present ones there
  soak       10,000 trackers made and destroyed under the address sanitizer
  cross      "cross arm64": build for AArch64 and run kernels, alignment, points, images, motion, C library and the
             sample under QEMU, compare the sample's labels with this machine's, and count the kernels' instructions
  distro     demo and test in a bare chroot of another release, e.g. "distro trixie"; needs root, or sudo
  compilers  build and test the libraries and hosts with each GCC and clang that the system's packages have;
             "compilers trixie" in a chroot; "compilers g++-11 clang++-15" with these alone
  help       this text

Debian and Ubuntu packages that are missing are installed (as root, or through sudo). Elsewhere install them yourself:
a C++17 compiler, CMake 3.22, Ninja, Eigen 3.3, OpenCV 4.5, GoogleTest, Google Benchmark.
DOT_JOBS=N limits the number of compilers that run at once.
TXT
}

say() {
  if [ -t 1 ]; then printf '\n\033[1m== %s\033[0m\n' "$*"; else printf '\n== %s\n' "$*"; fi
}
fail() {
  printf 'dev.sh: %s\n' "$*" >&2
  exit 1
}
on_error() { printf 'dev.sh: failed in line %s: %s\n' "$1" "$2" >&2; }
trap 'on_error "$LINENO" "$BASH_COMMAND"' ERR

# need PACKAGE...: installs those that dpkg does not know as installed; on other systems trusts the user.
need() {
  command -v dpkg-query >/dev/null || return 0
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" = 'install ok installed' ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${missing[*]}"
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "please install these packages, or sudo, first: ${missing[*]}"
    sudo=(sudo)
  fi
  local apt=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get)
  # The package lists may be old or absent: a first try without fetching them is cheaper and works offline.
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" && return 0
  "${apt[@]}" update || fail "apt-get update failed: is there a network?"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" || fail "cannot install: ${missing[*]}"
}
# python_for MODULE ARGUMENT...: the first Python in the path, or Debian's own, which has what apt installs.
python_for() {
  local python=python3
  "$python" -c "import numpy, $1" 2>/dev/null || python=/usr/bin/python3
  "$python" "${@:2}"
}
need_compiler() { need g++ cmake ninja-build libeigen3-dev libopencv-dev libgtest-dev libbenchmark-dev; }

# compile TARGET...
compile() {
  need_compiler
  say "building $* in $build (Release)"
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    || fail "CMake could not configure; to start afresh, remove $build"
  cmake --build "$build" --parallel "$jobs" --target "$@" || fail "does not build; the compiler's message is above"
}

sources() { git ls-files '*.hpp' '*.cpp' '*.h' '*.c'; }

demo() {
  compile dot_run
  say "running dot_run on $sample"
  local out=$root/out/demo
  rm -rf "$out"
  "$build/examples/dot_run" "$sample" --out "$out" --overlay --player "$out/run.html" || fail "dot_run failed on the sample"
  say "results"
  printf 'labels    %s (0 background, 1 static, 2 moving, 3 not observable)\n' "$out/labels"
  printf 'page      %s\n' "$out/run.html"
  printf 'pictures  %s\n' "$out/overlay"
  printf 'summary   %s\n' "$out/objects.csv" "$out/camera.txt" "$out/timing.csv"
}

# demo network: in real time, with the masks of a network that knows the sample's cars alone.
demo_network() {
  compile dot_run
  say "running dot_run on $sample in real time, with a network beside it"
  local out=$root/out/demo-network
  rm -rf "$out"
  local run=("$build/examples/dot_run" "$sample" --out "$out" --overlay --player "$out/run.html"
    --network examples/data/network/cars.onnx --real-time)
  local said status=0
  { said=$("${run[@]}" --video "$out/run.mp4" 2>&1 >&3); } 3>&1 || status=$?
  [ -z "$said" ] || printf '%s\n' "$said" >&2
  if [ "$status" -eq 1 ] && [[ $said = *"$out/run.mp4: "* ]]; then
    say "once more without the video, which not every OpenCV can write"
    status=0
    "${run[@]}" || status=$?
  fi
  [ "$status" -ne 130 ] || exit "$status" # Ctrl-C
  [ "$status" -eq 0 ] || fail "dot_run failed on the sample"
  say "results"
  printf 'page      %s\n' "$out/run.html"
  [ ! -f "$out/run.mp4" ] || printf 'video     %s\n' "$out/run.mp4"
  printf 'pictures  %s\n' "$out/overlay"
  printf 'summary   %s\n' "$out/objects.csv" "$out/camera.txt" "$out/timing.csv"
}

run_tests() {
  need python3-numpy python3-onnx python3-opencv python3-pytest python3-mypy python3-setuptools python3-wheel python3-pip \
    python3-venv python3-yaml git parallel
  need lintian pkg-config python3-jinja2 # for the tests of the packages
  compile all
  say "testing"
  ctest --test-dir "$build" --output-on-failure -j2 || fail "tests failed; what each of them printed is above"
}

player() {
  need chromium python3
  compile dot_run
  say "testing the player in Chromium"
  tests/player/player_test.py "$build/examples/dot_run" "$sample" chromium "$root/out/player" || fail "what failed is above"
  echo "pictures of it are in $root/out/player"
}

# bench [OPTION...]: without options all of them, on the sample where they want a sequence; in out/bench what they print
# and the plots of docs/performance.md.
bench() {
  need libopencv-contrib-dev
  compile dot_benchmarks
  if [ $# -gt 0 ]; then
    "$build/bench/dot_bench" "$@"
    return
  fi
  local out=$root/out/bench
  mkdir -p "$out"
  say "kernels, stages, whole frames"
  "$build/bench/dot_bench" --benchmark_out="$out/benchmarks.json" --benchmark_out_format=json
  if [ -x "$build/bench/bench_peer_room" ]; then
    say "the whole alignment of a new frame beside OpenCV's RgbdOdometry"
    "$build/bench/bench_peer_room" | tee "$out/peer_room.txt"
  fi
  if [ -x "$build/bench/bench_peer_sequence" ]; then
    say "the whole pipeline, and motions found from nothing, beside OpenCV's RgbdOdometry"
    "$build/bench/bench_peer_sequence" "$sample" | tee "$out/peer_sequence.txt"
    "$build/bench/bench_peer_convergence" "$sample" | tee "$out/peer_convergence.txt"
  fi
  if command -v python3 >/dev/null; then bench/plots.py "$out" "$out/benchmarks.json" "$out/peer_room.txt"; fi
  echo "written to $out"
}

wheel() {
  need_compiler
  need python3-numpy python3-setuptools python3-wheel python3-pip
  local out=$root/out/wheel
  rm -rf "$out"
  say "building the wheel"
  CMAKE_BUILD_PARALLEL_LEVEL=$jobs python_for "setuptools, wheel, pip" -m pip wheel --no-build-isolation --no-deps -w "$out" "$root/python" \
    || fail "the wheel does not build; pip's message is above"
  printf 'pip install %s\n' "$out"/*.whl
}

format() {
  need git clang-format
  sources | xargs clang-format -i
  echo "formatted $(sources | wc -l) files"
}

# versions: version.hpp is the source; all that repeats it must agree.
versions() {
  local version major minor patch number
  version=$(sed -n 's/^#define DOT_VERSION_STRING "\(.*\)"$/\1/p' include/dot/version.hpp)
  [ -n "$version" ] || fail "include/dot/version.hpp has no DOT_VERSION_STRING"
  grep -q "\"version\": \"$version\"" vcpkg.json \
    || fail "vcpkg.json does not have version $version of include/dot/version.hpp"
  grep -q "\"version\": \"$version\"" ports/dot/vcpkg.json || fail "ports/dot/vcpkg.json does not have version $version"
  IFS=. read -r major minor patch <<<"$version"
  number=$((major * 1000000 + minor * 1000 + patch))
  grep -q "^#define DOT_HEADER_VERSION $number$" capi/include/dot/dot.h \
    || fail "capi/include/dot/dot.h: DOT_HEADER_VERSION is not $number"
  grep -q "^HEADER_VERSION = $number " python/dot_slam/_library.py \
    || fail "python/dot_slam/_library.py: HEADER_VERSION is not $number"
  [ -f CHANGELOG.md ] || fail "CHANGELOG.md is missing"
  grep -qE "^## \[?v?${version//./\\.}\]?([ ,(-]|$)" CHANGELOG.md || fail "CHANGELOG.md has no section '## $version'"
  echo "version $version everywhere"
}

lint() {
  need_compiler
  need git clang-format clang-tidy python3-numpy python3-mypy
  say "versions"
  versions
  say "formatting"
  sources | xargs clang-format --dry-run -Werror || fail "not formatted; ./dev.sh format mends it"
  say "types of the Python package"
  (cd python && python_for mypy -m mypy --cache-dir "$build/mypy")
  say "clang-tidy"
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
  local other_machines=src/kernels/neon # kernels that this one has no compiler for
  [ "$(uname -m)" = x86_64 ] || other_machines=src/kernels/avx
  git ls-files 'src/*.cpp' 'capi/*.cpp' 'examples/*.cpp' | grep -v "^$other_machines" | xargs -P "$jobs" -n 1 clang-tidy -p "$build" --quiet
}

# sanitize_with PRESET [TARGET...]: builds with that preset's sanitizers.
sanitize_with() {
  need_compiler
  say "building in build-$1"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" --parallel "$jobs" --target "${@:2}"
}

sanitize() {
  need clang libclang-rt-dev # it compiles this in two thirds of GCC's time
  sanitize_with asan-ubsan all
  say "testing with the address and undefined-behaviour sanitizers"
  ctest --preset asan-ubsan -j2
  sanitize_with tsan test_trackers_at_once test_threads_test test_real_time
  say "testing with the thread sanitizer"
  # Without OpenCV's threads, say the preset and tests/cmake/TestProgram.cmake: its pool is not built for this sanitizer,
  # which cannot see how it synchronises.
  ctest --preset tsan
}

# fuzz [SECONDS]: from the inputs that are checked in; what is found on the way stays in the build's folder.
fuzz() {
  need_compiler
  need clang llvm libclang-rt-dev
  if [ "${1:-}" = coverage ]; then
    fuzz_coverage
    return
  fi
  local seconds=${1:-60} harness log found=() out=$root/build-fuzz harnesses=()
  [[ $seconds =~ ^[1-9][0-9]*$ ]] || fail "fuzz: a number of seconds, or coverage"
  mapfile -t harnesses < <(ls tests/fuzz/corpus)
  say "building the fuzzers in $out"
  cmake --preset fuzz >/dev/null
  cmake --build --preset fuzz --parallel "$jobs" --target "${harnesses[@]/#/fuzz_}"
  for harness in "${harnesses[@]}"; do
    say "fuzzing $harness for $seconds s"
    log=$out/fuzz_$harness.log
    mkdir -p "$out/corpus/$harness" "$out/findings"
    "$out/tests/fuzz/fuzz_$harness" -max_total_time="$seconds" -timeout=300 -rss_limit_mb=3000 -print_final_stats=1 \
      -artifact_prefix="$out/findings/$harness-" "$out/corpus/$harness" "tests/fuzz/corpus/$harness" \
      >"$log" 2>&1 || found+=("$harness: $(sed -n 's/.*Test unit written to //p' "$log" | head -1), told in $log")
    sed -n 's/^stat::number_of_executed_units: */executions: /p; /^frames tracked: /p' "$log"
  done
  [ ${#found[@]} -eq 0 ] || fail "found something: $(printf '%s\n' "${found[@]}")"
  echo "nothing found"
}

# Of the library's lines, by the inputs that are checked in.
fuzz_coverage() {
  local harness programs=() out=$root/build-coverage harnesses=()
  mapfile -t harnesses < <(ls tests/fuzz/corpus)
  say "building the harnesses in $out"
  cmake --preset coverage >/dev/null
  cmake --build --preset coverage --parallel "$jobs" --target "${harnesses[@]/#/test_fuzz_}"
  rm -rf "$out/profiles"
  for harness in "${harnesses[@]}"; do
    say "replaying $harness"
    LLVM_PROFILE_FILE=$out/profiles/$harness.profraw "$out/tests/fuzz/test_fuzz_$harness" \
      "tests/fuzz/corpus/$harness" | tail -n 2
    [ ${#programs[@]} -eq 0 ] || programs+=(-object)
    programs+=("$out/tests/fuzz/test_fuzz_$harness")
  done
  llvm-profdata merge -o "$out/all.profdata" "$out"/profiles/*.profraw
  say "lines of include/dot and capi, of functions that are part of a program"
  llvm-cov report "${programs[@]}" -instr-profile="$out/all.profdata" -show-region-summary=false \
    -show-branch-summary=false include/dot capi | awk '
      $NF ~ /%$/ { printf "%-48s %6d lines %6d missed %8s\n", $1, $(NF - 2), $(NF - 1), $NF; total = $NF }
      END { exit total + 0 < 80 }' || fail "the inputs in tests/fuzz/corpus reach less than 80 % of the lines"
}

# docs [pictures]
docs() {
  need doxygen katex nodejs python3
  case ${1:-} in '') ;; pictures) need chromium ;; *) fail "docs $1: only docs, and docs pictures" ;; esac
  say "the reference"
  scripts/docs.sh "$@"
}

# release VERSION [--draft | --tag]
release() {
  need git python3
  versions
  scripts/release.sh "$@"
}

# abi [accept]: a change of the binary interface is a decision, and shows as one in a diff.
abi() {
  case ${1:-} in '' | accept) ;; *) fail "abi $1: it is abi, or abi accept" ;; esac
  need_compiler
  need abigail-tools
  [ "$(uname -sm)" = 'Linux x86_64' ] || fail "capi/abi describes the library of 64-bit Linux on x86"
  compile test_core_shared test_core_layout test_capi_interface
  cmake -DNM=nm -DLIBRARY="$build/tests/libtest_core_shared.so" -DLAYOUT="$build/tests/test_core_layout" \
    -DFOLDER="$root/src/abi" ${1:+"-D${1^^}=ON"} -P tests/cmake/core_interface.cmake || fail "see above"
  local library=$build/tests/capi_interface/libdot_capi.so now=$build/libdot_capi.abi
  abidw --exported-interfaces-only --headers-dir capi/include --drop-private-types --drop-undefined-syms --no-show-locs \
    --no-comp-dir-path --no-corpus-path --no-elf-needed --out-file "$now" "$library"
  if [ "${1:-}" = accept ]; then
    cp "$now" capi/abi/libdot_capi.abi
    nm -D --defined-only "$library" | sed -n 's/^[0-9a-f]* [^A] \([^@]*\).*/\1/p' | LC_ALL=C sort >capi/abi/exports.txt
    git --no-pager diff --stat -- capi/abi src/abi
  else
    abidiff capi/abi/libdot_capi.abi "$now" || fail "not the interface of capi/abi; if it is meant: ./dev.sh abi accept"
    echo "the interfaces of capi/abi and src/abi"
  fi
}

# soak: the C library alone, in a process that does nothing else for a while.
soak() {
  sanitize_with asan-ubsan test_cycles_test
  say "10,000 trackers"
  "$root/build-asan-ubsan/tests/test_cycles_test" 10000
  echo "nothing found"
}

# cross MACHINE: Debian's packages for that machine go into build/sysroot-MACHINE, not into this system.
cross() {
  local machine=${1:-}
  case $machine in
    arm64) need g++-aarch64-linux-gnu ;;
    *) fail "cross $machine: only cross arm64" ;;
  esac
  need qemu-user-static python3-numpy python3-opencv
  compile dot_run
  tests/cross/run.sh "$machine" "$build/examples/dot_run" "$jobs" || fail "what failed is above"
}

verb=${1:-help}
[ $# -eq 0 ] || shift
case $verb in
  demo) case ${1:-} in '') demo ;; network) demo_network ;; *) fail "demo $1: only demo, and demo network" ;; esac ;;
  test) run_tests ;;
  player) player ;;
  bench) bench "$@" ;;
  wheel) wheel ;;
  format) format ;;
  lint) lint ;;
  sanitize) sanitize "$@" ;;
  fuzz) fuzz "$@" ;;
  docs) docs "$@" ;;
  release) release "$@" ;;
  abi) abi "$@" ;;
  soak) soak ;;
  cross) cross "$@" ;;
  distro)
    source scripts/distro.sh
    distro "$@"
    ;;
  compilers)
    source scripts/distro.sh
    source scripts/compilers.sh
    compilers "$@"
    ;;
  versions) versions ;;
  help | -h | --help)
    usage
    exit 0
    ;;
  *)
    usage >&2
    fail "unknown verb '$verb'"
    ;;
esac
printf '\n%s: done in %s s\n' "$verb" "$SECONDS"
