#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Checks the pages in Markdown: every link to a file or heading leads somewhere, and every block of code is one that a
test compiles or runs, or says in another way that it is right.

A block is preceded by a line
    <!-- snippet: NAME -->       taken from the page by a test, which compiles or runs it (tests/cmake/Snippet.cmake)
    <!-- fragment: REASON -->    not; why it cannot be, or what else checks it
Blocks of sh need neither: their syntax is checked, and that the verbs of dev.sh and the options of our programs that
they use exist. Of fragments of cmake the targets are checked, of fragments of Python the syntax; fragments of other
languages are refused."""
import ast
import re
import subprocess
import sys
from pathlib import Path

import markdown

NEEDS_NO_CHECK = {"math", "text", ""}
COMPILED = {"c", "cpp", "python", "rust", "cmake"}
TARGETS = {"dot::dot", "dot::headers", "dot::capi", "dot::capi_static"}
PROGRAMS = ("dot_run", "dot_eval", "slam_masks")


class Checker:
    def __init__(self, root):
        self.root = root
        self.complaints = []
        self.counts = {"pages": 0, "links": 0, "snippets": 0, "fragments": 0, "commands": 0}
        self.verbs = set(re.findall(r"^  (?:\w+ \| )*(\w+)\)", (root / "dev.sh").read_text(), re.M))
        self.tests = [p.read_text() for p in (root / "tests").rglob("*")
                      if p.suffix in (".txt", ".cmake", ".c", ".cpp", ".cc", ".h", ".hpp", ".rs", ".py") and p.is_file()]
        self.options = {o for p in (root / "examples").rglob("*.cpp") for o in re.findall(r"--[a-z][\w-]*", p.read_text())}

    def complain(self, page, line, text):
        self.complaints.append(f"{page}:{line}: {text}" if line else f"{page}: {text}")

    def check(self, page):
        text = (self.root / page).read_text()
        self.counts["pages"] += 1
        for target in markdown.links(text):
            self.check_link(page, target)
        for part in markdown.split(text):
            if isinstance(part, markdown.Block) and part.language not in NEEDS_NO_CHECK:
                self.check_block(page, part)

    def check_link(self, page, target):
        self.counts["links"] += 1
        resolved = markdown.resolve(page, target)
        if resolved is None:
            return
        path, anchor = resolved
        if not (self.root / path).exists():
            self.complain(page, 0, f"the link {target} leads to no file")
        elif anchor and anchor not in {a for _, _, a in markdown.anchors((self.root / path).read_text())}:
            self.complain(page, 0, f"the link {target} leads to no heading")

    def check_block(self, page, block):
        kind, _, what = (part.strip() for part in block.comment.partition(":"))
        if block.language in ("sh", "bash"):
            self.check_commands(page, block)
        elif block.language not in COMPILED:
            self.complain(page, block.line, f"blocks of {block.language} are not checked by anything")
        elif kind == "snippet":
            self.counts["snippets"] += 1
            if not any(re.search(rf"\b{re.escape(what)}\b", text) for text in self.tests):
                self.complain(page, block.line, f"no test takes the snippet {what}")
        elif kind == "fragment" and what:
            self.counts["fragments"] += 1
            if block.language == "cmake":
                self.check_targets(page, block)
            elif block.language == "python":
                self.check_python(page, block)
            else:
                self.complain(page, block.line, f"a fragment of {block.language}, which nothing checks")
        else:
            self.complain(page, block.line, f"a block of {block.language} without <!-- snippet: --> before it")

    def check_targets(self, page, block):
        for target in sorted(set(re.findall(r"\bdot::\w+", block.code)) - TARGETS):
            self.complain(page, block.line, f"there is no target {target}")

    def check_python(self, page, block):
        try:
            ast.parse(block.code)
        except SyntaxError as error:
            self.complain(page, block.line + error.lineno - 1, error.msg)

    def check_commands(self, page, block):
        self.counts["commands"] += 1
        syntax = subprocess.run(["bash", "-n"], input=block.code.replace("...", ""), text=True, capture_output=True)
        if syntax.returncode != 0:
            self.complain(page, block.line, syntax.stderr.split("\n")[0])
        for verb in re.findall(r"\./dev\.sh (\w+)", block.code):
            if verb not in self.verbs:
                self.complain(page, block.line, f"dev.sh has no verb {verb}")
        for command in re.sub(r"\\\n", " ", block.code).split("\n"):
            words = command.split("#")[0].split()
            if words and Path(words[0]).name in PROGRAMS:
                for option in re.findall(r"--[a-z][\w-]*", " ".join(words[1:])):
                    if option not in self.options:
                        self.complain(page, block.line, f"{Path(words[0]).name} has no option {option}")


def main():
    root = Path(sys.argv[1]).resolve()
    pages = sorted(p.relative_to(root) for place in ("*.md", "docs/**/*.md", "python/*.md", "examples/**/*.md")
                   for p in root.glob(place))
    checker = Checker(root)
    for page in pages:
        try:
            checker.check(page)
        except ValueError as error:
            checker.complain(page, 0, error)
    print(", ".join(f"{n} {what}" for what, n in checker.counts.items()))
    for complaint in checker.complaints:
        print(complaint, file=sys.stderr)
    return 1 if checker.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
