# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
#
# conan create packaging/conan --build=missing
#
# The package has the CMake configuration of the install tree, and consumers use that one: find_package(dot COMPONENTS
# ...) works as in docs/embedding.md.

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SOURCES = ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*", "capi/*")


class DotConan(ConanFile):
    name = "dot"
    description = "Dynamic object tracking for visual SLAM: which objects move, which are parked"
    license = "MIT"
    topics = ("slam", "computer-vision", "robotics")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False], "capi": [True, False]}
    default_options = {"shared": False, "fPIC": True, "capi": True}

    def set_version(self):
        version = os.path.join(self.recipe_folder, ROOT, "include", "dot", "version.hpp")
        self.version = re.search(r'DOT_VERSION_STRING "(.+)"', load(self, version)).group(1)

    def export_sources(self):
        for pattern in SOURCES:
            copy(self, pattern, ROOT, self.export_sources_folder)

    def config_options(self):
        if self.settings.os == "Windows":
            del self.options.fPIC

    def configure(self):
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        # The headers include both; a static library leaves both to be linked.
        self.requires("eigen/[>=3.3]", transitive_headers=True)
        self.requires("opencv/[>=4.5 <5]", transitive_headers=True, transitive_libs=True)

    def validate(self):
        check_min_cppstd(self, 17)

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.22]")

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("TESTS", "BENCH", "EXAMPLES"):
            toolchain.cache_variables[f"DOT_BUILD_{part}"] = False
        toolchain.cache_variables["DOT_INSTALL"] = True
        toolchain.cache_variables["DOT_BUILD_CAPI"] = bool(self.options.capi)
        toolchain.cache_variables["DOT_CAPI_SHARED"] = bool(self.options.shared)
        toolchain.cache_variables["DOT_CAPI_STATIC"] = not self.options.shared
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # lib/cmake/dot has our own
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "dot")]
        core = self.cpp_info.components["core"]
        core.libs = ["dot_core"]
        core.requires = ["eigen::eigen", "opencv::opencv_core", "opencv::opencv_imgproc"]
        core.set_property("pkg_config_name", "dot_core")
        if self.options.capi:
            capi = self.cpp_info.components["capi"]
            capi.libs = ["dot_capi"]
            capi.requires = ["opencv::opencv_core", "opencv::opencv_imgproc"]
            capi.set_property("pkg_config_name", "dot_capi")
            if not self.options.shared:
                capi.defines = ["DOT_CAPI_STATIC"]
                if self.settings.os in ("Linux", "FreeBSD"):
                    capi.system_libs = ["m"]
