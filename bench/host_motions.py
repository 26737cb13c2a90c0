#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Writes wrong motions of the camera, as a host may give them, for `dot_eval SEQ --camera FILE`.

usage: host_motions.py KIND FILE SEQ        needs numpy

Reads SEQ/poses.txt and writes camera-to-world poses, KITTI format. KIND is
  true          as they are
  inverse       of each interval T_prev_cur instead of T_cur_prev
  late, early   of each interval the motion of the one before, or after
  axes          motions in the axes of a body: x ahead, y left, z up
  rough         as of wheel odometry: errors of 2 cm and 0.11 degrees (sigma of each axis) in each interval
"""
import sys

import numpy as np

BODY = np.array([[0, 0, 1, 0], [-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 0, 1.0]])


def turned(vector):
    """Rotation by a small vector."""
    angle = np.linalg.norm(vector)
    x, y, z = vector / angle
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def rough(T, random):
    T = T.copy()
    T[:3, :3] = turned(random.normal(0, 0.002, 3)) @ T[:3, :3]
    T[:3, 3] += random.normal(0, 0.02, 3)
    return T


def motions(kind, right):
    """T_cur_prev of each interval."""
    random = np.random.default_rng(1)
    if kind == "late":
        return [np.eye(4)] + right[:-1]
    if kind == "early":
        return right[1:] + right[-1:]
    change = {
        "true": lambda T: T,
        "inverse": np.linalg.inv,
        "axes": lambda T: BODY @ T @ np.linalg.inv(BODY),
        "rough": lambda T: rough(T, random),
    }[kind]
    return [change(T) for T in right]


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in ("true", "inverse", "late", "early", "axes", "rough"):
        sys.exit(__doc__)
    kind, target, sequence = sys.argv[1:]
    with open(f"{sequence}/poses.txt") as f:
        poses = [np.vstack([np.array(line.split(), float).reshape(3, 4), [0, 0, 0, 1]]) for line in f]
    pose = np.eye(4)
    with open(target, "w") as f:
        for T in [np.eye(4)] + motions(kind, [np.linalg.inv(b) @ a for a, b in zip(poses, poses[1:])]):
            pose = pose @ np.linalg.inv(T)
            f.write(" ".join(f"{v:.12g}" for v in pose[:3].ravel()) + "\n")


if __name__ == "__main__":
    main()
