#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Puts a known fault into a copy of a sequence: to see whether `dot_run --check` finds it, and what it does to a run.

usage: faults.py FAULT SIZE OUT SEQ...        needs numpy and OpenCV for Python

Writes OUT/NAME-FAULT-SIZE for each folder SEQ of the layout of docs/evaluation.md, with its ground truth. FAULT is
"""
import glob
import os
import shutil
import sys

import cv2
import numpy as np


class Sequence:
    """What of a sequence a fault may change. Images are changed when they are written, in the order of the frames."""

    def __init__(self, folder):
        self.folder = folder
        self.frames = sorted(int(os.path.basename(f)[:6]) for f in glob.glob(f"{folder}/rgb/*"))
        with open(f"{folder}/intrinsics.txt") as f:
            self.intrinsics = [float(v) for v in f.readline().split()]
            self.further = f.read()
        fps = self.intrinsics[7]
        self.times = [i / fps for i in self.frames]
        if os.path.exists(f"{folder}/times.txt"):
            with open(f"{folder}/times.txt") as f:
                self.times = [float(line) for line in f]
        self.write_times = os.path.exists(f"{folder}/times.txt")
        n = len(self.frames)
        self.taken = {name: list(range(n)) for name in ("rgb", "right", "depth", "masks", "instance", "depth_true")}
        self.change = {}  # folder -> function(image, index)
        self.size = None

    def path(self, name, index):
        found = glob.glob(f"{self.folder}/{name}/{self.frames[index]:06d}.*g")
        return found[0] if found else None

    def read(self, name, index):
        path = self.path(name, index)
        return None if path is None else cv2.imread(path, cv2.IMREAD_UNCHANGED)

    def write(self, target):
        shutil.rmtree(target, ignore_errors=True)
        os.makedirs(target)
        with open(f"{target}/intrinsics.txt", "w") as f:
            f.write(" ".join(f"{v:.9g}" for v in self.intrinsics) + "\n" + self.further)
        for name, taken in self.taken.items():
            if not os.path.isdir(f"{self.folder}/{name}"):
                continue
            os.makedirs(f"{target}/{name}")
            for index, source in enumerate(taken):
                path = None if source is None else self.path(name, source)
                if path is None:
                    continue
                number = self.frames[index]
                if name not in self.change:
                    os.symlink(os.path.abspath(path), f"{target}/{name}/{number:06d}{os.path.splitext(path)[1]}")
                    continue
                image = self.change[name](cv2.imread(path, cv2.IMREAD_UNCHANGED), index)
                cv2.imwrite(f"{target}/{name}/{number:06d}.png", image, [cv2.IMWRITE_PNG_COMPRESSION, 1])
        for name in ("objects.csv", "poses.txt", "object_poses.txt"):
            if os.path.exists(f"{self.folder}/{name}"):
                shutil.copy(f"{self.folder}/{name}", target)
        if self.write_times:
            with open(f"{target}/times.txt", "w") as f:
                f.writelines(f"{t:.9f}\n" for t in self.times)


def late(sequence, folder, by):
    n = len(sequence.frames)
    sequence.taken[folder] = [min(max(i - by, 0), n - 1) for i in range(n)]


def keep(sequence, kept):
    """Only these frames, with their times and new numbers."""
    for name in sequence.taken:
        sequence.taken[name] = list(kept)
    sequence.times = [sequence.times[i] for i in kept]


def shifted(image, dx, dy):
    height, width = image.shape[:2]
    return cv2.warpAffine(image, np.float64([[1, 0, dx], [0, 1, dy]]), (width, height), flags=cv2.INTER_NEAREST)


def depth_unit(s, size):
    """size: mm, 5000 (1/5000 m) or cm, read as 1/256 m"""
    per_metre = {"mm": 1000, "5000": 5000, "cm": 100}[size]
    s.change["depth"] = lambda z, i: np.minimum(np.round(z * (per_metre / 256.0)), 65535).astype(np.uint16)


def depth_late(s, size):
    """depth late by so many frames; early if negative"""
    late(s, "depth", int(size))


def depth_offset(s, size):
    """depth moved to the right by so many pixels, down by half of that"""
    s.change["depth"] = lambda z, i: shifted(z, int(size), int(size) // 2)


def focal(s, size):
    """focal length in intrinsics.txt too long by so many per cent"""
    for i in (0, 1):
        s.intrinsics[i] *= 1 + float(size) / 100


def resolution(s, size):
    """fx, fy, cx and cy in intrinsics.txt are those of an image of so many per cent of the size"""
    for i in range(4):
        s.intrinsics[i] *= float(size) / 100


def no_centre(s, size):
    """size: cx or cy, which is 0 in intrinsics.txt"""
    s.intrinsics[{"cx": 2, "cy": 3}[size]] = 0


def depth_ray(s, size):
    """depth along the ray instead of along the optical axis (size without meaning)"""
    fx, fy, cx, cy, width, height = s.intrinsics[:6]
    v, u = np.indices((int(height), int(width)))
    factor = np.sqrt(1 + ((u - cx) / fx) ** 2 + ((v - cy) / fy) ** 2)
    s.change["depth"] = lambda z, i: np.where(z > 0, np.clip(np.round(z * factor), 1, 65534), 0).astype(np.uint16)


def radial(s, size):
    """images, depth and masks through a lens with this radial distortion (k1), which intrinsics.txt lacks"""
    fx, fy, cx, cy, width, height = s.intrinsics[:6]
    v, u = np.indices((int(height), int(width)))
    seen_x, seen_y = (u - cx) / fx, (v - cy) / fy
    x, y = seen_x, seen_y
    for _ in range(20):
        stretch = 1 + float(size) * (x * x + y * y)
        x, y = seen_x / stretch, seen_y / stretch
    at = (x * fx + cx).astype(np.float32), (y * fy + cy).astype(np.float32)
    s.change["rgb"] = lambda image, i: cv2.remap(image, *at, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT)
    for name in ("depth", "masks", "instance", "depth_true"):
        s.change[name] = lambda image, i: cv2.remap(image, *at, cv2.INTER_NEAREST, borderMode=cv2.BORDER_CONSTANT)


def disparity(s, size):
    """disparity instead of depth, so many values a pixel"""
    fb = s.intrinsics[0] * s.intrinsics[6] * 256
    s.change["depth"] = lambda z, i: np.where(
        z > 0, np.clip(np.round(float(size) * fb / np.maximum(z, 1)), 1, 65535), 0).astype(np.uint16)


def baseline(s, size):
    """baseline in intrinsics.txt too long by so many per cent"""
    s.intrinsics[6] *= 1 + float(size) / 100


def rows(s, size):
    """right image lower by so many rows"""
    def move(image, i):
        height, width = image.shape[:2]
        return cv2.warpAffine(image, np.float64([[1, 0, 0], [0, 1, float(size)]]), (width, height),
                              borderMode=cv2.BORDER_REPLICATE)
    s.change["right"] = move


def bias(s, size):
    """disparity of the depth images too large by so many pixels"""
    fb = s.intrinsics[0] * s.intrinsics[6] * 256
    def change(z, i):
        d = fb / np.maximum(z, 1) + float(size)
        return np.where((z > 0) & (d > 0.5), np.clip(np.round(fb / np.maximum(d, 0.5)), 1, 65535), 0).astype(np.uint16)
    s.change["depth"] = change


def masks_late(s, size):
    """masks late by so many frames; early if negative"""
    late(s, "masks", int(size))


def masks_size(s, size):
    """masks scaled by so many per cent"""
    f = float(size) / 100
    s.change["masks"] = lambda m, i: cv2.resize(m, None, fx=f, fy=f, interpolation=cv2.INTER_NEAREST)


def masks_values(s, size):
    """size: classes (1 everywhere), binary (255 everywhere) or probabilities (0 to 255)"""
    def change(m, i):
        m = (m > 0).astype(np.uint8)
        if size == "probabilities":
            return np.clip(cv2.GaussianBlur(m.astype(np.float32), (0, 0), 4) * 255, 0, 255).astype(np.uint8)
        return m * (1 if size == "classes" else 255)
    s.change["masks"] = change


def background(s, size):
    """the background is an instance, too, in so many per cent of the frames"""
    every = 100 / float(size)
    s.change["masks"] = lambda m, i: np.where((m == 0) & (i % every < 1), 255, m).astype(m.dtype)


def masks_missing(s, size):
    """so many per cent of all masks are missing, chosen at random"""
    shown = [(i, value) for i in range(len(s.frames)) for value in np.unique(s.read("masks", i)) if value]
    order = np.random.default_rng(1).permutation(len(shown))
    gone = {shown[k] for k in order[: round(len(shown) * float(size) / 100)]}

    def change(m, i):
        return np.where(np.isin(m, [value for index, value in gone if index == i]), 0, m).astype(m.dtype)
    s.change["masks"] = change


def time_unit(s, size):
    """times in ms, us or ns"""
    s.write_times = True
    s.times = [t * {"ms": 1e3, "us": 1e6, "ns": 1e9}[size] for t in s.times]


def dropped(s, size):
    """so many frames lost in each of three places; times tell"""
    n, k = len(s.frames), int(size)
    places = [n // 4, n // 2, 3 * n // 4]
    keep(s, [i for i in range(n) if not any(p <= i < p + k for p in places)])
    s.write_times = True


def dropped_silently(s, size):
    """the same, with times that do not tell"""
    times = list(s.times)
    dropped(s, size)
    s.times = times[: len(s.times)]


def twice(s, size):
    """so many per cent of the frames, image and depth, are the one before once more"""
    n = len(s.frames)
    every = round(100 / float(size))
    taken = [i - 1 if i % every == every // 2 and i > 0 else i for i in range(n)]
    for name in s.taken:
        s.taken[name] = taken


def depth_twice(s, size):
    """so many per cent of the depth images alone are the one before once more"""
    n = len(s.frames)
    every = round(100 / float(size))
    s.taken["depth"] = [i - 1 if i % every == every // 2 and i > 0 else i for i in range(n)]


def exposure(s, size):
    """brightness up by so many per cent every seven frames, for three frames"""
    def change(image, i):
        gain = 1 + float(size) / 100 if i % 7 >= 4 else 1
        return np.clip(np.round(image * 0.7 * gain), 0, 255).astype(np.uint8)
    s.change["rgb"] = s.change["right"] = change


def blur(s, size):
    """all images blurred along the rows over so many pixels"""
    s.change["rgb"] = s.change["right"] = lambda image, i: cv2.blur(image, (int(size), 1))


def bands(s, size):
    """brightness bands of so many per cent that roll over the image"""
    def change(image, i):
        rows = np.arange(image.shape[0]) / image.shape[0]
        gain = 1 + float(size) / 100 * np.sin(2 * np.pi * (3 * rows + 0.37 * i))
        gain = gain.reshape(-1, 1, 1)[:, :, : 1 if image.ndim == 3 else None]
        gain = gain if image.ndim == 3 else gain[:, :, 0]
        return np.clip(np.round(image * 0.8 * gain), 0, 255).astype(np.uint8)
    s.change["rgb"] = s.change["right"] = change


def depth_sparse(s, size):
    """depth of so many per cent of the pixels, at random"""
    random = np.random.default_rng(1)
    def change(z, i):
        valid = np.mean(z > 0)
        return np.where(random.random(z.shape) < float(size) / 100 / max(valid, 0.01), z, 0).astype(np.uint16)
    s.change["depth"] = change


def depth_saturated(s, size):
    """depth cut off at a largest value: the depth under which so many per cent of the measured pixels are"""
    depths = np.concatenate([z[z > 0] for z in (s.read("depth", i)[::4, ::4] for i in range(len(s.frames)))])
    farthest = int(np.percentile(depths, float(size)))
    s.change["depth"] = lambda z, i: np.minimum(z, farthest)


def texture(s, size):
    """contrast of the image only so many per cent, noise of a grey value"""
    random = np.random.default_rng(1)
    def change(image, i):
        mean = image.mean()
        out = mean + (image - mean) * (float(size) / 100) + random.normal(0, 1, image.shape)
        return np.clip(np.round(out), 0, 255).astype(np.uint8)
    s.change["rgb"] = s.change["right"] = change


def hood(s, size):
    """a hood over so many per cent of the image's height, at its bottom, without depth"""
    height, width = s.read("rgb", 0).shape[:2]
    x = np.linspace(-1, 1, width)
    top = height * (1 - float(size) / 100 * (1 - 0.25 * x * x))
    inside = np.arange(height)[:, None] >= top[None, :]
    random = np.random.default_rng(1)
    look = cv2.GaussianBlur(random.normal(0, 1, (height, width)), (0, 0), 5)
    look = 50 + 40 * look / np.abs(look).max() + 20 * np.linspace(0, 1, height)[:, None]
    def paint(image, i):
        noise = look + np.random.default_rng(i).normal(0, 1, look.shape)
        painted = noise if image.ndim == 2 else np.repeat(noise[:, :, None], image.shape[2], 2)
        out = image.copy()
        out[inside] = np.clip(painted[inside], 0, 255)
        return out
    s.change["rgb"] = paint
    s.change["depth"] = lambda z, i: np.where(inside, 0, z).astype(z.dtype)
    s.change["masks"] = lambda m, i: np.where(inside, 0, m).astype(m.dtype)


FAULTS = {
    "depth-unit": depth_unit, "depth-late": depth_late, "depth-offset": depth_offset, "depth-ray": depth_ray,
    "radial": radial, "focal": focal,
    "baseline": baseline, "resolution": resolution, "no-centre": no_centre, "disparity": disparity,
    "background": background, "rows": rows, "bias": bias, "masks-late": masks_late, "masks-size": masks_size,
    "masks-values": masks_values, "masks-missing": masks_missing, "time-unit": time_unit, "dropped": dropped,
    "dropped-silently": dropped_silently, "twice": twice, "depth-twice": depth_twice, "exposure": exposure, "blur": blur, "bands": bands,
    "depth-sparse": depth_sparse, "depth-saturated": depth_saturated, "texture": texture, "hood": hood,
}


def make(fault, size, out, folder):
    """@return the folder of the faulty copy."""
    sequence = Sequence(folder)
    FAULTS[fault](sequence, size)
    target = os.path.join(out, f"{os.path.basename(os.path.normpath(folder))}-{fault}-{size}")
    sequence.write(target)
    return target


def main():
    if len(sys.argv) < 5 or sys.argv[1] not in FAULTS:
        kinds = "\n".join(f"  {name:18}{function.__doc__}" for name, function in FAULTS.items())
        sys.exit(__doc__ + kinds)
    for folder in sys.argv[4:]:
        print(make(sys.argv[1], sys.argv[2], sys.argv[3], folder))


if __name__ == "__main__":
    main()
