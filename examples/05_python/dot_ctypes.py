# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The C library of dot for numpy, through ctypes: nothing to compile, nothing but the shared library to install.

    tracker = Tracker("libdot_capi.so.0", Camera(fx, fy, cx, cy, width, height, baseline))
    labels = tracker.track(seconds, image, depth, units_per_metre=1000, ids=ids)

The structs are those of dot/dot.h, field by field; a newer library takes them as they are. One thread at a time may use
a tracker. ctypes lets other threads of Python run during a call.
"""

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_float, c_int32, c_int64, c_uint32, c_uint64, c_void_p
from dataclasses import dataclass

import numpy as np

ABI_VERSION = 0
GREY8, BGR8, DEPTH_F32, DEPTH_U16, ID8, ID16, ID32 = 1, 2, 5, 6, 7, 8, 9
DEPTH_UNKNOWN, DEPTH_STEREO, DEPTH_RGBD, DEPTH_LIDAR = range(4)
BACKGROUND, STATIC, MOVING, NOT_OBSERVABLE = range(4)


class _Struct(ctypes.Structure):
    def __init__(self, **fields):
        super().__init__(struct_size=ctypes.sizeof(self), **fields)


class _Image(_Struct):
    _fields_ = [("struct_size", c_uint32), ("format", c_uint32), ("width", c_int32), ("height", c_int32),
                ("stride_bytes", c_int64), ("data", c_void_p), ("depth_units_per_metre", c_double)]


class _Camera(_Struct):
    _fields_ = [("struct_size", c_uint32), ("width", c_int32), ("height", c_int32), ("reserved", c_uint32),
                ("fx", c_double), ("fy", c_double), ("cx", c_double), ("cy", c_double), ("baseline", c_double)]


class _Options(_Struct):
    _fields_ = [("struct_size", c_uint32), ("classifier", c_uint32), ("depth_source", c_uint32),
                ("background_points", c_int32), ("object_points", c_int32), ("setting_count", c_uint32),
                ("settings", c_void_p), ("v0", c_double), ("stereo_sigma_px", c_double)]


class _Masks(_Struct):
    _fields_ = [("struct_size", c_uint32), ("instance_count", c_uint32), ("ids", POINTER(_Image)),
                ("instances", c_void_p)]


class _Frame(_Struct):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("id", c_uint64), ("timestamp", c_double),
                ("image", POINTER(_Image)), ("depth", POINTER(_Image)), ("masks", POINTER(_Masks)),
                ("camera_motion", c_void_p)]


class Object(_Struct):
    """One object in one frame; see dot_object in dot/dot.h for units and axes."""

    _fields_ = [("struct_size", c_uint32), ("id", c_uint32), ("state", c_uint32), ("reason", c_uint32),
                ("last_decided", c_uint32), ("flags", c_uint32), ("instance_id", c_uint32), ("class_id", c_int32),
                ("score", c_float), ("area", c_int32), ("box", c_int32 * 4), ("n_points", c_int32),
                ("n_inliers", c_int32), ("p_moving", c_double), ("T_o", c_double * 12), ("covariance", c_double * 36),
                ("velocity", c_double * 3), ("velocity_covariance", c_double * 9), ("speed", c_double),
                ("phi", c_double), ("disparity_px", c_double), ("disparity_noise_px", c_double),
                ("entropy", c_double), ("range", c_double), ("interval", c_double),
                ("fused_velocity", c_double * 3), ("fused_covariance", c_double * 9)]


@dataclass
class Camera:
    """A rectified pinhole camera: pixels, and metres for the baseline (0: the depth is not from stereo)."""

    fx: float
    fy: float
    cx: float
    cy: float
    width: int
    height: int
    baseline: float = 0


class Error(RuntimeError):
    """What the library says is wrong; the text names the field."""


class Tracker:
    def __init__(self, library, camera, depth_source=DEPTH_UNKNOWN):
        self._handle = None
        self._dll = ctypes.CDLL(library)
        self._declare()
        if self._dll.dot_abi_version() != ABI_VERSION:
            raise Error(f"{library} has the binary interface {self._dll.dot_abi_version()}, this file {ABI_VERSION}")
        options = _Options()
        self._check_plain(self._dll.dot_options_init(ctypes.byref(options), ctypes.sizeof(options)))
        options.depth_source = depth_source
        handle = c_void_p()
        self._check_plain(self._dll.dot_create(ctypes.byref(_Camera(**vars(camera))), ctypes.byref(options),
                                               ctypes.byref(handle)))
        self._handle = handle
        self._shape = (camera.height, camera.width)
        self._frames = 0

    def __del__(self):
        if self._handle:
            self._dll.dot_destroy(self._handle)

    def track(self, timestamp, image, depth, units_per_metre=1000, ids=None):
        """Labels one frame: an array of BACKGROUND, STATIC, MOVING and NOT_OBSERVABLE, the caller's to keep.

        timestamp: seconds, strictly increasing. image: uint8, (h, w), or (h, w, 3) with blue first. depth: float32 in
        metres, or uint16 in units_per_metre; 0 = no measurement. ids: uint8, uint16 or uint32 instances, 0 =
        background; None: no segmentation came with this frame.
        """
        # Arrays and structs live to the end of this function, and the library keeps none of them for longer.
        image, image_view = self._view(image, {(np.uint8, 2): GREY8, (np.uint8, 3): BGR8}, "image")
        depth, depth_view = self._view(depth, {(np.float32, 2): DEPTH_F32, (np.uint16, 2): DEPTH_U16}, "depth")
        depth_view.depth_units_per_metre = units_per_metre
        frame = _Frame(id=self._frames, timestamp=timestamp, image=ctypes.pointer(image_view),
                       depth=ctypes.pointer(depth_view))
        if ids is not None:
            formats = {(np.uint8, 2): ID8, (np.uint16, 2): ID16, (np.uint32, 2): ID32}
            ids, ids_view = self._view(ids, formats, "ids")
            frame.masks = ctypes.pointer(_Masks(ids=ctypes.pointer(ids_view)))
        self._check(self._dll.dot_track(self._handle, ctypes.byref(frame)))
        self._frames += 1
        return self._filled(self._dll.dot_copy_labels, np.uint8)

    def ids(self):
        """The track id of each pixel of the last frame, 0 = background; stable over time, unlike those handed in."""
        return self._filled(self._dll.dot_copy_ids, np.uint32)

    def exclusion_mask(self):
        """Of the last frame: 255 = take no features here, 0 = use it; invert it for OpenCV's detectors."""
        out = np.empty(self._shape, np.uint8)
        self._check(self._dll.dot_exclusion_mask(self._handle, None, out.ctypes.data, out.shape[1], out.shape[0],
                                                 out.strides[0]))
        return out

    def objects(self):
        """All objects of the last frame."""
        count = c_uint32()
        self._check(self._dll.dot_object_count(self._handle, ctypes.byref(count)))
        found = [Object() for _ in range(count.value)]
        for i, item in enumerate(found):
            self._check(self._dll.dot_get_object(self._handle, i, ctypes.byref(item)))
        return found

    def _declare(self):
        buffer = [c_void_p, c_void_p, c_int32, c_int32, c_int64]
        for name, result, arguments in (
                ("dot_abi_version", c_uint32, []),
                ("dot_options_init", c_int32, [c_void_p, c_uint32]),
                ("dot_create", c_int32, [c_void_p, c_void_p, c_void_p]),
                ("dot_create_error", c_char_p, []),
                ("dot_destroy", None, [c_void_p]),
                ("dot_track", c_int32, [c_void_p, c_void_p]),
                ("dot_object_count", c_int32, [c_void_p, c_void_p]),
                ("dot_get_object", c_int32, [c_void_p, c_uint32, c_void_p]),
                ("dot_copy_labels", c_int32, buffer),
                ("dot_copy_ids", c_int32, buffer),
                ("dot_exclusion_mask", c_int32, [c_void_p] + buffer),
                ("dot_last_error", c_char_p, [c_void_p])):
            function = getattr(self._dll, name)
            function.restype, function.argtypes = result, arguments

    def _view(self, array, formats, name):
        array = np.ascontiguousarray(array)
        pixel_format = formats.get((array.dtype.type, array.ndim))
        if pixel_format is None or (array.ndim == 3 and array.shape[2] != 3):
            raise Error(f"{name} is {array.dtype} of shape {array.shape}")
        return array, _Image(format=pixel_format, width=array.shape[1], height=array.shape[0],
                             stride_bytes=array.strides[0], data=array.ctypes.data)

    def _filled(self, function, dtype):
        out = np.empty(self._shape, dtype)
        self._check(function(self._handle, out.ctypes.data, out.shape[1], out.shape[0], out.strides[0]))
        return out

    def _check(self, status):
        if status != 0:
            raise Error(self._dll.dot_last_error(self._handle).decode())

    def _check_plain(self, status):
        if status != 0:
            raise Error(self._dll.dot_create_error().decode())
