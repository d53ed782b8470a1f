#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_numbers.py SURPRISES TOOL MESHES

Runs the tool on CGAL's meshes, and fails if the page "When the Result Surprises You" has another
result.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    text = " ".join(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").split())
    tool, meshes = pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])

    def run(name, *options):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([tool, meshes.resolve() / name, *options], check=True, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=folder)
        return done.stdout + done.stderr

    def number(name, *options):
        return json.loads(run(name, *options, "--quiet", "--json", "-"))["segments"]

    def salience(name):
        report = json.loads(run(name, "--quiet", "--json", "-"))
        return max(node["salience"] or 0 for node in report["hierarchy"]["nodes"])

    statements = [
        "with the probability %.2f." % salience("handle.off"),
        "segment_mesh handle.off -o parts.ply --salience-threshold 0.1 # %d segments" %
        number("handle.off", "--salience-threshold", "0.1"),
        "The elephant of \\cgal's demos has %d segments by default, %d with the threshold 0.5, and "
        "%d with the smallest area 0.05." %
        (number("elephant.off"), number("elephant.off", "--salience-threshold", "0.5"),
         number("elephant.off", "--minimum-segment-size", "0.05")),
        "The elephant has %d segments, and its refined copy with 88,928 faces has %d." %
        (number("elephant.off"), number("refined_elephant.off")),
        "this pig of \\cgal's demos begins with \"%s\"" %
        re.search("the input intersects itself in [0-9]+ pairs of faces",
                  run("pig.stl", "--split-dir", "parts", "--close"))[0]]
    wrong = [statement for statement in statements if statement not in text]
    if number("handle.off") != 1:
        wrong.append("handle.off has one segment")
    if wrong:
        sys.exit("The page states other numbers than:\n" + "\n".join(wrong))


if __name__ == "__main__":
    main()
