#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""contracted.py TOOL CONTRACTED_TOOL MESHES: checks that fused multiplications change no labels.

CONTRACTED_TOOL is the tool with an engine that was compiled for a processor with fused
multiplications, which the compiler may use wherever it likes.
"""

import pathlib
import subprocess
import sys

NAMES = ("elephant", "bunny00", "fandisk_large", "triceratops", "hand", "cactus", "camel", "cow",
         "dino", "lion", "homer", "bull")


def labels(tool, mesh, method):
    return subprocess.run([tool, mesh, "--quiet", "--method", method, "--labels", "-"], check=True,
                          stdout=subprocess.PIPE).stdout.split()


def main(tool, contracted_tool, meshes):
    failures = 0
    for name in NAMES:
        for method in ("calibrated", "paper"):
            mesh = pathlib.Path(meshes) / (name + ".off")
            pairs = list(zip(labels(tool, mesh, method), labels(contracted_tool, mesh, method)))
            number = sum(a != b for a, b in pairs)
            if number > 0 or not pairs:
                print("%s, %s: %d of %d labels differ" % (name, method, number, len(pairs)))
                failures += 1
    return failures > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
