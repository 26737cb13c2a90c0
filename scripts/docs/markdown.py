# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the checker and the reference need to know of a page in Markdown: its code blocks, headings and links."""
import re
from dataclasses import dataclass
from pathlib import Path

FENCE = re.compile(r"^(\s*)```(\w*)\s*$")
HEADING = re.compile(r"^(#+) (.*)$", re.M)
# A code span or link may go on in the next line, but not beyond a blank one.
MATH = re.compile(r"\$`((?:[^`\n]|\n(?!\s*\n))+)`\$")
CODE = re.compile(r"(?<!`)`((?:[^`\n]|\n(?!\s*\n))+)`(?!`)")
LINK = re.compile(r"(!?)\[((?:[^\[\]\n]|\n(?!\s*\n))*)\]\(([^()\s]+)\)")
COMMENT = re.compile(r"<!--.*?-->", re.S)


@dataclass
class Block:
    """A fenced block of code."""
    line: int      # of its first line of code, from 1
    indent: str
    language: str
    code: str
    comment: str   # the HTML comment in the line before, without its marks


def split(text):
    """Parts of a page in their order: strings of prose, and Blocks."""
    parts, prose, block, comment = [], [], None, ""
    for number, line in enumerate(text.split("\n"), 1):
        fence = FENCE.match(line)
        if block is None and fence:
            before = prose[-1].strip() if prose else ""
            comment = before[4:-3].strip() if before.startswith("<!--") and before.endswith("-->") else ""
            parts.append("\n".join(prose))
            block = Block(number + 1, fence[1], fence[2], "", comment)
            prose = []
        elif block is not None and fence:
            block.code = "\n".join(l[len(block.indent):] for l in prose)
            parts.append(block)
            block, prose = None, []
        else:
            prose.append(line)
    if block is not None:
        raise ValueError(f"the code block before line {block.line} does not end")
    parts.append("\n".join(prose))
    return parts


def plain(heading):
    """A heading's text without its marks."""
    return re.sub(r"[`*]|\$(?=`)|(?<=`)\$", "", LINK.sub(r"\2", heading)).strip()


def anchors(text):
    """The anchors that forges give the headings, in order: (level, heading, anchor)."""
    found, used = [], {}
    for part in split(text):
        if isinstance(part, Block):
            continue
        for level, heading in HEADING.findall(COMMENT.sub("", part)):
            anchor = re.sub(r"[^\w\- ]", "", plain(heading).lower()).replace(" ", "-")
            count = used.get(anchor, 0)
            used[anchor] = count + 1
            found.append((len(level), heading, anchor if count == 0 else f"{anchor}-{count}"))
    return found


def links(text):
    """The targets of all links and pictures outside of code."""
    for part in split(text):
        if not isinstance(part, Block):
            for _, _, target in LINK.findall(CODE.sub("code", MATH.sub("math", COMMENT.sub("", part)))):
                yield target


def resolve(page, target):
    """A link of a page as (file, anchor), the file relative to the project's folder; None for one to the network."""
    if re.match(r"[a-z]+:", target):
        return None
    path, _, anchor = target.partition("#")
    return (page if not path else Path(*_normal((page.parent / path).parts)), anchor)


def _normal(parts):
    out = []
    for part in parts:
        if part == "..":
            if not out:
                raise ValueError("a link leads out of the project")
            out.pop()
        elif part != ".":
            out.append(part)
    return out
