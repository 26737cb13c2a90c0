# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Whether pictures and truth agree: a picture that is moved into the next one by the true poses and depths must look
like it. Wrong poses, depths or parts show here before anybody blames a tracker."""
import cv2
import numpy as np

import truth

NEIGHBOURS = 50  # pixels that a figure needs


def compare(recording, poses, pictures):
    """(n, 4): mean difference in grey values between the pictures of every fourth pair, of standing surfaces after the
    true motion and without, and of moving things likewise; nan where there are none."""
    found, before = [], None
    for number, picture in enumerate(pictures):
        if before is not None and number % 4 == 1:
            found.append(compare_pair(recording, poses, before, picture))
        before = picture
    return np.array(found).reshape(-1, 4)


def compare_pair(recording, poses, before, picture):
    smooth_before, smooth = smoothed(before.image), smoothed(picture.image)
    x, y, z = places_before(recording, poses, before, picture)
    moved = cv2.remap(smooth_before, x, y, cv2.INTER_LINEAR).astype(float).mean(2)
    depth_there = cv2.remap(before.depth.astype(np.float32), x, y, cv2.INTER_NEAREST)
    grey, grey_before = smooth.astype(float).mean(2), smooth_before.astype(float).mean(2)

    seen_in_both = (picture.depth > 0) & (np.abs(depth_there - z) < 0.02 * z)
    seen_in_both &= (x > 1) & (x < recording.width - 2) & (y > 1) & (y < recording.height - 2)
    shifts = np.abs(poses.parts[picture.frame] - poses.parts[before.frame]).max(axis=(1, 2))
    moving = np.concatenate([[False], shifts > 1e-5])[picture.part]
    result = []
    for surface in (seen_in_both & ~moving, seen_in_both & moving):
        enough = surface.sum() > NEIGHBOURS
        for other in (moved, grey_before):
            result.append(np.abs(other - grey)[surface].mean() if enough else np.nan)
    return result


def places_before(recording, poses, before, picture):
    """Where what each pixel shows was in the picture before: x, y in pixels, depth in metres."""
    points = truth.surface_points(picture.depth, recording) @ poses.camera[picture.frame].T
    for part in np.unique(picture.part):
        if part:
            back = poses.parts[before.frame, part - 1] @ np.linalg.inv(poses.parts[picture.frame, part - 1])
            points[picture.part == part] = points[picture.part == part] @ back.T
    points = points @ np.linalg.inv(poses.camera[before.frame]).T
    z = points[..., 2]
    cx, cy = recording.centre
    with np.errstate(divide="ignore", invalid="ignore"):  # the sky has no depth
        x, y = recording.focal_length * points[..., 0] / z + cx, recording.focal_length * points[..., 1] / z + cy
    return x.astype(np.float32), y.astype(np.float32), z


def smoothed(image):
    return cv2.GaussianBlur(image, (0, 0), 0.7)
