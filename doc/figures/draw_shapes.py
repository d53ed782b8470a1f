#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picture of README.md and of the manual's first page from what the tool gives.

  draw_shapes.py SEGMENT_MESH MESHES            draws doc/fig/shapes.png, and writes shapes.sha256
  draw_shapes.py SEGMENT_MESH MESHES --check    fails if a label is not one of those in the picture
"""

import argparse
import hashlib
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "fig"
VIEWS = {"armadillo": 200, "elephant": 150, "bear": 20, "elk": 30, "triceratops": 60, "femur": 30}
SIZE = (380, 300)


def segmented(tool, mesh, output):
    """The labels of a mesh; writes the colored mesh."""
    done = subprocess.run([tool, mesh, "-o", output, "--labels", "-", "--quiet"], check=True,
                          stdout=subprocess.PIPE)
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tool")
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    render = None
    if not arguments.check:
        sys.path.insert(0, str(FOLDER.parent.parent / "scripts"))
        import render
        render.ensure_display()
    with tempfile.TemporaryDirectory() as folder:
        sums, renderers = "", []
        for name, azimuth in VIEWS.items():
            colored = str(pathlib.Path(folder) / (name + ".ply"))
            labels = segmented(arguments.tool, arguments.meshes / (name + ".off"), colored)
            sums += "%s  %s\n" % (hashlib.sha256(labels).hexdigest(), name)
            if render:
                view = argparse.Namespace(edges=False, up="y", azimuth=azimuth, elevation=15,
                                          size=SIZE)
                renderers.append(render.renderer_of(colored, view))
        if render:
            render.write_picture(renderers, SIZE, FOLDER / "shapes.png", columns=3)
            (FOLDER / "shapes.sha256").write_text(sums)
        elif (FOLDER / "shapes.sha256").read_text() != sums:
            sys.exit("doc/fig/shapes.png is not what segment_mesh gives: draw it again")


if __name__ == "__main__":
    main()
