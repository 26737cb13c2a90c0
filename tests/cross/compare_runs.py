#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Compares outputs of dot_run on one sequence by other kernels or other machines, which differ by rounding alone.

usage: compare_runs.py REFERENCE RUN...        folders of dot_run --out; needs numpy and OpenCV for Python

All objects must be the same, in the same states. Rounding may move an outline's pixel across a threshold and changes
the last digits of velocities: the bounds are for all 24 frames of the sample, among the kernels of one machine too.
"""
import csv
import glob
import os
import sys

import cv2
import numpy as np

MAX_PIXELS = 5  # of all labels that differ, in all frames
MAX_SPEED = 0.02  # m/s: largest difference of a component of a velocity


def objects(run):
    with open(os.path.join(run, "objects.csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def labels(run):
    images = [cv2.imread(path, cv2.IMREAD_UNCHANGED) for path in sorted(glob.glob(os.path.join(run, "labels", "*.png")))]
    if not images or any(image is None for image in images):
        sys.exit(f"{run}/labels lacks images")
    return np.stack(images)


def key(row):
    return row["frame"], row["track_id"], row["state"], row["reason"]


def velocity(row):
    return np.array([float(row[axis]) for axis in ("vx", "vy", "vz")] if row["vx"] else [0.0, 0.0, 0.0])


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    reference = sys.argv[1]
    wanted, wanted_labels = objects(reference), labels(reference)
    if not wanted:
        sys.exit(f"{reference}/objects.csv has no objects")
    failed = False
    for run in sys.argv[2:]:
        rows, images = objects(run), labels(run)
        if len(rows) != len(wanted) or images.shape != wanted_labels.shape:
            sys.exit(f"{run} has other objects or frames than {reference}")
        states = sum(key(a) != key(b) for a, b in zip(rows, wanted))
        pixels = int(np.count_nonzero(images != wanted_labels))
        speed = max(float(np.abs(velocity(a) - velocity(b)).max()) for a, b in zip(rows, wanted))
        good = states == 0 and pixels <= MAX_PIXELS and speed <= MAX_SPEED
        failed |= not good
        print(
            f"{os.path.basename(run)}: {states} of {len(rows)} states differ, {pixels} of {images.size} labels, "
            f"velocities by up to {speed:.4f} m/s{'' if good else '  TOO MUCH'}"
        )
    sys.exit(failed)


main()
