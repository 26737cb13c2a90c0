#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the sensors of bench/worlds do to depth and masks.

    tests/worlds/sensors_test.py FOLDER

FOLDER is bench/worlds. Needs numpy and OpenCV for Python (Debian: python3-opencv).
"""
import sys
import unittest

import numpy as np

sys.path.insert(0, sys.argv.pop(1))

import sensors  # noqa: E402

SHAPE = 120, 200
TEXTURE = np.random.default_rng(5).integers(0, 255, SHAPE).astype(np.uint8)
NOTHING = np.zeros(SHAPE, int)
STEREO = {"focal_length": 400, "baseline": 0.3, "max_depth": 50}
RGBD = {"focal_length": 520, "baseline": 0.075, "max_depth": 6}


def flat(depth):
    return np.full(SHAPE, float(depth))


def with_box(far, near):
    """A wall, and a box before it in columns 100 to 149."""
    depth = flat(far)
    depth[30:90, 100:150] = near
    return depth


def stereo(depth, grey=TEXTURE, instance=NOTHING, things=0, seed=1, **settings):
    return sensors.Stereo(**STEREO, **settings).measure(depth, grey, instance, things, np.random.default_rng(seed))


def rgbd(depth, seed=1):
    return sensors.Rgbd(**RGBD).measure(depth, np.random.default_rng(seed))


class Stereo(unittest.TestCase):
    def test_error_grows_with_the_square_of_depth(self):
        error = {z: np.median(np.abs(measured[measured > 0] - z))
                 for z in (4, 8, 16) for measured in [stereo(flat(z))]}
        self.assertGreater(error[4], 0.01)
        for z in (4, 8):
            self.assertAlmostEqual(error[2 * z] / error[z], 4, delta=0.8)

    def test_nothing_where_the_right_camera_sees_something_else(self):
        share = (stereo(with_box(far=12, near=4)) > 0)[30:90].mean(axis=0)
        shift = int(400 * 0.3 / 4 - 400 * 0.3 / 12)
        self.assertEqual(shift, 20)
        self.assertLess(share[100 - shift + 2:98].max(), 0.3)  # but for what is taken for the box, fattened
        self.assertGreater(share[60:78].min(), 0.9)
        self.assertGreater(share[153:170].min(), 0.9)
        self.assertEqual(share[:7].max(), 0)  # beyond the right image

    def test_nothing_without_texture_or_surface_or_far_away(self):
        self.assertLess((stereo(flat(5), grey=np.full(SHAPE, 90, np.uint8)) > 0).mean(), 0.5)
        self.assertEqual(stereo(flat(0)).max(), 0)
        self.assertLess((stereo(flat(60)) > 0).mean(), 0.05)
        self.assertLessEqual(stereo(flat(49)).max(), STEREO["max_depth"])

    def test_a_thing_may_be_off_as_a_whole(self):
        depth, instance = with_box(12, 4), NOTHING.copy()
        instance[30:90, 100:150] = 2
        usual = stereo(depth, instance=instance, things=2)
        off = stereo(depth, instance=instance, things=2, thing_sigma=1.0)
        both = (usual > 0) & (off > 0)
        change = np.where(both, 120 / np.where(both, off, 1) - 120 / np.where(both, usual, 1), 0)
        self.assertEqual(np.abs(change[instance == 0]).max(), 0)
        self.assertGreater(np.abs(np.median(change[both & (instance == 2)])), 0.05)
        self.assertLess(np.ptp(change[both & (instance == 2)]), 1e-6)

    def test_same_numbers_same_noise(self):
        np.testing.assert_array_equal(stereo(flat(5), seed=3), stereo(flat(5), seed=3))
        self.assertTrue((stereo(flat(5), seed=3) != stereo(flat(5), seed=4)).any())


class Rgbd(unittest.TestCase):
    def test_error_grows_with_the_square_of_depth(self):
        for z in (1, 2, 4):
            measured = rgbd(flat(z))
            self.assertAlmostEqual(measured[measured > 0].std() / z**2, 0.0015, delta=0.0007)

    def test_depth_comes_in_steps(self):
        measured = rgbd(flat(3))
        steps = 8 * 520 * 0.075 / measured[measured > 0]
        np.testing.assert_allclose(steps, np.rint(steps), atol=1e-9)

    def test_holes_at_edges(self):
        holes = rgbd(with_box(far=3, near=2)) == 0
        self.assertGreater(holes[40:80, 99:101].mean(), 0.4)
        self.assertLess(holes[40:80, 110:140].mean(), 0.1)

    def test_nothing_out_of_range(self):
        for z in (0, 0.2, 6.1):
            self.assertEqual(rgbd(flat(z)).max(), 0)


class Masks(unittest.TestCase):
    def setUp(self):
        self.instance, self.depth = NOTHING.copy(), flat(20)
        for thing, columns, z in ((3, slice(20, 70), 8), (5, slice(70, 120), 4), (9, slice(150, 156), 6)):
            rows = slice(56, 62) if thing == 9 else slice(30, 90)
            self.instance[rows, columns], self.depth[rows, columns] = thing, z

    def masks(self, seed=1, **settings):
        return sensors.network_masks(self.instance, self.depth, np.random.default_rng(seed), **settings)

    def test_ragged_but_right(self):
        masks, found = self.masks(miss_rate=0)
        self.assertEqual({thing for thing, _ in found.values()}, {3, 5})  # 36 pixels are too few
        self.assertEqual(set(np.unique(masks)), {0, *found})
        for mask_id, (thing, score) in found.items():
            mask, truth = masks == mask_id, self.instance == thing
            self.assertGreater((mask & truth).sum() / (mask | truth).sum(), 0.85)
            self.assertTrue((mask != truth).any())
            self.assertTrue(0.5 <= score <= 1)

    def test_nearer_instances_cover_farther_ones(self):
        covered = {seed: None for seed in range(8)}
        for seed in covered:
            masks, found = self.masks(seed, miss_rate=0)
            near, far = (next(i for i, (thing, _) in found.items() if thing == wanted) for wanted in (5, 3))
            covered[seed] = ((masks == near)[:, :70].sum(), (masks == far)[:, 70:].sum())
        outside = np.array(list(covered.values()))
        self.assertGreater(outside[:, 0].max(), 20)  # the nearer one's border runs over the farther one
        self.assertTrue((outside[:, 0] >= outside[:, 1]).mean() > 0.5)

    def test_ids_change_from_frame_to_frame(self):
        ids = {tuple(sorted((thing, mask_id) for mask_id, (thing, _) in self.masks(seed, miss_rate=0)[1].items()))
               for seed in range(12)}
        self.assertEqual(ids, {((3, 1), (5, 2)), ((3, 2), (5, 1))})

    def test_some_are_missed(self):
        self.assertEqual(self.masks(miss_rate=1)[1], {})
        self.assertEqual(self.masks(miss_rate=1)[0].max(), 0)


if __name__ == "__main__":
    unittest.main()
