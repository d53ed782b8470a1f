# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of meshes, by the readers and writers of the tool `segment_mesh`."""

from __future__ import annotations

import os
import warnings
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._boundaries import colors_of
from ._checks import Path
from ._hierarchy import Hierarchy
from ._meshes import array, is_flat, labels_array, surface_of
from ._page import page_of
from ._replace_file import replace_file

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_READ = (".off", ".obj", ".ply", ".stl")
_WRITTEN = (".ply", ".obj", ".off", ".glb", ".stl", ".html")


class Mesh(NamedTuple):
    """A mesh that `read()` or `refine_boundaries()` returns.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 3)
    triangles : ndarray of int32, shape (m, 3)
        The indices of the corners in `points`.
    polygon_of_triangle : ndarray of int32, shape (m,)
        The polygon of the file, or of the mesh that was refined, to which each triangle belongs.
    labels : ndarray of int, shape (m,), or None
        The segment of each triangle, if known: a file has it as the property `segment` of PLY, or
        as the objects and groups of OBJ, which are numbered in the order of the file.
    colors : ndarray of float64, shape (m, 3), or None
        Red, green and blue of each triangle, in the unit of the file, if its faces or points have
        colors. They can be the `features` of `segment()`.
    """

    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    polygon_of_triangle: NDArray[np.int32]
    labels: Optional[NDArray[np.intp]] = None
    colors: Optional[NDArray[np.float64]] = None


def _extension(path, known, hint=""):
    extension = os.path.splitext(path)[1].lower()
    if extension not in known:
        raise ValueError("the name must end in %s or %s: %s%s"
                         % (", ".join(known[:-1]), known[-1], path, hint))
    return extension


def _labels_of_file(segments, extension):
    if len(segments) == 0 or not (segments == np.floor(segments)).all():
        return None
    if extension == ".obj":
        segments = np.unique(segments, return_inverse=True)[1]
    return segments.astype(np.intp)


def read(path: Path) -> Mesh:
    """Reads the mesh of a file of OFF, OBJ, PLY or STL, by the ending of its name.

    Polygons are cut into triangles. If a file repeats points along a seam, or for each triangle as
    in STL, the triangles there get the first of them, so that they are neighbors.

    Parameters
    ----------
    path : path_like

    Returns
    -------
    Mesh
        The points, the triangles, the polygon of each triangle, the labels that `write()` put into
        PLY or OBJ, and the colors. Files of OFF, GLB and STL keep no labels for `read()`.

    Raises
    ------
    OSError
        If the file cannot be opened.
    ValueError
        If its contents contradict the format, with the line or byte at fault, if it has no polygon,
        or if the name ends otherwise. The message names ways for GLB and other formats.

    Warns
    -----
    UserWarning
        If a part of the file is left out, such as a corner at a point that is not finite.
    """
    path = os.fsdecode(path)
    extension = _extension(path, _READ, "; for other formats give segment() the mesh that "
                           "trimesh.load(path, force='mesh') reads, or convert the file by "
                           "segment_mesh FILE --keep-faces -o mesh.ply")
    with open(path, "rb") as file:
        contents = file.read()
    try:
        *arrays, segments, colors, messages = _core.parse_mesh(contents, extension)
    except ValueError as error:
        raise ValueError("%s cannot be read: %s" % (path, error)) from None
    mesh = Mesh(*arrays, _labels_of_file(segments, extension),
                colors if len(colors) > 0 else None)
    if len(mesh.triangles) == 0:
        raise ValueError("; ".join(["%s has no face with three different corners" % path]
                                   + messages[:1]))
    for message in messages:
        warnings.warn("%s: %s" % (path, message), stacklevel=2)
    return mesh


def write(path: Path, points: Any, triangles: Union[ArrayLike, Hierarchy, None] = None,
          labels: Union[ArrayLike, Hierarchy, None] = None, *,
          colors: Optional[ArrayLike] = None) -> None:
    """Writes a mesh in the format of the ending of the name: PLY, OBJ, OFF, GLB, STL or HTML.

    STL has no labels. HTML is a page that shows the mesh, with a slider for the number of segments;
    it needs a `Hierarchy` in place of labels.

    An existing file is replaced only when the new one is complete.

    Parameters
    ----------
    path : path_like
    points : array_like of real numbers, shape (n, 3), or mesh
        The points, or a mesh of any kind that `segment()` takes. Labels follow a mesh directly, as
        in `write(path, mesh, labels)`. Points of float32 are written with as few digits as these
        have.
    triangles : array_like of integers, shape (m, 3), or polygons, optional
        The indices of the corners in `points`.
    labels : array_like of integers, shape (m,), or Hierarchy, default: 0 for all
        The segment of each triangle or polygon, from 0 on. PLY has them as the property `segment`
        of faces, OBJ as groups, GLB as nodes.
    colors : array_like of integers from 0 to 255, shape (number of segments, 3), optional
        The default is `segment_colors()`. OBJ has them in a file of materials beside it, which
        is written too.

    Raises
    ------
    OSError
        If the file cannot be written.
    TypeError, ValueError
        If an argument has a wrong type, shape or range.

    Warns
    -----
    UserWarning
        If corners at points that are not finite are left out.
    """
    path = os.fsdecode(path)
    extension = _extension(path, _WRITTEN)
    if labels is None and (isinstance(triangles, Hierarchy) or is_flat(triangles)):
        triangles, labels = None, triangles
    surface = surface_of(points, triangles)
    if extension == ".html":
        if colors is not None:
            raise ValueError("a page chooses its colors itself")
        name = os.path.splitext(os.path.basename(path))[0]
        return replace_file(path, page_of(surface, labels, name))
    if isinstance(labels, Hierarchy):
        labels = labels.labels()
    if labels is None:
        labels = np.zeros(len(surface), np.intp)
    elif extension == ".stl":
        raise ValueError("STL has no labels")
    labels = labels_array(labels, len(surface))
    core = surface.core # which checks the mesh
    if colors is None:
        colors = colors_of(surface, labels)
    colors = array("colors", colors)
    number_of_segments = labels.max(initial=-1) + 1
    if colors.dtype.kind not in "iu" or colors.ndim != 2 or colors.shape[1] != 3 or \
            len(colors) < number_of_segments:
        raise ValueError("colors must be integers of shape (%d, 3)" % number_of_segments)
    if colors.size > 0 and not (colors.min() >= 0 and colors.max() <= 255):
        raise ValueError("colors must be from 0 to 255")
    materials = os.path.splitext(path)[0] + ".mtl" if extension == ".obj" else ""
    contents, of_materials = core.format(extension, labels.astype(np.uint32),
                                         np.ascontiguousarray(colors, np.uint8),
                                         os.path.basename(materials))
    if materials:
        replace_file(materials, of_materials)
    replace_file(path, contents)
