# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""tasks.py EXAMPLE_FOLDER: the Python of docs/tasks.md on the frames of the example."""

import sys

sys.path.insert(0, sys.argv[1])
from demo import CAMERA, MILLIMETRES, draw  # noqa: E402
from dot_slam import Tracker  # noqa: E402

tracker = Tracker(CAMERA, depth_source="rgbd", depth_units_per_metre=MILLIMETRES)
tracker.track(*draw(0), timestamp=0)
# snippet: task_exclude_python
# end of snippet
assert (exclude[100, 60], use[100, 60]) == (255, 0), "an object that is not decided yet"
assert (exclude[10, 10], use[10, 10]) == (0, 255), "the wall"
