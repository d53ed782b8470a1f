# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The build of the package knows the files that it depends on."""

import os
import pathlib
import subprocess
import sys

import pytest

PACKAGE = pathlib.Path(__file__).resolve().parents[1]
HEADERS = ["include/CGAL/Spectral_segmentation/version.h", "bindings/files/read_off.h",
           "bindings/python/src/arrays.h"]

# For each header prints whether the build would compile an extension that is older than the header,
# and one that is younger.
PROGRAM = """
import os, pathlib, sys
import setuptools
from distutils.core import run_setup
command = run_setup("setup.py", stop_after="init").get_command_obj("build_ext")
command.build_lib = sys.argv[1]
command.ensure_finalized()
class Compiler:
    def compile(self, *_, **__):
        raise EOFError
command.compiler = Compiler()
extension, = command.extensions
made = pathlib.Path(command.get_ext_fullpath(extension.name))
made.parent.mkdir()
made.touch()
assert set(sys.argv[2:]) < set(extension.depends)
for header in sys.argv[2:]:
    extension.depends, extension.sources = [header], []
    for seconds in (-10, 10):
        os.utime(made, (0, os.path.getmtime(header) + seconds))
        try:
            command.build_extension(extension)
        except EOFError:
            print("old", end=" ", file=sys.stderr)
        else:
            print("new", end=" ", file=sys.stderr)
"""


@pytest.mark.skipif(not (PACKAGE / "../../include").is_dir(), reason="only in the repository")
@pytest.mark.parametrize("flags, states",
                         [("", "old new "), ("-I/opt/cgal/include", "old old ")])
def test_a_changed_header_makes_the_extension_outdated(tmp_path, flags, states):
    pytest.importorskip("setuptools")
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", PROGRAM, tmp_path,
                           *(PACKAGE.parents[1] / header for header in HEADERS)],
                          cwd=PACKAGE, env={**os.environ, "CPPFLAGS": flags}, check=True,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    assert done.stderr == states * len(HEADERS)


# For each choice of TBB prints whether the build compiles an extension that is younger than all
# files.
CHOICES = """
import os, pathlib, sys
import setuptools
from distutils.core import run_setup
command = run_setup("setup.py", stop_after="init").get_command_obj("build_ext")
command.build_lib = command.build_temp = sys.argv[1]
command.ensure_finalized()
class Compiler:
    def compile(self, *_, **__):
        print("built", end=" ", file=sys.stderr)
        return []
    def link_shared_object(self, *_, **__):
        pass
command.compiler = Compiler()
extension, = command.extensions
extension.language = "c++"
made = pathlib.Path(command.get_ext_fullpath(extension.name))
made.parent.mkdir()
made.touch()
for has_tbb in (True, True, False, False, True):
    print(has_tbb, end=" ", file=sys.stderr)
    command.has_tbb = lambda: has_tbb
    command.force = False
    command.build_extensions()
"""


@pytest.mark.skipif(not (PACKAGE / "../../include").is_dir(), reason="only in the repository")
def test_another_choice_of_tbb_makes_the_extension_outdated(tmp_path):
    pytest.importorskip("setuptools")
    environment = {name: value for name, value in os.environ.items() if name != "CPPFLAGS"}
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", CHOICES, tmp_path], cwd=PACKAGE,
                          env=environment, check=True, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True)
    assert done.stderr == "True built True False built False True built "
