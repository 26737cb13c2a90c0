# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A look at a recording before it is run: the report of `dot_run --check`, which has the one implementation.

The program is $DOT_RUN, or dot_run in the path. It is built with the project (examples/dot_run); the wheel does not
hold it.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .sequence import FileError

FAULTS_FOUND = 3  # the program's status


@dataclass(frozen=True)
class Finding:
    """What was measured of one property of a recording."""

    fault: str  # name of what could be wrong, such as "depth-lag"; docs/check.md lists them
    verdict: str  # "fault", "hint", "fine" or "not measured"
    figure: float | None  # None where nothing could be measured
    unit: str
    words: str
    advice: str  # what to do about a fault or a hint


def program() -> str:
    found = os.environ.get("DOT_RUN") or shutil.which("dot_run")
    if not found:
        raise FileError("dot_run: not found; put it into the path, or name it in the environment as DOT_RUN")
    return found


def check(folder: str | os.PathLike[str], *, html: str | os.PathLike[str] | None = None) -> list[Finding]:
    """What is wrong with a recording, faults first. html: a page to write.

    Raises FileError where a file cannot be read, or the program is missing.
    """
    # Absolute, as a name may begin with a dash; and a folder's name may be of any bytes.
    arguments = [program(), os.path.abspath(Path(folder)), "--check", "--json"]
    if html is not None:
        arguments += ["--html", os.path.abspath(html)]
    try:
        done = subprocess.run(arguments, capture_output=True, encoding="utf-8", errors="surrogateescape", check=False)
    except OSError as error:
        raise FileError(f"{arguments[0]}: {error.strerror}") from None
    if done.returncode not in (0, FAULTS_FOUND):
        raise FileError(done.stderr.strip() or f"{arguments[0]}: ended with status {done.returncode}")
    try:
        return [Finding(**item) for item in json.loads(done.stdout)["findings"]]
    except (ValueError, KeyError, TypeError):
        raise FileError(f"{arguments[0]}: does not answer as dot_run does; what does DOT_RUN name?") from None
