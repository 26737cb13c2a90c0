# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Sequences on disk, in the project's own layout: rgb/, depth/, masks/, intrinsics.txt, times.txt.

Needs OpenCV for Python (cv2). For stereo pairs and for the layouts of public data sets there is the program dot_run.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator, Sequence as Items

import numpy as np
import numpy.typing as npt

from .enums import DepthSource
from .masks import Instance, Masks
from .tracker import Camera

DEPTH_UNITS_PER_METRE = 256


class FileError(Exception):
    """The text starts with the file's name."""


@dataclass(frozen=True, eq=False)
class SequenceFrame:
    number: int  # of the files
    timestamp: float  # seconds
    image: npt.NDArray[np.uint8]  # grey, or blue first
    depth: npt.NDArray[np.uint16]  # DEPTH_UNITS_PER_METRE
    masks: Masks | None  # None: no segmentation of this frame


class Sequence:
    """A folder, read frame by frame.

    mask_every: only the masks of frames 0, K, 2K, ... count. always_dynamic: classes in masks/*.csv that always count
    as moving.
    """

    def __init__(self, folder: Path, mask_every: int = 1, always_dynamic: Items[str] = ()) -> None:
        self._mask_every = mask_every
        self._always_dynamic = set(always_dynamic)
        self._folder = folder
        self.camera, fps, self.depth_source = _read_intrinsics(folder / "intrinsics.txt")
        if not (folder / "depth").is_dir():
            raise FileError(f"{folder / 'depth'}: no such folder; for stereo pairs and other layouts there is dot_run")
        self._images = _list_images(folder / "rgb")
        self._times = [number / fps for number in self._images]
        if (folder / "times.txt").exists():
            self._times = _read_times(folder / "times.txt", list(self._images))

    def __len__(self) -> int:
        return len(self._images)

    def __iter__(self) -> Iterator[SequenceFrame]:
        for index, (number, image) in enumerate(self._images.items()):
            masks = self._masks(image.stem, number) if index % self._mask_every == 0 else None
            depth = read_image(_same_frame(self._folder / "depth", image.stem, number))
            yield SequenceFrame(number, self._times[index], read_image(image), depth, masks)

    def _masks(self, stem: str, number: int) -> Masks | None:
        path = _same_frame(self._folder / "masks", stem, number)
        if not path.exists():
            return None
        listed = path.with_suffix(".csv")
        return Masks(read_image(path), _read_instances(listed, self._always_dynamic) if listed.exists() else ())


def read_image(path: Path) -> npt.NDArray[Any]:
    """As it is stored, colours with blue first."""
    try:
        data = np.fromfile(path, np.uint8)
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    image = _cv2().imdecode(data, -1) if data.size else None  # cv2.IMREAD_UNCHANGED
    if image is None:
        raise FileError(f"{path}: not a readable image")
    array: npt.NDArray[Any] = image
    return array


def write_png(path: Path, image: npt.NDArray[Any]) -> None:
    """The file has its name when it is whole."""
    done, data = _cv2().imencode(".png", image)
    if not done:
        raise FileError(f"{path}: cannot be encoded")
    part = path.with_name(path.name + ".partial")
    part.write_bytes(data.tobytes())
    part.replace(path)


def _cv2() -> Any:
    try:
        import cv2
    except ImportError:
        raise FileError("images are read with OpenCV for Python, which is missing: apt install python3-opencv, or "
                        "pip install opencv-python-headless") from None
    return cv2


# Text and numbers as dot_run reads them.


def _read_lines(path: Path) -> list[str]:
    """In any encoding: what is no UTF-8 stays as it is in command lines."""
    try:
        return path.read_bytes().decode(errors="surrogateescape").split("\n")
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error}") from None


def _parse_number(text: str) -> float | None:
    """A finite decimal number. Not what float() takes besides: nan, inf, 1_000, digits of other scripts."""
    try:
        value = float(text) if set(text) <= set("0123456789+-.eE") else np.nan
    except ValueError:
        return None
    return value if np.isfinite(value) else None


def _to_number(path: Path, line: int, name: str, text: str) -> float:
    value = _parse_number(text)
    if value is None:
        raise FileError(f"{path}:{line}: {name} is {text!r}, must be a number")
    return value


def _in_range(path: Path, line: int, name: str, value: float, low: float, high: float) -> float:
    if not low <= value <= high:
        raise FileError(f"{path}:{line}: {name} is {value:g}, must be from {low:g} to {high:g}")
    return value


def _to_whole(path: Path, line: int, name: str, value: float, low: int, high: int) -> int:
    if not low <= value <= high or value != int(value):
        raise FileError(f"{path}:{line}: {name} is {value:.10g}, must be a whole number from {low} to {high}")
    return int(value)


def _read_intrinsics(path: Path) -> tuple[Camera, float, DepthSource]:
    names = ("fx", "fy", "cx", "cy", "width", "height", "baseline", "fps")
    lines = [line.split() for line in _read_lines(path)]
    if len(lines[0]) != len(names):
        raise FileError(f"{path}:1: has {len(lines[0])} numbers, must be {' '.join(names)}")
    values = {name: _to_number(path, 1, name, text) for name, text in zip(names, lines[0])}
    width, height = (_to_whole(path, 1, name, values.pop(name), 1, 65535) for name in ("width", "height"))
    fps = _in_range(path, 1, "fps", values.pop("fps"), 1e-3, 1e5)
    source = DepthSource.STEREO if values["baseline"] > 0 else DepthSource.UNKNOWN
    for number, words in enumerate(lines[1:], 2):
        if not words:
            continue
        if len(words) != 2 or words[0] != "depth" or words[1].upper() not in DepthSource.__members__:
            raise FileError(f"{path}:{number}: must be 'depth stereo', 'depth rgbd', 'depth lidar' or 'depth unknown'")
        source = DepthSource[words[1].upper()]
    return Camera(width=width, height=height, **values), fps, source


def _list_images(folder: Path) -> dict[int, Path]:
    if not folder.is_dir():
        raise FileError(f"{folder}: no such folder")
    images: dict[int, Path] = {}
    for path in folder.iterdir():
        if path.suffix in (".png", ".jpg") and path.stem.isascii() and path.stem.isdigit():
            if int(path.stem) in images:
                raise FileError(f"{path}: the same frame as {images[int(path.stem)]}")
            images[int(path.stem)] = path
    if not images:
        raise FileError(f"{folder}: holds no images such as 000000.png or 000000.jpg")
    return dict(sorted(images.items()))


def _same_frame(folder: Path, stem: str, number: int) -> Path:
    """Images of a frame have the same name, or its number with six digits."""
    names = (folder / f"{stem}.png", folder / f"{number:06d}.png")
    return next((name for name in names if name.exists()), names[0])


def _read_times(path: Path, numbers: list[int]) -> list[float]:
    """A line an image, or, where images were left out, a line a frame."""
    lines = [(place, line.split()) for place, line in enumerate(_read_lines(path), 1) if line.strip()]
    rows = range(len(numbers)) if len(lines) == len(numbers) else numbers
    if rows[-1] >= len(lines):
        raise FileError(f"{path}: has {len(lines)} times for {len(numbers)} images up to number {numbers[-1]}")
    return [_to_number(path, lines[row][0], "the time", lines[row][1][0]) for row in rows]


def _read_instances(path: Path, always_dynamic: set[str]) -> list[Instance]:
    """Lines id,class,score. A class may be a number, which the library takes and does not interpret, or a name."""
    white, largest = " \t\r\n\v\f", 2**31 - 1
    instances = []
    for number, line in enumerate(_read_lines(path), 1):
        words = [word.strip(white) for word in line.removesuffix(",").split(",")]
        if not line.strip(white) or (number == 1 and words[0] == "id"):
            continue
        if len(words) < 2:
            raise FileError(f"{path}:{number}: must be id,class,score")
        id = _to_whole(path, number, "id", _to_number(path, number, "id", words[0]), 1, 65535)
        class_number = _parse_number(words[1])
        class_id = -1 if class_number is None else _to_whole(path, number, "class", class_number, -largest, largest)
        score = 1.0 if len(words) < 3 else _in_range(path, number, "score",
                                                     _to_number(path, number, "score", words[2]), -1e6, 1e6)
        instances.append(Instance(id, class_id=class_id, score=score, always_dynamic=words[1] in always_dynamic))
    return instances
