# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Builds the C library with CMake and puts it into the package. What is constant stands in pyproject.toml.

DOT_SLAM_LIBRARY=FILE takes a library that was built already. CMAKE_ARGS are further arguments of CMake.
"""

import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # setuptools before 70.1
    from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
# The project is the folder above; a source distribution has what it needs of it in cpp/.
PROJECT = HERE / "cpp" if (HERE / "cpp").is_dir() else HERE.parent
SOURCES = ("CMakeLists.txt", "LICENSE", "cmake", "include", "src", "capi")
FILE = "libdot_capi.so.0"


def version():
    text = (PROJECT / "include/dot/version.hpp").read_text(encoding="utf-8")
    return re.search(r'^#define DOT_VERSION_STRING "(.*)"$', text, re.MULTILINE).group(1)


class BuildLibrary(build_ext):
    def get_ext_filename(self, fullname):
        return os.path.join(*fullname.split(".")[:-1], FILE)

    def build_extension(self, ext):
        built = os.environ.get("DOT_SLAM_LIBRARY") or self.build_library()
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(built, target)

    def build_library(self):
        build = Path(self.build_temp).resolve()
        options = {"CMAKE_BUILD_TYPE": "Release", "DOT_BUILD_TESTS": "OFF", "DOT_BUILD_BENCH": "OFF",
                   "DOT_BUILD_EXAMPLES": "OFF", "DOT_BUILD_CAPI": "ON", "DOT_CAPI_STATIC": "OFF", "DOT_INSTALL": "OFF"}
        subprocess.run(["cmake", "-S", str(PROJECT), "-B", str(build), *(f"-D{k}={v}" for k, v in options.items()),
                        *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", str(build), "--target", "dot_capi", "--config", "Release", "--parallel",
                        jobs], check=True)
        return build / "capi" / FILE


class AnyPython(bdist_wheel):
    """The library knows nothing of Python: one wheel for all versions of it."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class WithSources(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for name in SOURCES:
            source, target = PROJECT / name, Path(base_dir) / "cpp" / name
            target.parent.mkdir(exist_ok=True)
            (shutil.copytree if source.is_dir() else shutil.copyfile)(source, target)


setup(version=version(), ext_modules=[Extension("dot_slam.libdot_capi", [])],
      cmdclass={"build_ext": BuildLibrary, "bdist_wheel": AnyPython, "sdist": WithSources})
