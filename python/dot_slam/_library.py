# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The C library, through ctypes: its structs and functions, as dot/dot.h declares them.

ctypes and not an extension module: nothing is compiled against Python, so one wheel serves every version of it, and
`CDLL` releases the interpreter's lock during each call. The price is some ten microseconds a frame.
"""

from __future__ import annotations

import ctypes
import logging
from ctypes import POINTER, c_char_p, c_double, c_float, c_int32, c_int64, c_uint32, c_uint64, c_void_p
from pathlib import Path
from typing import Any

ABI_VERSION = 0
HEADER_VERSION = 1000  # of dot.h: 1000000 major + 1000 minor + patch
_FILE = f"libdot_capi.so.{ABI_VERSION}"

GREY8, BGR8, RGB8, BGRA8, DEPTH_F32, DEPTH_U16, ID8, ID16, ID32 = range(1, 10)
INSTANCE_ALWAYS_DYNAMIC = 1
OBJECT_ALWAYS_DYNAMIC, OBJECT_SEGMENTED, OBJECT_DISCOVERED = 1, 2, 4
EXCLUDE_NOT_OBSERVABLE, EXCLUDE_STATIC, EXCLUDE_INVERTED = 1, 2, 4


class _Struct(ctypes.Structure):
    def __init__(self, **fields: Any) -> None:
        super().__init__(struct_size=ctypes.sizeof(self), **fields)


class Image(_Struct):
    _fields_ = [("struct_size", c_uint32), ("format", c_uint32), ("width", c_int32), ("height", c_int32),
                ("stride_bytes", c_int64), ("data", c_void_p), ("depth_units_per_metre", c_double)]


class Camera(_Struct):
    _fields_ = [("struct_size", c_uint32), ("width", c_int32), ("height", c_int32), ("reserved", c_uint32),
                ("fx", c_double), ("fy", c_double), ("cx", c_double), ("cy", c_double), ("baseline", c_double)]


class Setting(ctypes.Structure):
    _fields_ = [("name", c_char_p), ("value", c_double)]


class Options(_Struct):
    _fields_ = [("struct_size", c_uint32), ("classifier", c_uint32), ("depth_source", c_uint32),
                ("background_points", c_int32), ("object_points", c_int32), ("setting_count", c_uint32),
                ("settings", POINTER(Setting)), ("v0", c_double), ("stereo_sigma_px", c_double)]


class Instance(_Struct):
    _fields_ = [("struct_size", c_uint32), ("id", c_uint32), ("mask", POINTER(Image)), ("x", c_int32), ("y", c_int32),
                ("class_id", c_int32), ("score", c_float), ("flags", c_uint32), ("reserved", c_uint32)]


class Masks(_Struct):
    _fields_ = [("struct_size", c_uint32), ("instance_count", c_uint32), ("ids", POINTER(Image)),
                ("instances", POINTER(Instance))]


class CameraMotion(_Struct):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("T_cur_prev", c_double * 12),
                ("covariance", c_double * 36)]


class Frame(_Struct):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("id", c_uint64), ("timestamp", c_double),
                ("image", POINTER(Image)), ("depth", POINTER(Image)), ("masks", POINTER(Masks)),
                ("camera_motion", POINTER(CameraMotion)), ("camera_prior", POINTER(c_double))]


class ExclusionPolicy(_Struct):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("dilation", c_int32), ("reserved", c_uint32)]


_LogFunction = ctypes.CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)
_BUFFER = [c_void_p, c_void_p, c_int32, c_int32, c_int64]
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "dot_version": (c_uint32, []),
    "dot_abi_version": (c_uint32, []),
    "dot_options_init": (c_int32, [c_void_p, c_uint32]),
    "dot_create": (c_int32, [c_void_p, c_void_p, c_void_p]),
    "dot_create_error": (c_char_p, []),
    "dot_destroy": (None, [c_void_p]),
    "dot_set_log": (c_int32, [c_void_p, _LogFunction, c_void_p]),
    "dot_reset": (c_int32, [c_void_p]),
    "dot_track": (c_int32, [c_void_p, c_void_p]),
    "dot_label": (c_int32, [c_void_p, c_void_p]),
    "dot_prepare": (c_int32, [c_void_p]),
    "dot_submit_masks": (c_int32, [c_void_p, c_uint64, c_void_p]),
    "dot_object_count": (c_int32, [c_void_p, c_void_p]),
    "dot_get_object": (c_int32, [c_void_p, c_uint32, c_void_p]),
    "dot_get_camera": (c_int32, [c_void_p, c_void_p]),
    "dot_revision_count": (c_int32, [c_void_p, c_void_p]),
    "dot_get_revision": (c_int32, [c_void_p, c_uint32, c_void_p]),
    "dot_copy_labels": (c_int32, _BUFFER),
    "dot_copy_ids": (c_int32, _BUFFER),
    "dot_exclusion_mask": (c_int32, [c_void_p, *_BUFFER]),
    "dot_last_error": (c_char_p, [c_void_p]),
}


def _text(version: int) -> str:
    return f"{version // 1000000}.{version // 1000 % 1000}.{version % 1000}"


def _advice(error: str) -> str:
    """What to do about a library that the dynamic linker does not find: which one it is comes first in its text."""
    if "cannot open shared object file" not in error:
        return ""
    if error.startswith(_FILE):
        return (f". It is neither beside the package nor where the system looks for libraries: install the package with "
                f"pip, or add the folder of {_FILE} to LD_LIBRARY_PATH")
    return (". The C library is there, but it needs that one: install OpenCV's core and imgproc, of the version that it "
            "was built with, and the C++ runtime")


def _load() -> ctypes.CDLL:
    """The library beside this file, where a wheel has it; else the one that the dynamic linker finds."""
    bundled = Path(__file__).with_name(_FILE)
    try:
        library = ctypes.CDLL(str(bundled) if bundled.exists() else _FILE)
    except OSError as error:
        raise ImportError(f"dot_slam cannot load its C library: {error}{_advice(str(error))}") from error
    for name, (result, arguments) in FUNCTIONS.items():
        function = getattr(library, name, None)
        if function is None:
            raise ImportError(f"the C library has no {name}: it is older than dot_slam")
        function.restype, function.argtypes = result, arguments
    found = library.dot_abi_version()
    if found != ABI_VERSION:
        raise ImportError(f"the C library has the binary interface {found}, dot_slam needs {ABI_VERSION}")
    if library.dot_version() < HEADER_VERSION:  # its structs may lack fields
        raise ImportError(f"the C library has the version {_text(library.dot_version())}, dot_slam needs "
                          f"{_text(HEADER_VERSION)} or a later one")
    return library


lib = _load()

_logger = logging.getLogger("dot_slam")
_logger.addHandler(logging.NullHandler())
_LEVELS = {2: logging.WARNING, 3: logging.INFO}  # errors, level 1, are raised


def _log(_: Any, level: int, text: bytes) -> None:
    if level in _LEVELS:
        _logger.log(_LEVELS[level], text.decode(errors="replace"))


log_function = _LogFunction(_log)


def version() -> str:
    return _text(lib.dot_version())
