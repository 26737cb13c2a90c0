# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Trackers of several threads run at the same time; one tracker is for one thread at a time."""

import logging
import signal
import sys
import threading
import time

import demo
import numpy as np
import pytest
from conftest import new_tracker, same, track

from dot_slam import Busy
from dot_slam._library import lib


def test_interpreter_is_released_during_track(monkeypatch):
    """No thread is ever asked for the interpreter's lock here, so another one runs only when it is given away. Between
    the opening of the gate and the end of the call only the call itself can do that."""
    orders = []

    def dot_track(*arguments):
        order, gate = [], threading.Event()

        def other():
            gate.wait()
            order.append("other")

        thread = threading.Thread(target=other)
        thread.start()
        time.sleep(0.001)  # it waits at the gate
        gate.set()
        status = real(*arguments)
        order.append("track")
        thread.join()
        orders.append(order)
        return status

    real = lib.dot_track
    monkeypatch.setattr(lib, "dot_track", dot_track)
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    try:
        with new_tracker() as tracker:
            for i in range(20):
                track(tracker, i % 10, timestamp=i)
    finally:
        sys.setswitchinterval(interval)
    assert ["other", "track"] in orders


def test_two_trackers_in_two_threads():
    frames = [demo.draw(i) for i in range(12)]

    def run(out):
        with new_tracker() as tracker:
            for i, frame in enumerate(frames):
                out.append(tracker.track(*frame, timestamp=demo.SECONDS * i))

    alone, found = [], [[], [], []]
    run(alone)
    threads = [threading.Thread(target=run, args=(out,)) for out in found]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for out in found:
        assert len(out) == len(alone) and all(same(a, b) for a, b in zip(alone, out))


class Handler(logging.Handler):
    """Calls `action` while a call on the tracker is under way: the library logs from within track."""

    def __init__(self, action):
        super().__init__()
        self.action, self.records = action, []

    def emit(self, record):
        self.records.append(record)
        self.action()


def track_without_depth(tracker, action):
    """Its warning that the camera's motion is a guess starts `action`."""
    handler, logger = Handler(action), logging.getLogger("dot_slam")
    logger.addHandler(handler)
    try:
        for i in range(2):
            result = track(tracker, i, depth=np.zeros((demo.HEIGHT, demo.WIDTH), np.float32))
    finally:
        logger.removeHandler(handler)
    return result, handler.records


def in_another_thread(action):
    thread = threading.Thread(target=action)
    thread.start()
    thread.join()


@pytest.mark.parametrize("where", [lambda action: action(), in_another_thread], ids=["same thread", "other thread"])
def test_busy(tracker, where):
    """All calls are refused while one is under way, and it is not disturbed."""
    errors = []

    def attempt():
        for call in (tracker.exclusion_mask, tracker.reset, lambda: track(tracker, 5),
                     lambda: tracker.submit_masks(0, demo.draw(0)[2])):
            try:
                call()
            except Busy as error:
                errors.append(str(error))

    result, records = track_without_depth(tracker, lambda: where(attempt))
    assert errors == ["another call on this tracker has not ended"] * 4
    assert [(r.levelname, r.getMessage()) for r in records] == [
        ("WARNING", "too little depth: the camera's motion is guessed from the frames before")]
    assert result.frame_id == 1 and track(tracker, 2).frame_id == 2


def test_close_waits_for_the_call():
    tracker = new_tracker()
    threads = []

    def close():
        threads.append(threading.Thread(target=tracker.close))
        threads[0].start()
        threads[0].join(0.2)
        assert threads[0].is_alive() and not tracker.closed
        with pytest.raises(Busy):
            tracker.close()  # from within: it would wait for itself

    result, _ = track_without_depth(tracker, close)
    threads[0].join(10)
    assert tracker.closed and result.labels.shape == (demo.HEIGHT, demo.WIDTH)


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timer of signals")
def test_an_interrupt_leaves_the_tracker_usable(tracker):
    """Ctrl-C may come between any two instructions."""

    class Interrupt(Exception):
        pass

    def interrupt(*_):
        raise Interrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        for i in range(1000):
            try:
                signal.setitimer(signal.ITIMER_REAL, 1e-5 * (1 + i % 20))
                while True:
                    tracker.reset()
            except Interrupt:
                pass
            assert not tracker._lock.locked(), f"interrupt {i}"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert track(tracker, 0).frame_id == 0
