#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lays out the project in OUTPUT/Spectral_segmentation, as packages are in CGAL's source tree.

  lay_out_cgal_package.py OUTPUT [--pictures FOLDER] [--cgal FOLDER] [--aliases BASE_DOXYFILE]

FOLDER of --pictures is html/pictures of a manual that was built with pictures; without it, the
manual has no figures. The bindings, the programs that need them and their pages are left out.
Doxygen, if it is installed, builds the manual with the aliases of BASE_DOXYFILE, which is CGAL's
Documentation/doc/resources/*/BaseDoxyfile.in, or else with those of doc/Doxyfile.in, and there must
be no warning. With --cgal, the examples are compiled against the CGAL whose CGALConfig.cmake is in
FOLDER, without nlohmann-json; CMake names those whose libraries it does not find.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PACKAGE = "Spectral_segmentation"
ROOT = pathlib.Path(__file__).resolve().parents[1]
OWNER = "The Spectral_segmentation authors"
PAGES_LEFT_OUT = ("Bibliography", "Blender", "CMakeLists", "Developers", "Files", "JavaScript",
                  "Many_meshes", "Python", "Tool")

HEADER = """// Copyright (c) {year}  {owner}.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: {license}
//
// Author(s)     : {owner}
"""

CMAKE = """# This is the CMake script for compiling a CGAL application.

cmake_minimum_required(VERSION 3.12...3.31)
project({package}_{kind})

find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED)
include(CGAL_Eigen3_support)
find_package(TBB QUIET)
include(CGAL_TBB_support)
link_libraries(CGAL::Eigen3_support $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)
"""

# The libraries of programs: a pattern of their sources, the target, how CMake finds it, and the
# condition that it was found
LIBRARIES = (
    (r"CGAL/draw_", "CGAL::CGAL_Basic_viewer",
     "find_package(CGAL QUIET OPTIONAL_COMPONENTS Qt6)\n", "CGAL_Qt6_FOUND"),
    (r"<OpenMesh/", "CGAL::OpenMesh_support",
     "find_package(OpenMesh QUIET)\ninclude(CGAL_OpenMesh_support)\n",
     "TARGET CGAL::OpenMesh_support"),
    (r"<QApplication>", "Qt6::Widgets", "find_package(Qt6 QUIET COMPONENTS Widgets)\n"
     "add_compile_definitions(QT_NO_KEYWORDS) # TBB has a function emit()\n",
     "TARGET Qt6::Widgets"),
    (r"<nlohmann/|score_report\.h", "nlohmann_json::nlohmann_json",
     "find_package(nlohmann_json QUIET)\n", "TARGET nlohmann_json::nlohmann_json"),
    (r"<CLI/", "CLI11::CLI11", "find_package(CLI11 QUIET)\n", "TARGET CLI11::CLI11"),
    (r"<benchmark/", "benchmark::benchmark", "find_package(benchmark QUIET)\n",
     "TARGET benchmark::benchmark"))

TEST_LIBRARIES = """
find_package(Boost REQUIRED COMPONENTS unit_test_framework)
add_compile_definitions(
  BOOST_TEST_DYN_LINK
  SPECTRAL_SEGMENTATION_TEST_DATA_DIR="${CGAL_DATA_DIR}/meshes"
  SPECTRAL_SEGMENTATION_TEST_LABELS_DIR="${CMAKE_CURRENT_SOURCE_DIR}/labels")
add_library(test_main OBJECT main.cpp box_figures.cpp test_meshes.cpp)
target_link_libraries(test_main PUBLIC CGAL::CGAL Boost::unit_test_framework)
link_libraries(test_main)
"""

BENCHMARK_DEFINITIONS = """
add_compile_definitions(
  SPECTRAL_SEGMENTATION_MESHES_DIR="${CGAL_DATA_DIR}/meshes"
  SPECTRAL_SEGMENTATION_COMPILER_FLAGS="${CMAKE_CXX_FLAGS}")
"""

DOXYFILE = """@INCLUDE = ${CGAL_DOC_PACKAGE_DEFAULTS}

PROJECT_NAME       = "CGAL ${CGAL_DOC_VERSION} - Spectral Mesh Segmentation"
EXTRACT_ALL        = NO
HIDE_UNDOC_MEMBERS = YES
HIDE_UNDOC_CLASSES = YES
WARN_IF_UNDOCUMENTED = NO
SORT_MEMBER_DOCS   = NO
EXCLUDE            = ${CGAL_PACKAGE_INCLUDE_DIR}/CGAL/Spectral_segmentation/internal \\
                     ${CGAL_PACKAGE_INCLUDE_DIR}/CGAL/Segmented_mesh/internal
EXCLUDE_SYMBOLS   += *internal* *internal_np*
CITE_BIB_FILES    += ${CGAL_PACKAGE_DOC_DIR}/Spectral_segmentation.bib
# Names of parameters that a visitor does not use are commented out there.
FILTER_PATTERNS    = */Segmentation_visitor.h="sed -e s,/[*],,g -e s,[*]/,,g"
"""

BIB_ENTRY = """@misc{%s,
  author = {%s},
  title = {{%s}},
  howpublished = {%s},
  year = %s
}
"""

# The settings of CGAL's manual besides the aliases
DOXYGEN_SETTINGS = r"""
JAVADOC_AUTOBRIEF = YES
QT_AUTOBRIEF = YES
INHERIT_DOCS = NO
EXTENSION_MAPPING = txt=C++
TOC_INCLUDE_HEADINGS = 0
BUILTIN_STL_SUPPORT = YES
SUBGROUPING = NO
EXTRACT_STATIC = YES
FILE_PATTERNS = *.cpp *.txt *.md *.h *.hpp
RECURSIVE = YES
EXCLUDE_SYMBOLS = Tr Vb Cb Fb K Traits internal
EXAMPLE_PATTERNS = *.cpp *.h
EXAMPLE_RECURSIVE = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = DOXYGEN_RUNNING
GENERATE_LATEX = NO
SEARCHENGINE = NO
USE_MATHJAX = YES
HAVE_DOT = NO
CLASS_GRAPH = NO
QUIET = YES
ALIASES += "cgalPkgDescriptionBegin{2}=\details "
ALIASES += "cgalPkgManuals{2}=<div class=\"PkgManuals\"></div>"
"""


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def copy_include(output):
    first_lines = re.compile(
        r"// Copyright \(c\) (\d+)  (.*)\.\n// SPDX-License-Identifier: (.*)\n")
    for path in sorted((ROOT / "include").rglob("*.h")):
        text = path.read_text(encoding="utf-8")
        year, owner, license_ = first_lines.match(text).groups()
        header = HEADER.format(year=year, owner=owner, license=license_)
        write(output / path.relative_to(ROOT), first_lines.sub(header, text, 1))


def copy_source(path, folder, name):
    """Copies a source, and the headers of the bindings that it includes beside it."""
    if (folder / name).exists():
        return

    def include(match):
        other = (path.parent / match[1]).resolve()
        if "bindings" not in other.relative_to(ROOT).parts:
            return match[0]
        copy_source(other, folder, other.name)
        return '#include "%s"' % other.name

    write(folder / name, re.sub(r'#include "(.*)"', include, path.read_text(encoding="utf-8")))


def copy_programs(output, source, libraries, folders=()):
    """Copies the programs of a folder, or of some folders in it to one, with a CMakeLists.txt."""
    folder, root = output / source / PACKAGE, ROOT / source
    groups = {}
    for path in sorted(path for name in folders or (".",) for path in root.glob(name + "/*.cpp")):
        text = path.read_text(encoding="utf-8")
        copy_source(path, folder, path.name)
        if re.search(r"\bmain\(|BOOST_AUTO_TEST_CASE|BENCHMARK_MAIN", text):
            needed = tuple(entry for entry in LIBRARIES if re.search(entry[0], text))
            parts = ['"%s/%s"' % (path.stem, part.name)
                     for part in sorted((path.parent / path.stem).glob("*.cpp"))]
            program = 'create_single_source_cgal_program(%s)' % " ".join(
                ['"%s"' % path.name] + parts)
            groups.setdefault(needed, []).append((path.stem, program))
    if folders:
        for path in sorted(path for name in folders for path in root.glob(name + "/*.h")):
            copy_source(path, folder, path.name)
    else:
        for path in sorted(root.rglob("*.h")) + sorted(root.glob("*/*.cpp")):
            if path.parent.name != "test":
                copy_source(path, folder, path.relative_to(root))
    finds = dict.fromkeys(find for needed in groups for _, _, find, _ in needed)
    text = CMAKE.format(package=PACKAGE, kind=source.capitalize()) + libraries
    text += "".join("\n" + find for find in finds)
    for needed, programs in groups.items():
        targets = [target for _, target, _, _ in needed]
        lines = [line for name, program in programs for line in [program] + [
            "target_link_libraries(%s PRIVATE %s)" % (name, target) for target in targets]]
        if targets:
            names = ", ".join(name for name, _ in programs)
            lines = (["if(%s)" % " AND ".join(condition for _, _, _, condition in needed)]
                     + ["  " + line for line in lines]
                     + ["else()", '  message(STATUS "NOTICE: Not compiled, without %s: %s")'
                        % (", ".join(targets), names), "endif()"])
        text += "\n" + "\n".join(lines) + "\n"
    write(folder / "CMakeLists.txt", text)


def copy_figure(source, folder):
    """Copies the pictures of a figure of the manual. Returns a table of them."""
    fragment = source.read_text(encoding="utf-8").replace("&#x27;", "'")
    columns = int(re.search(r"columns-(\d)", fragment)[1])
    cells = []
    for name, caption in re.findall(
            r'<img src="pictures/([\w.]+)".*?<figcaption>(.*?)</figcaption>', fragment):
        shutil.copy(source.parent / name, folder)
        cells.append('<td><img src="%s" style="width:100%%"/><br>%s</td>' % (name, caption))
    rows = [" ".join(cells[i:i + columns]) for i in range(0, len(cells), columns)]
    return "<table border=0>\n%s\n</table>" % "\n".join("<tr>%s</tr>" % row for row in rows)


def copy_page(text, folder, pictures):
    """Returns a page without texts about the bindings, and copies its figures."""
    text = re.sub(r" *\\if standalone\n.*?\\endif\n", "", text, flags=re.DOTALL)
    text = text.replace(r"\cgalExample{", r"\cgalExample{%s/" % PACKAGE)
    if not pictures:
        return re.sub(r"\\cgalFigureAnchor.*?\\cgalFigureCaptionEnd\n", "", text, flags=re.DOTALL)
    return re.sub(r"\\htmlinclude\[block\] (\w+\.html)",
                  lambda match: copy_figure(pictures / match[1], folder / "fig"), text)


def bib_entries():
    """Returns the references of the manual as entries of BibTeX."""
    text = (ROOT / "doc/Bibliography.txt").read_text(encoding="utf-8")
    for key, reference in re.findall(r"<b>\[(\w+)\]</b>\s(.*?)\n\n", text[:-3] + "\n\n", re.DOTALL):
        reference = reference.replace("\n", " ").replace("&ouml;", '{\\"o}')
        authors, title, venue, year = re.fullmatch(
            r"(.*?): (.*?)\. (<em>.*), (\d{4})\.\s*", reference).groups()
        yield BIB_ENTRY % (
            key, authors.replace(", ", " and "), title, re.sub("</?em>", "", venue), year)


def copy_manual(output, pictures):
    folder = output / "doc" / PACKAGE
    shutil.copytree(ROOT / "doc/fig", folder / "fig")
    shutil.copytree(ROOT / "doc/Concepts", folder / "Concepts")
    for path in sorted((ROOT / "doc").glob("*.txt")):
        if path.stem not in PAGES_LEFT_OUT:
            text = path.read_text(encoding="utf-8")
            write(folder / path.name, copy_page(text, folder, pictures))
    write(folder / "Spectral_segmentation.bib", "\n".join(bib_entries()))
    examples = sorted(path.name for path in (output / "examples" / PACKAGE).glob("*.cpp"))
    write(folder / "examples.txt",
          "/*!\n" + "".join("\\example %s/%s\n" % (PACKAGE, name) for name in examples) + "*/\n")
    tags = (ROOT / "doc/cgal.tag").read_text(encoding="utf-8")
    write(folder / "dependencies",
          "".join(name + "\n" for name in sorted(set(re.findall(r"<filename>(\w+)/", tags)))))
    figures = sorted(path.name for path in (folder / "fig").iterdir() if path.name != "shapes.png")
    extra = "".join("HTML_EXTRA_FILES  += ${CGAL_PACKAGE_DOC_DIR}/fig/%s\n" % f for f in figures)
    write(folder / "Doxyfile.in", DOXYFILE + extra)


def packages_used(output, cgal):
    """Returns the packages of CGAL whose headers the package includes, from the URLs in them."""
    include = output / "include"
    headers = [path.relative_to(include).as_posix() for path in include.rglob("*.h")
               if path.name != "compiled.h"] # its effect is an option
    search = ["-I", str(include)] + (["-isystem", str(cgal / "include")] if cgal else [])
    rules = subprocess.run(
        [os.environ.get("CXX", "c++"), "-std=c++17", "-M", "-MG", "-x", "c++", "-"] + search,
        input="".join("#include <%s>\n" % header for header in sorted(headers)),
        stdout=subprocess.PIPE, check=True, text=True).stdout
    names = {PACKAGE}
    for path in re.findall(r"\S+/CGAL/\S+\.h(?=\s)", rules):
        text = pathlib.Path(path).read_text(encoding="utf-8", errors="replace")
        names.update(re.findall(r"\$URL: https://github.com/CGAL/cgal/blob/[^/]*/(\w+)/", text)[:1])
    return sorted(names)


def write_package_info(output, cgal):
    description = (ROOT / "doc/PackageDescription.txt").read_text(encoding="utf-8")
    title = re.search(r"\\cgalPkgDescriptionBegin\{(.*?),", description)[1]
    text = re.search(r"\\cgalPkgDesc\{(.*?)\}", description, re.DOTALL)[1]
    for name, content in {
            "copyright": OWNER, "maintainer": OWNER, "license.txt": "GPL (v3 or later)",
            "description.txt": title, "long_description.txt": text,
            "dependencies": "\n".join(packages_used(output, cgal))}.items():
        write(output / "package_info" / PACKAGE / name, content + "\n")


def check_manual(output, base, folder):
    """Builds the manual as CGAL does. Returns the warnings of Doxygen."""
    doc = output / "doc" / PACKAGE
    aliases = re.findall(r'"(cgal\w*(?:\{\d+\})?=.*)"', base.read_text(encoding="utf-8"))
    defaults = ['ALIASES += "%s"' % alias for alias in aliases] + [
        DOXYGEN_SETTINGS, "OUTPUT_DIRECTORY = %s" % folder, "INPUT = %s %s/include" % (doc, output),
        "EXAMPLE_PATH = %s/examples" % output, "IMAGE_PATH = %s/fig" % doc,
        "STRIP_FROM_PATH = %s %s/include" % (doc, output),
        "STRIP_FROM_INC_PATH = %s %s/include" % (doc, output),
        "TAGFILES = %s/doc/cgal.tag=https://doc.cgal.org/latest" % ROOT]
    if shutil.which("bibtex"):
        defaults.append(r'ALIASES += "cgalCite{1}=<!-- -->\cite \1"')
    else:
        print("There is no bibtex: the citations of the manual are not checked")
        defaults.append(r'ALIASES += "cgalCite{1}=[\1]"')
    write(folder / "defaults", "\n".join(defaults))
    text = (doc / "Doxyfile.in").read_text(encoding="utf-8")
    for name, value in {"CGAL_DOC_PACKAGE_DEFAULTS": folder / "defaults", "CGAL_DOC_VERSION": "",
                        "CGAL_PACKAGE_DOC_DIR": doc,
                        "CGAL_PACKAGE_INCLUDE_DIR": output / "include"}.items():
        text = text.replace("${%s}" % name, str(value))
    write(folder / "Doxyfile", text)
    return subprocess.run(["doxygen", folder / "Doxyfile"], cwd=folder, check=True, text=True,
                          stderr=subprocess.PIPE).stderr


def check_examples(output, cgal, folder):
    subprocess.run(["cmake", "-S", output / "examples" / PACKAGE, "-B", folder,
                    "-DCGAL_DIR=%s" % cgal, "-DCMAKE_CXX_FLAGS=-I%s/include" % output,
                    "-DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON",
                    "-DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON"], check=True)
    subprocess.run(["cmake", "--build", folder], check=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("output", type=pathlib.Path)
    for name in ("--pictures", "--cgal", "--aliases"):
        parser.add_argument(name, type=lambda path: pathlib.Path(path).resolve())
    arguments = parser.parse_args()
    output = arguments.output.resolve() / PACKAGE
    if output.exists():
        sys.exit("lay_out_cgal_package.py: %s exists already" % output)
    if arguments.cgal and not (arguments.cgal / "CGALConfig.cmake").exists():
        sys.exit("lay_out_cgal_package.py: %s has no CGALConfig.cmake" % arguments.cgal)

    copy_include(output)
    (output / "src").mkdir() # CGAL is header only
    copy_programs(output, "examples", "")
    copy_programs(output, "test", TEST_LIBRARIES, ("functions", "helpers", "rooms/*"))
    shutil.copytree(ROOT / "test/labels", output / "test" / PACKAGE / "labels")
    copy_programs(output, "benchmark", BENCHMARK_DEFINITIONS)
    copy_manual(output, arguments.pictures)
    write_package_info(output, arguments.cgal)

    with tempfile.TemporaryDirectory() as name:
        if not shutil.which("doxygen"):
            print("There is no doxygen: the manual is not checked")
        else:
            base = arguments.aliases or ROOT / "doc/Doxyfile.in"
            warnings = check_manual(output, base, pathlib.Path(name) / "doc")
            if warnings:
                sys.exit(warnings + "The manual has warnings")
            print("The manual has no warnings")
        if arguments.cgal:
            check_examples(output, arguments.cgal, pathlib.Path(name) / "examples")
            print("The examples compile, but for those that CMake has named")


if __name__ == "__main__":
    main()
