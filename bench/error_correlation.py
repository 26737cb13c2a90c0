#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""How much of a velocity's error do successive fits to a standing object share?

usage: error_correlation.py DOT_RUN SEQ...        needs numpy and OpenCV for Python

Runs DOT_RUN on each sequence with a mask in every and in every fourth frame. Prints the mean product of two successive
velocities of standing objects, each over its sigma, for fits to the same reference and to different ones: the share of
the variance that both have in common.
"""
import collections
import csv
import pathlib
import subprocess
import sys
import tempfile

import cv2
import numpy as np

AXES = ("x", "y", "z")
GROSS = 4  # sigmas: such an error is a wrong fit


def standing(sequence):
    """The ids of standing objects in each frame."""
    ids = collections.defaultdict(set)
    with open(sequence / "objects.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["moving"] == "0":
                ids[int(row["frame"])].add(int(row["id"]))
    return ids


def products(sequence, out):
    """Yields (same reference, products along the axes) for each pair of successive fits to what stands."""
    stands, last = standing(sequence), {}
    step = 1 / float((sequence / "intrinsics.txt").read_text().split()[7])  # seconds of a frame
    with open(out / "objects.csv", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["vx"]]
    for row in rows:
        frame, track = int(row["frame"]), int(row["track_id"])
        truth = cv2.imread(str(sequence / f"instance/{frame:06d}.png"), cv2.IMREAD_UNCHANGED)
        tracks = cv2.imread(str(out / f"instances/{frame:06d}.png"), cv2.IMREAD_UNCHANGED)
        shown = truth[tracks == track]
        if len(shown) < 100 or np.bincount(shown).argmax() not in stands[frame]:
            continue
        error = np.array([float(row["v" + a]) / float(row["sigma_v" + a]) for a in AXES])
        span = float(row["interval_s"])
        if track in last and last[track][0] == frame - 1:
            _, before, span_before = last[track]
            same = abs(span - span_before - step) < 0.1 * step
            yield same, np.where(np.maximum(abs(error), abs(before)) < GROSS, error * before, np.nan)
        last[track] = (frame, error, span)


def main(dot_run, sequences):
    found = {True: [], False: []}
    for sequence in map(pathlib.Path, sequences):
        for every in ("1", "4"):
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([dot_run, sequence, "--mask-every", every, "--out", folder], check=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                for same, product in products(sequence, pathlib.Path(folder)):
                    found[same].append(product)
    for same, name in ((True, "the same reference"), (False, "different ones")):
        mean = np.nanmean(found[same], axis=0) if found[same] else [np.nan] * 3
        print(f"{name:20}{len(found[same]):6} pairs  x {mean[0]:.2f}  y {mean[1]:.2f}  z {mean[2]:.2f}  "
              f"mean {np.mean(mean):.2f}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
