# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Motions of the camera that a later frame proves to be wrong."""

import json
import os
import re
import subprocess

import numpy as np
import pytest
from conftest import demo, new_tracker

from dot_slam import CameraRevision
from dot_slam.__main__ import main

MASKED = 2  # the frame from which on the network sees the plate
PIXELS_PER_FRAME = 40  # at 2 m: 0.29 m, more than a camera's velocity changes in an interval
MOVED = PIXELS_PER_FRAME * 2 / demo.FOCAL  # metres
FRAMES = 6
WALL = demo.texture(1, demo.HEIGHT, demo.WIDTH)
PLATE = demo.texture(2, 200, 1200)


def draw(frame):
    """A camera that stands, and most of whose view is a plate that slides to the right."""
    grey, depth = WALL.copy(), np.full(WALL.shape, 4 * demo.MILLIMETRES, np.uint16)
    ids = np.zeros(WALL.shape, np.uint8)
    place = np.s_[20:220, 40:300]
    begin = 900 - PIXELS_PER_FRAME * frame
    grey[place] = PLATE[:, begin:begin + 260]
    depth[place] = 2 * demo.MILLIMETRES
    if frame >= MASKED:
        ids[place] = 1
    return grey, depth, ids


def results(tracker):
    for i in range(FRAMES):
        yield tracker.track(*draw(i), timestamp=demo.SECONDS * i, frame_id=10 + i)


def test_motions_are_revised():
    with new_tracker() as tracker:
        found = list(results(tracker))
    wrong = [abs(result.camera.T_cur_prev[0, 3]) for result in found[1:MASKED + 1]]
    assert wrong == pytest.approx([MOVED] * MASKED, abs=0.01), "the scene is too easy"
    assert [len(result.revised) for result in found] == [0, 0, 0, MASKED, 0, 0]
    for number, item in enumerate(found[MASKED + 1].revised, 1):
        assert isinstance(item, CameraRevision)
        assert (item.frame_id, item.timestamp) == (10 + number, demo.SECONDS * number)
        assert item.T_cur_prev.shape == (3, 4) and item.covariance.shape == (6, 6)
        np.testing.assert_allclose(item.T_cur_prev, np.eye(3, 4), atol=0.01)
        assert (item.covariance.diagonal() > 0).all()
    item.T_cur_prev[:] = 0  # the caller's
    assert found[MASKED + 1].revised[-1] is item


@pytest.mark.skipif("DOT_RUN" not in os.environ, reason="dot_run was not built")
def test_recording(tmp_path):
    """What dot_run, its page and python -m dot_slam say of a recording where it happens."""
    cv2 = pytest.importorskip("cv2", reason="no OpenCV for Python, with which sequences are read")
    folder, cpp, python, page = (tmp_path / name for name in ("seq", "cpp", "python", "run.html"))
    for i in range(FRAMES):
        grey, depth, ids = draw(i)
        depth = depth // demo.MILLIMETRES * np.uint16(256)  # units of the own layout
        for kind, image in (("rgb", grey), ("depth", depth), ("masks", ids)):
            (folder / kind).mkdir(parents=True, exist_ok=True)
            cv2.imwrite(str(folder / kind / f"{i:06d}.png"), image)
    camera = demo.CAMERA
    (folder / "intrinsics.txt").write_text(f"{camera.fx} {camera.fy} {camera.cx} {camera.cy} {camera.width} "
                                           f"{camera.height} 0 {1 / demo.SECONDS}\n")
    said = subprocess.run([os.environ["DOT_RUN"], folder, "--out", cpp, "--player", page], check=True,
                          capture_output=True, encoding="utf-8").stdout
    assert "camera    2 motions of the camera were revised" in said and "revised.txt" in said
    table = np.loadtxt(cpp / "revised.txt")
    np.testing.assert_allclose(table[:, 0], [1, 2])
    np.testing.assert_allclose(table[:, 1:].reshape(-1, 3, 4), [np.eye(3, 4)] * 2, atol=0.01)

    frames = [json.loads(text) for text in re.findall(r'class="frame">(.*?)</script>', page.read_text("utf-8"))]
    revised = {frame["frame"]: frame["camera"].get("revised") for frame in frames}
    assert [number for number, items in revised.items() if items] == [MASKED + 1]
    assert [item["frame"] for item in revised[MASKED + 1]] == [1, 2]
    assert [item["wrong"] for item in revised[MASKED + 1]] == pytest.approx([MOVED] * 2, abs=0.01)

    assert main([str(folder), "--out", str(python)]) == 0
    assert (python / "revised.txt").read_bytes() == (cpp / "revised.txt").read_bytes()
