# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Results on disk, in the formats of the program dot_run."""

from __future__ import annotations

from pathlib import Path
from types import TracebackType
from typing import Iterator, TextIO, Type

import numpy as np

from .enums import Reason, State
from .result import Object, Result
from .sequence import FileError, write_png

_FOLDERS, _TABLES, _REVISED = ("labels", "instances"), ("camera.txt", "objects.csv"), "revised.txt"
_COLUMNS = ("frame,track_id,state,speed_mps,p_moving,disparity_px,entropy,phi,n_points,vx,vy,vz,sigma_vx,sigma_vy,"
            "sigma_vz,T00,T01,T02,T03,T10,T11,T12,T13,T20,T21,T22,T23,reason,n_inliers,disparity_noise_px,range_m,"
            "interval_s,fused_vx,fused_vy,fused_vz,sigma_fused_vx,sigma_fused_vy,sigma_fused_vz,pixels,class,"
            "segmented,always_dynamic,discovered,point_speed_mps,sigma_point_speed,wx,wy,wz,sigma_wx,sigma_wy,sigma_wz")
_STATES = {state: state.name.lower() for state in State} | {State.NOT_OBSERVABLE: "unobservable"}


class ResultWriter:
    """labels/ and instances/ frame by frame; camera.txt and objects.csv, which end in .partial until all is done.

    revised.txt likewise, if there are motions of the camera that were wrong.
    """

    def __init__(self, out: Path) -> None:
        for path in (out / name for name in (*_TABLES, _REVISED, *_FOLDERS)):
            if path.is_file() or (path.is_dir() and any(path.iterdir())):
                raise FileError(f"{path}: is there already; remove it, or name another folder")
        for name in _FOLDERS:
            (out / name).mkdir(parents=True, exist_ok=True)
        self._out = out
        self._tables = {name: self._open(name) for name in _TABLES}
        self._tables["objects.csv"].write(_COLUMNS + "\n")
        self._T_world_camera = np.eye(4)

    def write(self, number: int, result: Result) -> None:
        if result.ids.max() > np.iinfo(np.uint16).max:
            raise FileError(f"frame {number}: track id {result.ids.max()} does not fit the 16 bits of instances/")
        write_png(self._out / "labels" / f"{number:06d}.png", result.labels)
        write_png(self._out / "instances" / f"{number:06d}.png", result.ids.astype(np.uint16))
        self._T_world_camera = self._T_world_camera @ np.linalg.inv(np.vstack((result.camera.T_cur_prev, (0, 0, 0, 1))))
        self._tables["camera.txt"].write(" ".join(f"{v:.15g}" for v in self._T_world_camera[:3].flat) + "\n")
        for item in result.objects:
            self._tables["objects.csv"].write(",".join(_row(number, item)) + "\n")

        if result.revised and _REVISED not in self._tables:
            self._tables[_REVISED] = self._open(_REVISED)
        for revision in result.revised:
            numbers = " ".join(f"{v:.15g}" for v in revision.T_cur_prev.flat)
            self._tables[_REVISED].write(f"{revision.frame_id} {numbers}\n")

    def _open(self, name: str) -> TextIO:
        return open(self._out / f"{name}.partial", "w", encoding="ascii", newline="\n")

    def finish(self) -> None:
        """After the last frame: the tables are complete."""
        for name, table in self._tables.items():
            table.close()
            Path(table.name).replace(self._out / name)

    def __enter__(self) -> ResultWriter:
        return self

    def __exit__(self, kind: Type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        for table in self._tables.values():
            table.close()


def _row(number: int, o: Object) -> Iterator[str]:
    """What a frame did not measure stays empty: a zero would be a statement."""
    def some(values: object, exist: bool) -> Iterator[str]:
        for value in np.ravel(values):  # type: ignore[call-overload]
            yield f"{value:.10g}" if exist else ""

    measured, fused = o.reason == Reason.NONE, o.fused_covariance[0, 0] > 0
    yield from (str(number), str(o.id), _STATES[o.state])
    yield from some(o.speed, measured)
    yield f"{o.p_moving:.10g}"
    yield from some([o.disparity_px, o.entropy, o.phi], measured)
    yield str(o.n_points)
    yield from some(o.velocity, measured)
    yield from some(np.sqrt(o.velocity_covariance.diagonal()), measured)
    yield from some(o.T_o, measured)
    yield from ("" if measured else o.reason.name.lower(), str(o.n_inliers))
    yield from some([o.disparity_noise_px, o.range, o.interval], measured)
    yield from some(o.fused_velocity, fused)
    yield from some(np.sqrt(o.fused_covariance.diagonal()), fused)
    yield from (str(o.area), str(o.class_id), f"{o.segmented:d}", f"{o.always_dynamic:d}", f"{o.discovered:d}")
    yield from some([o.point_speed, o.point_speed_sigma], measured)
    yield from some(o.angular_velocity, measured)
    yield from some(np.sqrt(o.angular_covariance.diagonal()), measured)
