#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Files and truth that bench/worlds writes of a small world, of which everything is known without Blender.

    tests/worlds/sequence_test.py FOLDER

FOLDER is bench/worlds. Needs numpy and OpenCV for Python (Debian: python3-opencv).
"""
import csv
import math
import os
import sys
import tempfile
import unittest

import cv2
import numpy as np

sys.path.insert(0, sys.argv.pop(1))

import agreement  # noqa: E402
import sequence  # noqa: E402
from recording import Recording  # noqa: E402
from rendered import Picture, Poses  # noqa: E402

RECORDING = Recording(frames=3, sensor="stereo", focal_length=100, baseline=0.3, seed=1, width=160, height=120)
KINDS = {1: "car", 2: "car", 3: "toy"}
WALL, BOARDS = 8.0, 4.0  # y of a wall, and of a square board for each thing before it
HALF = 0.3  # of a board's side
PLACES = {1: -0.5, 2: 0.6, 3: -1.4}  # x of the boards in frame 0
SPEED = 0.1  # metres a frame, of board 1
TURN = math.radians(1)  # a frame, of board 3, about its own middle
FORWARDS = 0.05  # metres a frame, of the camera
SKY_ROWS = 10  # at the top of the image


def pose(x, y, z, yaw=0.0):
    result = np.eye(4)
    result[:2, :2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
    result[:3, 3] = x, y, z
    return result


def board_at(thing, frame):
    return PLACES[thing] + (SPEED * frame if thing == 1 else 0)


def world():
    """The Poses: a board is the only part of its thing."""
    camera, things = [], []
    for frame in range(RECORDING.frames):
        axes = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
        camera.append(pose(0, FORWARDS * frame, 0) @ axes)
        things.append([pose(board_at(thing, frame), BOARDS, 0, TURN * frame if thing == 3 else 0) for thing in KINDS])
    return Poses(np.array(camera), np.array(things), np.array(things), np.array(list(KINDS)))


def picture(frame):
    """What the camera sees: grey values are a pattern that is fixed to the wall and to each board. The turned board is
    drawn as if it were not: it has turned by two degrees at most."""
    cx, cy = RECORDING.centre
    u, v = np.meshgrid(np.arange(RECORDING.width), np.arange(RECORDING.height))
    right, down = (u - cx) / RECORDING.focal_length, (v - cy) / RECORDING.focal_length
    depth = np.full(u.shape, WALL - FORWARDS * frame)
    part, x = np.zeros(u.shape, int), right * depth
    for number, thing in enumerate(KINDS, start=1):
        z = BOARDS - FORWARDS * frame
        board = (np.abs(right * z - board_at(thing, frame)) < HALF) & (np.abs(down * z) < HALF)
        part[board], depth[board], x[board] = number, z, (right * z)[board] - board_at(thing, frame)
    grey = 128 + 60 * np.sin(8 * x + part) * np.cos(6 * down * depth)
    depth[:SKY_ROWS] = 0
    return Picture(frame, np.repeat(grey[..., None], 3, axis=2).astype(np.uint8), depth, part)


def pictures():
    return [picture(frame) for frame in range(RECORDING.frames)]


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = f"{cls.holder.name}/sequence"
        sequence.write(cls.folder, RECORDING, KINDS, world(), pictures())

    def image(self, name, frame):
        return cv2.imread(f"{self.folder}/{name}/{frame:06d}.png", cv2.IMREAD_UNCHANGED)

    def lines(self, name):
        with open(f"{self.folder}/{name}", encoding="utf-8") as file:
            return file.read().splitlines()

    def test_camera(self):
        self.assertEqual(self.lines("intrinsics.txt"),
                         ["100.000000 100.000000 79.500000 59.500000 160 120 0.300000 10", "depth stereo"])
        poses = np.loadtxt(f"{self.folder}/poses.txt").reshape(-1, 3, 4)
        for frame, there in enumerate(poses):
            np.testing.assert_allclose(there[:, :3], np.eye(3), atol=1e-12)
            np.testing.assert_allclose(there[:, 3], [0, 0, FORWARDS * frame], atol=1e-12)

    def test_objects(self):
        with open(f"{self.folder}/objects.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(int(row["frame"]), int(row["id"])) for row in rows],
                         [(frame, thing) for frame in range(3) for thing in KINDS])
        speeds = {1: SPEED * RECORDING.rate, 2: 0}
        for row in rows:
            thing = int(row["id"])
            self.assertEqual(row["class"], KINDS[thing])
            self.assertEqual(row["moving"], "0" if thing == 2 else "1")
            self.assertEqual(int(row["pixels"]), (self.image("instance", int(row["frame"])) == thing).sum())
            if thing in speeds:
                self.assertAlmostEqual(float(row["speed_mps"]), speeds[thing], places=3)
            else:  # it moves because it turns
                self.assertTrue(0 < float(row["speed_mps"]) < RECORDING.slowest)

    def test_object_poses(self):
        values = np.loadtxt(f"{self.folder}/object_poses.txt")
        self.assertEqual(values[:, :2].astype(int).tolist(), [[frame, thing] for frame in range(3) for thing in KINDS])
        for row in values:
            frame, thing, there = int(row[0]), int(row[1]), row[2:].reshape(3, 4)
            np.testing.assert_allclose(there[:, 3], [board_at(thing, frame), 0, BOARDS], atol=1e-12)
            turned = TURN * frame if thing == 3 else 0
            np.testing.assert_allclose(there[:, 0], [math.cos(turned), 0, math.sin(turned)], atol=1e-9)
            np.testing.assert_allclose(there[:, 1], [0, 1, 0], atol=1e-12)

    def test_images(self):
        for frame in range(3):
            truth = picture(frame)
            np.testing.assert_array_equal(self.image("instance", frame), truth.part)
            np.testing.assert_array_equal(self.image("depth_true", frame), np.rint(truth.depth * 256))
            noise = self.image("rgb", frame).astype(float) - truth.image
            self.assertAlmostEqual(noise.std(), 2, delta=0.1)
            measured = self.image("depth", frame)
            self.assertEqual(measured.dtype, np.uint16)
            self.assertEqual(measured[:SKY_ROWS - 1].max(), 0)
            right = np.abs(measured / 256 - truth.depth) < 0.15 * truth.depth
            self.assertGreater(right[measured > 0].mean(), 0.9)
            self.assertGreater((measured[SKY_ROWS:] > 0).mean(), 0.3)

    def test_masks(self):
        for frame in range(3):
            rows = [line.split(",") for line in self.lines(f"masks/{frame:06d}.csv")]
            self.assertEqual(rows[0], ["id", "class", "score"])
            self.assertEqual({0, *(int(row[0]) for row in rows[1:])}, set(np.unique(self.image("masks", frame))))
            self.assertTrue(all(row[1] in KINDS.values() for row in rows[1:]))


class SomeFrames(unittest.TestCase):
    def test_numbered_from_0_in_the_first_camera(self):
        with tempfile.TemporaryDirectory() as holder:
            folder = f"{holder}/sequence"
            sequence.write(folder, RECORDING, KINDS, world(), pictures()[1:])
            there = np.loadtxt(f"{folder}/poses.txt").reshape(-1, 3, 4)
            self.assertEqual(len(there), 2)
            np.testing.assert_allclose(there[0], np.eye(4)[:3], atol=1e-12)
            first = np.loadtxt(f"{folder}/object_poses.txt")[0]
            self.assertEqual(first[0], 0)
            self.assertAlmostEqual(first[2 + 11], BOARDS - FORWARDS)
            self.assertEqual(sorted(os.listdir(f"{folder}/rgb")), ["000000.png", "000001.png"])


class Agreement(unittest.TestCase):
    def test_right_truth(self):
        (standing, as_it_is, moving, as_they_are), = agreement.compare(RECORDING, world(), pictures())
        self.assertLess(standing, 1.5)
        self.assertLess(moving, 3)
        self.assertGreater(as_they_are, 4 * moving)
        self.assertGreater(as_it_is, standing)

    def test_wrong_truth(self):
        poses = world()
        poses.camera[1:, 0, 3] += 0.1
        standing, _, moving, _ = agreement.compare(RECORDING, poses, pictures())[0]
        self.assertGreater(standing, 4)
        self.assertGreater(moving, 6)


if __name__ == "__main__":
    unittest.main()
