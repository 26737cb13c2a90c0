# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What a frame comes to.

Axes x right, y down, z forward; metres, radians, seconds. `T_a_b` maps coordinates of b into a. A static point at X in
the previous camera is at T_cur_prev X in this one, a point of an object at T_cur_prev T_o X. A twist is
[translation; rotation].
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, Type, TypeVar

import numpy as np
import numpy.typing as npt

from . import _library as c
from .enums import CameraStatus, Reason, State, Suspicion

Floats = npt.NDArray[np.float64]

# dot_object, dot_camera_result and dot_camera_revision of dot/dot.h, field by field.
OBJECT_DTYPE = np.dtype(
    [("struct_size", "u4"), ("id", "u4"), ("state", "u4"), ("reason", "u4"), ("last_decided", "u4"), ("flags", "u4"),
     ("instance_id", "u4"), ("class_id", "i4"), ("score", "f4"), ("area", "i4"), ("box", "i4", 4), ("n_points", "i4"),
     ("n_inliers", "i4"), ("p_moving", "f8"), ("T_o", "f8", (3, 4)), ("covariance", "f8", (6, 6)),
     ("velocity", "f8", 3), ("velocity_covariance", "f8", (3, 3)), ("speed", "f8"), ("phi", "f8"),
     ("disparity_px", "f8"), ("disparity_noise_px", "f8"), ("entropy", "f8"), ("range", "f8"), ("interval", "f8"),
     ("fused_velocity", "f8", 3), ("fused_covariance", "f8", (3, 3)), ("angular_velocity", "f8", 3),
     ("angular_covariance", "f8", (3, 3)), ("point_speed", "f8"), ("point_speed_sigma", "f8")], align=True)
CAMERA_DTYPE = np.dtype(
    [("struct_size", "u4"), ("status", "u4"), ("n_points", "i4"), ("n_inliers", "i4"), ("frame_id", "u8"),
     ("timestamp", "f8"), ("interval", "f8"), ("T_cur_prev", "f8", (3, 4)), ("covariance", "f8", (6, 6)),
     ("phi", "f8"), ("gain", "f8"), ("offset", "f8"), ("residual_sigma", "f8"), ("normalised_variance", "f8"),
     ("masked_share", "f8"), ("small_instances", "i4"), ("reserved", "u4"), ("suspicion_figure", "f8"),
     ("suspicion", "u4"), ("reserved2", "u4")], align=True)
REVISION_DTYPE = np.dtype(
    [("struct_size", "u4"), ("reserved", "u4"), ("frame_id", "u8"), ("timestamp", "f8"), ("T_cur_prev", "f8", (3, 4)),
     ("covariance", "f8", (6, 6))], align=True)


@dataclass(frozen=True, eq=False, repr=False)
class CameraResult:
    """The camera's motion over the last interval."""

    status: CameraStatus
    frame_id: int
    timestamp: float
    interval: float  # seconds since the previous frame, 0 if there is no reference
    T_cur_prev: Floats  # (3, 4)
    covariance: Floats  # (6, 6), of the left twist, metres and radians
    n_points: int  # background points inside the image
    n_inliers: int
    phi: float  # Pearson correlation of reference and tracked intensities
    gain: float  # I_cur = gain I_prev + offset
    offset: float  # grey values
    residual_sigma: float  # grey values, robust
    normalised_variance: float  # of the residuals over their predicted sigma; near 1 if consistent
    masked_share: float  # 0 to 1: share of the image that the default policy excludes, without dilation
    small_instances: int  # masks of this frame without a track, too small to start one (mask.min_pixels)
    suspicion: Suspicion  # what may be wrong with the last frames' images, depth and times
    suspicion_figure: float  # its size; see Suspicion

    def __repr__(self) -> str:
        return (f"<CameraResult of frame {self.frame_id}: {self.status.name}, {self.n_inliers} of {self.n_points} "
                f"points{_suspected(self)}>")


@dataclass(frozen=True, eq=False, repr=False)
class CameraRevision:
    """An earlier motion of the camera that was wrong, and the right one. Who has used it should use this instead."""

    frame_id: int  # of the frame that the motion led to
    timestamp: float  # of that frame, seconds
    T_cur_prev: Floats  # (3, 4), from the frame before that one to it: replaces what was reported then
    covariance: Floats  # (6, 6), of its left twist, metres and radians

    def __repr__(self) -> str:
        return f"<CameraRevision of frame {self.frame_id}>"


@dataclass(frozen=True, eq=False, repr=False)
class Object:
    """One object in one frame."""

    id: int  # of the track, never reused by its tracker
    state: State
    reason: Reason  # why it has no motion estimate in this frame; NONE: it has one
    last_decided: State  # last state that was STATIC or MOVING; NOT_OBSERVABLE if there was none
    segmented: bool  # an instance of this frame's masks was associated: instance_id
    always_dynamic: bool  # flagged by the caller
    discovered: bool  # found by its motion (option discover_unknown); no instance was associated so far
    instance_id: int  # Instance.id, or the value in the id image; if `segmented`
    class_id: int  # of the last instance associated
    score: float  # likewise
    area: int  # visible label pixels
    box: tuple[int, int, int, int]  # x, y, width, height of the visible label pixels; zeros if there are none
    n_points: int  # points inside the image
    n_inliers: int
    p_moving: float  # belief after this frame

    # The single fit of this frame. Valid if `reason` is NONE.
    T_o: Floats  # (3, 4), previous camera's axes
    covariance: Floats  # (6, 6), of T_o: twist about the centroid, photometric part only
    velocity: Floats  # (3,), of the centroid, m/s, previous camera's axes
    velocity_covariance: Floats  # (3, 3), includes the errors of camera and depth
    speed: float  # m/s
    phi: float  # Pearson correlation
    disparity_px: float  # median pixel distance between the points moved by T_c and by T_c T_o
    disparity_noise_px: float  # the part of that due to the covariance
    entropy: float  # of the pose, nats
    range: float  # depth of the centroid, metres
    interval: float  # seconds that velocity spans; T_o is of the last interval

    # Fused over time.
    fused_velocity: Floats  # (3,), m/s, this camera's axes
    fused_covariance: Floats  # (3, 3); zeros if nothing was fused yet

    # The single fit of this frame, continued.
    angular_velocity: Floats  # (3,), rad/s, previous camera's axes
    angular_covariance: Floats  # (3, 3)
    point_speed: float  # m/s, of the object's points, turning included: root of the mean square
    point_speed_sigma: float  # m/s, of the points' velocities: root of the mean trace of their covariances

    def __repr__(self) -> str:
        fit = f"{self.speed:.2f} m/s" if self.reason == Reason.NONE else f"no motion: {self.reason.name}"
        return f"<Object {self.id}: {self.state.name}, P(moving) {self.p_moving:.2f}, {fit}, {self.area} pixels>"


def _suspected(camera: CameraResult) -> str:
    return f", suspicion {camera.suspicion.name} ({camera.suspicion_figure:.3g})" if camera.suspicion else ""


_FLAGS = {"segmented": c.OBJECT_SEGMENTED, "always_dynamic": c.OBJECT_ALWAYS_DYNAMIC,
          "discovered": c.OBJECT_DISCOVERED}
_ENUMS: dict[tuple[type, str], Any] = {(Object, "state"): State, (Object, "last_decided"): State,
                                       (Object, "reason"): Reason, (CameraResult, "status"): CameraStatus,
                                       (CameraResult, "suspicion"): Suspicion}
_T = TypeVar("_T", Object, CameraResult, CameraRevision)


def _from_row(kind: Type[_T], row: np.void) -> _T:
    def convert(name: str) -> Any:
        if name in _FLAGS:
            return bool(row["flags"] & _FLAGS[name])
        value = row[name]
        if name == "box":
            return tuple(value.tolist())
        if isinstance(value, np.ndarray):
            return value.copy()  # for a field of arrays numpy gives a view of the row
        return _ENUMS.get((kind, name), lambda number: number)(value.item())

    return kind(**{field.name: convert(field.name) for field in fields(kind)})


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """Of one frame. All arrays are copies: the caller's to keep and to change, whatever becomes of the tracker."""

    labels: npt.NDArray[np.uint8]  # (h, w), a State a pixel
    ids: npt.NDArray[np.uint32]  # (h, w), track id a pixel, 0 = background; stable over time
    table: npt.NDArray[np.void]  # (n,) of OBJECT_DTYPE: all objects, also without pixels, and those just dropped
    _camera: npt.NDArray[np.void]
    _revised: npt.NDArray[np.void]

    @cached_property
    def objects(self) -> tuple[Object, ...]:
        """The rows of `table`."""
        return tuple(_from_row(Object, row) for row in self.table)

    @cached_property
    def camera(self) -> CameraResult:
        return _from_row(CameraResult, self._camera[0])

    @cached_property
    def revised(self) -> tuple[CameraRevision, ...]:
        """Earlier frames whose camera motion this frame proved to be wrong, the oldest first; mostly empty."""
        return tuple(_from_row(CameraRevision, row) for row in self._revised)

    @property
    def frame_id(self) -> int:
        return int(self._camera["frame_id"][0])

    @property
    def timestamp(self) -> float:
        return float(self._camera["timestamp"][0])

    def __repr__(self) -> str:
        """In a line: the arrays would fill pages. Counts the objects that have pixels in this frame."""
        states = self.table["state"][self.table["area"] > 0].tolist()
        counts = ", ".join(f"{states.count(state)} {state.name.lower().replace('_', ' ')}"
                           for state in (State.MOVING, State.STATIC, State.NOT_OBSERVABLE))
        return (f"<Result of frame {self.frame_id} at {self.timestamp:.16g} s: camera {self.camera.status.name}, "
                f"objects {counts}{_suspected(self.camera)}>")

    def find(self, id: int) -> Object | None:
        """The object with this track id."""
        return next((item for item in self.objects if item.id == id), None)
