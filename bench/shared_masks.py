# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Masks about two objects: used by variants.py."""
import collections
import csv

import cv2
import numpy as np

KINDS = ("shared",)
REACH = np.ones((25, 25))  # objects at most 12 pixels apart touch


def pairs(sequence, frames):
    """Pairs of ids of objects that touch in five frames or more and move differently, each object in one pair."""
    with open(f"{sequence}/objects.csv") as f:
        speed = {(int(r["frame"]), int(r["id"])): float(r["speed_mps"]) for r in csv.DictReader(f)}
    touching = collections.Counter()
    for frame in frames:
        ids = cv2.imread(f"{sequence}/instance/{frame:06d}.png", cv2.IMREAD_UNCHANGED)
        area = {i: int((ids == i).sum()) for i in np.unique(ids) if i}
        large = [i for i in area if area[i] > 400]
        for i in large:
            near = cv2.dilate((ids == i).astype(np.uint8), REACH) > 0
            for j in (j for j in large if j > i):
                slow, fast = sorted(speed.get((frame, int(k)), -1) for k in (i, j))
                differ = (slow < 0.05 and fast > 0.5) or fast - slow > 1
                alike = min(area[i], area[j]) > 0.1 * max(area[i], area[j])
                touching[int(i), int(j)] += differ and alike and ((ids == j) & near).sum() > 40
    chosen = []
    for pair, count in touching.most_common():
        if count >= 5 and not {*pair} & {i for other in chosen for i in other}:
            chosen.append(pair)
    return chosen


def uniter(sequence, frames):
    """A function that gives both objects of each pair one mask, of the true ids in a frame."""
    united = pairs(sequence, frames)

    def unite(masks, frame):
        truth = cv2.imread(f"{sequence}/instance/{frame:06d}.png", cv2.IMREAD_UNCHANGED)
        masks_of = collections.defaultdict(list)
        for mask in np.unique(masks[masks > 0]):
            ids, counts = np.unique(truth[masks == mask], return_counts=True)
            if ids[counts.argmax()] and counts.max() > 0.4 * counts.sum():
                masks_of[int(ids[counts.argmax()])].append(mask)
        for a, b in united:
            if masks_of[a]:
                masks[np.isin(masks, masks_of[b])] = masks_of[a][0]
        return masks

    return unite
