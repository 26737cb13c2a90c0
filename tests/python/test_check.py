# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The look at a recording, through the program: findings, or a FileError whatever goes wrong."""

import os
import shutil

import pytest
from conftest import SAMPLE

import dot_slam
from dot_slam.sequence import FileError

pytestmark = pytest.mark.skipif("DOT_RUN" not in os.environ, reason="needs the program dot_run")


def test_the_sample_is_fine():
    assert {item.verdict for item in dot_slam.check(SAMPLE)} <= {"fine", "not measured"}


@pytest.mark.parametrize("name", ["-dash", os.fsdecode(b"caf\xe9")])
def test_folders_of_any_name(tmp_path, monkeypatch, name):
    shutil.copytree(SAMPLE, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    assert len(dot_slam.check(name)) == len(dot_slam.check(SAMPLE))
    with pytest.raises(FileError, match="none"):
        dot_slam.check(os.path.join(name, "none"))


@pytest.mark.parametrize("answer", ["", "hello", "[]", '{"findings": [{}]}', '{"findings": 1}'])
def test_another_program(tmp_path, monkeypatch, answer):
    program = tmp_path / "other"
    program.write_text(f"#!/bin/sh\necho '{answer}'\n")
    program.chmod(0o755)
    monkeypatch.setenv("DOT_RUN", str(program))
    with pytest.raises(FileError, match="does not answer as dot_run"):
        dot_slam.check(SAMPLE)


def test_no_program(tmp_path, monkeypatch):
    monkeypatch.setenv("DOT_RUN", str(tmp_path / "none"))
    with pytest.raises(FileError, match="none"):
        dot_slam.check(SAMPLE)
