#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# docs.sh [pictures]: the reference in out/docs, by Doxygen, from the headers and the pages. Called by ./dev.sh docs, which
# installs what it needs. Fails for a warning, a public name without a description, and a link that leads nowhere.
# "pictures" leaves pictures of some pages in out/docs-pictures, made by Chromium.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
staged=$root/build/docs
html=$root/out/docs
pictured=(index page_docs_tasks page_docs_api page_docs_algorithm page_docs_embedding page_docs_embedding_orb_slam
  pages annotated classdot_1_1Tracker structdot_1_1ObjectResult structdot_1_1VelocitySettings namespacedot dot_8h
  structdot__object)

rm -rf "$staged" "$html"
mkdir -p "$staged/pages" "$html"

python3 -B scripts/docs/check_markdown.py "$root"

pages=(*.md docs/*.md docs/*/*.md examples/data/*.md)
python3 -B scripts/docs/pages.py "$root" "$staged/pages" "${pages[@]}"
mv "$staged"/pages/*.json "$staged"

DOT_VERSION=$(sed -n 's/^#define DOT_VERSION_STRING "\(.*\)"$/\1/p' include/dot/version.hpp)
export DOT_VERSION DOT_STAGED=$staged DOT_HTML=$html
status=0
doxygen docs/reference/Doxyfile 2>"$staged/warnings" || status=$?
sed "s|$root/||" "$staged/warnings" >&2
echo "$(grep -c . "$staged/warnings" || true) warnings"
[ "$status" -eq 0 ] || exit "$status"

python3 -B scripts/docs/finish.py "$root" "$staged" "$html"
python3 -B scripts/docs/check_html.py "$html"

if [ "${1:-}" = pictures ]; then
  mkdir -p "$root/out/docs-pictures"
  sandbox=()
  [ "$(id -u)" -ne 0 ] || sandbox=(--no-sandbox) # it refuses to run as root otherwise
  for page in "${pictured[@]}"; do
    chromium --headless=new "${sandbox[@]}" --disable-gpu --hide-scrollbars --force-device-scale-factor=1 \
      --window-size=1280,1600 --screenshot="$root/out/docs-pictures/$page.png" "file://$html/$page.html" 2>/dev/null \
      || { echo "docs: Chromium took no picture of $page" >&2; exit 1; }
  done
  echo "pictures of ${#pictured[@]} pages in $root/out/docs-pictures"
fi
echo "open $html/index.html"
