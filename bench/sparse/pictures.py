#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Pictures of what becomes of sparse depth, for docs/sparse-depth.md.

usage: pictures.py BUILD OUT SEQ FRAME        needs numpy and OpenCV for Python

BUILD has bench_sparse_points and dot_run. For the depth of several sensors, as ../variants.py makes them of the sequence
SEQ, writes OUT/KIND.jpg and prints how many pixels are measured, how many have depth then, and how many points there
are. A picture shows the depth as measured and as interpolated (near is red, far is blue), the points that are found in
each, and the labels: orange is moving, green is static, grey is not observable.
"""
import os
import subprocess
import sys
import tempfile

os.environ.setdefault("OPENCV_LOG_LEVEL", "ERROR")  # a folder that variants.py may find missing is no news
import cv2
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import variants

KINDS = ("lidar64", "lidar16", "holes50", "edges")
NEAR, FAR = 4.0, 60.0  # metres: ends of the colours
COLOURS = {1: (80, 200, 80), 2: (0, 140, 255), 3: (160, 160, 160)}  # of the labels, BGR


def colour_of(depth):
    """BGR of depths in metres, by their logarithm."""
    share = np.clip(np.log(np.maximum(depth, 1e-3) / NEAR) / np.log(FAR / NEAR), 0, 1)
    return cv2.applyColorMap((255 * (1 - share)).astype(np.uint8).reshape(-1, 1), cv2.COLORMAP_JET).reshape(-1, 3)


def titled(picture, text):
    cv2.rectangle(picture, (0, 0), (9 * len(text) + 12, 22), (0, 0, 0), -1)
    cv2.putText(picture, text, (6, 16), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 255, 255), 1, cv2.LINE_AA)
    return picture


def with_depth(grey, depth):
    picture = (0.5 * grey).astype(np.uint8)
    known = depth > 0
    picture[known] = colour_of(depth[known])
    return picture


def with_points(grey, points):
    picture = (0.7 * grey).astype(np.uint8)
    if len(points):
        for (u, v), colour in zip(points[:, :2], colour_of(points[:, 2]).tolist()):
            cv2.circle(picture, (int(round(u)), int(round(v))), 2, colour, -1, cv2.LINE_AA)
    return picture


def with_labels(grey, labels):
    picture = grey.copy()
    for label, colour in COLOURS.items():
        picture[labels == label] = 0.4 * picture[labels == label] + 0.6 * np.array(colour)
    return picture


def points_of(path):
    with open(path, encoding="utf-8") as file:
        return np.array([[float(x) for x in line.split(",")] for line in file]).reshape(-1, 3)


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    build, out, sequence, frame = sys.argv[1], sys.argv[2], os.path.normpath(sys.argv[3]), int(sys.argv[4])
    os.makedirs(out, exist_ok=True)
    print("| depth | measured | with depth, once interpolated | points in the measurements | points |")
    print("|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as work:
        for kind in KINDS:
            variants.make(kind, work, sequence)
            folder = f"{work}/{os.path.basename(sequence)}-{kind}"
            subprocess.run([f"{build}/bench/bench_sparse_points", folder, str(frame), f"{work}/points"], check=True)
            subprocess.run([f"{build}/examples/dot_run", folder, "--out", f"{work}/run"], check=True,
                           stdout=subprocess.DEVNULL)
            grey = cv2.cvtColor(cv2.imread(f"{folder}/rgb/{frame:06d}.png", cv2.IMREAD_GRAYSCALE), cv2.COLOR_GRAY2BGR)
            measured = cv2.imread(f"{folder}/depth/{frame:06d}.png", cv2.IMREAD_UNCHANGED) / 256
            dense = cv2.imread(f"{work}/points/depth.png", cv2.IMREAD_UNCHANGED) / 256
            before, after = points_of(f"{work}/points/points_measured.csv"), points_of(f"{work}/points/points.csv")
            labels = cv2.imread(f"{work}/run/labels/{frame:06d}.png", cv2.IMREAD_UNCHANGED)
            truth = cv2.imread(f"{folder}/masks/{frame:06d}.png", cv2.IMREAD_UNCHANGED)
            outlines = grey.copy()
            outlines[cv2.morphologyEx(truth.astype(np.float32), cv2.MORPH_GRADIENT, np.ones((3, 3))) > 0] = (255, 255, 255)
            rows = [(titled(with_depth(grey, measured), "depth, measured"),
                     titled(with_depth(grey, dense), "depth, interpolated")),
                    (titled(with_points(grey, before), "points in the measurements"),
                     titled(with_points(grey, after), "points")),
                    (titled(outlines, "masks given"), titled(with_labels(grey, labels), "labels"))]
            picture = np.vstack([np.hstack(row) for row in rows])
            cv2.imwrite(f"{out}/{kind}.jpg", cv2.resize(picture, None, fx=0.8, fy=0.8, interpolation=cv2.INTER_AREA),
                        [cv2.IMWRITE_JPEG_QUALITY, 85])
            print(f"| `{kind}` | {(measured > 0).mean():.3f} | {(dense > 0).mean():.3f} | {len(before)} | {len(after)} |")


if __name__ == "__main__":
    main()
