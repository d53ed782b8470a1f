#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of a segmented mesh, by matplotlib.

    picture.py elephant.off -o elephant.png
    picture.py elephant.off --segments 6 --show

For meshes of up to some 100,000 triangles; picture_by_vtk.py draws larger ones, and more exactly.
Needs matplotlib, Debian's package python3-matplotlib.
"""

import argparse

import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from spectral_segmentation import read, segment, segment_colors

AROUND, ABOVE = 30, 20 # degrees by which the view is turned and raised
TOWARD_LIGHT = np.array([0.70, -0.12, 0.70]) # to the left of the viewer, and above


def draw(axes, mesh, labels, up="y"):
    """Draws the segments, each in a color of its own, into three-dimensional axes."""
    points = np.roll(mesh.points, 2 - "xyz".index(up), axis=1) # so that z is up
    corners = points[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    # Both sides of a surface are lit, as triangles may be oriented in any way.
    lit = np.abs(normals @ TOWARD_LIGHT) / np.where(lengths > 0, lengths, 1)
    colors = segment_colors(mesh.triangles, labels)[labels] / 255
    colors *= (0.45 + 0.55 * lit)[:, np.newaxis]
    axes.add_collection3d(Poly3DCollection(corners, facecolors=colors, edgecolors=colors,
                                           linewidths=0.2))
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    middle, half = (low + high) / 2, max(high - low) / 2
    for set_limits, m in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), middle):
        set_limits(m - half, m + half)
    axes.set_box_aspect((1, 1, 1), zoom=1.6)
    axes.view_init(ABOVE, AROUND)
    axes.set_axis_off()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", help="OFF, OBJ, PLY or STL")
    parser.add_argument("-o", "--output", default="picture.png", help="[%(default)s]")
    parser.add_argument("--segments", type=int, metavar="N", help="the number of segments")
    parser.add_argument("--up", choices="xyz", default="y", help="the axis that is up [%(default)s]")
    parser.add_argument("--show", action="store_true", help="open a window, too")
    arguments = parser.parse_args()

    mesh = read(arguments.mesh)
    labels = segment(mesh, number_of_segments=arguments.segments)
    figure = plt.figure(figsize=(7, 7))
    axes = figure.add_axes([0, 0, 1, 0.93], projection="3d")
    draw(axes, mesh, labels, arguments.up)
    axes.set_title("%d segments" % (labels.max() + 1))
    figure.savefig(arguments.output, dpi=150)
    if arguments.show:
        plt.show()


if __name__ == "__main__":
    main()
