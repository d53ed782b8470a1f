# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the package from the headers of the repository, or from their copies in an sdist.

CPPFLAGS may name the folders of CGAL, Boost, Eigen, nlohmann-json and TBB, such as
-I/opt/cgal/include. SPECTRAL_SEGMENTATION_TBB=0 leaves out TBB, so that the package needs no
library, but has no threads.
"""

import os
import pathlib
import re
import shutil
import tempfile

from pybind11.setup_helpers import ParallelCompile, Pybind11Extension, build_ext
from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE if (HERE / "include").is_dir() else HERE.parent.parent
# The files and folders outside of this folder that the package needs
SHARED = ["LICENSE", "include", "bindings/files", "bindings/meshes"]
THREE_JS = ["three.min.js", "OrbitControls.js"] # for the page, as in page.cmake

TBB_PROGRAM = """
#include <tbb/task_arena.h>
int main() { return tbb::this_task_arena::max_concurrency() > 0 ? 0 : 1; }
"""


def version():
    header = (ROOT / "include/CGAL/Spectral_segmentation/version.h").read_text()
    return re.search(r'VERSION "(.*)"', header).group(1)


def headers():
    """Returns the files that the sources include: a change of any makes the extension outdated."""
    folders = [ROOT / "include", ROOT / "bindings/files", ROOT / "bindings/meshes", HERE / "src"]
    return [str(path) for folder in folders for path in sorted(folder.rglob("*.h"))]


def eigen_folders():
    prefixes = ["/usr", "/usr/local", "/opt/homebrew"]
    folders = [os.path.join(prefix, "include", "eigen3") for prefix in prefixes]
    return [folder for folder in folders if os.path.isdir(folder)]


def three_js_files():
    """Returns the files of three.js: from an sdist, or from Debian's package libjs-three."""
    debian = pathlib.Path("/usr/share/javascript/three")
    for folders in ([HERE / "three"] * 2, [debian, debian / "examples/js/controls"]):
        files = [folder / name for folder, name in zip(folders, THREE_JS)]
        if all(file.is_file() for file in files):
            return files
    print("No three.js: the package makes no page")
    return []


class BuildPy(build_py):

    def run(self):
        super().run()
        target = pathlib.Path(self.build_lib, "spectral_segmentation", "page")
        target.mkdir(parents=True, exist_ok=True)
        page = ROOT / "bindings/meshes/page"
        for file in [*page.glob("*.html"), *page.glob("*.css"), *page.glob("*.js"),
                     *three_js_files()]:
            shutil.copyfile(file, target / file.name)


class Build(build_ext):

    def has_tbb(self):
        if os.environ.get("SPECTRAL_SEGMENTATION_TBB") == "0":
            return False
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "tbb.cpp")
            pathlib.Path(source).write_text(TBB_PROGRAM)
            try:
                objects = self.compiler.compile([source], output_dir=folder,
                                                extra_postargs=["-std=c++17"])
                self.compiler.link_executable(objects, "tbb", folder, libraries=["tbb"],
                                              target_lang="c++")
            except Exception: # of distutils, whose module moves
                print("No TBB: the package is built without threads")
                return False
        return True

    def finalize_options(self):
        super().finalize_options()
        # Nobody knows whether headers of other folders have changed.
        self.force = bool(self.force or os.environ.get("CPPFLAGS"))

    def build_extensions(self):
        has_tbb = self.has_tbb()
        if has_tbb:
            for extension in self.extensions:
                extension.define_macros.append(("CGAL_LINKED_WITH_TBB", "1"))
                extension.libraries.append("tbb")
        # The result of an earlier build with the other choice is outdated.
        choice = pathlib.Path(self.build_temp, "tbb")
        self.force = self.force or not choice.is_file() or choice.read_text() != str(has_tbb)
        super().build_extensions()
        choice.parent.mkdir(parents=True, exist_ok=True)
        choice.write_text(str(has_tbb))


class Sdist(sdist):

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for name in SHARED:
            target = pathlib.Path(base_dir, name)
            target.parent.mkdir(parents=True, exist_ok=True)
            if (ROOT / name).is_dir():
                shutil.copytree(ROOT / name, target, dirs_exist_ok=True)
            else:
                shutil.copyfile(ROOT / name, target)
        for file in three_js_files():
            pathlib.Path(base_dir, "three").mkdir(exist_ok=True)
            shutil.copyfile(file, pathlib.Path(base_dir, "three", file.name))


ParallelCompile("SPECTRAL_SEGMENTATION_JOBS").install()
setup(
    version=version(),
    cmdclass={"build_ext": Build, "build_py": BuildPy, "sdist": Sdist},
    ext_modules=[Pybind11Extension(
        "spectral_segmentation._core",
        ["src/engine.cpp", "src/mesh_files.cpp", "src/page.cpp", "src/parts.cpp",
         "src/segmentation.cpp"],
        include_dirs=[str(ROOT / "include"), str(ROOT / "bindings"), *eigen_folders()],
        depends=[__file__, *headers()],
        # CGAL takes the exact numbers of Boost instead of GMP, so that a wheel needs no library.
        define_macros=[("CGAL_SPECTRAL_SEGMENTATION_COMPILED", "1"), ("NDEBUG", "1"),
                       ("CGAL_DISABLE_GMP", "1")],
        # Labels do not depend on whether the processor has fused multiplications.
        extra_compile_args=["-O2", "-g0", "-ffp-contract=off"],
        cxx_std=17)])
