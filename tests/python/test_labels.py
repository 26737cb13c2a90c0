# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The same answers as through C++."""

import os
import subprocess

import demo
import numpy as np
import pytest
from conftest import SAMPLE, new_tracker, same, track

from dot_slam import State
from dot_slam.__main__ import main


@pytest.mark.skipif("DOT_RUN" not in os.environ, reason="dot_run was not built")
@pytest.mark.parametrize("options", [[], ["--mask-every", "3"], ["--mask-every", "4", "--mask-delay", "2"]],
                         ids=" ".join)
def test_files_of_dot_run(tmp_path, options):
    """labels/, instances/ and objects.csv byte for byte; poses are multiplied by another library."""
    cv2 = pytest.importorskip("cv2", reason="no OpenCV for Python, with which sequences are read")
    cpp, python = tmp_path / "cpp", tmp_path / "python"
    subprocess.run([os.environ["DOT_RUN"], SAMPLE, "--out", cpp, *options], check=True, stdout=subprocess.DEVNULL)
    assert main([str(SAMPLE), "--out", str(python), *options]) == 0
    files = [path.relative_to(cpp) for path in sorted(cpp.glob("*/*.png"))] + ["objects.csv"]
    assert len(files) == 2 * 24 + 1
    assert [str(file) for file in files if (cpp / file).read_bytes() != (python / file).read_bytes()] == []
    np.testing.assert_allclose(np.loadtxt(python / "camera.txt"), np.loadtxt(cpp / "camera.txt"), atol=1e-12)
    labels = [cv2.imread(str(path), -1) for path in (python / "labels").iterdir()]
    assert sum((image == State.MOVING).sum() for image in labels) > 10000


def test_same_again():
    """Another tracker, and the same one after a reset, but for its ids, which go on."""
    with new_tracker() as one, new_tracker() as other:
        first = [track(one, i) for i in range(8)]
        assert all(same(a, track(other, i)) for i, a in enumerate(first))
        one.reset()
        for i, before in enumerate(first):
            again = track(one, i)
            assert np.array_equal(before.labels, again.labels)
            assert set(again.table["id"]).isdisjoint(first[-1].table["id"])
            np.testing.assert_array_equal(before.table["p_moving"], again.table["p_moving"])


def test_in_two_steps():
    """The host prepares, or the next frame does."""
    with new_tracker() as whole, new_tracker() as steps:
        for i in range(8):
            grey, depth, ids = demo.draw(i)
            result = steps.label(grey, depth, ids, timestamp=demo.SECONDS * i)
            if i % 2:
                steps.prepare()
            assert same(result, track(whole, i))
        steps.prepare()
        steps.prepare()


def test_options_arrive():
    def labels(**changes):
        with new_tracker(**changes) as tracker:
            return [track(tracker, i) for i in range(8)][-1].labels

    assert (labels() == State.MOVING).any()
    assert not (labels(options={"velocity.v0": 1.0, "velocity.v0_per_square_metre": 1}) == State.MOVING).any()
    assert np.array_equal(labels(options={"threads": 2}), labels())

    def farthest(**changes):
        with new_tracker(**changes) as tracker:
            return [track(tracker, i) for i in range(8)][-1].table["range"].max()

    assert farthest(depth_units_per_metre=10000) < 0.2 * farthest()  # all of it is ten times nearer


def test_exclusion_mask(tracker):
    result = [track(tracker, i) for i in range(8)][-1]
    moving, static = result.labels == State.MOVING, result.labels == State.STATIC
    exact = tracker.exclusion_mask(dilation=0)
    assert moving.any() and np.array_equal(exact == 255, moving) and np.array_equal(exact == 0, ~moving)
    assert np.array_equal(tracker.exclusion_mask(dilation=0, static=True) == 255, moving | static)
    assert np.array_equal(tracker.exclusion_mask(inverted=True), 255 - tracker.exclusion_mask())
    assert (tracker.exclusion_mask() > 0).sum() > moving.sum()
