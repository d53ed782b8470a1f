#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""readme_blocks.py SOURCE_DIR HAS_TBB CMAKE_OPTION ...

Runs the blocks of README.md as they stand. The program is compiled once; the other ways to get the
package are configured, each with and without TBB. What installs packages, runs the tests or draws
is looked up only. The blocks for Python are run by bindings/python/test.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "helpers"))
from mesh_files import write_off
from meshes import dumbbell

SOURCE = None
HAS_TBB = None
OPTIONS = None

# Packages that a machine need not have to install the headers
NOT_NEEDED = ["CLI11", "nlohmann_json", "assimp", "OpenMesh", "Python3", "Doxygen", "TBB"]

# In the shell of a block, cmake has further options where it configures.
SHELL = """
options=("$@")
cmake() {
  if [[ $1 == -S ]]; then command cmake "$@" "${options[@]}"; else command cmake "$@"; fi
}
"""


def blocks_of(text, language):
    """Returns the fenced blocks of a language. Blocks of `shell` are indented."""
    if language == "shell":
        blocks = re.findall(r"\n\n((?: {4}.*\n)+)", text)
        return [re.sub(r"^ {4}", "", block, flags=re.MULTILINE) for block in blocks]
    return re.findall(r"^```%s\n(.*?)^```$" % language, text, re.MULTILINE | re.DOTALL)


class Readme(unittest.TestCase):

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)
        readme = (SOURCE / "README.md").read_text(encoding="utf-8")
        self.readme = readme
        self.shell = blocks_of(readme, "shell")
        self.program, = blocks_of(readme, "cpp")
        self.project, *self.instead_of_find_package = blocks_of(readme, "cmake")

    def run_command(self, command, **options):
        done = subprocess.run(command, text=True, check=False, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def install(self):
        """Runs the block that installs the headers, in a copy of the repository."""
        block, = (block for block in self.shell if "cmake --install" in block)
        clone = self.directory / "clone"
        clone.mkdir()
        for path in SOURCE.iterdir():
            if not path.name.startswith("build"):
                (clone / path.name).symlink_to(path)
        disabled = ["-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON" % name for name in NOT_NEEDED]
        self.run_command(["bash", "-euc", SHELL + block, "bash", *OPTIONS, *disabled], cwd=clone,
                         env={**os.environ, "DESTDIR": str(self.directory / "root")})
        return self.directory / "root/usr/local"

    def configure(self, name, way, tbb, *options):
        """Configures the block for CMake with `way` for find_package(). Returns the folder."""
        folder = self.directory / name
        folder.mkdir()
        self.assertEqual(self.project.count("find_package(Spectral_segmentation REQUIRED)\n"), 1)
        project = re.sub(r"find_package\(Spectral_segmentation REQUIRED\)\n", way or r"\g<0>",
                         self.project)
        # The other target too
        project += ("add_executable(header_only my_program.cpp)\n"
                    "target_link_libraries(header_only PRIVATE "
                    "Spectral_segmentation::Spectral_segmentation)\n")
        (folder / "CMakeLists.txt").write_text(project)
        (folder / "my_program.cpp").write_text(self.program)
        (folder / "spectral_segmentation").symlink_to(SOURCE)
        done = self.run_command([
            "cmake", "--no-warn-unused-cli", "-S", folder, "-B", folder / "build",
            *OPTIONS, *options,
            "-DFETCHCONTENT_SOURCE_DIR_SPECTRAL_SEGMENTATION=%s" % SOURCE,
            "-DCMAKE_DISABLE_FIND_PACKAGE_TBB=" + ("OFF" if tbb else "ON"),
            "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"])
        self.check_warnings(done.stderr, tbb)
        self.check_commands(folder / "build", tbb)
        return folder / "build"

    def check_warnings(self, errors, is_debug):
        """CMake warns of the build type if there is none."""
        self.assertEqual(errors.count("CMake Warning"), 0 if is_debug else 1, errors)
        self.assertEqual("CMAKE_BUILD_TYPE" in errors, not is_debug)

    def check_commands(self, build, tbb):
        """A user's project builds nothing else of the package, and uses TBB where it is found."""
        commands = json.loads((build / "compile_commands.json").read_text())
        names = sorted(pathlib.Path(command["file"]).name for command in commands)
        self.assertEqual(names, ["Spectral_segmentation_engine.cpp"] + 2 * ["my_program.cpp"])
        for command in commands:
            self.assertEqual("CGAL_LINKED_WITH_TBB" in command["command"], tbb and HAS_TBB)
            is_engine = command["file"].endswith("engine.cpp")
            self.assertEqual(" -O2" in command["command"], is_engine and not tbb)

    def check_both(self, name, way, *options):
        """With TBB in a Debug build, and without both."""
        self.configure(name + "-without-tbb", way, False, *options, "-DCMAKE_BUILD_TYPE=",
                       "-DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=OFF")
        return self.configure(name, way, True, *options)

    def test_program(self):
        root = self.install()
        self.assertFalse((root / "bin").exists())
        build = self.check_both("find_package", None, "-DSpectral_segmentation_ROOT=%s" % root)
        self.run_command(["cmake", "--build", build, "--target", "my_program"])
        write_off(self.directory / "mesh.off", *dumbbell())
        done = self.run_command([build / "my_program", self.directory / "mesh.off"],
                                cwd=self.directory)
        self.assertEqual(done.stdout, "2 segments\n")
        header = (self.directory / "segments.ply").read_bytes().split(b"end_header")[0]
        self.assertIn(b"property uchar red", header[header.index(b"element face"):])

    def test_that_switches_are_named_where_programs_lack_packages(self):
        done = subprocess.run(
            ["cmake", "-S", SOURCE, "-B", self.directory / "build", *OPTIONS,
             "-DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON"],
            text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr.count("CMake Error"), 1, done.stderr)
        install, = (block for block in self.shell if "cmake --install" in block)
        switches = re.findall(r"-D(\w+)=OFF", install)
        self.assertEqual(len(switches), 3)
        for switch in switches:
            self.assertIn(switch, done.stderr)

    def test_ways_without_installation(self):
        subdirectory, fetch_content = self.instead_of_find_package
        self.assertIn("FetchContent_Declare", fetch_content)
        for name, way in (("subdirectory", subdirectory), ("fetch_content", fetch_content)):
            with self.subTest(name):
                self.check_both(name, way)

    def test_that_commands_and_files_in_blocks_exist(self):
        commands = [line for block in self.shell for line in block.splitlines()]
        scripts = [command.split()[0] for command in commands if command.startswith("scripts/")]
        self.assertGreater(len(scripts), 2)
        for script in scripts:
            self.assertTrue(os.access(SOURCE / script, os.X_OK), script)
        for command in commands:
            if command.startswith("scripts/setup.sh"):
                setup = (SOURCE / "scripts/setup.sh").read_text()
                for group in command.split()[1:]:
                    self.assertRegex(setup, r"(?m)^    %s\)" % group)
        others = {command.split()[0] for command in commands} - set(scripts)
        self.assertLessEqual(others, {"build/bindings/command_line/segment_mesh", "cmake",
                                      "/usr/bin/python3", "my_env/bin/pip",
                                      "-DSPECTRAL_SEGMENTATION_BUILD_EXAMPLES=OFF"})
        self.assertTrue((SOURCE / "bindings/command_line/segment_mesh.cpp").exists())
        self.assertTrue((SOURCE / "doc/CMakeLists.txt").exists())
        for path in re.findall(r"\]\((?!https?:)([^)]*)\)", self.readme):
            self.assertTrue((SOURCE / path).exists(), path)

    def test_that_the_manual_says_the_same(self):
        manual = (SOURCE / "doc/Spectral_segmentation.txt").read_text(encoding="utf-8")
        for block in (self.project, *self.instead_of_find_package):
            self.assertIn("\\code{.cmake}\n%s\\endcode" % block, manual)
        install, = (block for block in self.shell if "cmake --install" in block)
        self.assertIn("".join("    " + line for line in install.splitlines(True)), manual)


if __name__ == "__main__":
    SOURCE, HAS_TBB, OPTIONS = pathlib.Path(sys.argv[1]), sys.argv[2] == "1", sys.argv[3:]
    unittest.main(argv=sys.argv[:1])
