#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""check_html.py FOLDER: every link, picture and script in the pages of a folder, and every entry of the search, leads
to a file in it and to an anchor of that file. Links into the network are counted, not followed."""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def main():
    root = Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(root.rglob("*.html"))}
    links = [(path, link) for path, page in pages.items() for link in page.links]
    links += [(path, link) for path in sorted(root.glob("search/*.js"))
              for link in re.findall(r"\['(\.\./[^']*)'", path.read_text())]
    network, dead = 0, []
    for path, link in links:
        if re.match(r"(https?|mailto):", link):
            network += 1
            continue
        if link.startswith("javascript:"):
            continue
        file, _, anchor = unquote(link).partition("#")
        target = (path.parent / file).resolve() if file else path
        if not target.is_file() or root not in target.parents:
            dead.append((path, link, "no such file"))
        elif anchor and target in pages and anchor not in pages[target].anchors:
            dead.append((path, link, "no such anchor"))
    for path, link, why in dead:
        print(f"{path.relative_to(root)}: {link}: {why}", file=sys.stderr)
    print(f"{len(pages)} pages, {len(links)} links, {network} of them into the network, {len(dead)} dead")
    sys.exit(1 if dead else 0)


if __name__ == "__main__":
    main()
