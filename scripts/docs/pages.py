#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""pages.py ROOT OUT PAGE...: writes the pages in a form that Doxygen reads as the forges do.

Doxygen 1.9 gives headings no anchors, knows no formulas in this notation, takes words for names of classes, and reads
commands in code spans. So headings get labels and links lead to these. Formulas, code spans and pictures are put away
under a mark, in OUT/marks.json; finish.py puts them into the reference, see there. Files that a page links to are
listed in OUT/files.json."""
import json
import re
import sys
from pathlib import Path

import markdown

NAMES_OF_CLASSES = re.compile(r"^(?:template <[^>]*>\n)?(?:class|struct|enum class|using) (?:DOT_EXPORT )?(\w+)", re.M)


def label(page, anchor=""):
    """Doxygen's name for a page, or for a heading of it."""
    if str(page) == "README.md" and not anchor:
        return "index"  # Doxygen's name of the first page
    stem = "_".join(page.with_suffix("").parts)
    return re.sub(r"\W", "_", f"page_{stem}" + (f"__{anchor}" if anchor else "")).lower()


LONG = 6  # headings of a page that gets a table of contents


class Stage:
    def __init__(self, root, pages):
        self.root = root
        self.pages = set(pages)
        self.marks = []
        self.files = set()
        headers = (p.read_text() for p in (root / "include").rglob("*.hpp"))
        classes = sorted({name for text in headers for name in NAMES_OF_CLASSES.findall(text)})
        self.words = re.compile(r"\[[^\[\]]*\]\([^()]*\)|\b(?:" + "|".join(classes) + r")\b")  # links stay as they are

    def mark(self, kind, text, **more):
        self.marks.append({"kind": kind, "text": text, **more})
        return f"xmark{len(self.marks) - 1:05d}x"

    def page(self, page):
        text = (self.root / page).read_text()
        headings = markdown.anchors(text)
        anchors = iter(headings)
        if len(headings) >= LONG and label(page) != "index":
            text = re.sub(r"^(# .*\n)", r"\1\n[TOC]\n", text, count=1)
        out = []
        for part in markdown.split(text):
            if isinstance(part, markdown.Block):
                out.append(self.block(part))
            else:
                out.append(self.prose(page, part, anchors))
        return "\n".join(out)

    def block(self, block):
        if block.language == "math":
            return block.indent + self.mark("formula", block.code)
        if block.language in ("c", "cpp", "python") and not block.indent:
            extension = {"python": "py"}.get(block.language, block.language)
            return f"~~~{{.{extension}}}\n{block.code}\n~~~"
        return block.indent + self.mark("block", block.code)

    def prose(self, page, text, anchors):
        text = markdown.COMMENT.sub("", text)
        text = markdown.MATH.sub(lambda m: self.mark("math", m[1]), text)
        text = markdown.CODE.sub(lambda m: self.mark("code", " ".join(m[1].split())), text)
        text = markdown.LINK.sub(lambda m: self.link(page, m), text)
        text = self.words.sub(lambda m: m[0] if m[0][0] == "[" else "%" + m[0], text)
        return markdown.HEADING.sub(lambda m: self.heading(page, m, next(anchors)), text)

    def heading(self, page, match, known):
        level, _, anchor = known
        title = match[2].replace("%", "")
        name = label(page, anchor if level > 1 else "")
        return f"{match[1]} {title} {{#{'mainpage' if name == 'index' else name}}}"

    def link(self, page, match):
        picture, text, target = match.groups()
        resolved = markdown.resolve(page, target)
        if resolved is None:
            return " ".join(match[0].split())
        path, anchor = resolved
        if picture:
            self.files.add(str(path))
            return self.mark("picture", " ".join(text.split()), path=str(path))
        if path in self.pages:
            return f"[{' '.join(text.split())}](@ref {label(path, anchor)})"
        if (self.root / path).is_dir():
            return " ".join(text.split())
        self.files.add(str(path))
        return self.mark("file", " ".join(text.split()), path=str(path))


def main():
    root, out = Path(sys.argv[1]), Path(sys.argv[2])
    pages = [Path(p) for p in sys.argv[3:]]
    stage = Stage(root, pages)
    for page in pages:
        (out / (label(page) + ".md")).write_text(stage.page(page))
    (out / "marks.json").write_text(json.dumps(stage.marks))
    (out / "files.json").write_text(json.dumps(sorted(stage.files)))


if __name__ == "__main__":
    main()
