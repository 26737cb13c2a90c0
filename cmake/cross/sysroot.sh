#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# Unpacks Debian packages of another architecture, with all that they depend on, into a folder to compile and link
# against and to run programs in under an emulator. They come from the package sources of this machine, through an apt
# with a state of its own: the machine's dpkg and apt do not learn of that architecture. None of their scripts is run.
#
#     cmake/cross/sysroot.sh ARCHITECTURE TRIPLET FOLDER PACKAGE...
set -euo pipefail
[ $# -ge 4 ] || { echo "usage: $0 ARCHITECTURE TRIPLET FOLDER PACKAGE..." >&2; exit 2; }
architecture=$1 triplet=$2 folder=$3
shift 3
[ "$(cat "$folder/packages" 2>/dev/null)" != "$*" ] || exit 0 # made already
fail() { echo "sysroot.sh: $*" >&2; exit 1; }

mkdir -p "$(dirname "$folder")"
folder=$(realpath -m "$folder")
state=$folder.apt part=$folder.part
rm -rf "$folder" "$part"
mkdir -p "$state/lists/partial" "$state/cache/archives/partial" "$part"
: >"$state/status"
cat >"$state/apt.conf" <<TXT
APT::Architecture "$architecture";
APT::Architectures { "$architecture"; };
APT::Install-Recommends "false";
APT::Sandbox::User "root";
Acquire::Languages "none";
Dir::State "$state";
Dir::State::status "$state/status";
Dir::Cache "$state/cache";
Debug::NoLocking "true";
TXT
export APT_CONFIG=$state/apt.conf
apt-get -q update || echo "sysroot.sh: not all package lists could be fetched; trying with those that could" >&2
apt-get -q install -y --download-only "$@" || fail "cannot get packages for $architecture: is there a network?"

# Only what is linked and loaded: no documentation, programs or settings.
unneeded=(./bin ./sbin ./etc ./var ./usr/bin ./usr/sbin ./usr/games ./usr/share/doc ./usr/share/man ./usr/share/locale
  ./usr/share/fonts ./usr/share/icons ./usr/share/perl './usr/lib/*/perl*')
for package in "$state"/cache/archives/*.deb; do
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$part" --keep-directory-symlink "${unneeded[@]/#/--exclude=}"
done
# An absolute link would leave the folder.
find "$part" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
  ln -sfnr "$part$(readlink "$link")" "$link"
done
# Debian chooses among implementations of these in a script of the package.
libraries=$part/usr/lib/$triplet
for library in blas lapack; do
  [ ! -e "$libraries/$library/lib$library.so.3" ] || ln -sfn "$library/lib$library.so.3" "$libraries/lib$library.so.3"
done
printf '%s\n' "$*" >"$part/packages"
mv "$part" "$folder"
rm -rf "$state"
