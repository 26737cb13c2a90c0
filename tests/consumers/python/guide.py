# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""guide.py EXAMPLE_FOLDER: the code of docs/embedding/python.md on the frames of the example, by a Unix clock."""

import sys
import time

import numpy as np

sys.path.insert(0, sys.argv[1])
from demo import CAMERA, FOCAL, HEIGHT, WIDTH, draw  # noqa: E402
from dot_slam import State  # noqa: E402
from exclusion import Exclusion  # noqa: E402

fx = fy = FOCAL
cx, cy, width, height = CAMERA.cx, CAMERA.cy, WIDTH, HEIGHT


def recorded():
    for i in range(10):
        grey, depth, ids = draw(i)
        yield 1.7e9 + 0.1 * i, np.dstack((grey, grey, grey)), depth, ids if i % 3 == 0 else None


frames = recorded()
# snippet: python_use
# end of snippet

slid = np.s_[100:150, 170 + 4 * 9 + 20:170 + 4 * 9 + 60]
assert (excluded[slid] == 255).all() and (allowed[slid] == 0).all()
assert (excluded[100:150, 60:100] == 0).all() and (excluded[:60] == 0).all()
assert sorted(exclusion.states().values()) == [State.STATIC, State.MOVING]
assert (exclusion.mask(1.7e9 + 0.9, image, depth) == 0).all()  # the same frame again
assert (exclusion.mask(1.7e9 + 1, image, depth[:9]) == 0).all()
assert (exclusion.mask(1.7e9 + 1, image[:, :, ::-1], depth, ids)[slid] == 255).all()
assert (exclusion.mask(1.7e9 - 3600, image, depth, ids)[slid] == 255).all()  # a clock that was set back by an hour
assert (exclusion.mask(1.7e9 - 3600 + 0.1, image, depth, ids)[slid] == 255).all()
nothing_yet = Exclusion(CAMERA)
assert (nothing_yet.mask(1.7e9, image[:9], depth) == 0).all() and nothing_yet.states() == {}


def recorded_at_leisure():
    """The next frame comes when the network has done the last one: it is always one frame late."""
    for seconds, image, depth, _ in recorded():
        while running is not None and not running[1].done():
            time.sleep(0.001)
        yield seconds, image, depth


def network(image):
    network.calls += 1
    return draw(network.calls - 1)[2]


network.calls = 0
camera, frames = CAMERA, recorded_at_leisure()
# snippet: python_late
# end of snippet
assert network.calls == 10 and (result.labels[slid] == State.MOVING).all()
