# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the tests share. ctest sets PYTHONPATH to the package in the build folder, and DOT_RUN to the program dot_run."""

import sys
from pathlib import Path

import numpy as np
import pytest

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "examples" / "05_python"))
import demo  # noqa: E402

from dot_slam import Tracker  # noqa: E402

SAMPLE = SOURCE / "examples" / "data" / "mini"


def new_tracker(**changes):
    """For the frames of demo.draw."""
    return Tracker(demo.CAMERA, **{"depth_source": "rgbd", "depth_units_per_metre": demo.MILLIMETRES, **changes})


def track(tracker, frame, **changes):
    """Frame number `frame` of the demo, with some of its arguments replaced."""
    grey, depth, ids = demo.draw(frame)
    arguments = {"image": grey, "depth": depth, "masks": ids, "timestamp": demo.SECONDS * frame, **changes}
    return tracker.track(**arguments)


def same(a, b):
    """Two results, to the last bit."""
    return (np.array_equal(a.labels, b.labels) and np.array_equal(a.ids, b.ids)
            and a.table.tobytes() == b.table.tobytes())


@pytest.fixture
def tracker():
    with new_tracker() as made:
        yield made
