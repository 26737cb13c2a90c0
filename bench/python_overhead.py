#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the Python package adds to dot_track of the C library, in microseconds a frame.

usage: python_overhead.py [SEQ]      needs dot_slam and OpenCV for Python; PYTHONPATH=build/python finds the built one

`dot_track` is timed around its own call, the rest is what remains of Tracker.track. The copies of labels and ids, which
a host in C makes only if it wants them, are timed in the same way. Times are of this thread on its processor.
"""

import statistics
import sys
import time
from pathlib import Path

from dot_slam import Tracker
from dot_slam._library import lib
from dot_slam.sequence import DEPTH_UNITS_PER_METRE, Sequence

RUNS = 20


class Clock:
    """Stands for a function of the library and adds up its time."""

    def __init__(self, name):
        self._function, self.total = getattr(lib, name), 0
        setattr(lib, name, self)

    def __call__(self, *arguments):
        start = time.thread_time_ns()
        status = self._function(*arguments)
        self.total += time.thread_time_ns() - start
        return status

    def take(self):
        total, self.total = self.total, 0
        return total


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1] / "examples/data/mini"
    sequence = Sequence(folder)
    frames = list(sequence)
    calls = {name: Clock(name) for name in ("dot_track", "dot_copy_labels", "dot_copy_ids")}
    rows, dataclasses = [], []
    for run in range(RUNS):
        with Tracker(sequence.camera, depth_source=sequence.depth_source,
                     depth_units_per_metre=DEPTH_UNITS_PER_METRE) as tracker:
            for frame in frames:
                start = time.thread_time_ns()
                result = tracker.track(frame.image, frame.depth, frame.masks, timestamp=frame.timestamp)
                total = time.thread_time_ns() - start
                parts = [call.take() for call in calls.values()]
                if run % 2 == 0:
                    rows.append((parts[0], parts[1] + parts[2], total - sum(parts)))
                    continue
                start = time.thread_time_ns()  # in runs of its own: it leaves other things in the caches
                result.objects, result.camera
                dataclasses.append(time.thread_time_ns() - start)
    track, copies, binding = (statistics.median(column) / 1000 for column in zip(*rows))
    camera = sequence.camera
    print(f"{len(rows)} frames of {camera.width}x{camera.height}, {len(result.table)} objects in the last, medians")
    print(f"dot_track               {track:8.0f} us")
    print(f"copies of labels, ids   {copies:8.0f} us")
    print(f"Python besides          {binding:8.0f} us, {100 * binding / track:.1f} % of dot_track")
    print(f"objects as dataclasses  {statistics.median(dataclasses) / 1000:8.0f} us, if they are asked for")


if __name__ == "__main__":
    main()
