# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Metric depth of a network that sees one image, for depth_sensors.py. Images are (height, width), depth is in metres.

Sizes are about those that are published of such networks on streets and in rooms: a mean error of 4 to 5 % where they
were trained, more elsewhere and far away; a largest depth of 80 m; a scale that changes from frame to frame.
"""
import cv2
import numpy as np

import depth_cameras
from worlds.sensors import patches

LARGEST = 80.0  # metres: what the network was trained with
STICKS = 0.045  # error of the logarithm of depth that stays on the surface, near the camera
FLICKERS = 0.015  # the same, another in each frame
JITTER = 0.015  # of the scale of a whole frame
FAR = 20.0  # metres: up to here the errors have these sizes, and at twice that distance and beyond twice them
CORRELATED = 0.1  # of the width of the image: distance at which errors differ
BLEEDS = 1 / 600  # of the width: sigma of the transition from one surface to another
THIN = 1 / 150  # of the width: narrower things have the depth of what is behind
CELLS = np.random.default_rng(5).normal(0, 1, (32, 32, 32)).astype(np.float32)


def lattice_noise(points):
    """Smooth noise of unit variance at points of space, (..., 3), whose values at whole numbers are independent."""
    whole = np.floor(points)
    part = points - whole
    part = (part * part * (3 - 2 * part)).astype(np.float32)
    whole = whole.astype(int)
    total, squares = 0, 0
    for corner in np.ndindex(2, 2, 2):
        weight = np.prod(np.where(corner, part, 1 - part), -1)
        total = total + weight * CELLS[tuple((whole[..., k] + corner[k]) % 32 for k in range(3))]
        squares = squares + weight**2
    return total / np.sqrt(squares)


def sticking(points, size):
    """Noise of unit variance that stays at points of space and changes over `size`, metres, at each of them. Where the
    camera comes nearer, finer noise takes the place of coarser."""
    level = np.log2(size)
    coarse = np.floor(level)
    part = 0.5 * np.pi * (level - coarse)
    return (np.cos(part) * lattice_noise(points / np.exp2(coarse)[..., None]) +
            np.sin(part) * lattice_noise(points / np.exp2(coarse + 1)[..., None] + 11.5))


def complete(depth, instance):
    """Depth without holes, of that of a sensor: what nothing measures is as far as what is below it, or above it."""
    filled = depth_cameras.surfaces(depth, instance)
    for order in (slice(None, None, -1), slice(None)):
        rows = filled[order]
        last = np.maximum.accumulate(np.where(rows > 0, np.arange(len(rows))[:, None], -1), axis=0)
        filled = np.where(last >= 0, np.take_along_axis(rows, np.maximum(last, 0), 0), 0)[order]
    return np.where(filled > 0, filled, LARGEST)


class Network:
    """Depth of a recording's frames. What stands keeps its error in the scene, what moves on itself."""

    def __init__(self, intrinsics, movers):
        self.intrinsics, self.movers = intrinsics, movers  # movers: (frame, id) of all that move

    def __call__(self, surface, instance, frame, pose):
        """The depth where that of the surfaces is `surface`. @param pose camera to world, 3x4. 0 = the sky."""
        random, shape, width = np.random.default_rng(frame), surface.shape, surface.shape[1]
        surface = np.where(surface > 0, surface, 2 * LARGEST).astype(np.float32)
        disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * round(THIN * width / 2) + 1,) * 2)
        surface = cv2.morphologyEx(surface, cv2.MORPH_CLOSE, disc)
        spacing = CORRELATED * width
        far = np.clip(surface / FAR, 1, 2)
        error = STICKS * sticking(self.places(surface, instance, frame, pose), spacing / self.intrinsics[0] * surface)
        error = far * (error + patches(random, shape, round(spacing), FLICKERS)) + random.normal(0, JITTER)
        largest = LARGEST * (1 - 0.03 * np.abs(patches(random, shape, round(spacing))))
        metres = np.minimum(surface * np.exp(error), largest)
        return np.exp(cv2.GaussianBlur(np.log(metres), (0, 0), BLEEDS * width))

    def places(self, surface, instance, frame, pose):
        """The pixels' places in the world, and of what moves in its own axes."""
        fx, fy, cx, cy = self.intrinsics[:4]
        v, u = np.indices(surface.shape)
        places = np.stack([(u - cx) / fx, (v - cy) / fy, np.ones(surface.shape)], -1) * surface[..., None]
        places = places @ pose[:, :3].T + pose[:, 3]
        for thing in np.unique(instance[instance > 0]):
            if (frame, int(thing)) in self.movers:
                own = instance == thing
                places[own] += 1000.0 * thing - np.median(places[own], axis=0)
        return places
