# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Fog, rain and snow, for variants.py. Drops and flakes are others in each frame."""
import cv2
import numpy as np

import depth_cameras
from depth_sensors import read
from worlds.sensors import noisy_image

KINDS = ("fog", "rain", "snow")
VISIBILITY = 60.0  # metres: where 5 % of the contrast is left
FOG_GREY = 190
SHUTTER = 0.01  # seconds
NEAR, FAR = 0.4, 12.0  # metres: nearer ones do not occur, farther ones are not seen one by one
# per cubic metre, diameter (m), fall (m/s), brightness, share of the light that comes from it where it is
PARTICLES = {"rain": (30, (0.002, 0.004), 8.0, 225, 0.15), "snow": (12, (0.004, 0.012), 1.2, 240, 0.8)}
LEAST_WIDTH = 3  # pixels: of a flake that the depth shows


def surfaces(sequence, frame):
    """Depth, metres, 0 = sky."""
    depth = read(sequence, "depth_true", frame)
    if depth is None:
        return depth_cameras.surfaces(read(sequence, "depth", frame) / 256.0, read(sequence, "instance", frame))
    return depth / 256.0


def foggy(image, depth, random):
    """Contrast falls with the distance; the noise of the sensor does not."""
    left = np.where(depth > 0, np.exp(-3 * depth / VISIBILITY), 0)
    left = cv2.GaussianBlur(left.astype(np.float32), (0, 0), 1).reshape(left.shape + (1,) * (image.ndim - 2))
    return noisy_image(left * image + (1 - left) * FOG_GREY, random)


class Falling:
    """Drops or flakes before the camera."""

    def __init__(self, kind, sequence, frames, intrinsics):
        self.kind, self.sequence, self.intrinsics = kind, sequence, intrinsics
        poses = np.loadtxt(f"{sequence}/poses.txt").reshape(-1, 3, 4)
        steps = np.gradient(poses[:, :, 3], axis=0) * intrinsics[7]
        self.velocity = {f: pose[:, :3].T @ step for f, pose, step in zip(frames, poses, steps)}  # the camera's own

    def seen(self, frame):
        """Both ends in pixels, width in pixels and distance of each, the farthest first."""
        fx, fy, cx, cy, width, height = self.intrinsics[:6]
        per_volume, diameters, fall, _, _ = PARTICLES[self.kind]
        random = np.random.default_rng(frame)
        count = int(per_volume * width * height / (fx * fy) * FAR**3 / 3)
        z = -np.sort(-FAR * random.random(count) ** (1 / 3))
        z = z[z > NEAR]
        start = np.stack([(random.uniform(0, width, len(z)) - cx) / fx * z,
                          (random.uniform(0, height, len(z)) - cy) / fy * z, z], 1)
        wind = np.array([0.2 * fall, fall, 0]) + random.normal(0, 0.1 * fall, start.shape)
        end = start + SHUTTER * (wind - self.velocity[frame])
        end[:, 2] = np.maximum(end[:, 2], 0.1)
        ends = [np.stack([fx * p[:, 0] / p[:, 2] + cx, fy * p[:, 1] / p[:, 2] + cy], 1) for p in (start, end)]
        return ends[0], ends[1], fx * random.uniform(*diameters, len(z)) / z, z

    def before_scene(self, frame):
        """The same, without what the scene hides."""
        scene = surfaces(self.sequence, frame)
        for start, end, wide, z in zip(*self.seen(frame)):
            column, row = np.clip(np.rint((start + end) / 2), 0, np.array(scene.shape[::-1]) - 1).astype(int)
            if not 0 < scene[row, column] < z:
                yield start, end, wide, z

    def image(self, image, frame):
        brightness, share = PARTICLES[self.kind][3:]
        fine, wide_ones = np.zeros(image.shape[:2], np.uint8), np.zeros(image.shape[:2], np.uint8)
        for start, end, wide, _ in self.before_scene(frame):
            cover = share * min(1, wide)
            if self.kind == "snow":  # a flake is before a pixel for a part of the exposure only
                cover *= min(1, 2 * wide / max(1, np.hypot(*(end - start))))
            line(fine if wide < 2 else wide_ones, start, end, wide, int(255 * cover), cv2.LINE_AA)
        cover = np.maximum(fine, cv2.GaussianBlur(wide_ones, (0, 0), 1.2)) / 255.0  # near ones are not in focus
        cover = cover.reshape(cover.shape + (1,) * (image.ndim - 2))
        return np.rint(image + cover * np.maximum(brightness - image.astype(float), 0)).astype(np.uint8)

    def depth(self, depth, frame):
        """Wide flakes have depth, drops have none."""
        out = depth.astype(np.float32)
        for start, end, wide, z in self.before_scene(frame):
            if self.kind == "snow" and wide >= LEAST_WIDTH:
                line(out, start, end, wide, 256 * z, cv2.LINE_8)
        return np.rint(out).astype(depth.dtype)


def line(image, start, end, wide, value, kind):
    ends = [tuple(int(v) for v in np.clip(np.rint(16 * p), -(1 << 20), 1 << 20)) for p in (start, end)]
    cv2.line(image, *ends, value, max(1, round(float(wide))), kind, 4)


def sky(kind, sequence, frames, intrinsics, random):
    """A function of an image, its folder ("rgb" or "depth") and its frame."""
    falling = Falling(kind, sequence, frames, intrinsics) if kind in PARTICLES else None

    def seen(image, folder, frame):
        if kind == "fog":
            return foggy(image, surfaces(sequence, frame), random) if folder == "rgb" else image
        return (falling.image if folder == "rgb" else falling.depth)(image, frame)

    return seen
