# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""package.py EXAMPLE_FOLDER: the Python of python/README.md on the frames of the example."""

import sys

sys.path.insert(0, sys.argv[1])
from demo import CAMERA, FOCAL, HEIGHT, WIDTH, draw  # noqa: E402

fx = fy = FOCAL
cx, cy, width, height = CAMERA.cx, CAMERA.cy, WIDTH, HEIGHT
frames = [(0.1 * i, *draw(i)) for i in range(10)]
# snippet: package_readme
# end of snippet
slid = 170 + 4 * 9 + 40
assert moving[120, slid] and not moving[120, 80] and not moving[20, 20]
