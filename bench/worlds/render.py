#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Renders a world in which things move, with its ground truth: a sequence of the layout of docs/evaluation.md.

usage: render.py WORLD OUT [--frames A:B] [--threads N]        needs Blender 3.4, numpy and OpenCV for Python

docs/worlds.md shows the worlds. --frames A:B renders the frames from A to before B, which are then numbered from 0 on.
OUT must not exist. At the end it is said how well the pictures agree with the truth.
"""
import argparse
import collections
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import agreement
import sequence
from rendered import Rendered

HERE = os.path.dirname(os.path.abspath(__file__))
WORLDS = sorted(name[:-3] for name in os.listdir(f"{HERE}/places") if name.endswith(".py"))
ALL_FRAMES = (0, sys.maxsize)


def frame_range(text):
    """(A, B) of "A:B"."""
    first, colon, end = text.partition(":")
    if not (colon and first.isdigit() and end.isdigit() and int(first) < int(end)):
        raise argparse.ArgumentTypeError(f"{text} is not A:B, with A less than B")
    return int(first), int(end)


def run_blender(world, folder, frames, threads):
    """Builds the world and renders its frames into the folder."""
    blender = shutil.which("blender")
    if blender is None:
        sys.exit("render.py: there is no blender on the PATH; Debian and Ubuntu: apt install blender")
    command = [blender, "--background", "--factory-startup", "--python-exit-code", "1",
               "--python", f"{HERE}/in_blender.py", "--", world, folder, *map(str, frames), str(threads)]
    last_lines = collections.deque(maxlen=20)
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace") as run:
        for line in run.stdout:
            last_lines.append(line)
            if line.startswith("rendered frame"):
                print(line, end="", flush=True)
    if run.returncode != 0:
        sys.exit("".join(last_lines) + f"render.py: Blender failed (exit status {run.returncode})")


def say_agreement(rendered):
    pairs = agreement.compare(rendered.recording, rendered.poses, rendered.pictures())
    for what, columns in (("what stands", pairs[:, :2]), ("what moves", pairs[:, 2:])):
        columns = columns[~np.isnan(columns).any(axis=1)]
        if len(columns):
            moved, as_is = columns.mean(axis=0)
            print(f"{what}: pictures differ by {moved:.1f} grey values after the true motion, by {as_is:.1f} without")


def main():
    arguments = argparse.ArgumentParser(usage=__doc__)
    arguments.add_argument("world", choices=WORLDS)
    arguments.add_argument("out")
    arguments.add_argument("--frames", type=frame_range, default=ALL_FRAMES)
    arguments.add_argument("--threads", type=int, default=os.cpu_count())
    a = arguments.parse_args()
    if os.path.exists(a.out):
        sys.exit(f"render.py: {a.out} exists")
    with tempfile.TemporaryDirectory() as folder:
        run_blender(a.world, folder, a.frames, a.threads)
        rendered = Rendered(folder)
        if not rendered.frames:
            sys.exit(f"render.py: {a.world} has {rendered.recording.frames} frames")
        sequence.write(a.out, rendered.recording, rendered.kinds, rendered.poses, rendered.pictures())
        say_agreement(rendered)
    print("wrote", a.out)


if __name__ == "__main__":
    main()
