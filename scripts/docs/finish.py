#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""finish.py ROOT STAGED HTML: puts into the pages that Doxygen made what pages.py put away: formulas as MathML, made by
KaTeX; code spans, with a link where they name something that is described; pictures, and files of the project."""
import html
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

from names import Names

MARK = re.compile(r"xmark(\d{5})x")
TAG = re.compile(r"(<[^>]*>)")
KATEX = """const katex = require("katex");
const said = JSON.parse(require("fs").readFileSync(0, "utf8"));
console.log(JSON.stringify(said.map(([tex, block]) =>
  katex.renderToString(tex, {output: "mathml", displayMode: block, throwOnError: true}))));"""
PICTURES = {".jpg", ".png", ".svg"}


def mathml(marks):
    """MathML of the formulas among the marks, by their number."""
    numbers = [i for i, m in enumerate(marks) if m["kind"] in ("math", "formula")]
    said = json.dumps([(marks[i]["text"], marks[i]["kind"] == "formula") for i in numbers])
    run = subprocess.run(["node", "-e", KATEX], input=said, text=True, stdout=subprocess.PIPE, check=True,
                         env={"PATH": "/usr/bin:/bin", "NODE_PATH": "/usr/share/nodejs"})
    return dict(zip(numbers, json.loads(run.stdout)))


def file_url(path):
    return f"files/{path}" + ("" if Path(path).suffix in PICTURES else ".txt")


class Finish:
    def __init__(self, marks, names):
        self.marks = marks
        self.names = names
        self.math = mathml(marks)
        self.used = set()

    def name_url(self, text):
        """Where the name in a code span is described: `track`, `dot::Tracker::track`, `frame.masks`, `dot_track()`."""
        name = re.sub(r"\(.*\)$|<.*>$", "", text)
        if not re.fullmatch(r"[\w:.]+", name):
            return None
        for spelt in (name, re.sub(r"^(frame|result|object|camera|intrinsics|tracker)\.", lambda m: {
                "frame": "Frame", "result": "Result", "object": "ObjectResult", "camera": "CameraResult",
                "intrinsics": "Intrinsics", "tracker": "Tracker"}[m[1]] + "::", name)):
            # A single word may be meant otherwise: `track`, or the Frame of another system.
            if spelt in self.names.url and re.search(r"::|_|\.|[A-Z].*[A-Z]", spelt):
                return self.names.url[spelt]
        return None

    def plain(self, match):
        return html.escape(" ".join(self.marks[int(match[1])]["text"].split()))

    def rich(self, number, in_link):
        mark = self.marks[number]
        self.used.add(number)
        text, kind = html.escape(mark["text"], quote=False), mark["kind"]
        if kind in ("math", "formula"):
            return self.math[number]
        if kind == "block":
            return f'<pre class="fragment">{text}</pre>'
        if kind == "picture":
            alt = html.escape(mark["text"])
            return f'<img src="{file_url(mark["path"])}" alt="{alt}"/>'
        if kind == "file":
            inner = MARK.sub(lambda m: self.rich(int(m[1]), True), text)
            return f'<a href="{file_url(mark["path"])}">{inner}</a>'
        url = None if in_link else self.name_url(mark["text"])
        return f'<a class="name" href="{url}"><code>{text}</code></a>' if url else f"<code>{text}</code>"

    def page(self, text):
        out, depth, title = [], 0, False
        for part in TAG.split(text):
            if part.startswith("<"):
                depth += part.startswith("<a ") - (part == "</a>")
                title = part == "<title>" if part in ("<title>", "</title>") else title
                out.append(MARK.sub(self.plain, part))
            elif title:
                out.append(MARK.sub(self.plain, part))
            else:
                out.append(MARK.sub(lambda m: self.rich(int(m[1]), depth > 0), part))
        text = "".join(out)
        # A block is no paragraph. Doxygen's link to the nested classes leads nowhere if all of them are private.
        text = re.sub(r"<p>\s*(<pre class=\"fragment\">.*?</pre>)\s*</p>", r"\1", text, flags=re.S)
        if 'name="nested-classes"' not in text:
            text = re.sub(r"<a href=\"#nested-classes\">[^<]*</a>( &#124;\s*)?", "", text)
        return text


def main():
    root, staged, out = (Path(a) for a in sys.argv[1:4])
    finish = Finish(json.loads((staged / "marks.json").read_text()), Names(staged / "xml"))
    for path in sorted(out.rglob("*.html")):
        path.write_text(finish.page(path.read_text()))
    for path in sorted(out.rglob("*.js")):
        path.write_text(MARK.sub(finish.plain, path.read_text()))
    for path in json.loads((staged / "files.json").read_text()):
        to = out / file_url(path)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / path, to)
    lost = set(range(len(finish.marks))) - finish.used
    if lost:
        sys.exit("not in any page: " + ", ".join(finish.marks[i]["text"][:40] for i in sorted(lost)[:5]))
    for name in finish.names.undescribed:
        print(f"{name} has no description", file=sys.stderr)
    print(f"{finish.names.count} names, {len(finish.names.undescribed)} without a description")
    sys.exit(1 if finish.names.undescribed else 0)


if __name__ == "__main__":
    main()
