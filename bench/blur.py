# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Images of a long exposure and of a lens that is not in focus, for variants.py.

A long exposure is the mean of the light of many moments. The scene at each of them is the frame's own, moved by the
true motion of the camera and of the objects between the true poses. A frame's time is the middle of its exposure.
"""
import os

import cv2
import numpy as np

import depth_cameras
from depth_sensors import read
from worlds.sensors import noisy_image

KINDS = ("motionblur", "jolt", "defocus", "focusing")
EXPOSURE = 0.5  # of the time between two frames
MARGIN = 32  # pixels: how far beyond its border an image is continued, for what comes in during the exposure
JOLT, JOLT_EVERY = np.radians(1.5), 8  # turn during the exposure, and in which frames
DEFOCUS, FOCUS_SECONDS = 4.0, 0.5  # pixels (sigma), and the time in which a lens goes from there to sharp
SKY = 1e4  # metres


def rigid(words):
    return np.vstack([np.array(words, float).reshape(3, 4), [0, 0, 0, 1]])


def steps(T):
    """A motion as translation and rotation, to be scaled."""
    return np.concatenate([T[:3, 3], cv2.Rodrigues(T[:3, :3])[0].ravel()])


def mean_light(images):
    """The mean in linear light of 8-bit images."""
    light = (np.arange(256) / 255.0) ** 2.2
    total = sum(light[image].astype(np.float32) for image in images) / len(images)
    return np.rint(255 * total ** (1 / 2.2)).astype(np.uint8)


def drawn(image, depth, flow, far_to_near):
    """The image with each pixel moved by `flow` (x and y), the nearest where two meet. What nothing comes to has the
    farther one of its neighbours in the row."""
    height, width = depth.shape
    v, u = np.indices(depth.shape, np.int32)
    to = [np.rint(at + by).astype(np.int32).ravel()[far_to_near] for at, by in zip((u, v), flow)]
    inside = (to[0] >= 0) & (to[1] >= 0) & (to[0] < width) & (to[1] < height)
    source = np.zeros(depth.shape, np.int32)  # a pixel's number, from 1
    source[to[1][inside], to[0][inside]] = far_to_near[inside] + 1
    before, after = (depth_cameras.in_rows(source, forwards)[0] for forwards in (True, False))
    farther = np.where((before == 0) | (depth.flat[after - 1] > depth.flat[before - 1]) & (after > 0), after, before)
    index = np.where(source > 0, source, np.maximum(farther, 1)) - 1
    x, y = ((at - by.flat[index]).astype(np.float32) for at, by in zip((u, v), flow))
    x = np.where(source > 0, x, index % width).astype(np.float32)
    y = np.where(source > 0, y, index // width).astype(np.float32)
    return cv2.remap(image, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)


class Exposure:
    """The images of a recording with an exposure of that share of the time between two frames."""

    def __init__(self, sequence, frames, intrinsics):
        self.sequence, self.intrinsics = sequence, intrinsics
        with open(f"{sequence}/poses.txt", encoding="utf-8") as file:
            self.camera = dict(zip(frames, (rigid(line.split()) for line in file)))
        self.objects = {}
        if os.path.exists(f"{sequence}/object_poses.txt"):
            with open(f"{sequence}/object_poses.txt", encoding="utf-8") as file:
                for words in map(str.split, file):
                    self.objects.setdefault(int(words[1]), {})[int(words[0])] = rigid(words[2:])

    def motion(self, poses, frame, time):
        """From the place in a frame to that after `time` intervals, in the axes of the world."""
        here = poses[frame]
        before, after = (steps(np.linalg.inv(here) @ poses[f]) if f in poses else None for f in (frame - 1, frame + 1))
        if before is None and after is None:
            return np.eye(4)
        before, after = (-after if before is None else before), (-before if after is None else after)
        x = time * (after - before) / 2 + time * time * (after + before) / 2  # an even acceleration
        T = np.vstack([np.column_stack([cv2.Rodrigues(x[3:])[0], x[:3]]), [0, 0, 0, 1]])
        return here @ T @ np.linalg.inv(here)

    def flow(self, rays, depth, instance, frame, time):
        """Where the pixels are after that time, relative to where they are."""
        fx, fy, cx, cy = self.intrinsics[:4]
        pose, points = self.camera[frame], rays * depth[..., None]
        to_camera = np.linalg.inv(self.motion(self.camera, frame, time) @ pose)
        moved = np.zeros_like(points)
        for thing in np.unique(instance):
            own, poses = instance == thing, self.objects.get(thing, {})
            T = to_camera @ (self.motion(poses, frame, time) if frame in poses else np.eye(4)) @ pose
            moved[own] = points[own] @ T[:3, :3].T + T[:3, 3]
        z = np.maximum(moved[..., 2], 0.05)
        old, new = rays, moved / z[..., None]
        return fx * (new[..., 0] - old[..., 0]), fy * (new[..., 1] - old[..., 1])

    def __call__(self, image, frame):
        fx, fy, cx, cy = self.intrinsics[:4]
        instance, depth = read(self.sequence, "instance", frame), read(self.sequence, "depth_true", frame)
        if depth is None:
            depth = 256 * depth_cameras.surfaces(read(self.sequence, "depth", frame) / 256.0, instance)
        depth = np.where(depth > 0, depth / 256.0, SKY)
        image, depth, instance = (cv2.copyMakeBorder(i, MARGIN, MARGIN, MARGIN, MARGIN, border) for i, border in (
            (image, cv2.BORDER_REFLECT), (depth, cv2.BORDER_REPLICATE), (instance, cv2.BORDER_REPLICATE)))
        v, u = np.indices(depth.shape) - MARGIN
        rays = np.stack([(u - cx) / fx, (v - cy) / fy, np.ones(depth.shape)], -1).astype(np.float32)
        longest = np.hypot(*self.flow(rays, depth, instance, frame, EXPOSURE / 2))
        count = int(np.clip(np.ceil(np.percentile(2 * longest, 98) / 2), 2, 12))
        moments = EXPOSURE * ((np.arange(count) + 0.5) / count - 0.5)
        order = np.argsort(-depth.ravel())
        images = [drawn(image, depth, self.flow(rays, depth, instance, frame, time), order) for time in moments]
        return mean_light(images)[MARGIN:-MARGIN, MARGIN:-MARGIN]


def jolted(image, frame, intrinsics):
    """The image of a camera that turns during the exposure of that frame, by another axis each time."""
    fx, fy, cx, cy = intrinsics[:4]
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    angle, size, images = 2.4 * (frame // JOLT_EVERY), (image.shape[1], image.shape[0]), []
    for share in np.linspace(-0.5, 0.5, 16):
        R = cv2.Rodrigues(share * JOLT * np.array([np.cos(angle), np.sin(angle), 0]))[0]
        H = K @ R @ np.linalg.inv(K)
        images.append(cv2.warpPerspective(image, H, size, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT))
    return mean_light(images)


def sigma_of(kind, seconds):
    """Of the blur, in pixels: back and forth, or from the start of the recording until it is sharp."""
    if kind == "defocus":
        return DEFOCUS / 2 * (1 - np.cos(np.pi * seconds / FOCUS_SECONDS))
    return DEFOCUS * max(0.0, 1 - seconds / FOCUS_SECONDS)


def lens(kind, sequence, frames, intrinsics, random):
    """A function of image and frame."""
    exposure = Exposure(sequence, frames, intrinsics) if kind == "motionblur" else None

    def blurred(image, frame):
        if kind == "motionblur":
            return noisy_image(exposure(image, frame), random)
        if kind == "jolt":
            return noisy_image(jolted(image, frame, intrinsics), random) if frame % JOLT_EVERY == 4 else image
        sigma = sigma_of(kind, (frame - frames[0]) / intrinsics[7])
        return noisy_image(cv2.GaussianBlur(image, (0, 0), sigma), random) if sigma > 0.3 else image

    return blurred
