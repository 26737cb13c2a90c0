# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Masks that come after their frame."""

import demo
import numpy as np
import pytest
from conftest import new_tracker, track

from dot_slam import InvalidArgument, State


def test_late_masks_show_in_the_next_result(tracker):
    for i in range(6):
        result = track(tracker, i, masks=None)
        assert len(result.table) == 0
        if i == 3:
            tracker.submit_masks(1, demo.draw(1)[2])
            tracker.submit_masks(2, [])  # the network found nothing there
            break
    result = track(tracker, 4, masks=None)
    assert len(result.table) == 2
    # Where the plates are now, not where they were.
    assert (result.labels[85:165, 45:115] != State.BACKGROUND).mean() > 0.95
    assert (result.labels[85:165, 175 + 16:245 + 16] != State.BACKGROUND).mean() > 0.95


def test_numbers_of_ones_own(tracker):
    assert track(tracker, 0, masks=None, frame_id=700).frame_id == 700
    assert track(tracker, 1, masks=None).frame_id == 701
    tracker.submit_masks(np.int64(700), demo.draw(0)[2])
    assert len(track(tracker, 2, masks=None).table) == 2


@pytest.mark.parametrize("field, arguments, text", [
    ("frame_id", (5, demo.draw(5)[2]), "5 is none of the frames"),
    ("frame_id", (-1, demo.draw(0)[2]), "is -1"),
    ("masks", (1, None), "use []"),
    ("masks", (1, demo.draw(1)[2][1:]), "shape (239, 320)"),
])
def test_refused(tracker, field, arguments, text):
    for i in range(3):
        track(tracker, i, masks=None)
    with pytest.raises(InvalidArgument) as caught:
        tracker.submit_masks(*arguments)
    assert caught.value.field == field
    assert str(caught.value).startswith(field) and text in str(caught.value)
    tracker.submit_masks(1, demo.draw(1)[2])
    assert len(track(tracker, 3, masks=None).table) == 2


def test_too_late_and_twice():
    with new_tracker(options={"mask.late_seconds": 0.25}) as tracker:
        for i in range(5):
            track(tracker, i, masks=None)
        with pytest.raises(InvalidArgument):
            tracker.submit_masks(0, demo.draw(0)[2])
        tracker.submit_masks(3, demo.draw(3)[2])
        with pytest.raises(InvalidArgument):
            tracker.submit_masks(3, demo.draw(3)[2])
