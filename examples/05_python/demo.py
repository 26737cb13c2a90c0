# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Labels from Python: a wall with two plates in front of it, of which one slides to the right."""

import sys

import numpy as np

from dot_slam import Camera, State, Tracker

WIDTH, HEIGHT, FOCAL, SECONDS = 320, 240, 280.0, 0.1
CAMERA = Camera(FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2, WIDTH, HEIGHT)
MILLIMETRES = 1000  # units of the depth in a metre
PIXELS_PER_FRAME = 4  # at 2 m: 0.29 m/s


def texture(seed, height, width):
    """Smooth noise: random values, averaged over 5 x 5 pixels."""
    noise = np.random.default_rng(seed).uniform(0, 1, (height + 4, width + 4))
    smooth = sum(noise[y:y + height, x:x + width] for y in range(5) for x in range(5)) / 25
    return np.clip(128 + 500 * (smooth - 0.5), 0, 255).astype(np.uint8)


def draw(frame):
    """What camera, depth sensor and segmentation network would deliver."""
    grey = texture(1, HEIGHT, WIDTH)
    depth = np.full((HEIGHT, WIDTH), 4 * MILLIMETRES, np.uint16)
    ids = np.zeros((HEIGHT, WIDTH), np.uint8)
    for plate, left in ((1, 40), (2, 170 + PIXELS_PER_FRAME * frame)):
        place = np.s_[80:170, left:left + 80]
        grey[place] = texture(10 + plate, 90, 80)
        depth[place] = 2 * MILLIMETRES
        ids[place] = plate
    return grey, depth, ids


def main():
    with Tracker(CAMERA, depth_source="rgbd", depth_units_per_metre=MILLIMETRES) as tracker:
        for frame in range(10):
            grey, depth, ids = draw(frame)
            network = ids if frame % 3 == 0 else None  # in between, the masks are carried on
            result = tracker.track(grey, depth, network, timestamp=SECONDS * frame)
            excluded = tracker.exclusion_mask() > 0
            print(f"frame {frame}: {(result.labels == State.MOVING).sum()} pixels moving, "
                  f"{(result.labels == State.STATIC).sum()} static, {excluded.mean():.0%} excluded")
    for item in result.objects:
        print(f"object {item.id}: P(moving) {item.p_moving:.2f}, {item.speed:.2f} m/s")
    return 0 if sorted(item.state for item in result.objects) == [State.STATIC, State.MOVING] else 1


if __name__ == "__main__":
    sys.exit(main())
