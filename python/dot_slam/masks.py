# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What a segmentation network found in a frame, in any of the forms in which networks give it."""

from __future__ import annotations

import ctypes
from collections import abc
from dataclasses import dataclass
from typing import Any, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _arrays
from . import _library as c
from ._numbers import in_range, whole
from .errors import InvalidArgument, invalid


@dataclass(frozen=True, eq=False)
class Instance:
    """One instance. Instances may overlap. Boxes are cut to the objects in them, by depth."""

    id: int  # 1 to 2^32 - 1, the caller's; need not be stable from frame to frame
    mask: npt.ArrayLike | None = None  # bool or uint8, (h, w) of its own; None: the pixels of Masks.ids that equal `id`
    x: int = 0  # pixels: place of the mask's top left corner in the frame
    y: int = 0
    class_id: int = -1  # the caller's, -1 = unknown
    score: float = 1.0  # -1e6 to 1e6
    always_dynamic: bool = False  # people and other non-rigid objects: always reported as moving


@dataclass(frozen=True, eq=False)
class Masks:
    """An id image, or instances, or an id image with instances that tell class and score of some of its ids.

    Without either: the network ran and found nothing.
    """

    ids: npt.ArrayLike | None = None  # integers, (h, w) as the frame, 0 = background
    instances: Sequence[Instance] = ()


# An array is an id image (integers, (h, w)) or a stack of masks (bool, (n, h, w)), of which number i gets the id i + 1.
MasksLike = Union[Masks, Sequence[Instance], npt.NDArray[Any]]


class MaskViews:
    """Masks as the C library takes them; owns all that they point to."""

    def __init__(self, masks: MasksLike, shape: _arrays.Shape) -> None:
        masks = _as_masks(masks, shape)
        if not isinstance(masks.instances, abc.Sequence):
            raise invalid("masks.instances", f"is {type(masks.instances).__name__}, must be a list of "
                                             "dot_slam.Instance")
        self._kept: list[Any] = []
        self.struct = c.Masks(instance_count=len(masks.instances))
        if masks.ids is not None:
            self.struct.ids = self._keep(_arrays.id_view(masks.ids, shape, "masks.ids"))
        if masks.instances:
            self._instances = (c.Instance * len(masks.instances))()
            for i, instance in enumerate(masks.instances):
                self._instances[i] = self._convert(instance, f"masks.instances[{i}]")
            self._check_places(shape)
            self.struct.instances = self._instances

    def _keep(self, view: _arrays.ViewOf) -> Any:
        self._kept.append(view)
        return ctypes.pointer(view[1])

    def _check_places(self, shape: _arrays.Shape) -> None:
        """Masks of a network's own resolution would all lie in the upper left corner."""
        height, width = shape
        if any(item.x or item.y or not item.mask for item in self._instances):
            return
        sizes = {(item.mask.contents.height, item.mask.contents.width) for item in self._instances}
        h, w = next(iter(sizes))
        several = len(self._instances) > 1  # one alone may be a thing in that corner
        if len(sizes) == 1 and 0 < h < height and 0 < w < width and (several or w * height == h * width):
            raise invalid("masks.instances", f"have masks of shape {(h, w)} at x = y = 0, the frame is {shape}: resize "
                                             "them to the frame, or say by x and y where in the frame they lie")

    def _convert(self, instance: Instance, name: str) -> c.Instance:
        if not isinstance(instance, Instance):
            raise invalid(name, f"is {type(instance).__name__}, must be dot_slam.Instance")
        out = c.Instance(class_id=whole(instance.class_id, -2**31, 2**31 - 1, f"{name}.class_id"),
                         id=whole(instance.id, 0, 2**32 - 1, f"{name}.id"),
                         x=whole(instance.x, -2**31, 2**31 - 1, f"{name}.x"),
                         y=whole(instance.y, -2**31, 2**31 - 1, f"{name}.y"),
                         score=in_range(instance.score, -1e6, 1e6, f"{name}.score"),
                         flags=c.INSTANCE_ALWAYS_DYNAMIC if instance.always_dynamic else 0)
        if instance.mask is not None:
            out.mask = self._keep(_arrays.mask_view(instance.mask, f"{name}.mask"))
        return out


def _as_masks(masks: MasksLike, shape: _arrays.Shape) -> Masks:
    if isinstance(masks, Masks):
        return masks
    if isinstance(masks, (list, tuple)) and all(isinstance(item, Instance) for item in masks):
        return Masks(instances=masks)
    array = _as_array(masks)
    if array.ndim == 3 and array.dtype != np.bool_:
        how = ""
        if array.shape[1:] == shape:
            how = "; masks of single instances are bool: " + ("masks > 0.5" if array.dtype.kind == "f" else
                                                              "masks.astype(bool)")
        elif array.shape[:2] == shape:
            how = "; an id image has one channel: masks[:, :, 0]"
        raise invalid("masks", f"is {array.dtype} of shape {array.shape}, must be integer ids of shape (h, w), or bool "
                               f"of shape (n, h, w){how}")
    if array.dtype != np.bool_:
        return Masks(ids=_arrays.id_view(array, shape, "masks")[0])
    if array.ndim != 3 or array.shape[1:] != shape:
        raise invalid("masks", f"is bool of shape {array.shape}, must be (n, {shape[0]}, {shape[1]}): a mask for each "
                               "instance")
    return Masks(instances=[Instance(i + 1, mask) for i, mask in enumerate(array)])


def _as_array(masks: Any) -> _arrays.Array:
    """What numpy makes no array of numbers of was mostly meant as a list of Instance."""
    try:
        array = _arrays.as_array(masks, "masks")
        if array.dtype != np.object_:
            return array
    except InvalidArgument as error:
        if "differ in length" not in str(error):
            raise
    what = f"it is {type(masks).__name__}"
    if isinstance(masks, (list, tuple)):
        what = next(f"masks[{i}] is {type(item).__name__}" for i, item in enumerate(masks)
                    if not isinstance(item, Instance))
    raise invalid("masks", f"is no array of one shape, nor a list of dot_slam.Instance, as Instance(1, mask): {what}")
