# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of meshes, by the readers and writers of the tool `segment_mesh`."""

import os
from collections import namedtuple

import numpy as np

from . import _core
from ._boundaries import segment_colors
from ._meshes import arrays_of, labels_array
from ._replace_file import replace_file

_READ = (".off", ".obj", ".ply", ".stl")
_WRITTEN = (".ply", ".obj", ".off", ".glb", ".stl")

Mesh = namedtuple("Mesh", "points triangles polygon_of_triangle")
Mesh.__doc__ = """A mesh that `read()` returns: `points`, shape (n, 3), float64; `triangles`, shape
(m, 3), int32; `polygon_of_triangle`, shape (m,), int32, which polygon of the file each triangle is
of."""


def _extension(path, known):
    extension = os.path.splitext(path)[1].lower()
    if extension not in known:
        raise ValueError("the name must end in %s or %s: %s"
                         % (", ".join(known[:-1]), known[-1], path))
    return extension


def read(path):
    """Reads the mesh of a file of OFF, OBJ, PLY or STL, as its name tells, and returns a `Mesh`.

    Polygons are cut into triangles. Where a file repeats points along a seam, or for each triangle
    as in STL, the triangles there have the first of them, so that they are neighbors.

    Raises OSError if the file cannot be opened, ValueError with the line or byte at fault if its
    contents contradict the format, or if it has no polygon.
    """
    path = os.fsdecode(path)
    extension = _extension(path, _READ)
    with open(path, "rb") as file:
        contents = file.read()
    try:
        mesh = Mesh(*_core.parse_mesh(contents, extension))
    except ValueError as error:
        raise ValueError("%s cannot be read: %s" % (path, error)) from None
    if len(mesh.triangles) == 0:
        raise ValueError("%s has no face with three different corners" % path)
    return mesh


def write(path, points, triangles=None, labels=None, *, colors=None):
    """Writes a mesh in the format that the name tells: PLY, OBJ, OFF, GLB, or STL without labels.

    points, triangles: the mesh, as for `segment()`; points of float32 are written with as few
        digits as these have.
    labels: array_like of integers, shape (m,), from 0 on: the segment of each triangle. PLY has
        them as the property 'segment' of faces, OBJ as groups, GLB as nodes. By default all are 0.
    colors: array_like of integers from 0 to 255, shape (number of segments, 3), by default those of
        `segment_colors()`. OBJ has them in a file of materials beside it, which is written too.

    Raises OSError if the file cannot be written, TypeError or ValueError if an argument has a wrong
    type, shape or range. An existing file is replaced only when the new one is complete.
    """
    path = os.fsdecode(path)
    extension = _extension(path, _WRITTEN)
    points, triangles = arrays_of(points, triangles)
    if triangles.size > 0 and not (triangles.min() >= 0 and triangles.max() < len(points)):
        raise ValueError("triangles have corners that are no indices of points")
    if not np.isfinite(points[triangles.ravel()]).all():
        raise ValueError("points have coordinates that are not finite")
    if labels is None:
        labels = np.zeros(len(triangles), np.intp)
    elif extension == ".stl":
        raise ValueError("STL has no labels")
    labels = labels_array(labels, len(triangles))
    if colors is None:
        colors = segment_colors(triangles, labels)
    colors = np.asarray(colors)
    number_of_segments = labels.max(initial=-1) + 1
    if colors.dtype.kind not in "iu" or colors.ndim != 2 or colors.shape[1] != 3 or \
            len(colors) < number_of_segments:
        raise ValueError("colors must be integers of shape (%d, 3)" % number_of_segments)
    if colors.size > 0 and not (colors.min() >= 0 and colors.max() <= 255):
        raise ValueError("colors must be from 0 to 255")
    materials = os.path.splitext(path)[0] + ".mtl" if extension == ".obj" else ""
    contents, of_materials = _core.format_mesh(
        extension, np.ascontiguousarray(points, np.float64), points.dtype == np.float32,
        np.ascontiguousarray(triangles, np.uint32), labels.astype(np.uint32),
        np.ascontiguousarray(colors, np.uint8), os.path.basename(materials))
    if materials:
        replace_file(materials, of_materials)
    replace_file(path, contents)
