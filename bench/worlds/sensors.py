# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What sensors and a segmentation network make of the truth. All images are (height, width), depth is in metres with 0
where there is none, `random` is a numpy Generator; the same one gives the same noise."""
from dataclasses import dataclass

import cv2
import numpy as np


def patches(random, shape, spacing, sigma=1.0):
    """Noise of that standard deviation at points `spacing` pixels apart, and smooth in between."""
    height, width = shape
    rows, columns = height // spacing + 3, width // spacing + 3
    coarse = random.normal(0, 1, (rows, columns)).astype(np.float32)
    fine = cv2.resize(coarse, (columns * spacing, rows * spacing), interpolation=cv2.INTER_CUBIC)
    return fine[:height, :width] * sigma


def blurred_noise(random, shape, radius, gain):
    """Noise of about unit variance that is alike in neighbouring pixels; `gain` makes up for what the blur takes."""
    noise = random.normal(0, 1, shape).astype(np.float32)
    return cv2.GaussianBlur(noise, (0, 0), radius) * gain


def noisy_image(image, random, sigma=2.0):
    """The image (height, width, channels) with noise of so many grey values."""
    noisy = image.astype(np.float32) + random.normal(0, sigma, image.shape)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


@dataclass(frozen=True)
class Stereo:
    """Depth as from matching a stereo pair: edges fattened here and there, noise that is alike in neighbouring pixels,
    gross errors in spots, none where the right camera sees something else or nothing has texture."""

    focal_length: float  # pixels
    baseline: float  # metres
    max_depth: float  # metres
    pixel_sigma: float = 0.16  # pixels of disparity, from pixel to pixel
    patch_sigma: float = 0.12  # from patch to patch
    thing_sigma: float = 0.0  # from thing to thing
    gross_share: float = 0.004  # of the pixels that have a gross error, together with those around them
    gross_sigma: float = 3.0
    least_disparity: float = 1.0
    least_texture: float = 2.5  # grey values: mean horizontal gradient of 9 x 9 pixels

    def measure(self, depth, grey, instance, things, random):
        """The depth that is measured where the true one is `depth`; the instances are numbered from 1 to `things`."""
        shape = depth.shape
        focal_baseline = self.focal_length * self.baseline
        disparity = np.where(depth == 0, 0, focal_baseline / np.maximum(depth, 1e-3))
        disparity = self._fattened(disparity, random)
        measured = (disparity + blurred_noise(random, shape, 1.0, gain=3.54) * self.pixel_sigma
                    + patches(random, shape, 10, self.patch_sigma))
        measured += np.concatenate([[0], random.normal(0, 1, things)])[instance] * self.thing_sigma
        blank = (self._texture(grey) < self.least_texture) & (patches(random, shape, 8) > -0.3)
        found = ~self._hidden_from_right(disparity) & (depth > 0) & ~blank & (measured > self.least_disparity)
        spots = random.random(shape) < self.gross_share
        spots = cv2.dilate(spots.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        measured = np.where(spots & found, measured + random.normal(0, self.gross_sigma, shape), measured)
        result = np.where(found, focal_baseline / np.maximum(measured, 0.5), 0)
        return np.where(result > self.max_depth, 0, result)

    @staticmethod
    def _fattened(disparity, random):
        """Nearer surfaces reach a pixel too far, in patches."""
        fat = cv2.dilate(disparity.astype(np.float32), np.ones((3, 3), np.uint8))
        return np.where(patches(random, disparity.shape, 12) > 0.2, fat, disparity)

    @staticmethod
    def _hidden_from_right(disparity):
        """Pixels that lie beyond the left border of the right image, or where a nearer surface covers them there."""
        at = np.arange(disparity.shape[1]) - disparity
        leftmost_from_here = np.minimum.accumulate(at[:, ::-1], axis=1)[:, ::-1]
        hidden = at < 0
        hidden[:, :-1] |= at[:, :-1] >= leftmost_from_here[:, 1:] + 0.5
        return hidden

    @staticmethod
    def _texture(grey):
        return cv2.boxFilter(np.abs(cv2.Sobel(grey.astype(np.float32), cv2.CV_32F, 1, 0, ksize=3)), -1, (9, 9))


@dataclass(frozen=True)
class Rgbd:
    """Depth as from a structured-light camera: noise that grows with the square of the depth, steps of an eighth of a
    pixel of disparity, holes at edges and in a few patches."""

    focal_length: float  # pixels
    baseline: float  # metres, between projector and camera
    max_depth: float  # metres
    min_depth: float = 0.25
    sigma: float = 0.0015  # metres at a metre

    def measure(self, depth, random):
        """The depth that is measured where the true one is `depth`."""
        shape = depth.shape
        noise = blurred_noise(random, shape, 0.7, gain=2.48) * 0.9 + patches(random, shape, 8, 0.44)
        measured = self._in_steps(depth + self.sigma * depth**2 * noise)
        steepness = cv2.morphologyEx(depth.astype(np.float32), cv2.MORPH_GRADIENT, np.ones((5, 5), np.uint8))
        hole = steepness > 0.05 * np.maximum(depth, 0.3)
        hole &= patches(random, shape, 4) + random.normal(0, 0.5, shape) > -0.25
        hole |= patches(random, shape, 10) > 2.2
        return np.where(hole | (depth < self.min_depth) | (depth > self.max_depth), 0, measured)

    def _in_steps(self, depth):
        focal_baseline = self.focal_length * self.baseline
        disparity = np.rint(8 * focal_baseline / np.maximum(depth, 0.05)) / 8
        return np.where(disparity > 0, focal_baseline / np.maximum(disparity, 0.01), 0)


def network_masks(instance, depth, random, min_pixels=40, miss_rate=0.015):
    """Masks as of a network: ids drawn anew, borders wrong by a pixel or two, nearer instances over farther ones, some
    instances missed. Returns an id image and {id: (true instance, score)}."""
    present = [int(thing) for thing in np.unique(instance) if thing and (instance == thing).sum() >= min_pixels]
    ids = random.permutation(len(present)) + 1
    distance = {thing: np.median(depth[instance == thing]) for thing in present}
    masks, found = np.zeros(instance.shape, np.uint16), {}
    for thing, mask_id in sorted(zip(present, ids), key=lambda pair: -distance[pair[0]]):
        if random.random() < miss_rate:
            continue
        mask = (instance == thing).astype(np.uint8)
        outwards = patches(random, instance.shape, 9, 1.3) + random.normal(0.15, 0.4)
        inside = cv2.distanceTransform(mask, cv2.DIST_L2, 3) - cv2.distanceTransform(1 - mask, cv2.DIST_L2, 3)
        small = min(1.0, np.sqrt(mask.sum()) / 30)  # borders of small instances are off by less
        masks[(inside + outwards * small) > 0] = mask_id
        found[int(mask_id)] = thing, 0.5 + 0.5 * random.random()
    return masks, found
