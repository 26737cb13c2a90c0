# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What a recording is, apart from the world that it shows. For Blender's Python and the system's alike."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Recording:
    """How a world is recorded. Lengths in metres, those in the image in pixels, angles in degrees, times in seconds."""

    frames: int
    sensor: str  # what measures depth: "stereo" or "rgbd"
    focal_length: float
    baseline: float  # between the two cameras, or the camera and the projector of an RGB-D sensor
    seed: int  # of the noise of image, depth and masks
    width: int = 640
    height: int = 360
    rate: float = 10  # frames a second
    max_depth: float = 90  # what is farther has no depth
    slowest: float = 0.05  # m/s: what is faster moves
    slowest_turn: float = 2  # degrees/s: what turns faster moves, too

    @property
    def centre(self):
        """The principal point (x, y), which is in the middle of the image: pixel 0 has its centre at 0."""
        return (self.width - 1) / 2, (self.height - 1) / 2
