#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What sparse depth costs: runs sequences with the depth of other sensors, and prints a table like that of docs/decisions.md.

usage: density.py DOT_EVAL OUT SEQ...        needs numpy and OpenCV for Python

The sequences, of the layout of docs/evaluation.md, are run as they are and as variants.py makes them of each kind; the
copies go into OUT, with the figures as KIND.json and the plot as density.svg. Figures are those of all sequences together.
"""
import glob
import json
import os
import subprocess
import sys

import cv2

import plots
import variants

KINDS = ("as recorded", "holes50", "edges", "lidar64", "lidar32", "lidar16")
RATES = ("1", "4")


def share_with_depth(folders):
    """Of the pixels, in every eighth frame."""
    shares = [(cv2.imread(path, cv2.IMREAD_UNCHANGED) > 0).mean()
              for folder in folders for path in sorted(glob.glob(f"{folder}/depth/*.png"))[::8]]
    return sum(shares) / len(shares)


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    dot_eval, out, sequences = sys.argv[1], sys.argv[2], [os.path.normpath(s) for s in sys.argv[3:]]
    os.makedirs(out, exist_ok=True)
    found = []
    for kind in KINDS:
        folders = sequences
        if kind != KINDS[0]:
            for sequence in sequences:
                variants.make(kind, out, sequence)
            folders = [f"{out}/{os.path.basename(s)}-{kind}" for s in sequences]
        figures = f"{out}/{kind.replace(' ', '-')}.json"
        subprocess.run([dot_eval, *folders, "--rates", ",".join(RATES), "--json", figures], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(figures, encoding="utf-8") as file:
            found.append((kind, share_with_depth(folders), json.load(file)["pooled"]))

    print("| depth | pixels with depth | masks | F1 | standing called moving | kept | mask IoU | camera, cm |")
    print("|---|---|---|---|---|---|---|---|")
    for kind, share, pooled in found:
        for rate in RATES:
            p = pooled[rate]
            print(f"| {kind} | {share:.3f} | 1/{rate} | {p['moving_f1']:.3f} | {p['static_moving_share']:.3f} "
                  f"| {p['static_kept_share']:.3f} | {p['moving_mask_iou']:.3f} | {p['rpe_trans_median_cm']:.2f} |")

    def line(name, figure):
        return name, [(100 * share, max(figure(pooled["1"]), 1e-3)) for _, share, pooled in found], False

    plots.plot(f"{out}/density.svg", "What sparse depth costs", "% of the pixels with depth", "error", [
        line("1 - F1", lambda p: 1 - p["moving_f1"]),
        line("1 - kept", lambda p: 1 - p["static_kept_share"]),
        line("camera, cm a frame", lambda p: p["rpe_trans_median_cm"]),
    ], log=True)


if __name__ == "__main__":
    main()
