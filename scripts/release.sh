#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# release.sh VERSION [--draft | --tag]: in out/release the source archive of the present commit, its checksum, its bill of
# materials (SPDX 2.3) and the notes of the changelog. The same commit gives the same bytes, in any clone, at any time.
#   --draft  also while the changelog calls the version unreleased
#   --tag    then sets the annotated tag vVERSION; nothing is pushed
# Called by ./dev.sh release, which installs what it needs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C TZ=UTC
umask 022

fail() {
  printf 'release: %s\n' "$*" >&2
  exit 1
}

version='' draft=no tag=no
for argument in "$@"; do
  case $argument in
    --draft) draft=yes ;;
    --tag) tag=yes ;;
    -*) fail "no option $argument: only --draft and --tag" ;;
    *)
      [ -z "$version" ] || fail "one version, not $version and $argument"
      version=$argument
      ;;
  esac
done
[ -n "$version" ] || fail "which version? release VERSION [--draft | --tag]"
[[ $version =~ ^(0|[1-9][0-9]*)(\.(0|[1-9][0-9]*)){2}$ ]] || fail "'$version' is no version MAJOR.MINOR.PATCH"
[ "$draft$tag" != yesyes ] || fail "a draft gets no tag"

# --- Is it that version? ---------------------------------------------------------------------------------------------

stated=$(sed -n 's/^#define DOT_VERSION_STRING "\([^"]*\)".*/\1/p' include/dot/version.hpp)
[ "$stated" = "$version" ] || fail "include/dot/version.hpp has version ${stated:-none}, not $version"
heading=$(grep -m 1 '^## \[' CHANGELOG.md || true)
[[ $heading == "## [$version] - "* ]] || fail "the first version in CHANGELOG.md is '${heading:-none}', not $version"
if [ "$draft" = no ] && ! [[ ${heading##* } =~ ^[0-9]{4}-[0-9]{2}-[0-9]{2}$ ]]; then
  fail "CHANGELOG.md gives $version no date but '${heading##* }'; --draft makes an archive nevertheless"
fi
changed=$(git status --porcelain)
[ -z "$changed" ] || fail "the working tree is not that of the commit:"$'\n'"$changed"
commit=$(git rev-parse HEAD)
if git rev-parse -q --verify "refs/tags/v$version" >/dev/null; then
  [ "$(git rev-parse "v$version^{commit}")" = "$commit" ] || fail "the tag v$version is on another commit"
  tag=no # it is there
fi

# --- What is made ----------------------------------------------------------------------------------------------------

name=dot-$version
out=out/release
rm -rf "$out"
mkdir -p "$out"
# The times in the archive are the commit's. Settings of the user and of the machine must not change it.
git -c tar.umask=0022 -c core.autocrlf=false -c core.eol=lf -c core.attributesFile=/dev/null \
  archive --format=tar --prefix="$name/" "$commit" | gzip -n -9 >"$out/$name.tar.gz"
(cd "$out" && sha256sum "$name.tar.gz" >"$name.tar.gz.sha256")
python3 -B scripts/release/sbom.py "$out/$name.tar.gz" "$version" "$commit" "$(git show -s --format=%ct "$commit")" \
  >"$out/$name.spdx.json"
awk '/^## \[/ { ++section } section == 1' CHANGELOG.md >"$out/$name.md"
if [ "$tag" = yes ]; then
  git tag -a "v$version" -m "dot $version" "$commit"
  echo "tag v$version on $commit; git push origin v$version publishes it"
fi
cat "$out/$name.tar.gz.sha256"
echo "written to $PWD/$out"
