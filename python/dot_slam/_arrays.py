# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""numpy arrays as images of the C library, without a copy where its rows allow that.

Int64 ids that fit are converted, float64 depth is rounded to float32; other types are an error. The views point into
the arrays that are returned beside them, which the caller has to keep for as long.
"""

from __future__ import annotations

from typing import Any, Sequence, Tuple

import numpy as np

from . import _library as c
from .errors import invalid

Array = np.ndarray[Any, Any]
ViewOf = Tuple[Array, c.Image]
Shape = Tuple[int, int]  # height, width


def as_array(value: Any, field: str) -> Array:
    if isinstance(value, np.ma.MaskedArray):
        raise invalid(field, "is a masked array: say what its gaps hold, with .filled(0)")
    if value is None:
        raise invalid(field, "is None")
    try:
        return np.asarray(value)
    except (TypeError, ValueError) as error:
        what = "its rows differ in length" if "inhomogeneous" in str(error) else error
        raise invalid(field, f"is no array: {what}") from None


def _describe(array: Array) -> str:
    return f"is {array.dtype} of shape {array.shape}"


def _check_shape(array: Array, shape: Shape, field: str) -> None:
    if array.shape[:2] != shape:
        raise invalid(field, f"has shape {array.shape}, of a camera of {shape[1]}x{shape[0]} it is "
                             f"{shape + array.shape[2:]}: rows first")


def view(array: Array, pixel_format: int) -> ViewOf:
    """Any (h, w) or (h, w, channels). Copied if pixels of a row are not side by side, or not in native byte order."""
    row = array.itemsize * (1 if array.ndim == 2 else array.shape[2])
    packed = array.strides[1] == row and array.strides[-1] == array.itemsize
    if not (packed and array.strides[0] >= row * array.shape[1] and array.strides[0] % array.itemsize == 0
            and array.flags.aligned and array.dtype.isnative):
        # Not np.require: it takes an array of a single row for contiguous, whatever its strides.
        array = np.array(array, array.dtype.newbyteorder("="), order="C")
    return array, c.Image(format=pixel_format, width=array.shape[1], height=array.shape[0],
                          stride_bytes=array.strides[0], data=array.ctypes.data)


def image_view(value: Any, shape: Shape, rgb: bool) -> ViewOf:
    """uint8: (h, w), (h, w, 1), (h, w, 3) or (h, w, 4), whose alpha does not count."""
    array = as_array(value, "image")
    if array.ndim == 3 and array.shape[2] == 1:
        array = array[:, :, 0]
    if array.dtype != np.uint8 or not (array.ndim == 2 or (array.ndim == 3 and array.shape[2] in (3, 4))):
        raise invalid("image", f"{_describe(array)}, must be uint8 of shape (h, w), (h, w, 3) or (h, w, 4)")
    _check_shape(array, shape, "image")
    if array.ndim == 2:
        return view(array, c.GREY8)
    if not rgb:
        return view(array, c.BGR8 if array.shape[2] == 3 else c.BGRA8)
    return view(array[:, :, :3], c.RGB8)


def depth_view(value: Any, shape: Shape, units_per_metre: float | None) -> ViewOf:
    """Floats are metres, taken as float32; uint16 counts units."""
    array = as_array(value, "depth")
    if array.ndim == 3 and array.shape[2] == 1:
        array = array[:, :, 0]
    if array.ndim != 2 or not (array.dtype.kind == "f" or array.dtype.newbyteorder("=") == np.uint16):
        raise invalid("depth", f"{_describe(array)}, must be float in metres or uint16, of shape (h, w)")
    _check_shape(array, shape, "depth")
    if array.dtype.kind == "f":
        with np.errstate(over="ignore"):  # what is no float32 becomes infinite: no measurement
            return view(array.astype(np.float32, copy=False), c.DEPTH_F32)
    if units_per_metre is None:
        raise invalid("depth", "is uint16: make the tracker with depth_units_per_metre, 1000 for millimetres")
    array, image = view(array, c.DEPTH_U16)
    image.depth_units_per_metre = units_per_metre
    return array, image


def id_view(value: Any, shape: Shape, field: str) -> ViewOf:
    """Integers of any type, 0 = background; those that the library does not know become uint32 if they fit."""
    array = as_array(value, field)
    if array.ndim != 2 or array.dtype.kind not in "iu":
        raise invalid(field, f"{_describe(array)}, must be integer ids of shape (h, w); masks of single instances are "
                             "bool of shape (n, h, w)")
    _check_shape(array, shape, field)
    if array.dtype.kind == "i" or array.dtype.itemsize > 4:
        low, high = int(array.min()), int(array.max())
        if low < 0 or high > np.iinfo(np.uint32).max:
            raise invalid(field, f"holds ids from {low} to {high}, must be 0 to 4294967295")
        array = array.astype(np.uint32)
    formats = {1: c.ID8, 2: c.ID16, 4: c.ID32}
    return view(array, formats[array.dtype.itemsize])


def mask_view(value: Any, field: str) -> ViewOf:
    """The mask of one instance, bool or uint8, not zero = object; of any size, see `Instance.x`."""
    array = as_array(value, field)
    if array.ndim != 2 or array.dtype not in (np.bool_, np.uint8):
        raise invalid(field, f"{_describe(array)}, must be bool or uint8 of shape (h, w)")
    return view(array.view(np.uint8), c.GREY8)


def doubles(value: Any, shapes: Sequence[tuple[int, ...]], field: str) -> Array:
    """Numbers of one of these shapes, as contiguous doubles."""
    array = as_array(value, field)
    if array.shape not in shapes or array.dtype.kind not in "fiu":
        raise invalid(field, f"{_describe(array)}, must be numbers of shape {' or '.join(map(str, shapes))}")
    return np.ascontiguousarray(array, np.float64)


def transform(value: Any, field: str) -> Array:
    """A (3, 4), or a (4, 4) of which the last row is dropped."""
    array = doubles(value, [(3, 4), (4, 4)], field)
    if array.shape == (4, 4) and not np.array_equal(array[3], [0, 0, 0, 1]):
        raise invalid(field, f"has the last row {array[3]}, must be 0 0 0 1")
    return array[:3]
