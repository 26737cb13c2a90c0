# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Sequences on disk, in the project's own layout: rgb/, depth/, masks/, intrinsics.txt, times.txt.

Needs OpenCV for Python (cv2). For stereo pairs and for the layouts of public data sets there is the program dot_run.
"""

from __future__ import annotations

import csv
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


def _read_lines(path: Path) -> list[list[str]]:
    try:
        return [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    except (OSError, UnicodeDecodeError) as error:
        raise FileError(f"{path}: cannot be read: {error}") from None


def _to_number(path: Path, line: int, name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise FileError(f"{path}:{line}: {name} is {text!r}, must be a number")
    return value


def _read_intrinsics(path: Path) -> tuple[Camera, float, DepthSource]:
    names = ("fx", "fy", "cx", "cy", "width", "height", "baseline", "fps")
    lines = [words for words in _read_lines(path)] or [[]]
    if len(lines[0]) != len(names):
        raise FileError(f"{path}:1: has {len(lines[0])} numbers, must be {' '.join(names)}")
    values = {name: _to_number(path, 1, name, text) for name, text in zip(names, lines[0])}
    for name in ("width", "height"):
        if values[name] != int(values[name]) or not 1 <= values[name] <= 65535:
            raise FileError(f"{path}:1: {name} is {values[name]:g}, must be a whole number from 1 to 65535")
    fps = values.pop("fps")
    if fps <= 0:
        raise FileError(f"{path}:1: fps is {fps:g}, must be > 0")
    source = DepthSource.STEREO if values["baseline"] > 0 else DepthSource.UNKNOWN
    for number, words in enumerate(lines[1:], 2):
        if not words:
            continue
        if len(words) != 2 or words[0] != "depth" or words[1].upper() not in DepthSource.__members__:
            raise FileError(f"{path}:{number}: must be 'depth stereo', 'depth rgbd', 'depth lidar' or 'depth unknown'")
        source = DepthSource[words[1].upper()]
    width, height = int(values.pop("width")), int(values.pop("height"))
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
    lines = [(place, words) for place, words in enumerate(_read_lines(path), 1) if words]
    rows = range(len(numbers)) if len(lines) == len(numbers) else numbers
    if rows[-1] >= len(lines):
        raise FileError(f"{path}: has {len(lines)} times for {len(numbers)} images up to number {numbers[-1]}")
    return [_to_number(path, lines[row][0], "the time", lines[row][1][0]) for row in rows]


def _read_instances(path: Path, always_dynamic: set[str]) -> list[Instance]:
    instances = []
    with path.open(encoding="utf-8", newline="") as file:
        for line, row in enumerate(csv.reader(file), 1):
            words = [word.strip() for word in row]
            if not any(words) or (line == 1 and words[0] == "id"):
                continue
            if len(words) < 2:
                raise FileError(f"{path}:{line}: must be id,class,score")
            number = _to_number(path, line, "id", words[0])
            if number != int(number) or not 1 <= number <= 65535:
                raise FileError(f"{path}:{line}: id is {words[0]}, must be a whole number from 1 to 65535")
            # A class may be a number or a name; the library takes numbers and does not interpret them.
            class_id = int(words[1]) if words[1].lstrip("-").isdecimal() else -1
            score = _to_number(path, line, "score", words[2]) if len(words) > 2 else 1.0
            instances.append(Instance(int(number), class_id=class_id, score=score,
                                      always_dynamic=words[1] in always_dynamic))
    return instances
