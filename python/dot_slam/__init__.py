# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Finds out which objects move and which are parked, so that a visual SLAM system drops features only where it must.

    from dot_slam import Camera, State, Tracker

    with Tracker(Camera(fx, fy, cx, cy, width, height), depth_source="rgbd", depth_units_per_metre=1000) as tracker:
        for seconds, image, depth, ids in frames:
            result = tracker.track(image, depth, ids, timestamp=seconds)
            moving = result.labels == State.MOVING
            excluded = tracker.exclusion_mask()

`python -m dot_slam --help` runs a recorded sequence. Warnings go to the logger "dot_slam".
"""

from ._library import version as _version
from ._check import Finding, check
from .enums import CameraStatus, Classifier, DepthSource, Reason, State, Suspicion
from .errors import Busy, Closed, Error, InternalError, InvalidArgument, NoResult, OutOfMemory
from .masks import Instance, Masks, MasksLike
from .result import CAMERA_DTYPE, OBJECT_DTYPE, REVISION_DTYPE, CameraResult, CameraRevision, Object, Result
from .tracker import Camera, CameraMotion, Tracker

__version__ = _version()

__all__ = ["CAMERA_DTYPE", "OBJECT_DTYPE", "REVISION_DTYPE", "Busy", "Camera", "CameraMotion", "CameraResult",
           "CameraRevision", "CameraStatus", "Classifier", "Closed", "DepthSource", "Error", "Finding", "Instance",
           "InternalError", "InvalidArgument", "Masks", "MasksLike", "NoResult", "Object", "OutOfMemory", "Reason",
           "Result", "State", "Suspicion", "Tracker", "check"]
