# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154 # dev.sh and distro.sh define what is not defined here
#
# Each compiler that the system's packages have. Sourced by dev.sh, after distro.sh.

readonly compiled=$root/build-compilers

# compilers [SUITE] [COMPILER...]: here, or in a chroot of that release; all, or those, e.g. g++-12 clang++-16.
compilers() {
  local compiler failed=() folder
  case ${1:-} in
    '' | g++-* | clang++-*) ;;
    *)
      compilers_in "$@"
      return
      ;;
  esac
  need_compiler
  mkdir -p "$compiled"
  # shellcheck disable=SC2046 # one word each
  [ $# -gt 0 ] || set -- $(available_compilers)
  [ $# -gt 0 ] || fail "no compilers to try: apt-get update?"
  for compiler in "$@"; do
    say "$compiler"
    folder=$compiled/$compiler
    mkdir -p "$folder"
    (try_compiler "$compiler" "$folder" >"$folder/row.md.partial") || {
      failed+=("$compiler, see $folder.log")
      continue
    }
    mv "$folder/row.md.partial" "$folder/row.md"
    cat "$folder/row.md"
  done
  say "built and tested"
  echo '| system | compiler | Eigen | OpenCV | tests | hosts of the templates | warnings |'
  echo '|---|---|---|---|---|---|---|'
  cat "$compiled"/*/row.md
  [ ${#failed[@]} -eq 0 ] || fail "$(printf 'failed: %s\n' "${failed[@]}")"
}

# compilers_in SUITE [COMPILER...]: the chroot is kept, with what was installed and built in it.
compilers_in() {
  local suite=$1 place=$chroots/$1/compilers
  distro_known "$suite"
  become_root compilers "$@"
  distro_bootstrap "$suite"
  if [ ! -d "$place/dot" ]; then
    rm -rf --one-file-system "$place" "$place.partial"
    cp -a --reflink=auto "$chroots/$suite/base" "$place.partial"
    mkdir "$place.partial/dot"
    git init -q "$place.partial/dot"
    # debootstrap knows the packages of the release alone; Ubuntu corrects its compilers in the updates.
    in_chroot "$suite" compilers.partial env DEBIAN_FRONTEND=noninteractive sh -c 'apt-get update && apt-get -y dist-upgrade' \
      >"$chroots/$suite/upgrade.log" 2>&1 || fail "$suite cannot be upgraded; see $chroots/$suite/upgrade.log"
    mv "$place.partial" "$place"
  fi
  git_as_root -C "$place/dot" fetch -q --depth 1 "file://$root" HEAD
  git_as_root -C "$place/dot" reset -q --hard FETCH_HEAD
  in_chroot "$suite" compilers sh -c 'cd /dot && exec ./dev.sh compilers "$@"' - "${@:2}" \
    || fail "some failed on $suite; their logs are in $place/dot/build-compilers"
}

available_compilers() {
  local version
  for version in 10 11 12 13 14; do ! installable "gcc-$version" || echo "g++-$version"; done
  for version in 14 15 16 17 18 19; do ! installable "clang-$version" || echo "clang++-$version"; done
}
# Not by "grep -q" behind a pipe: it ends before apt-cache has written all, and the pipe counts as failed.
installable() { [[ $(apt-cache policy "$1" 2>/dev/null) == *'Candidate: '[0-9]* ]]; }

# try_compiler COMPILER FOLDER: prints the row of the table; all else goes to FOLDER.log.
try_compiler() {
  local compiler=$1 folder=$2 c name test targets=() tests warnings hosts
  exec 3>&1 >"$2.log" 2>&1
  case $compiler in
    g++-*)
      c=gcc-${compiler#g++-} name=GCC
      need "$compiler" "$c"
      ;;
    clang++-*)
      c=clang-${compiler#clang++-} name=clang
      need "$c"
      ;;
    *) fail "$compiler: g++-N or clang++-N, please" ;;
  esac
  for test in tests/capi/*.c; do targets+=("test_$(basename "$test" .c)"); done
  for test in lie statistics containers camera kernel image; do targets+=("test_$test"); done

  # Debian 13 compiled its packages with GCC 14. They want the standard library of that one; GCC 13 links with its own.
  # Programs run with that of the system in any case.
  if ! links_packages "$compiler"; then
    ln -sf "$(g++ -print-file-name=libstdc++.so)" "$folder/libstdc++.so"
    links_packages "$compiler" -L"$folder" || return
    export LDFLAGS=-L$folder
  fi
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$c" -DCMAKE_CXX_COMPILER="$compiler" \
    -DDOT_BUILD_BENCH=OFF -DDOT_BUILD_EXAMPLES=OFF || return
  cmake --build "$folder" --parallel "$jobs" --target dot_core dot_capi dot_capi_static test_identity test_core_layout \
    test_core_shared "${targets[@]}" || return
  ctest --test-dir "$folder" --output-on-failure -R '^(lie|statistics|containers|camera|kernel|image|capi|core)\.' || return
  tests=$(sed -n 's/^[0-9]*% tests passed.* out of \([0-9]*\)$/\1/p' "$folder.log")

  # The installed headers, in every standard.
  rm -rf "$folder/prefix"
  cmake --install "$folder" --prefix "$folder/prefix" >/dev/null || return
  host_standards "$folder" "$compiler" "" || return
  hosts=$(standards_run "$folder.log")
  if [ "$compiler" = "clang++-$(libcxx_version)" ]; then
    host_standards "$folder" "$compiler" -stdlib=libc++ >"$folder.libc++.log" 2>&1 || return
    hosts+="; with libc++ $(standards_run "$folder.libc++.log")"
  fi
  warnings=$(cat "$folder".log "$folder".libc++.log 2>/dev/null | grep -c 'warning:' || true)
  (
    . /etc/os-release
    echo "| ${NAME% GNU/Linux} $VERSION_ID | $name $(compiler_version "$compiler") | $(package_version libeigen3-dev) |" \
      "$(package_version libopencv-dev) | $tests | $hosts | $warnings |"
  ) >&3
}

# links_packages COMPILER [OPTION...]: whether programs link with the libraries of the packages.
links_packages() {
  "$1" -std=c++17 "${@:2}" -x c++ -o /dev/null - -Wl,--no-as-needed -lopencv_core -lgtest -pthread <<<'#include <gtest/gtest.h>
    int main(int count, char** arguments) { testing::InitGoogleTest(&count, arguments); return RUN_ALL_TESTS(); }'
}
# compiler_version COMPILER: the first of the words that are numbers with dots, e.g. of
# "g++-10 (Ubuntu 10.5.0-1ubuntu1~22.04) 10.5.0" and of "Ubuntu clang version 14.0.0-1ubuntu1.1".
compiler_version() { "$1" --version | head -n 1 | grep -oE '\b[0-9]+(\.[0-9]+)+' | head -n 1; }

host_standards() {
  local hosts_build="$1/hosts${3:+-libc++}" # "build" is dev.sh's, and cannot be changed
  cmake -S "$root/tests/consumers/header_tier" -B "$hosts_build" -G Ninja -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DSTANDARDS=17,20,23 -DDOT_TESTS="$root/tests" \
    -Ddot_ROOT="$1/prefix" || return
  cmake --build "$hosts_build" --parallel "$jobs" --target check
}
# standards_run LOG: those whose host was run.
standards_run() { sed -n 's/^\(C++[0-9]*\) (.*: the parked car is static, the other moving$/\1/p' "$1" | sort -u | paste -sd ' '; }

# The version of libc++ that is used: the one that is installed, because there can be but one, or the newest.
libcxx_version() {
  local version
  for version in 19 18 17 16 15 14; do
    ! dpkg-query -W "libc++-$version-dev" >/dev/null 2>&1 || { echo "$version" && return; }
  done
  for version in 19 18 17 16 15 14; do
    if installable "libc++-$version-dev" && installable "clang-$version"; then
      need "libc++-$version-dev" "libc++abi-$version-dev" >&2
      echo "$version"
      return
    fi
  done
}

package_version() { dpkg-query -W -f '${Version}' "$1" | sed 's/^[0-9]*://; s/[+-].*//'; }
