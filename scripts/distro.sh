# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2154 # dev.sh and distro.sh define what is not defined here
#
# Other releases of Debian and Ubuntu, in a chroot. Sourced by dev.sh.
#
# build/distro/SUITE/base is what debootstrap made, packages what apt loaded; both are kept. Each run starts with a new
# copy of base. All mounts are made in a mount namespace of their own, which ends with the processes in it, however they
# end: nothing has to be unmounted.

readonly chroots=$root/build/distro
exec 8>&2 # where the user reads

# distro SUITE: the two commands of the README, in a bare chroot with a clone of the last commit.
distro() {
  local suite=${1:-} folder verb log started status
  distro_known "$suite"
  become_root distro "$@"
  distro_bootstrap "$suite"
  folder=$chroots/$suite
  say "a bare $suite with a clone of $(git_as_root describe --always --dirty)"
  rm -rf --one-file-system "$folder/root"
  cp -a --reflink=auto "$folder/base" "$folder/root"
  git_as_root clone -q --depth 1 "file://$root" "$folder/root/dot"

  declare -A seconds
  for verb in demo test; do
    say "$suite: ./dev.sh $verb"
    log=$folder/$verb.log
    started=$SECONDS status=0
    in_chroot "$suite" root sh -c "cd /dot && ./dev.sh $verb" >"$log" 2>&1 || status=$?
    seconds[$verb]=$((SECONDS - started))
    tail -n 3 "$log"
    [ "$status" -eq 0 ] || fail "./dev.sh $verb fails on $suite; all it printed is in $log"
  done

  say "tried"
  local versions tests
  # shellcheck disable=SC2016
  versions=$(in_chroot "$suite" root sh -c '
    version() { dpkg-query -W -f "\${Version}" "$1" | sed "s/^[0-9]*://; s/[+-].*//"; }
    . /etc/os-release
    echo "$PRETTY_NAME | $(g++ -dumpfullversion) | $(version cmake) | $(version libeigen3-dev) | $(version libopencv-dev)"')
  tests=$(sed -n 's/^[0-9]*% tests passed.* out of \([0-9]*\)$/\1/p' "$folder/test.log")
  echo '| system | GCC | CMake | Eigen | OpenCV | demo | test | tests |'
  echo "| $versions | ${seconds[demo]} s | ${seconds[test]} s | $tests |" | tee "$folder/result.md"
}

distro_known() {
  case $1 in
    bookworm | trixie | jammy | noble) ;;
    *) fail "a release to try, please: bookworm or trixie of Debian, jammy or noble of Ubuntu; not '$1'" ;;
  esac
}

# become_root VERB ARGUMENT...: starts dev.sh again through sudo, where that is needed.
become_root() {
  mkdir -p "$chroots" # ours, not root's: build/ is used by the other verbs
  [ "$(id -u)" -ne 0 ] || return 0
  command -v sudo >/dev/null || fail "$1 makes chroots: it needs root, or sudo"
  exec sudo --preserve-env=DOT_JOBS,DOT_MIRROR,http_proxy "$root/dev.sh" "$@"
}
# Not by -c: git does not pass that on to the process that reads the repository to be cloned.
git_as_root() {
  printf '[safe]\n\tdirectory = *\n' >"$chroots/gitconfig"
  GIT_CONFIG_GLOBAL=$chroots/gitconfig git "$@"
}

# distro_bootstrap SUITE: fills base, once. What is left of an interrupted try is thrown away.
distro_bootstrap() {
  local suite=$1 folder=$chroots/$1 mirror security components=main keyring script=
  need debootstrap debian-archive-keyring git
  command -v debootstrap >/dev/null || fail "debootstrap is missing"
  mkdir -p "$folder/packages/partial"
  exec 9>"$folder/lock"
  flock -n 9 || fail "$suite is in use by another run; fuser -v $folder/lock shows it"
  [ ! -d "$folder/base" ] || return 0

  case $suite in
    jammy | noble)
      mirror=${DOT_MIRROR:-http://archive.ubuntu.com/ubuntu} security=$mirror components=main,universe
      keyring=$(ubuntu_keyring)
      script=/usr/share/debootstrap/scripts/gutsy # of all newer ones; an old debootstrap lacks the links to it
      ;;
    *)
      mirror=${DOT_MIRROR:-http://deb.debian.org/debian} security=${mirror%/debian}/debian-security
      keyring=/usr/share/keyrings/debian-archive-keyring.gpg
      ;;
  esac
  say "bootstrapping $suite from $mirror"
  rm -rf --one-file-system "$folder/base.partial"
  isolated debootstrap --variant=minbase --components="$components" --keyring="$keyring" "$suite" "$folder/base.partial" \
    "$mirror" ${script:+"$script"} >"$folder/debootstrap.log" 2>&1 || fail "debootstrap failed; see $folder/debootstrap.log"
  local line
  for line in "$mirror $suite" "$mirror $suite-updates" "$security $suite-security"; do
    echo "deb $line ${components/,/ }"
  done >"$folder/base.partial/etc/apt/sources.list"
  mv "$folder/base.partial" "$folder/base"
}

# ubuntu_keyring: the file of the keys that Ubuntu signs with; Debian 12 has no package of them, Debian 13 has.
ubuntu_keyring() {
  local keys=usr/share/keyrings/ubuntu-archive-keyring.gpg package
  if [ -f "/$keys" ]; then
    echo "/$keys"
    return
  fi
  if [ ! -f "$chroots/keys/$keys" ]; then
    [ -d "$chroots/trixie/base" ] || (distro_bootstrap trixie) >&2
    in_chroot trixie base sh -c 'cd /tmp && apt-get -q download ubuntu-keyring' >&2 || fail "cannot get Ubuntu's keys from Debian 13"
    package=$(echo "$chroots"/trixie/base/tmp/ubuntu-keyring_*.deb)
    dpkg -x "$package" "$chroots/keys"
    rm "$package"
  fi
  echo "$chroots/keys/$keys"
}

# in_chroot SUITE FOLDER COMMAND...: in that folder of the release.
in_chroot() {
  local suite=$1 place=$chroots/$1/$2
  cp -L /etc/resolv.conf /etc/hosts "$place/etc/"
  # shellcheck disable=SC2016
  isolated bash -ec '
    place=$1 packages=$2
    mount -t proc proc "$place/proc"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$place/dev/pts"
    mkdir -p "$place/dev/shm"
    mount -t tmpfs shm "$place/dev/shm"
    mount --bind "$packages" "$place/var/cache/apt/archives"
    exec chroot "$place" "${@:3}"' - "$place" "$chroots/$suite/packages" \
    env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 TERM="${TERM:-dumb}" \
    DOT_JOBS="$jobs" ${http_proxy:+http_proxy="$http_proxy"} "${@:3}"
}

# isolated COMMAND...: with mounts and processes of its own. Interrupted, all of them are killed: unshare is, the process
# that is number 1 in there goes with it, and with that one all others.
isolated() {
  local child status=0
  unshare --mount --pid --fork --kill-child "$@" </dev/null &
  child=$!
  trap 'kill -KILL "$child"; fail "interrupted" 2>&8' INT TERM HUP
  wait "$child" || status=$?
  trap - INT TERM HUP
  return "$status"
}
