# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Labels the objects of a recorded sequence: python -m dot_slam SEQ --out OUT."""

from __future__ import annotations

import argparse
import logging
import statistics
import sys
import time
from collections import deque
from pathlib import Path
from typing import Sequence as Items

from . import Error, State, Tracker, __version__, check
from ._check import FAULTS_FOUND
from .sequence import DEPTH_UNITS_PER_METRE, FileError, Sequence, SequenceFrame
from .writer import ResultWriter


def _arguments(values: Items[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m dot_slam", description=__doc__.split(":")[0] + ".", epilog="""
        SEQ holds rgb/, depth/, masks/ and intrinsics.txt. OUT receives labels/ (0 background, 1 static, 2 moving, 3 not
        observable), instances/ (track ids), camera.txt, objects.csv and revised.txt, as of dot_run.""")
    parser.add_argument("sequence", metavar="SEQ", type=Path)
    parser.add_argument("--out", metavar="OUT", type=Path, help="folder for the results")
    parser.add_argument("--check", action="store_true",
                        help="look at the recording instead, with the program dot_run; status 3 if there are faults")
    parser.add_argument("--html", metavar="FILE", type=Path, help="with --check: the report as a page")
    parser.add_argument("--mask-every", metavar="K", type=int, default=1, help="use the masks of frames 0, K, 2K alone")
    parser.add_argument("--mask-delay", metavar="N", type=int, default=0,
                        help="hand a frame's masks over only after N further frames, as if a network took that long")
    parser.add_argument("--always-dynamic", metavar="CLASS,...", default="",
                        help="classes of the masks' csv files that always count as moving")
    parser.add_argument("--set", metavar="NAME=VALUE", action="append", default=[], type=_setting,
                        help="an option of the tracker, such as velocity.v0=1; may be repeated")
    parser.add_argument("--version", action="version", version=__version__)
    arguments = parser.parse_args(values)
    if not arguments.check and arguments.out is None:
        parser.error("the following arguments are required: --out")
    if arguments.html and not arguments.check:
        parser.error("--html needs --check")
    if arguments.mask_every < 1:
        parser.error("--mask-every must be at least 1")
    if arguments.mask_delay < 0:
        parser.error("--mask-delay must be at least 0")
    return arguments


def _setting(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    try:
        if equals:
            return name, float(value)
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"{text!r} is not NAME=NUMBER")


def run(arguments: argparse.Namespace) -> None:
    classes = [name for name in arguments.always_dynamic.split(",") if name]
    sequence = Sequence(arguments.sequence, arguments.mask_every, classes)
    delay, milliseconds = arguments.mask_delay, []
    waiting: deque[SequenceFrame] = deque()  # frames whose masks are on their way
    decided: dict[int, State] = {}
    with Tracker(sequence.camera, depth_source=sequence.depth_source, options=dict(arguments.set),
                 depth_units_per_metre=DEPTH_UNITS_PER_METRE) as tracker, ResultWriter(arguments.out) as writer:
        print(f"sequence  {arguments.sequence}: {len(sequence)} frames, {sequence.camera.width}x"
              f"{sequence.camera.height}, depth {sequence.depth_source.name.lower()}")
        for frame in sequence:
            start = time.perf_counter()
            try:
                result = tracker.track(frame.image, frame.depth, None if delay else frame.masks,
                                       timestamp=frame.timestamp, frame_id=frame.number)
                waiting.append(frame)
                if len(waiting) > delay:
                    then = waiting.popleft()
                    if delay and then.masks is not None:
                        tracker.submit_masks(then.number, then.masks)
            except Error as error:
                raise FileError(f"{arguments.sequence}: frame {frame.number}: {error}") from error
            milliseconds.append(1e3 * (time.perf_counter() - start))
            writer.write(frame.number, result)
            decided.update({item.id: item.last_decided for item in result.objects if item.area > 0})
        writer.finish()
    states = list(decided.values())
    print(f"objects   {len(states)}: {states.count(State.MOVING)} moving, {states.count(State.STATIC)} static, "
          f"{states.count(State.NOT_OBSERVABLE)} never decided (as last decided)")
    print(f"time      median {statistics.median(milliseconds):.1f} ms a frame (tracking alone)")
    print(f"results   {arguments.out.resolve()}")


def look(arguments: argparse.Namespace) -> int:
    findings = check(arguments.sequence, html=arguments.html)
    for item in findings:
        figure = "" if item.figure is None or item.verdict not in ("fault", "hint") else f"{item.figure:.4g} {item.unit}: "
        print(f"{item.verdict:14}{item.fault:18}{figure}{item.words}")
        if item.advice:
            print(f"{'':32}What to do: {item.advice}")
    return FAULTS_FOUND if any(item.verdict == "fault" for item in findings) else 0


def main(values: Items[str] | None = None) -> int:
    logging.basicConfig(format="dot_slam: %(message)s")
    try:
        arguments = _arguments(values)
        if arguments.check:
            return look(arguments)
        run(arguments)
        return 0
    except KeyboardInterrupt:
        return 130  # as a shell has it; the tables keep the name .partial
    except (Error, FileError, OSError) as error:
        print(f"dot_slam: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
