# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What a result looks like when it is printed: a line, not pages of arrays."""

import re

from conftest import track


def test_result_in_a_line(tracker):
    for i in range(6):
        result = track(tracker, i)
    assert repr(result) == "<Result of frame 5 at 0.5 s: camera TRACKED, objects 1 moving, 1 static, 0 not observable>"
    assert str(result) == repr(result)
    assert re.fullmatch(r"<CameraResult of frame 5: TRACKED, \d+ of \d+ points>", repr(result.camera))
    texts = sorted(repr(item) for item in result.objects)
    assert re.fullmatch(r"<Object 1: STATIC, P\(moving\) 0\.\d\d, \d\.\d\d m/s, 7200 pixels>", texts[0])
    assert re.fullmatch(r"<Object 2: MOVING, P\(moving\) [01]\.\d\d, 0\.\d\d m/s, 7200 pixels>", texts[1])


def test_objects_without_a_motion(tracker):
    result = track(tracker, 0)
    assert "objects 0 moving, 0 static, 2 not observable>" in repr(result)
    assert "<Object 1: NOT_OBSERVABLE, P(moving) 0.50, no motion: NEW, 7200 pixels>" in map(repr, result.objects)


def test_suspicion_is_in_the_line(tracker):
    for i in range(10):
        result = track(tracker, i, timestamp=100 * i)
    assert repr(result).endswith(", suspicion IMPLAUSIBLE_TIMES (100)>")
    assert repr(result.camera).endswith(", suspicion IMPLAUSIBLE_TIMES (100)>")
