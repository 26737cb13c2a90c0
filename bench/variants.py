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
  reverse       the frames from the last to the first
  late          without the first 13 frames
  skip1, skip2, skip3
                without the first one, two, three frames: other masks serve where not every frame has one
  flicker       brightness that jumps by up to a quarter and 10 grey values from frame to frame
  noise         noise of 8 grey values
  dark          a quarter of the brightness, noise of 1.5 grey values
  near          no depth beyond 20 m
  bias          disparities wrong by up to a pixel at the borders, as from a stereo pair calibrated badly
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


def biased(depth, focal_baseline):
    """Depth, 1/256 m, of disparities that are too small at the left border and too large right of the middle."""
    height, width = depth.shape
    u, v = np.meshgrid(np.linspace(-1, 1, width), np.linspace(-1, 1, height))
    disparity = focal_baseline * 256 / np.maximum(depth, 1) + 0.6 * np.sin(2.4 * u + 0.4) + 0.2 * v - 0.1
    changed = np.clip(focal_baseline * 256 / np.maximum(disparity, 0.1), 1, 65535)
    return np.where(depth > 0, np.round(changed), 0).astype(depth.dtype)


def changed(image, folder, kind, random, focal_baseline):
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
    if kind == "bias" and folder == "depth":
        return biased(image, focal_baseline)
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


def order(frames, kind):
    """The recorded frames in the order of the new ones."""
    if kind == "slow":
        return frames[::2]
    if kind == "reverse":
        return frames[::-1]
    return frames[{"late": 13, "skip1": 1, "skip2": 2, "skip3": 3}.get(kind, 0) :]


def make(kind, out, sequence):
    folder = os.path.join(out, f"{os.path.basename(os.path.normpath(sequence))}-{kind}")
    os.makedirs(folder, exist_ok=True)
    random = np.random.default_rng(1)
    frames = sorted(int(os.path.basename(f)[:-4]) for f in glob.glob(f"{sequence}/instance/*.png"))
    with open(f"{sequence}/intrinsics.txt") as f:
        intrinsics = [float(v) for v in f.readline().split()]
    number = {frame: i for i, frame in enumerate(order(frames, kind))}
    for name in IMAGES:
        for path in sorted(glob.glob(f"{sequence}/{name}/*")):
            stem, suffix = os.path.splitext(os.path.basename(path))
            if int(stem) not in number:
                continue
            target = f"{folder}/{name}/{number[int(stem)]:06d}"
            os.makedirs(f"{folder}/{name}", exist_ok=True)
            if suffix in (".png", ".jpg"):
                image = changed(cv2.imread(path, cv2.IMREAD_UNCHANGED), name, kind, random, intrinsics[0] * intrinsics[6])
                cv2.imwrite(f"{target}.png", np.ascontiguousarray(image), [cv2.IMWRITE_PNG_COMPRESSION, 1])
            else:
                shutil.copy(path, target + suffix)
    with open(f"{sequence}/intrinsics.txt") as f, open(f"{folder}/intrinsics.txt", "w") as g:
        g.write(camera(f.readline(), kind) + f.read())
    with open(f"{sequence}/objects.csv") as f, open(f"{folder}/objects.csv", "w") as g:
        g.write(f.readline())
        rows = [line.split(",", 1) for line in f]
        rows = [(number[int(frame)], rest) for frame, rest in rows if int(frame) in number]
        g.writelines(f"{i},{rest}" for i, rest in sorted(rows, key=lambda row: row[0]))
    for name, before in POSES:
        if not os.path.exists(f"{sequence}/{name}"):
            continue
        with open(f"{sequence}/{name}") as f:
            lines = [line.split() for line in f]
        poses = []
        for i, v in enumerate(lines):
            frame = int(v[0]) if before else frames[i]
            if frame in number:
                pose = mirrored(v[before:]) if kind == "mirror" else v[before:]
                poses.append((number[frame], ([str(number[frame])] + v[1:before] if before else []) + pose))
        with open(f"{folder}/{name}", "w") as g:
            g.writelines(" ".join(words) + "\n" for _, words in sorted(poses, key=lambda pose: pose[0]))


def main():
    kinds = "half third mirror crop slow reverse late skip1 skip2 skip3 flicker noise dark near bias"
    if len(sys.argv) < 4 or sys.argv[1] not in kinds.split():
        sys.exit(__doc__)
    for sequence in sys.argv[3:]:
        make(sys.argv[1], sys.argv[2], sequence)


if __name__ == "__main__":
    main()
