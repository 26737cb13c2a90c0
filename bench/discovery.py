#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What `dot_run --discover` finds and invents: the figures of docs/decisions.md that dot_eval does not have.

usage: discovery.py DOT_RUN OUT SEQ... [--frames A-B] [--still A-B,...]        needs numpy and OpenCV for Python

Runs each sequence, of the layout of docs/evaluation.md, as it is, with all its masks. Results go into OUT/NAME. Prints

  found     share of the movers' pixels that are called moving, in the frames of --frames (default: all)
  outside   share of the pixels called moving there that are not of a mover
  still     frames of --still with anything called moving, of how many
  invented  frames in which a discovered object has 200 pixels or more off the movers, and less than .3 of it on them
"""
import argparse
import csv
import os
import subprocess
import sys

import cv2
import numpy as np

MOVING = 2  # in labels/
LEAST_PIXELS, LEAST_ON_MOVER = 200, 0.3


def frames_of(text):
    """The numbers in a list like 0-22,105-108."""
    ends = [part.split("-") for part in text.split(",")]
    return {n for end in ends for n in range(int(end[0]), int(end[-1]) + 1)}


def ids_by_frame(path, frame, identity, wanted):
    found = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row[wanted] == "1":
                found.setdefault(int(row[frame]), []).append(int(row[identity]))
    return found


def measure(sequence, out, counted, still):
    movers = ids_by_frame(f"{sequence}/objects.csv", "frame", "id", "moving")
    discovered = ids_by_frame(f"{out}/objects.csv", "frame", "track_id", "discovered")
    on = of_movers = called = disturbed = stills = invented = frames = 0
    for name in sorted(os.listdir(f"{out}/labels")):
        number = int(os.path.splitext(name)[0])
        truth = cv2.imread(f"{sequence}/instance/{name}", cv2.IMREAD_UNCHANGED)
        moving = cv2.imread(f"{out}/labels/{name}", cv2.IMREAD_UNCHANGED) == MOVING
        tracks = cv2.imread(f"{out}/instances/{name}", cv2.IMREAD_UNCHANGED)
        mover = np.isin(truth, movers.get(number, []))
        frames += 1
        if counted is None or number in counted:
            on, of_movers, called = on + (moving & mover).sum(), of_movers + mover.sum(), called + moving.sum()
        if number in still:
            stills, disturbed = stills + 1, disturbed + moving.any()
        regions = [tracks == track for track in discovered.get(number, [])]
        invented += any((r & ~mover).sum() >= LEAST_PIXELS and (r & mover).sum() < LEAST_ON_MOVER * r.sum()
                        for r in regions)
    return np.array([on, of_movers, called, disturbed, stills, invented, frames])


def row(name, sums):
    on, of_movers, called, disturbed, stills, invented, frames = sums
    share = lambda part, whole: f"{part / whole:.3f}" if whole else "-"
    print(f"{name:<16}{share(on, of_movers):>8}{share(called - on, called):>9}"
          f"{f'{disturbed}/{stills}':>9}{f'{invented}/{frames}':>10}", flush=True)


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    arguments = argparse.ArgumentParser(usage=__doc__)
    arguments.add_argument("dot_run")
    arguments.add_argument("out")
    arguments.add_argument("sequences", nargs="+")
    arguments.add_argument("--frames", type=frames_of)
    arguments.add_argument("--still", type=frames_of, default=set())
    a = arguments.parse_args()
    print(f"{'sequence':<16}{'found':>8}{'outside':>9}{'still':>9}{'invented':>10}")
    total = np.zeros(7, dtype=np.int64)
    for sequence in map(os.path.normpath, a.sequences):
        out = os.path.join(a.out, os.path.basename(sequence))
        run = subprocess.run([a.dot_run, sequence, "--discover", "--out", out], capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(run.stderr)
        sums = measure(sequence, out, a.frames, a.still)
        row(os.path.basename(sequence), sums)
        total += sums
    if len(a.sequences) > 1:
        row("together", total)


if __name__ == "__main__":
    main()
