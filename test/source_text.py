#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""source_text.py SOURCE_DIR: checks the layout of the sources, and the names in them.

Lines have at most 100 columns, and no tabs or blanks at the end. A comment begins with its subject
or its verb, and has none of some private words. A comment on a function begins with a verb.
Bindings and examples use public headers and names only, and the segmentation includes no header of
Segmented_mesh. Folders of the engine include only those below, also through public headers.
include/ does not grow beyond a number of lines.
"""

import pathlib
import re
import sys

FOLDERS = ("include", "examples", "bindings", "benchmark", "test", "scripts", "doc/figures")
SUFFIXES = (".h", ".cpp", ".py", ".js", ".mjs", ".ts", ".cmake", ".sh")
LONG_LINES = ("test/compile_failure/",) # each line has the error that it must cause
OPENING = re.compile(r"\s*(?://[/!]?|#|/\*\*|\"\"\") ?(?:Of|As|But|Where|What|Without) ")
COMMENT = re.compile(r"(?:(?:^|\s)(?:///?|#|/\*\*)|^\s*\*) (.*)")
# The words of the field are fraction, message, and to report, determine or have in common.
PRIVATE_WORDS = re.compile(r"(?<![/\w])(?:[Tt]ells?|[Ss]entences?|[Ss]hares?)\b")
# A function with its type, which constructors do not have, after its template arguments are removed
FUNCTION = re.compile(r"[^={;#]*[\w*&\]] +[*&]*(?:\w+|operator\W+)\(")
VERB = re.compile(r" *// (?!This\b|Its\b)[A-Z][a-z]+s\b")
CLASS = re.compile(r" *(?:template.*> )?(?:class|struct)\b")
# The folders of the engine: each includes headers of those after it only, also through public
# headers. engine.h, run.h and cut_surface.h belong to no folder.
ENGINE = "CGAL/Spectral_segmentation/internal/"
ENGINE_FOLDERS = ("model", "constraints", "levels", "search", "salience", "hierarchy",
                  "weights", "read", "surface", "base")
INCLUDE = re.compile(r"#include <(CGAL/(?:Spectral_segmentation|Segmented_mesh)[^>]*)>")
MOST_LINES_OF_INCLUDE = 19380
# Words that files must not have
FORBIDDEN = (
    (re.compile(r"(bindings|examples)/"),
     re.compile(r"#include .CGAL/.*\binternal/|\binternal::|::internal\b|namespace internal\b"),
     "a header or a name of internal"),
    (re.compile(r"include/CGAL/(?!Segmented_mesh/)"),
     re.compile(r"#include .CGAL/Segmented_mesh/"), "a header of Segmented_mesh"))


def folder_of(header):
    """The folder of a header of the engine, else None."""
    parts = header[len(ENGINE):].split("/") if header.startswith(ENGINE) else ()
    return parts[0] if len(parts) == 2 else None


def includes_of_folders(include):
    """The pairs of a header of a folder and a header of another one, which it includes itself or
    through public headers."""
    included = {path.relative_to(include).as_posix(): INCLUDE.findall(path.read_text("utf-8"))
                for path in include.rglob("*.h")}
    for header in sorted(filter(folder_of, included)):
        reached = list(included[header])
        for other in reached: # grows
            if folder_of(other) is None:
                reached += [h for h in included[other] if h not in reached]
            elif folder_of(other) != folder_of(header):
                yield header, other


def comment_of(line, is_docstring):
    """Returns the comment in a line, or a line of a docstring."""
    comment = COMMENT.search(line)
    return line if is_docstring else comment[1] if comment else ""


def comments_without_verb(lines):
    """Yields the number of each comment directly above a function, at the level of a namespace or a
    class, that does not begin with a verb in the third person, such as Returns."""
    is_comment = [line.lstrip().startswith("//") for line in lines]
    for i, line in enumerate(lines):
        if not line.lstrip().startswith("// ") or is_comment[i - 1]:
            continue
        end = is_comment.index(False, i)
        code = " ".join(lines[end:end + 4]).replace("explicit ", "") if lines[end] else ""
        while re.search("<[^<>]*>", code):
            code = re.sub("<[^<>]*>", "", code)
        # The line that begins the scope is less indented, and neither a label nor a brace.
        outer = re.compile(" {0,%d}[^ #/{].*[^:]$" % (len(line) - len(line.lstrip()) - 1))
        scope = next(filter(outer.match, reversed(lines[:i])), "class" if line[0] == "/" else "")
        if FUNCTION.match(code) and CLASS.match(scope) and not VERB.match(line):
            yield i + 1


def problems(path, name):
    previous, is_docstring = "", False
    lines = path.read_text(encoding="utf-8").split("\n")
    if path.suffix in (".h", ".cpp") and "test/" not in name:
        for number in comments_without_verb(lines):
            yield number, "a comment on a function that begins with no verb, such as Returns"
    for number, line in enumerate(lines, 1):
        if len(line) > 100 and not name.startswith(LONG_LINES):
            yield number, "%d columns" % len(line)
        if "\t" in line or line != line.rstrip():
            yield number, "a tab, or a blank at the end"
        begins_comment = not previous.lstrip().startswith(("//", "# "))
        if begins_comment and OPENING.match(line):
            yield number, "a comment that begins with neither its subject nor its verb"
        quotes = line.count('"""') if path.suffix == ".py" else 0
        if PRIVATE_WORDS.search(comment_of(line, is_docstring or quotes > 0)):
            yield number, "a private word: " + line.strip()
        is_docstring ^= quotes % 2 == 1
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
    for header, other in includes_of_folders(source / "include"):
        if ENGINE_FOLDERS.index(folder_of(other)) < ENGINE_FOLDERS.index(folder_of(header)):
            print("%s includes %s, of a folder above its own" % (header, other))
            found += 1
    lines = sum(len(path.read_text(encoding="utf-8").splitlines())
                for path in (source / "include").rglob("*.h"))
    if lines > MOST_LINES_OF_INCLUDE:
        print("include/ has %d lines, more than %d" % (lines, MOST_LINES_OF_INCLUDE))
        found += 1
    sys.exit(1 if found else 0)


main(pathlib.Path(sys.argv[1]))
