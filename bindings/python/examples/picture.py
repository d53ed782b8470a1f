#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of a segmented mesh, by matplotlib.

    picture.py elephant.off -o elephant.png
    picture.py hand.off --segments 6 --up z -o hand.png

For meshes of up to some 100,000 triangles. picture_by_vtk.py draws larger ones faster, and large
triangles, such as in a cube, always in the right order.
Needs matplotlib, Debian's package python3-matplotlib.
"""

import argparse

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from spectral_segmentation import read, segment, segment_colors

# The viewer sees the mesh from its left and from above; the light is to the left of the viewer.
AROUND, ABOVE = np.radians([30, 20])
TOWARD_LIGHT = np.array([-0.4, 0.5, 0.77]) # to the right, up, and toward the viewer


def view(points, up):
    """Returns the coordinates of the points to the right, up, and toward the viewer."""
    rightward = [-np.sin(AROUND), np.cos(AROUND), 0]
    toward = [np.cos(ABOVE) * np.cos(AROUND), np.cos(ABOVE) * np.sin(AROUND), np.sin(ABOVE)]
    axes = np.stack([rightward, np.cross(toward, rightward), toward])
    return np.roll(points, 2 - "xyz".index(up), axis=1) @ axes.T


def draw(axes, mesh, labels, up="y"):
    """Draws the segments, each in a color of its own. Nearer triangles cover those behind them."""
    corners = view(mesh.points, up)[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    # Both sides of a surface are lit, as triangles may be oriented in any way.
    lit = np.abs(normals @ TOWARD_LIGHT) / np.where(lengths > 0, lengths, 1)
    colors = segment_colors(mesh.triangles, labels)[labels] / 255
    colors *= np.minimum(0.45 + 0.55 * lit, 1)[:, np.newaxis]
    order = corners[:, :, 2].mean(axis=1).argsort()
    axes.add_collection(PolyCollection(corners[order, :, :2], facecolors=colors[order],
                                       edgecolors="face", linewidths=0.2))
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_axis_off()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", help="OFF, OBJ, PLY or STL")
    parser.add_argument("-o", "--output", default="picture.png", help="[%(default)s]")
    parser.add_argument("--segments", type=int, metavar="N", help="the number of segments")
    parser.add_argument("--up", choices="xyz", default="y", help="the axis upwards [%(default)s]")
    arguments = parser.parse_args()

    mesh = read(arguments.mesh)
    labels = segment(mesh, number_of_segments=arguments.segments)
    figure, axes = plt.subplots(figsize=(8, 6))
    draw(axes, mesh, labels, arguments.up)
    axes.set_title("segments: %d" % (labels.max() + 1))
    figure.savefig(arguments.output, dpi=150, bbox_inches="tight")


if __name__ == "__main__":
    main()
