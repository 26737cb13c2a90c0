# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Labels from Python: a wall with two plates in front of it, of which one slides to the right.

usage: demo.py LIBRARY      (libdot_capi.so, with its path unless it is installed)
"""

import sys

import numpy as np

from dot_ctypes import DEPTH_RGBD, MOVING, STATIC, Camera, Tracker

WIDTH, HEIGHT, FOCAL, SECONDS = 320, 240, 280.0, 0.1
PIXELS_PER_FRAME = 4  # at 2 m: 0.29 m/s


def texture(seed, height, width):
    """Smooth noise: random values, averaged over 5 x 5 pixels."""
    noise = np.random.default_rng(seed).uniform(0, 1, (height + 4, width + 4))
    smooth = sum(noise[y:y + height, x:x + width] for y in range(5) for x in range(5)) / 25
    return np.clip(128 + 500 * (smooth - 0.5), 0, 255).astype(np.uint8)


def draw(frame):
    """What camera, depth sensor and segmentation network would deliver."""
    grey = texture(1, HEIGHT, WIDTH)
    depth = np.full((HEIGHT, WIDTH), 4000, np.uint16)  # millimetres
    ids = np.zeros((HEIGHT, WIDTH), np.uint8)
    for plate, left in ((1, 40), (2, 170 + PIXELS_PER_FRAME * frame)):
        place = np.s_[80:170, left:left + 80]
        grey[place] = texture(10 + plate, 90, 80)
        depth[place] = 2000
        ids[place] = plate
    return grey, depth, ids


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    camera = Camera(FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2, WIDTH, HEIGHT)
    tracker = Tracker(sys.argv[1], camera, DEPTH_RGBD)
    for frame in range(10):
        grey, depth, ids = draw(frame)
        network = ids if frame % 3 == 0 else None  # in between, the masks are carried on
        labels = tracker.track(SECONDS * frame, grey, depth, 1000, network)
        moving, static = (labels == MOVING).sum(), (labels == STATIC).sum()
        print(f"frame {frame}: {moving} pixels moving, {static} static, {(tracker.exclusion_mask() > 0).mean():.0%} excluded")
    for item in tracker.objects():
        print(f"object {item.id}: P(moving) {item.p_moving:.2f}, {item.speed:.2f} m/s")
    return 0 if sorted(item.state for item in tracker.objects()) == [STATIC, MOVING] else 1


if __name__ == "__main__":
    sys.exit(main())
