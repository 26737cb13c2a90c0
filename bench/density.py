#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What sparse depth costs: runs sequences with the depth of other sensors, and prints the table of docs/sparse-depth.md.

usage: density.py DOT_EVAL OUT SEQ... [--OPTION VALUE]...        needs numpy and OpenCV for Python

The sequences, of the layout of docs/evaluation.md, are run as they are and as variants.py makes them of each kind, with
the options, which are those of dot_eval. The copies go into OUT, and those that are there already are used again. So do
the figures as KIND.json and the plot as density.svg. Figures are those of all sequences together, those of the camera
the median of the sequences'.
"""
import glob
import json
import os
import statistics
import subprocess
import sys

import cv2

import plots
import variants

KINDS = ("as recorded", "holes50", "edges", "lidar64", "lidar32", "lidar16", "flash60", "tof60", "mappoints")
RATES = ("1", "4")


def share_with_depth(folders):
    """Of the pixels, in every eighth frame."""
    shares = [(cv2.imread(path, cv2.IMREAD_UNCHANGED) > 0).mean()
              for folder in folders for path in sorted(glob.glob(f"{folder}/depth/*.png"))[::8]]
    return sum(shares) / len(shares)


def copy_of(sequence, kind, out):
    folder = f"{out}/{os.path.basename(sequence)}-{kind}"
    if not os.path.exists(f"{folder}/complete"):
        variants.make(kind, out, sequence)
        with open(f"{folder}/complete", "w", encoding="utf-8"):
            pass
    return folder


def camera_cm(found, rate):
    return statistics.median(run["camera"]["rpe_trans_median_cm"] for run in found["runs"] if run["every"] == int(rate))


def shown(value, digits=3):
    return "" if value is None else f"{value:.{digits}f}".lstrip("0") if value < 1 else f"{value:.{digits}f}"


def print_table(results):
    """results: (kind, share of the pixels with depth, what --json wrote)."""
    print("| depth | pixels with depth | masks | object-frames | F1 | st>mov | kept | mask IoU | camera, cm |")
    print("|---|---|---|---|---|---|---|---|---|")
    for kind, share, found in results:
        for rate, p in found["pooled"].items():
            print(f"| `{kind}` | {shown(share, 4)} | 1/{rate} | {p['object_frames']} | {shown(p['moving_f1'])} "
                  f"| {shown(p['static_moving_share'])} | {shown(p['static_kept_share'])} "
                  f"| {shown(p['moving_mask_iou'])} | {shown(camera_cm(found, rate), 2)} |")


def draw(path, results):
    def line(name, figure):
        points = [(100 * share, figure(found)) for _, share, found in results]
        return name, [(x, max(y, 1e-3)) for x, y in points if y is not None], False

    def lost(name):
        def error(found):
            value = found["pooled"]["1"][name]
            return None if value is None else 1 - value

        return error

    plots.plot(path, "What sparse depth costs", "% of the pixels with depth", "error", [
        line("1 - F1", lost("moving_f1")),
        line("1 - kept", lost("static_kept_share")),
        line("camera, cm a frame", lambda found: camera_cm(found, "1")),
    ], log=True)


def main():
    options = next((i for i, word in enumerate(sys.argv) if word.startswith("--")), len(sys.argv))
    if options < 4:
        sys.exit(__doc__)
    dot_eval, out, sequences = sys.argv[1], sys.argv[2], [os.path.normpath(s) for s in sys.argv[3:options]]
    os.makedirs(out, exist_ok=True)
    results = []
    for kind in KINDS:
        folders = sequences if kind == KINDS[0] else [copy_of(sequence, kind, out) for sequence in sequences]
        figures = f"{out}/{kind.replace(' ', '-')}.json"
        subprocess.run([dot_eval, *folders, "--rates", ",".join(RATES), "--json", figures, *sys.argv[options:]],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(figures, encoding="utf-8") as file:
            results.append((kind, share_with_depth(folders), json.load(file)))

    print_table(results)
    draw(f"{out}/density.svg", results)


if __name__ == "__main__":
    main()
