# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""python -m dot_slam on what nobody made for it."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import SAMPLE

from dot_slam import DepthSource
from dot_slam.__main__ import main
from dot_slam.sequence import Sequence
from dot_slam.writer import ResultWriter

cv2 = pytest.importorskip("cv2", reason="no OpenCV for Python, with which sequences are read")


@pytest.fixture
def folder(tmp_path):
    """Four frames of the sample."""
    out = tmp_path / "seq"
    for kind in ("rgb", "depth", "masks"):
        (out / kind).mkdir(parents=True)
        for i in range(4):
            shutil.copy(SAMPLE / kind / f"{i:06d}.png", out / kind)
    shutil.copy(SAMPLE / "intrinsics.txt", out)
    return out


def run(folder, capsys, *options):
    status = main([str(folder), "--out", str(folder.parent / "out"), *options])
    return status, capsys.readouterr().err


def break_intrinsics(text):
    return lambda folder: (folder / "intrinsics.txt").write_text(text)


def write(name, image):
    return lambda folder: cv2.imwrite(str(folder / name), image)


@pytest.mark.parametrize("breaking, text", [
    (lambda folder: shutil.rmtree(folder), "intrinsics.txt: cannot be read"),
    (lambda folder: shutil.rmtree(folder / "rgb"), "rgb: no such folder"),
    (lambda folder: shutil.rmtree(folder / "depth"), "depth: no such folder; for stereo pairs"),
    (lambda folder: [path.unlink() for path in (folder / "rgb").iterdir()], "rgb: holds no images such as"),
    (lambda folder: (folder / "depth/000002.png").unlink(), "depth/000002.png: No such file"),
    (lambda folder: (folder / "depth/000002.png").write_bytes(b""), "depth/000002.png: not a readable image"),
    (lambda folder: (folder / "rgb/000001.png").write_bytes(b"GIF89a"), "rgb/000001.png: not a readable image"),
    (lambda folder: shutil.copy(folder / "rgb/000001.png", folder / "rgb/1.png"), "the same frame as"),
    (lambda folder: (folder / "times.txt").write_text("0\n0.1\n"), "times.txt: has 2 times for 4 images"),
    (lambda folder: (folder / "times.txt").write_text("0\n0.1\nsoon\n1"), "times.txt:3: the time is 'soon'"),
    (lambda folder: (folder / "times.txt").write_text("0\n0.2\n0.1\n1"), "frame 2: timestamp: is 0.1 s, must be greater"),
    (lambda folder: (folder / "masks/000000.csv").write_text("id,class\nseven,car"), "000000.csv:2: id is 'seven'"),
    (lambda folder: (folder / "masks/000000.csv").write_text("1"), "000000.csv:1: must be id,class,score"),
    (lambda folder: (folder / "masks/000000.csv").mkdir(), "000000.csv: cannot be read"),
    (write("rgb/000001.png", np.zeros((188, 619, 3), np.uint8)), "frame 1: image has shape (188, 619, 3)"),
    (write("depth/000001.png", np.zeros((188, 620), np.uint8)), "frame 1: depth is uint8"),
    (write("masks/000000.png", np.zeros((188, 620, 3), np.uint8)), "frame 0: masks.ids is uint8 of shape"),
    (break_intrinsics(""), "intrinsics.txt:1: has 0 numbers, must be fx fy cx cy width height baseline fps"),
    (break_intrinsics("1 2 3 4 5 6 7"), "has 7 numbers"),
    (break_intrinsics("a 2 3 4 5 6 7 8"), "fx is 'a', must be a number"),
    (break_intrinsics("362 362 309 93 620 188.5 0.5 10"), "height is 188.5, must be a whole number"),
    (break_intrinsics("362 362 309 93 620 188 0.5 0"), "fps is 0, must be from 0.001 to 100000"),
    (break_intrinsics("362 362 309 93 620 188 0.5 1e-4"), "fps is 0.0001, must be from"),
    (break_intrinsics("362 362 309 93 620 188 0.5 1e6"), "fps is 1e+06, must be from"),
    (break_intrinsics("3_62 362 309 93 620 188 0.5 10"), "fx is '3_62', must be a number"),
    (break_intrinsics("362 362 309 93 1e10 188 0.5 10"), "width is 1e+10, must be a whole number"),
    (break_intrinsics("0 362 309 93 620 188 0.5 10"), "camera.fx"),
    (break_intrinsics("362 362 309 93 620 188 0.5 10\ndepth sonar"), "intrinsics.txt:2: must be 'depth stereo'"),
])
def test_told_with_the_name(folder, capsys, breaking, text):
    breaking(folder)
    status, errors = run(folder, capsys)
    assert status == 1 and errors.startswith("dot_slam: ") and errors.count("\n") == 1 and text in errors
    assert not (folder.parent / "out" / "objects.csv").exists()


def test_unknown_option_of_the_tracker(folder, capsys):
    assert run(folder, capsys, "--set", "velocity.nonsense=1") == (
        1, "dot_slam: options: there is no setting 'velocity.nonsense'\n")


@pytest.mark.parametrize("options", [["--mask-every", "0"], ["--mask-delay", "-1"], ["--set", "velocity.v0"],
                                     ["--set", "velocity.v0=fast"], ["--nonsense"]], ids=" ".join)
def test_wrong_command_line(folder, capsys, options):
    with pytest.raises(SystemExit) as caught:
        run(folder, capsys, *options)
    assert caught.value.code == 2 and "error: " in capsys.readouterr().err


def test_results_are_not_mixed(folder, capsys):
    assert run(folder, capsys) == (0, "")
    status, errors = run(folder, capsys)
    assert status == 1 and "camera.txt: is there already" in errors


def test_nothing_of_others_is_replaced(folder, capsys):
    """The truth of a sequence has the name of a table."""
    shutil.copy(SAMPLE / "objects.csv", folder)
    assert main([str(folder), "--out", str(folder)]) == 1
    assert "objects.csv: is there already" in capsys.readouterr().err
    assert (folder / "objects.csv").read_bytes() == (SAMPLE / "objects.csv").read_bytes()
    assert not (folder / "labels").exists()


def test_stopped_in_the_middle(folder, capsys, monkeypatch):
    """Whole pictures, unfinished tables."""
    write = ResultWriter.write

    def write_two(writer, number, result):
        if number == 2:
            raise KeyboardInterrupt
        write(writer, number, result)

    monkeypatch.setattr(ResultWriter, "write", write_two)
    assert run(folder, capsys)[0] == 130
    out = folder.parent / "out"
    assert sorted(path.name for path in (out / "labels").iterdir()) == ["000000.png", "000001.png"]
    assert sorted(path.name for path in out.iterdir()) == ["camera.txt.partial", "instances", "labels",
                                                           "objects.csv.partial"]
    assert len((out / "camera.txt.partial").read_text().splitlines()) == 2


def test_names_and_frames_left_out(folder):
    for i in range(4):
        (folder / f"rgb/{i:06d}.png").rename(folder / f"rgb/{i}.png")
    (folder / "rgb/1.png").unlink()
    (folder / "times.txt").write_text("5\n6\n7\n8\n")
    frames = list(Sequence(folder))
    assert [(frame.number, frame.timestamp) for frame in frames] == [(0, 5), (2, 7), (3, 8)]
    assert all(frame.masks is not None for frame in frames)
    (folder / "times.txt").write_text("5\n6\n7\n")
    assert [frame.timestamp for frame in Sequence(folder)] == [5, 6, 7]


def test_without_masks_and_with_instances(folder, capsys):
    shutil.rmtree(folder / "masks")
    assert run(folder, capsys) == (0, "")
    rows = (folder.parent / "out" / "objects.csv").read_text().splitlines()
    assert len(rows) == 1  # the header
    shutil.rmtree(folder.parent / "out")
    (folder / "masks").mkdir()
    shutil.copy(SAMPLE / "masks/000000.png", folder / "masks")
    values = np.unique(cv2.imread(str(folder / "masks/000000.png"), -1))[1:]
    (folder / "masks/000000.csv").write_text("id,class,score\n" + "".join(f"{v},person,0.5\n" for v in values))
    assert run(folder, capsys, "--always-dynamic", "car,person") == (0, "")
    rows = [row.split(",") for row in (folder.parent / "out" / "objects.csv").read_text().splitlines()]
    states = {row[rows[0].index("state")] for row in rows[1:]}
    assert states == {"moving"}


@pytest.mark.skipif("DOT_RUN" not in os.environ, reason="DOT_RUN does not name the program dot_run")
@pytest.mark.parametrize("text", [
    b"id,class,score\r\n1,car,0.5\r\n", b"1,2.0,0.5", b"1,1e1", b"1,-7,1", b"1,--5,1", b"1,\xd9\xa1,1",
    b"1,caf\xe9,0.5", b"1,car,", b"1,,", b"1,car,0.5\x0c\n2,4", b"1,2\xe2\x80\xa8,1", b"1,nan", b"1,1_0",
    b'1,"car",0.5', b"\n \n+1.0,3,1,more",
    b'1,"car, red",0.5', b"1,1.5", b"1,3e9", b"1,car,1e7", b"1,car,nan", b"1,car, ", b",,", b"1", b"1,", b"1.5,car",
    b"70000,car", b"1_0,car", b"2,3\nid,class,score",
])
def test_lists_of_instances_are_read_as_dot_run_does(folder, capsys, text):
    """The same classes and scores in the same results, or an error of both that names the same line."""
    (folder / "masks/000000.csv").write_bytes(text)
    always = ["--always-dynamic", "caf\udce9,car"]
    status, errors = run(folder, capsys, *always)
    done = subprocess.run([os.environ["DOT_RUN"], folder, "--out", folder.parent / "by_dot_run", *always],
                          capture_output=True, text=True)
    assert (status == 0) == (done.returncode == 0), errors + done.stderr
    if status == 0:
        results = [(folder.parent / out / "objects.csv").read_bytes() for out in ("out", "by_dot_run")]
        assert results[0] == results[1]
    else:
        lines = [re.search(r"000000\.csv:(\d+): \w+", words).group(0) for words in (errors, done.stderr)]
        assert lines[0] == lines[1]


def test_depth_source(folder):
    assert Sequence(folder).depth_source is DepthSource.STEREO
    line = (folder / "intrinsics.txt").read_text().strip()
    (folder / "intrinsics.txt").write_text(f"{line}\n\ndepth lidar\n")
    assert Sequence(folder).depth_source is DepthSource.LIDAR


def test_without_opencv(folder):
    """The library itself needs numpy alone."""
    code = ("import sys; sys.modules['cv2'] = None; import dot_slam.__main__ as m; "
            f"sys.exit(m.main([{str(folder)!r}, '--out', {str(folder.parent / 'out')!r}]))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 1 and "images are read with OpenCV for Python, which is missing" in done.stderr
