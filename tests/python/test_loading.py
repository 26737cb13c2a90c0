# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""A C library that does not fit is told at the import."""

import ctypes

import pytest

from dot_slam import _library


def library(abi_version=_library.ABI_VERSION, version=_library.HEADER_VERSION, without=()):
    """Stands for one that was loaded."""
    class Functions:
        pass

    def function(name):
        value = {"dot_abi_version": abi_version, "dot_version": version}.get(name, 0)
        return lambda *_: value

    made = Functions()
    for name in _library.FUNCTIONS:
        if name not in without:
            setattr(made, name, function(name))
    return made


def test_a_later_library(monkeypatch):
    later = library(version=_library.HEADER_VERSION + 1)
    monkeypatch.setattr(ctypes, "CDLL", lambda path: later)
    assert _library._load() is later


@pytest.mark.parametrize("found, text", [
    (library(abi_version=7), "has the binary interface 7, dot_slam needs 0"),
    (library(version=_library.HEADER_VERSION - 1), "has the version 0.0.999, dot_slam needs 0.1.0 or a later one"),
    (library(without=["dot_submit_masks"]), "has no dot_submit_masks: it is older than dot_slam"),
])
def test_another_library(monkeypatch, found, text):
    monkeypatch.setattr(ctypes, "CDLL", lambda path: found)
    with pytest.raises(ImportError, match=text):
        _library._load()


@pytest.mark.parametrize("said, text", [
    ("libopencv_core.so.999: cannot open shared object file: No such file or directory",
     "libopencv_core.so.999: .* The C library is there, but it needs that one: install OpenCV's core"),
    ("libdot_capi.so.0: cannot open shared object file: No such file or directory",
     "libdot_capi.so.0: .* It is neither beside the package nor .* LD_LIBRARY_PATH$"),
    ("/x/libdot_capi.so.0: file too short", "/x/libdot_capi.so.0: file too short$"),
])
def test_missing_library(monkeypatch, said, text):
    def fail(path):
        raise OSError(said)

    monkeypatch.setattr(ctypes, "CDLL", fail)
    with pytest.raises(ImportError, match="cannot load its C library: " + text) as caught:
        _library._load()
    assert ("OpenCV" in str(caught.value)) == ("opencv" in said)


def test_missing_library_as_the_linker_says_it(monkeypatch):
    """The text that `_advice` reads is that of this system."""
    monkeypatch.setattr(_library, "_FILE", "libdot_capi.so.999")
    with pytest.raises(ImportError, match="neither beside the package"):
        _library._load()


def test_library_of_this_package(monkeypatch):
    """The one beside the modules, and not another one that the system has."""
    paths = []
    monkeypatch.setattr(ctypes, "CDLL", lambda path: paths.append(path) or library())
    _library._load()
    assert [path.endswith("/dot_slam/libdot_capi.so.0") for path in paths] == [True]
