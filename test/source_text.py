#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""source_text.py SOURCE_DIR: checks the layout of the sources, and what they name.

Lines have at most 100 columns, and no tabs or blanks at the end. A comment in include/ begins with
its subject or its verb. Bindings and examples use public headers and names only, and the
segmentation includes no header of Segmented_mesh. Folders of internal/ include only those below.
"""

import pathlib
import re
import sys

FOLDERS = ("include", "examples", "bindings", "benchmark", "test", "scripts", "doc/figures")
SUFFIXES = (".h", ".cpp", ".py", ".js", ".mjs", ".ts", ".cmake", ".sh")
LONG_LINES = ("test/compile_failure/",) # each line has the error that it must cause
OPENING = re.compile(r"\s*// (Of|As|But|Where|What|Without) ")
# The folders of internal/ whose headers each folder must not include
INTERNAL_FOLDERS = ("tree", "levels", "search", "salience", "weights", "surface", "base")
FOLDERS_ABOVE = [(folder, ("read",) + INTERNAL_FOLDERS[:i])
                 for i, folder in enumerate(INTERNAL_FOLDERS)]
FOLDERS_ABOVE.append(("read", INTERNAL_FOLDERS[:-2]))
# Words that files must not have
FORBIDDEN = (
    (re.compile(r"(bindings|examples)/"),
     re.compile(r"#include .CGAL/.*\binternal/|\binternal::|::internal\b|namespace internal\b"),
     "a header or a name of internal"),
    (re.compile(r"include/CGAL/(?!Segmented_mesh/)"),
     re.compile(r"#include .CGAL/Segmented_mesh/"), "a header of Segmented_mesh"),
    *((re.compile("include/CGAL/Spectral_segmentation/internal/%s/" % folder),
       re.compile("internal/(?:%s)/" % "|".join(others)), "a header of a folder above its own")
      for folder, others in FOLDERS_ABOVE))


def problems(path, name):
    previous = ""
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if len(line) > 100 and not name.startswith(LONG_LINES):
            yield number, "%d columns" % len(line)
        if "\t" in line or line != line.rstrip():
            yield number, "a tab, or a blank at the end"
        begins_comment = not previous.lstrip().startswith("//")
        if name.startswith("include/") and begins_comment and OPENING.match(line):
            yield number, "a comment that begins with neither its subject nor its verb"
        for names, words, problem in FORBIDDEN:
            if names.match(name) and words.search(line):
                yield number, problem
        previous = line


def main(source):
    found = 0
    for path in sorted(p for folder in FOLDERS for p in (source / folder).rglob("*")):
        name = path.relative_to(source).as_posix()
        if path.suffix not in SUFFIXES or "node_modules" in name or "/build" in name:
            continue
        for number, problem in problems(path, name):
            print("%s:%d: %s" % (name, number, problem))
            found += 1
    sys.exit(1 if found else 0)


main(pathlib.Path(sys.argv[1]))
