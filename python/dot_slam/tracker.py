# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The tracker itself."""

from __future__ import annotations

import ctypes
import threading
import weakref
from collections import abc
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Mapping, NoReturn, Type

import numpy as np
import numpy.typing as npt

from . import _arrays, errors
from . import _library as c
from ._library import lib
from ._numbers import in_range, number, whole
from .enums import Classifier, DepthSource
from .errors import InvalidArgument, invalid
from .masks import MasksLike, MaskViews
from .result import CAMERA_DTYPE, OBJECT_DTYPE, REVISION_DTYPE, Result


@dataclass(frozen=True)
class Camera:
    """A rectified pinhole camera. Pixel centres are at whole numbers."""

    fx: float  # pixels
    fy: float
    cx: float
    cy: float
    width: int  # pixels
    height: int
    baseline: float = 0.0  # metres; 0 if the depth does not come from stereo


@dataclass(frozen=True, eq=False)
class CameraMotion:
    """A camera motion that the host knows better than the tracker."""

    T_cur_prev: npt.ArrayLike  # (3, 4) or (4, 4): a static point at X in the previous camera is at T_cur_prev X in this
    covariance: npt.ArrayLike  # (6, 6), of the left twist [translation; rotation], metres and radians


class Tracker:
    """Tells frame by frame which objects move.

    camera: of all frames.
    depth_source: "stereo", "rgbd", "lidar" or "unknown", the form of the depth's noise.
    classifier: "velocity", "entropy" or "entropy_literal".
    options: further settings by name, {"velocity.v0": 1.0}; see dot/pipeline/options.hpp.
    colour: "bgr" (as OpenCV reads) or "rgb", the order of images with colours.
    depth_units_per_metre: of uint16 depth; 1000 for RGB-D cameras, 256 for KITTI files.

    Trackers are independent: each thread may have its own, and they run at the same time, because calls release the
    interpreter's lock. A call during another call on the same tracker raises Busy. `with` closes it at the end; one
    that nobody holds any more is closed as well.
    """

    def __init__(self, camera: Camera, *, depth_source: str | DepthSource = "unknown",
                 classifier: str | Classifier = "velocity", options: Mapping[str, float] | None = None,
                 colour: str = "bgr", depth_units_per_metre: float | None = None) -> None:
        if colour not in ("bgr", "rgb"):
            raise invalid("colour", f"is {colour!r}, must be 'bgr' or 'rgb'")
        self._units = None if depth_units_per_metre is None else in_range(depth_units_per_metre, 1e-3, 1e7,
                                                                          "depth_units_per_metre")
        c_options = c.Options()
        self._check_create(lib.dot_options_init(ctypes.byref(c_options), ctypes.sizeof(c_options)))
        c_options.depth_source = _named(DepthSource, depth_source, "depth_source")
        c_options.classifier = _named(Classifier, classifier, "classifier")
        settings = _c_settings({} if options is None else options)
        if settings:
            c_options.setting_count = len(settings)
            c_options.settings = (c.Setting * len(settings))(*settings)

        handle = ctypes.c_void_p()
        self._check_create(lib.dot_create(ctypes.byref(_c_camera(camera)), ctypes.byref(c_options),
                                          ctypes.byref(handle)))
        self._lock = threading.Lock()
        self._owner = 0  # the thread of the last call
        self._handle = handle
        self._destroy = weakref.finalize(self, lib.dot_destroy, handle)
        self._destroy.atexit = False  # a thread may still be at work, and memory goes back anyway
        self._camera = camera
        self._shape = (int(camera.height), int(camera.width))
        self._rgb = colour == "rgb"
        self._next_id = 0
        self._check(lib.dot_set_log(handle, c.log_function, None))

    @property
    def camera(self) -> Camera:
        return self._camera

    def track(self, image: npt.ArrayLike, depth: npt.ArrayLike, masks: MasksLike | None = None, *, timestamp: float,
              frame_id: int | None = None, camera_motion: CameraMotion | None = None,
              camera_prior: npt.ArrayLike | None = None) -> Result:
        """Labels one frame.

        image: uint8, (h, w), (h, w, 3) or (h, w, 4).
        depth: (h, w), floats in metres or uint16 in units; zero, negative, NaN, infinite, or 65535 of uint16 =
            no measurement.
        masks: integer ids of shape (h, w), 0 = background; or bool of shape (n, h, w); or a list of Instance; or Masks;
        None = no segmentation for this frame, or not yet.
        timestamp: seconds, strictly increasing.
        frame_id: the caller's number of the frame, for submit_masks; None = one more than the last.
        camera_motion: None = estimated from the image.
        camera_prior: T_cur_prev, (3, 4) or (4, 4), from which that estimate starts.

        Arrays are read where they lie if their rows are packed, else copied; nobody may write to them during the call.
        Raises InvalidArgument, after which the tracker is as it was; Busy, Closed, OutOfMemory, InternalError.
        """
        return self._run(lib.dot_track, image, depth, masks, timestamp, frame_id, camera_motion, camera_prior)

    def label(self, image: npt.ArrayLike, depth: npt.ArrayLike, masks: MasksLike | None = None, *, timestamp: float,
              frame_id: int | None = None, camera_motion: CameraMotion | None = None,
              camera_prior: npt.ArrayLike | None = None) -> Result:
        """track in two steps: returns as soon as the labels are ready. prepare, or the next frame, does the rest.

        Its camera.suspicion is not known yet, and stays NONE in this result.
        """
        return self._run(lib.dot_label, image, depth, masks, timestamp, frame_id, camera_motion, camera_prior)

    def prepare(self) -> None:
        """Prepares for the next frame what label left: points of the new one. Does nothing if all is prepared."""
        self._refuse_if_busy()
        with self._lock:
            handle = self._begin()
            self._check(lib.dot_prepare(handle))

    def submit_masks(self, frame_id: int, masks: MasksLike) -> None:
        """Takes masks that arrive late, for an earlier frame that was tracked without; the next result shows them.

        Masks come in the order of their frames, at most a second late (option mask.late_seconds).
        """
        if masks is None:
            raise invalid("masks", "is None; for a network that found nothing use []")
        views = MaskViews(masks, self._shape)
        id = _frame_id(frame_id)
        self._refuse_if_busy()
        with self._lock:
            handle = self._begin()
            self._check(lib.dot_submit_masks(handle, id, ctypes.byref(views.struct)))

    def exclusion_mask(self, *, not_observable: bool = True, static: bool = False, dilation: int = 2,
                       inverted: bool = False) -> npt.NDArray[np.uint8]:
        """Where a feature extractor must not look, in the last frame: 255 = do not use this pixel, 0 = use it.

        Moving objects are always excluded. not_observable: objects that were never decided, too. static: static ones,
        too. dilation: pixels by which the area is widened. inverted: 0 = do not use, 255 = use, as OpenCV's detectors
        take it. The array is the caller's.
        """
        pixels = whole(dilation, 0, 2**31 - 1, "dilation")
        policy = c.ExclusionPolicy(dilation=pixels, flags=(c.EXCLUDE_NOT_OBSERVABLE if not_observable else 0)
                                   | (c.EXCLUDE_STATIC if static else 0) | (c.EXCLUDE_INVERTED if inverted else 0))
        out = np.empty(self._shape, np.uint8)
        self._refuse_if_busy()
        with self._lock:
            handle = self._begin()
            self._check(lib.dot_exclusion_mask(handle, ctypes.byref(policy), *_buffer(out)))
        return out

    def reset(self) -> None:
        """Forgets all frames and objects. Ids are not used again."""
        self._refuse_if_busy()
        with self._lock:
            handle = self._begin()
            self._check(lib.dot_reset(handle))

    def close(self) -> None:
        """Frees the tracker, after a call on another thread has ended. Calling it again does nothing."""
        if self._lock.locked() and self._owner == threading.get_ident():
            raise errors.Busy("close was called from within a call on this tracker")
        with self._lock:
            self._destroy()

    @property
    def closed(self) -> bool:
        return not self._destroy.alive

    def __enter__(self) -> Tracker:
        return self

    def __exit__(self, kind: Type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Tracker cannot be copied or pickled")

    # What follows dot_track must still be of its frame, so a lock is held for the whole call. It is taken by `with
    # self._lock` alone: an interrupt from the keyboard inside a function that takes it would leave it taken.

    def _refuse_if_busy(self) -> None:
        if self._lock.locked():
            raise errors.Busy("another call on this tracker has not ended")

    def _begin(self) -> ctypes.c_void_p:
        self._owner = threading.get_ident()
        if self.closed:
            raise errors.Closed("the tracker is closed")
        return self._handle

    def _run(self, call: abc.Callable[..., int], image: npt.ArrayLike, depth: npt.ArrayLike, masks: MasksLike | None,
             timestamp: float, frame_id: int | None, camera_motion: CameraMotion | None,
             camera_prior: npt.ArrayLike | None) -> Result:
        image_array, image_view = _arrays.image_view(image, self._shape, self._rgb)
        depth_array, depth_view = _arrays.depth_view(depth, self._shape, self._units)
        id = _frame_id(self._next_id if frame_id is None else frame_id)
        frame = c.Frame(id=id, timestamp=number(timestamp, "timestamp"), image=ctypes.pointer(image_view),
                        depth=ctypes.pointer(depth_view))
        if masks is not None:
            views = MaskViews(masks, self._shape)
            frame.masks = ctypes.pointer(views.struct)
        if camera_motion is not None:
            frame.camera_motion = ctypes.pointer(_c_motion(camera_motion))
        if camera_prior is not None:
            prior = _arrays.transform(camera_prior, "camera_prior")
            frame.camera_prior = prior.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
        self._refuse_if_busy()
        with self._lock:
            handle = self._begin()
            self._check(call(handle, ctypes.byref(frame)))
            self._next_id = id + 1
            return self._result(handle)

    def _result(self, handle: ctypes.c_void_p) -> Result:
        labels = np.empty(self._shape, np.uint8)
        ids = np.empty(self._shape, np.uint32)
        camera = np.zeros(1, CAMERA_DTYPE)
        camera["struct_size"] = CAMERA_DTYPE.itemsize
        count = ctypes.c_uint32()
        self._check(lib.dot_copy_labels(handle, *_buffer(labels)))
        self._check(lib.dot_copy_ids(handle, *_buffer(ids)))
        self._check(lib.dot_get_camera(handle, camera.ctypes.data))
        self._check(lib.dot_object_count(handle, ctypes.byref(count)))
        table = self._rows(handle, lib.dot_get_object, count.value, OBJECT_DTYPE)
        self._check(lib.dot_revision_count(handle, ctypes.byref(count)))
        revised = self._rows(handle, lib.dot_get_revision, count.value, REVISION_DTYPE)
        return Result(labels, ids, table, camera, revised)

    def _rows(self, handle: ctypes.c_void_p, get: Any, count: int, dtype: np.dtype[np.void]) -> npt.NDArray[np.void]:
        rows = np.zeros(count, dtype)
        rows["struct_size"] = dtype.itemsize
        place = rows.ctypes.data
        for i in range(count):
            self._check(get(handle, i, place + i * dtype.itemsize))
        return rows

    def _check(self, status: int) -> None:
        if status != 0:
            raise errors.from_library(status, lib.dot_last_error(self._handle).decode(errors="replace"))

    @staticmethod
    def _check_create(status: int) -> None:
        if status != 0:
            raise errors.from_library(status, lib.dot_create_error().decode(errors="replace"))


def _buffer(array: npt.NDArray[Any]) -> tuple[int, int, int, int]:
    return array.ctypes.data, array.shape[1], array.shape[0], array.strides[0]


def _frame_id(value: Any) -> int:
    return whole(value, 0, 2**64 - 1, "frame_id")


def _named(kind: Any, value: Any, field: str) -> int:
    if isinstance(value, kind):
        return int(value)
    names = {item.name.lower(): int(item) for item in kind}
    if not isinstance(value, str) or value not in names:
        raise invalid(field, f"is {value!r}, must be one of {', '.join(names)}")
    return names[value]


def _c_camera(camera: Camera) -> c.Camera:
    if not isinstance(camera, Camera):
        raise invalid("camera", f"is {type(camera).__name__}, must be dot_slam.Camera")
    sizes = {name: whole(getattr(camera, name), 1, 2**31 - 1, f"camera.{name}") for name in ("width", "height")}
    numbers = {name: number(getattr(camera, name), f"camera.{name}") for name in ("fx", "fy", "cx", "cy", "baseline")}
    return c.Camera(**sizes, **numbers)


def _c_settings(options: Mapping[str, float]) -> list[c.Setting]:
    if not isinstance(options, abc.Mapping):
        raise invalid("options", f"is {type(options).__name__}, must be a dict of names and numbers")
    settings = []
    for name, value in options.items():
        if not isinstance(name, str) or not name.isascii() or "\0" in name:
            raise invalid("options", f"has the name {name!r}, must be text in ASCII")
        settings.append(c.Setting(name.encode(), number(value, name)))
    return settings


def _c_motion(motion: CameraMotion) -> c.CameraMotion:
    if not isinstance(motion, CameraMotion):
        raise InvalidArgument("camera_motion", f"camera_motion is {type(motion).__name__}, must be CameraMotion")
    T = _arrays.transform(motion.T_cur_prev, "camera_motion.T_cur_prev")
    covariance = _arrays.doubles(motion.covariance, [(6, 6)], "camera_motion.covariance")
    out = c.CameraMotion()
    out.T_cur_prev[:] = T.ravel().tolist()
    out.covariance[:] = covariance.ravel().tolist()
    return out
