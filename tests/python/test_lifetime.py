# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Who owns what, and for how long."""

import copy
import gc
import pickle
import subprocess
import sys
import weakref

import demo
import numpy as np
import pytest
from conftest import new_tracker, same, track

from dot_slam import Closed


def snapshot(result):
    return copy.deepcopy((result.labels, result.ids, result.table, result.camera.T_cur_prev))


def test_results_are_the_callers():
    """They do not change with later frames, a reset or the end of the tracker, and may be written to."""
    with new_tracker() as tracker, new_tracker() as other:
        results = [track(tracker, i) for i in range(4)]
        mask = tracker.exclusion_mask()
        kept, kept_mask = [snapshot(result) for result in results], mask.copy()
        for result in results[:2]:
            result.labels[:] = result.ids[:] = 77
            result.table["state"] = 9
        assert same(track(tracker, 4), [track(other, i) for i in range(5)][-1])
        tracker.reset()
    del tracker
    gc.collect()
    assert np.array_equal(mask, kept_mask)
    for result, before in list(zip(results, kept))[2:]:
        for now, then in zip(snapshot(result), before):
            assert np.array_equal(now, then)
    arrays = [array for result in results for array in (result.labels, result.ids, result.table)]
    assert not any(np.shares_memory(a, b) for i, a in enumerate(arrays) for b in arrays[:i])
    item = results[3].objects[0]
    results[3].table["T_o"] = 5
    assert not (item.T_o == 5).any()


def test_arguments_are_the_callers():
    """Nothing is kept of them, and what is written to them after the call does not count."""
    with new_tracker() as tracker, new_tracker() as other:
        for i in range(4):
            arrays = list(demo.draw(i))
            result = tracker.track(*arrays, timestamp=demo.SECONDS * i)
            references = [weakref.ref(array) for array in arrays]
            for array in arrays:
                array[:] = 3
            del arrays, array
            assert [reference() for reference in references] == [None] * 3
            assert same(result, track(other, i))


def test_closed_at_the_end_of_with():
    with new_tracker() as tracker:
        track(tracker, 0)
        assert not tracker.closed
    assert tracker.closed
    for call in (lambda: track(tracker, 1), tracker.exclusion_mask, tracker.reset,
                 lambda: tracker.submit_masks(0, demo.draw(0)[2])):
        with pytest.raises(Closed, match="the tracker is closed"):
            call()
    tracker.close()


def test_stopped_in_the_middle():
    kept = []
    with pytest.raises(KeyError):
        with new_tracker() as tracker:
            for i in range(6):
                kept.append(track(tracker, i))
                if i == 3:
                    raise KeyError("the host's")
    assert tracker.closed and len(kept) == 4
    with new_tracker() as other:
        assert all(same(result, track(other, i)) for i, result in enumerate(kept))


def test_freed_when_nobody_holds_it():
    tracker = new_tracker()
    destroyed = tracker._destroy
    track(tracker, 0)
    assert destroyed.alive
    del tracker
    gc.collect()
    assert not destroyed.alive


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, pickle.dumps])
def test_not_copied(tracker, duplicate):
    """Two of them would free the same memory."""
    with pytest.raises(TypeError, match="cannot be copied or pickled"):
        duplicate(tracker)


def test_results_can_be_copied_and_sent(tracker):
    result = [track(tracker, i) for i in range(3)][-1]
    sent = pickle.loads(pickle.dumps(result))
    assert same(sent, result) and sent.objects[1].id == result.objects[1].id
    assert same(copy.deepcopy(result), result)


def resident_kb():
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))


@pytest.mark.skipif(sys.platform != "linux", reason="memory is read from /proc")
def test_memory_comes_back():
    def work(count):
        for _ in range(count):
            with new_tracker() as tracker:
                track(tracker, 0)
                track(tracker, 1)
        gc.collect()

    work(20)
    before = resident_kb()
    work(60)
    one = demo.WIDTH * demo.HEIGHT * 5 // 1024  # what a single result holds; a tracker holds more
    assert resident_kb() - before < 10 * one


END = """
import os, sys, threading
sys.path.insert(0, sys.argv[1])
import demo
from dot_slam import Tracker
tracker = Tracker(demo.CAMERA, depth_units_per_metre=demo.MILLIMETRES)
frame = demo.draw(0)
began = threading.Event()
def work():
    for i in range(10**9):
        tracker.track(*frame, timestamp=i)
        began.set()
threading.Thread(target=work, daemon=True).start()
began.wait()
print("leaving")
"""


def test_program_ends_while_a_thread_tracks():
    for _ in range(5):
        done = subprocess.run([sys.executable, "-c", END, str(demo.__file__).rsplit("/", 1)[0]], capture_output=True,
                              text=True, timeout=60)
        assert (done.returncode, done.stdout, done.stderr) == (0, "leaving\n", "")
