#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Makes other recordings of a sequence's scene, with its ground truth: to see what holds beyond the cameras at hand.

usage: variants.py KIND OUT SEQ...        needs numpy and OpenCV for Python

Writes OUT/NAME-KIND for each folder SEQ of the layout of docs/evaluation.md. KIND is
  half, third   images of that share of the width
  mirror        left and right exchanged
  crop          the middle half, left to right
  slow          every other frame
  flicker       brightness that jumps by up to a quarter and 10 grey values from frame to frame
  noise         noise of 8 grey values
  dark          a quarter of the brightness, noise of 1.5 grey values
  near          no depth beyond 20 m
"""
import glob
import os
import shutil
import sys

import cv2
import numpy as np

IMAGES = ("rgb", "depth", "depth_true", "instance", "masks")
POSES = (("poses.txt", 0), ("object_poses.txt", 2))  # and the columns before the pose


def shrunk(image, folder, n):
    """The mean of n x n pixels; of depth and ids the one in their middle, or next to it."""
    image = image[: image.shape[0] // n * n, : image.shape[1] // n * n]
    if folder != "rgb":
        return image[(n - 1) // 2 :: n, (n - 1) // 2 :: n]
    return cv2.resize(image, (image.shape[1] // n, image.shape[0] // n), interpolation=cv2.INTER_AREA)


def changed(image, folder, kind, random):
    if kind in ("half", "third"):
        return shrunk(image, folder, 2 if kind == "half" else 3)
    if kind == "mirror":
        return image[:, ::-1]
    if kind == "crop":
        return image[:, image.shape[1] // 4 :][:, : image.shape[1] // 2]
    if kind == "flicker" and folder == "rgb":
        return np.clip(random.uniform(0.75, 1.25) * image + random.uniform(-10, 10), 0, 255).astype(np.uint8)
    if kind in ("noise", "dark") and folder == "rgb":
        gain, sigma = (1, 8) if kind == "noise" else (0.25, 1.5)
        return np.clip(gain * image + random.normal(0, sigma, image.shape), 0, 255).astype(np.uint8)
    if kind == "near" and folder == "depth":
        return np.where(image > 20 * 256, 0, image).astype(image.dtype)
    return image


def camera(line, kind):
    """fx fy cx cy width height baseline fps"""
    fx, fy, cx, cy, width, height, baseline, fps = (float(v) for v in line.split())
    if kind in ("half", "third"):
        n = 2 if kind == "half" else 3
        fx, fy, cx, cy = fx / n, fy / n, (cx + 0.5) / n - 0.5, (cy + 0.5) / n - 0.5
        width, height = width // n, height // n
    if kind == "mirror":
        cx = width - 1 - cx
    if kind == "crop":
        cx, width = cx - width // 4, width // 2
    if kind == "slow":
        fps /= 2
    return f"{fx} {fy} {cx} {cy} {int(width)} {int(height)} {baseline} {fps}\n"


def mirrored(pose):
    mirror = np.diag([-1, 1, 1, 1])
    T = np.vstack([np.array(pose, float).reshape(3, 4), [0, 0, 0, 1]])
    return [f"{v:.9g}" for v in (mirror @ T @ mirror)[:3].ravel()]


def make(kind, out, sequence):
    folder = os.path.join(out, f"{os.path.basename(os.path.normpath(sequence))}-{kind}")
    os.makedirs(folder, exist_ok=True)
    random = np.random.default_rng(1)
    step = 2 if kind == "slow" else 1
    frames = sorted(os.path.basename(f)[:-4] for f in glob.glob(f"{sequence}/instance/*.png"))
    first = int(frames[0])
    for name in IMAGES:
        for path in sorted(glob.glob(f"{sequence}/{name}/*")):
            stem, suffix = os.path.splitext(os.path.basename(path))
            if (int(stem) - first) % step:
                continue
            target = f"{folder}/{name}/{(int(stem) - first) // step:06d}"
            os.makedirs(f"{folder}/{name}", exist_ok=True)
            if suffix in (".png", ".jpg"):
                image = changed(cv2.imread(path, cv2.IMREAD_UNCHANGED), name, kind, random)
                cv2.imwrite(f"{target}.png", np.ascontiguousarray(image), [cv2.IMWRITE_PNG_COMPRESSION, 1])
            else:
                shutil.copy(path, target + suffix)
    with open(f"{sequence}/intrinsics.txt") as f, open(f"{folder}/intrinsics.txt", "w") as g:
        g.write(camera(f.readline(), kind) + f.read())
    with open(f"{sequence}/objects.csv") as f, open(f"{folder}/objects.csv", "w") as g:
        g.write(f.readline())
        for line in f:
            frame, rest = line.split(",", 1)
            if (int(frame) - first) % step == 0:
                g.write(f"{(int(frame) - first) // step},{rest}")
    for name, before in POSES:
        if not os.path.exists(f"{sequence}/{name}"):
            continue
        with open(f"{sequence}/{name}") as f, open(f"{folder}/{name}", "w") as g:
            for i, line in enumerate(f):
                v = line.split()
                frame = int(v[0]) - first if before else i
                if frame % step:
                    continue
                head = [str(frame // step)] + v[1:before] if before else []
                g.write(" ".join(head + (mirrored(v[before:]) if kind == "mirror" else v[before:])) + "\n")


def main():
    kinds = ("half", "third", "mirror", "crop", "slow", "flicker", "noise", "dark", "near")
    if len(sys.argv) < 4 or sys.argv[1] not in kinds:
        sys.exit(__doc__)
    for sequence in sys.argv[3:]:
        make(sys.argv[1], sys.argv[2], sequence)


if __name__ == "__main__":
    main()
