# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""through_ctypes.py LIBRARY MODULE_FOLDER FOLDER: the frames that the program identity wrote into FOLDER, once more
through Python: the same labels and track ids to the last pixel."""

import os
import sys

import numpy as np

library, module_folder, folder = sys.argv[1:]
sys.path.insert(0, module_folder)
from dot_ctypes import DEPTH_STEREO, Camera, Tracker  # noqa: E402

numbers = [float(word) for word in open(os.path.join(folder, "camera.txt"), encoding="ascii").read().split()]
width, height, frames, mask_every = (int(numbers[i]) for i in (4, 5, 8, 9))
fps = numbers[7]
tracker = Tracker(library, Camera(*numbers[:4], width, height, numbers[6]), DEPTH_STEREO)
differing = compared = 0
with open(os.path.join(folder, "frames.bin"), "rb") as file:
    def read(dtype, *shape):
        return np.fromfile(file, dtype, int(np.prod(shape))).reshape(shape)

    for i in range(frames):
        image = read(np.uint8, height, width, 3)
        depth = read(np.uint16, height, width)
        masks = read(np.uint8, height, width)
        labels = tracker.track(i / fps, image, depth, 256, masks if i % mask_every == 0 else None)
        differing += not np.array_equal(labels, read(np.uint8, height, width))
        differing += not np.array_equal(tracker.ids(), read(np.uint32, height, width))
        compared += 2
print(f"{compared} images compared, {differing} differ between C++ and Python")
sys.exit(0 if compared == 2 * frames > 0 and differing == 0 else 1)
