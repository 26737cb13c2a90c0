# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the logger "dot_slam" is told."""

import demo
from conftest import track


def test_times_in_milliseconds_are_told_once(tracker, caplog):
    for i in range(17):
        track(tracker, i, timestamp=1000 * demo.SECONDS * i)
    assert [record.levelname for record in caplog.records] == ["WARNING"]
    text = caplog.records[0].getMessage()
    assert text.startswith("suspicion implausible_times (100 s): ") and text.endswith("are the times in seconds?")


def test_labels_first(tracker, caplog):
    for i in range(17):
        tracker.label(*demo.draw(i), timestamp=1000 * demo.SECONDS * i)
        tracker.prepare()
    assert ["implausible_times" in record.getMessage() for record in caplog.records] == [True]


def test_good_input_says_nothing(tracker, caplog):
    for i in range(17):
        track(tracker, i)
    assert caplog.records == []
