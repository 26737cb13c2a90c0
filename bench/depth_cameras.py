# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What depth cameras measure, for depth_sensors.py: structured light and time of flight.

Images are (height, width). Depth is in metres with 0 where there is none, `random` is a numpy Generator; the same one
gives the same noise.
"""
import cv2
import numpy as np

from worlds.sensors import blurred_noise, patches

KINDS = ("shadow", "flying")
STEP = 1.12  # depth over that of a neighbour, from which on there is an edge between them


def in_rows(depth, forwards):
    """Each hole filled with the last depth before it in its row, and how many pixels away that is."""
    depth = depth if forwards else depth[:, ::-1]
    column = np.arange(depth.shape[1])
    last = np.maximum.accumulate(np.where(depth > 0, column, -1), axis=1)
    filled = np.where(last >= 0, np.take_along_axis(depth, np.maximum(last, 0), 1), 0)
    away = np.where(last >= 0, column - last, 9999)
    return (filled, away) if forwards else (filled[:, ::-1], away[:, ::-1])


def surfaces(depth, instance):
    """Depth of the surfaces themselves, of that of a sensor: its noise smoothed, its holes filled from the same thing
    in the same row. Wide holes are shadows of a projector or of a second camera: they belong to the farther surface."""
    filled = np.zeros_like(depth)
    for thing in np.unique(instance):
        own = np.where(instance == thing, depth, 0)
        (left, to_left), (right, to_right) = in_rows(own, True), in_rows(own, False)
        wide = (to_left + to_right > 6) & (left > 0) & (right > 0)
        nearest = np.where(to_left <= to_right, left, right) * (np.minimum(to_left, to_right) < 60)  # no sky
        filled = np.where(instance == thing, np.where(wide, np.maximum(left, right), nearest), filled)
    inverse = np.where(filled > 0, 1 / np.maximum(filled, 1e-3), 0).astype(np.float32)
    median = cv2.medianBlur(inverse, 5)
    smooth = cv2.bilateralFilter(median, 9, 0.03 * float(np.median(median)), 3)
    return np.where(filled > 0, 1 / np.maximum(smooth, 1e-3), 0)


def ragged(random, shape, share, spacing=3):
    """True in that share of the pixels, in patches, and otherwise in each frame."""
    noise = patches(random, shape, spacing) + random.normal(0, 0.4, shape)
    return noise < np.quantile(noise, share)


def hidden_from_projector(disparity):
    """Pixels that the projector, to the right of the camera, does not see: a nearer surface is before them."""
    at = np.arange(disparity.shape[1]) - disparity
    leftmost_from_here = np.minimum.accumulate(at[:, ::-1], axis=1)[:, ::-1]
    hidden = np.zeros(disparity.shape, bool)
    hidden[:, :-1] = at[:, :-1] >= leftmost_from_here[:, 1:] + 0.5
    return hidden


def edges(depth, radius):
    """Depth of the nearest and of the farthest surface that many pixels about, and whether there is a step between."""
    kernel = np.ones((2 * radius + 1, 2 * radius + 1), np.uint8)
    near = cv2.erode(np.where(depth > 0, depth, 1e3).astype(np.float32), kernel)
    far = cv2.dilate(depth.astype(np.float32), kernel)
    return near, far, far > STEP * near


def grazing(depth, focal, least):
    """Pixels of surfaces that the ray meets at an angle whose sine is below `least`."""
    smooth = cv2.GaussianBlur(depth.astype(np.float32), (0, 0), 1.5)
    slope = np.hypot(cv2.Sobel(smooth, cv2.CV_32F, 1, 0), cv2.Sobel(smooth, cv2.CV_32F, 0, 1)) / 8
    return (slope * focal / np.maximum(depth, 1e-3) > np.sqrt(1 / least**2 - 1)) & ~edges(depth, 4)[2]


def structured_light(depth, grey, focal, baseline, random):
    """The depth that is measured where the true one is `depth`: none beside near things, where they hide the scene from
    the projector; edges that reach up to three pixels too far, and flicker; steps of an eighth of a pixel of disparity;
    holes at grazing angles and where it is dark or glares."""
    shape = depth.shape
    disparity = np.where(depth > 0, focal * baseline / np.maximum(depth, 1e-3), 0).astype(np.float32)
    disc = [cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * r + 1, 2 * r + 1)) for r in (2, 3)]
    fat = [cv2.dilate(disparity, d) for d in disc]
    fat = np.where(ragged(random, shape, 0.4), fat[1], np.where(ragged(random, shape, 0.8), fat[0], disparity))
    measured = np.where(edges(depth, 3)[2] & (fat > STEP * disparity), fat, disparity)
    measured = measured + blurred_noise(random, shape, 0.7, gain=2.48) * 0.06 + patches(random, shape, 8, 0.04)
    measured = np.rint(8 * measured) / 8
    hole = hidden_from_projector(cv2.dilate(disparity, disc[0]))
    hole |= grazing(depth, focal, 0.12) & ragged(random, shape, 0.7)
    hole |= ((grey < 25) | (grey > 245)) & ragged(random, shape, 0.7)
    hole |= patches(random, shape, 10) > 2.2
    return np.where(hole | (depth == 0) | (measured <= 0), 0, focal * baseline / np.maximum(measured, 0.125))


def time_of_flight(depth, grey, random):
    """The depth that is measured where the true one is `depth`: one or two pixels at edges take a mixture of both
    depths, another one in each frame; noise that grows with the distance, and where it is dark; corners bent away."""
    shape = depth.shape
    true = np.where(depth > 0, depth, 0).astype(np.float32)
    measured = true + 0.1 * np.clip(true - cv2.blur(true, (31, 31)), 0, 0.1)
    for radius, share in ((1, 0.8), (2, 0.25)):
        near, far, is_edge = edges(true, radius)
        mixed = is_edge & (random.random(shape) < share)
        measured = np.where(mixed, near + random.random(shape) * (far - near), measured)
    sigma = (0.002 + 0.0015 * true**2) * np.sqrt(110.0 / (grey.astype(float) + 10))
    sigma = np.minimum(sigma, 0.02 * true)
    return np.where(depth > 0, np.maximum(measured + sigma * random.normal(0, 1, shape), 0.05), 0)


def measured(kind, depth, grey, instance, focal, baseline, random):
    """Depth of a recording, 1/256 m, as the sensor `kind`, "shadow" or "flying", would have measured it."""
    true = surfaces(depth / 256.0, instance)
    if kind == "shadow":
        seen = structured_light(true, grey, focal, baseline, random)
    else:
        seen = time_of_flight(true, grey, random)
    return np.where(seen > 0, np.clip(np.rint(256 * seen), 1, 65535), 0).astype(depth.dtype)
