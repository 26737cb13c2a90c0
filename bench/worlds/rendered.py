# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Reads what Blender wrote (in_blender.py)."""
import glob
import json
import os
from dataclasses import dataclass

os.environ["OPENCV_IO_ENABLE_OPENEXR"] = "1"  # read when OpenCV is imported

import cv2  # noqa: E402
import numpy as np  # noqa: E402

from recording import Recording  # noqa: E402

SKY = 1e4  # metres; what is farther is no surface


@dataclass(frozen=True)
class Poses:
    """Of all frames of a recording, whether they are rendered or not, to the world: x right, y forward, z up, metres.

    Things and parts have the world's axes when they are not turned; the camera looks along z, its x points to the right
    and its y down."""

    camera: np.ndarray  # (frames, 4, 4)
    parts: np.ndarray  # (frames, parts, 4, 4)
    things: np.ndarray  # (frames, things, 4, 4); of the thing with id 1, 2, ...
    thing_of_part: np.ndarray  # (parts,)


@dataclass(frozen=True)
class Picture:
    frame: int
    image: np.ndarray  # (height, width, 3), 8 bit
    depth: np.ndarray  # (height, width), metres along the optical axis, 0 for the sky
    part: np.ndarray  # (height, width), number of the part that is seen, from 1 on, 0 = background


class Rendered:
    """A folder of rendered frames."""

    def __init__(self, folder):
        self.folder = folder
        with open(f"{folder}/recording.json", encoding="utf-8") as file:
            content = json.load(file)
        self.recording = Recording(**content["recording"])
        self.kinds = {int(thing): kind for thing, kind in content["kinds"].items()}
        self.frames = sorted(int(path[-8:-4]) for path in glob.glob(f"{glob.escape(folder)}/image*.png"))
        with np.load(f"{folder}/poses.npz") as poses:
            # Blender's camera looks along -z, and its y points up.
            self.poses = Poses(poses["camera"] @ np.diag([1.0, -1, -1, 1]), poses["parts"], poses["things"],
                               poses["thing_of_part"])

    def pictures(self):
        """One Picture after the other."""
        for frame in self.frames:
            depth = self._channel("depth", frame).astype(np.float64)
            yield Picture(frame, cv2.imread(f"{self.folder}/image{frame:04d}.png"), np.where(depth > SKY, 0, depth),
                          np.rint(self._channel("part", frame)).astype(int))

    def _channel(self, name, frame):
        image = cv2.imread(f"{self.folder}/{name}{frame:04d}.exr", cv2.IMREAD_UNCHANGED)
        return image[..., 0] if image.ndim > 2 else image
