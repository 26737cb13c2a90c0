# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""How each thing of a picture truly moves: from the poses of the parts that its pixels show, limbs and wheels too."""
import numpy as np


def surface_points(depth, recording):
    """(height, width, 4): the point that each pixel sees, in the camera's axes, homogeneous."""
    cx, cy = recording.centre
    u, v = np.meshgrid(np.arange(recording.width), np.arange(recording.height))
    return np.stack([(u - cx) / recording.focal_length * depth, (v - cy) / recording.focal_length * depth, depth,
                     np.ones_like(depth)], -1)


def instances(picture, poses):
    """(height, width): the id of the thing that each pixel shows, 0 = background."""
    return np.concatenate([[0], poses.thing_of_part])[picture.part]


def motions(picture, recording, poses):
    """{thing: (speed, turn, pixels)} of the things in a picture, since the frame before; of the first, until the next.

    The speed in m/s is the root of the mean square over the visible points, the turn that of the part that turns
    fastest, in degrees/s, and the pixels are how many show the thing."""
    now, other = picture.frame, picture.frame - 1 if picture.frame else 1
    points = surface_points(picture.depth, recording)
    instance = instances(picture, poses)
    found = {}
    for thing in np.unique(poses.thing_of_part):
        mask = instance == thing
        if not mask.any():
            continue
        part = picture.part[mask] - 1
        here = points[mask] @ poses.camera[now].T
        shift = np.zeros((len(part), 3))
        for i in np.unique(part):
            of_part = part == i
            motion = poses.parts[other, i] @ np.linalg.inv(poses.parts[now, i])
            shift[of_part] = (here[of_part] @ motion.T - here[of_part])[:, :3]
        speed = np.sqrt((shift**2).sum(1).mean()) * recording.rate
        own = poses.thing_of_part == thing
        turned = (poses.parts[other, own] @ np.linalg.inv(poses.parts[now, own]))[:, :3, :3]
        cosine = np.clip((np.trace(turned, axis1=1, axis2=2) - 1) / 2, -1, 1)
        found[int(thing)] = speed, np.degrees(np.arccos(cosine)).max() * recording.rate, int(mask.sum())
    return found
