# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The recipes for Conan and conda-forge against the install tree: recipes_test.py SOURCE BUILD WORK

Neither tool is in Debian. So this runs the recipes with stand-ins for what they import, which look up each CMake option
in BUILD, install BUILD instead of building again, and check what the recipe says of the package. What the tools do
beyond that is not tried: choosing versions, building dependencies, their own CMake files.
"""

import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
import types
import unittest
from pathlib import Path

import jinja2
import yaml

SOURCE, BUILD, WORK = (Path(argument).resolve() for argument in sys.argv[1:4])
CACHE = dict(re.findall(r"^(\w+):\w+=(.*)$", (BUILD / "CMakeCache.txt").read_text(), re.MULTILINE))
OPTIONS = set(re.findall(r"^option\((\w+)", "".join(path.read_text() for path in
              [SOURCE / "CMakeLists.txt", SOURCE / "capi" / "CMakeLists.txt"]), re.MULTILINE))
VERSION = re.search(r'DOT_VERSION_STRING "(.+)"', (SOURCE / "include/dot/version.hpp").read_text()).group(1)


def run(*command, **arguments):
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL, **arguments)


def install(prefix):
    shutil.rmtree(prefix, ignore_errors=True)
    run("cmake", "--install", BUILD, "--prefix", prefix)


class Attributes(types.SimpleNamespace):
    """Settings or options: attributes that a recipe may also remove."""

    def rm_safe(self, name):
        self.__dict__.pop(name, None)


class CppInfo:
    def __init__(self):
        self.libs, self.requires, self.defines, self.system_libs, self.builddirs = [], [], [], [], []
        self.properties, self.parts = {}, {}

    def set_property(self, name, value):
        self.properties[name] = value

    @property
    def components(self):
        return self

    def __getitem__(self, name):
        return self.parts.setdefault(name, CppInfo())


class ConanFile:
    def requires(self, reference, **traits):
        self.required[reference] = traits

    tool_requires = requires


class CMakeToolchain:
    def __init__(self, recipe):
        self.recipe, self.cache_variables = recipe, {}

    def generate(self):
        self.recipe.variables = self.cache_variables


class CMake:
    def __init__(self, recipe):
        self.recipe = recipe

    def configure(self):
        unknown = set(self.recipe.variables) - OPTIONS
        assert not unknown, f"the project has no option {unknown}"

    def build(self):
        pass

    def install(self):
        install(self.recipe.package_folder)


def copy(_recipe, pattern, source, destination):
    found = [path for path in Path(source).glob(pattern) if path.exists()]
    assert found, f"nothing in {source} is {pattern}"
    for path in found:
        target = Path(destination) / path.relative_to(source)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(path, target) if path.is_dir() else shutil.copy(path, target)


def conan_recipe():
    modules = {
        "conan": {"ConanFile": ConanFile},
        "conan.tools": {},
        "conan.tools.build": {"check_min_cppstd": lambda recipe, least: None},
        "conan.tools.cmake": {"CMake": CMake, "CMakeDeps": CMakeToolchain, "CMakeToolchain": CMakeToolchain,
                              "cmake_layout": lambda recipe: None},
        "conan.tools.files": {"copy": copy, "load": lambda recipe, path: Path(path).read_text()},
    }
    for name, content in modules.items():
        sys.modules[name] = types.ModuleType(name)
        sys.modules[name].__dict__.update(content)
    sys.modules["conan.tools.cmake"].CMakeDeps = type("CMakeDeps", (), {"__init__": lambda self, recipe: None,
                                                                       "generate": lambda self: None})
    spec = importlib.util.spec_from_file_location("conanfile", SOURCE / "packaging/conan/conanfile.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.DotConan


class Conan(unittest.TestCase):
    def recipe(self, **chosen):
        recipe = conan_recipe()()
        recipe.recipe_folder = str(SOURCE / "packaging/conan")
        recipe.source_folder, recipe.required, recipe.cpp_info = str(SOURCE), {}, CppInfo()
        recipe.package_folder = str(WORK / "conan/package")
        recipe.settings = Attributes(os="Linux", build_type="Release", arch="x86_64")
        recipe.options = Attributes(**{**recipe.default_options, **chosen})
        for step in ("set_version", "config_options", "configure", "layout", "requirements", "validate",
                     "build_requirements", "generate", "build"):
            getattr(recipe, step)()
        return recipe

    def test_version_and_requirements(self):
        recipe = self.recipe()
        self.assertEqual(recipe.version, VERSION)
        self.assertEqual({reference.split("/")[0] for reference in recipe.required}, {"eigen", "opencv", "cmake"})

    def test_sources_are_complete(self):
        """What is exported is configured, built as far as a header tier needs, and installed."""
        exported = WORK / "conan/source"
        shutil.rmtree(exported, ignore_errors=True)
        recipe = self.recipe()
        recipe.export_sources_folder = str(exported)
        recipe.export_sources()
        options = [f"-D{name}={'ON' if value else 'OFF'}" for name, value in recipe.variables.items()]
        run("cmake", "-S", exported, "-B", WORK / "conan/build", "-G", CACHE["CMAKE_GENERATOR"],
            f"-DCMAKE_CXX_COMPILER={CACHE['CMAKE_CXX_COMPILER']}", *options)

    def test_package(self):
        """All that package_info names is installed, and the package's own test is built and run."""
        recipe = self.recipe()
        recipe.package()
        recipe.package_info()
        package = Path(recipe.package_folder)
        self.assertTrue((package / "licenses/LICENSE").is_file())
        self.assertTrue((package / recipe.cpp_info.builddirs[0] / "dotConfig.cmake").is_file())
        self.assertEqual(set(recipe.cpp_info.parts), {"core", "capi"})
        for component in recipe.cpp_info.parts.values():
            for library in component.libs:
                self.assertTrue(list(package.glob(f"lib/lib{library}.*")), f"lib{library} is not installed")
            name = component.properties["pkg_config_name"]
            self.assertTrue((package / f"lib/pkgconfig/{name}.pc").is_file(), f"{name}.pc is not installed")
        build_host(WORK / "conan/host", package)

    def test_shared(self):
        recipe = self.recipe(shared=True)
        self.assertNotIn("fPIC", recipe.options.__dict__)
        self.assertTrue(recipe.variables["DOT_CAPI_SHARED"])
        self.assertFalse(recipe.variables["DOT_CAPI_STATIC"])


def build_host(build, prefix):
    run("cmake", "-S", SOURCE / "packaging/conan/test_package", "-B", build, "-G", CACHE["CMAKE_GENERATOR"],
        f"-DCMAKE_CXX_COMPILER={CACHE['CMAKE_CXX_COMPILER']}", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", build)
    run(build / "host")


class Conda(unittest.TestCase):
    FOLDER = SOURCE / "packaging/conda"

    def recipe(self):
        def load_file_regex(load_file, regex_pattern, from_recipe_dir):
            self.assertTrue(from_recipe_dir)
            return re.search(regex_pattern, (self.FOLDER / load_file).read_text())

        text = (self.FOLDER / "meta.yaml").read_text()
        names = {"load_file_regex": load_file_regex, "compiler": lambda language: f"compiler_{language}",
                 "stdlib": lambda language: f"stdlib_{language}", "pin_subpackage": lambda name, max_pin: f"{name} {max_pin}"}
        return yaml.safe_load(jinja2.Environment(undefined=jinja2.StrictUndefined).from_string(text).render(names))

    def test_metadata(self):
        recipe = self.recipe()
        self.assertEqual(str(recipe["package"]["version"]), VERSION)
        self.assertTrue((self.FOLDER / recipe["source"]["path"] / recipe["about"]["license_file"]).is_file())
        for file in recipe["test"]["source_files"]:
            self.assertTrue((SOURCE / file).exists(), file)
        self.assertIn("libopencv", recipe["requirements"]["host"])

    def test_options_of_the_build(self):
        """build.sh runs up to the compilers: with a cmake in front that only notes its arguments."""
        tools = WORK / "conda/bin"
        tools.mkdir(parents=True, exist_ok=True)
        calls = WORK / "conda/calls"
        calls.write_text("")
        (tools / "cmake").write_text(f'#!/bin/sh\necho "$@" >> "{calls}"\n')
        (tools / "cmake").chmod(0o755)
        environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "PREFIX": "/prefix", "CPU_COUNT": "3"}
        run(self.FOLDER / "build.sh", cwd=SOURCE, env=environment)
        configure, build, installs = (shlex.split(line) for line in calls.read_text().splitlines())
        options = {part[2:].split("=")[0] for part in configure if part.startswith("-DDOT_")}
        self.assertTrue(options)
        self.assertEqual(options - OPTIONS, set())
        self.assertIn("-DCMAKE_INSTALL_PREFIX=/prefix", configure)
        self.assertEqual(build, ["--build", "build-conda", "--parallel", "3"])
        self.assertEqual(installs, ["--install", "build-conda"])

    def test_commands(self):
        """The recipe's test commands, of the static install tree those that do not want libdot_core shared."""
        prefix = WORK / "conda/prefix"
        install(prefix)
        work = WORK / "conda/test"
        shutil.rmtree(work, ignore_errors=True)
        for file in self.recipe()["test"]["source_files"]:
            shutil.copytree(SOURCE / file, work / file)
        environment = {**os.environ, "PREFIX": str(prefix), "SHLIB_EXT": ".so", "CMAKE_PREFIX_PATH": str(prefix),
                       "PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig"), "CXX": CACHE["CMAKE_CXX_COMPILER"],
                       "CMAKE_ARGS": ""}
        commands = self.recipe()["test"]["commands"]
        shared = CACHE.get("BUILD_SHARED_LIBS") == "ON"
        ran = 0
        for command in commands:
            if not shared and "libdot_core" in command:
                continue
            run("bash", "-ec", command, cwd=work, env=environment)
            ran += 1
        self.assertGreaterEqual(ran, len(commands) - 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
