# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrays of meshes, also of meshes of other libraries, which are known by their attributes."""

import os
import sys
import warnings
from collections import namedtuple
from types import SimpleNamespace

import numpy as np

from . import _core

# Types whose arrays are read without a copy
_POINT_TYPES = (np.float32, np.float64)
_TRIANGLE_TYPES = (np.int32, np.int64, np.uint32, np.uint64)

# The corners of one polygon after the other, and the number of corners of each
_Polygons = namedtuple("_Polygons", "corners sizes")


def array(name, value):
    """The array of a value. NumPy would forget the masks of one that is masked."""
    if np.ma.is_masked(value):
        raise ValueError("%s must not have masked elements" % name)
    try:
        return np.asarray(value)
    except ValueError:
        raise ValueError("%s must be an array, not rows of different lengths" % name) from None


def _with_type(array, types, other):
    """The array itself if it has one of the types, of the machine's order, and is aligned."""
    if array.dtype.type in types and array.dtype.isnative and array.flags.aligned:
        return array
    return array.astype(array.dtype.type if array.dtype.type in types else other)


def points_array(points):
    points = array("points", points)
    if points.dtype.kind not in "fiu" and points.size > 0:
        raise TypeError("points must be real numbers, not %s" % points.dtype)
    points = _with_type(points, _POINT_TYPES, np.float64)
    if points.size == 0 and points.ndim < 3:
        return points.reshape(0, 3)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("points must have the shape (n, 3), not %s" % (points.shape,))
    return points


def _rows_of_different_lengths(value):
    """The polygons of a list of rows, or None if the rows have one length."""
    if not isinstance(value, (list, tuple)):
        return None
    sizes = [len(row) if hasattr(row, "__len__") else -1 for row in value]
    if len(set(sizes)) < 2 or min(sizes) < 1 or any(isinstance(row, str) for row in value):
        return None
    return _Polygons(np.concatenate([array("triangles", row) for row in value]), np.array(sizes))


def _integers(name, value):
    value = array(name, value)
    if value.dtype.kind not in "iu" and value.size > 0:
        raise TypeError("%s must be integers, not %s" % (name, value.dtype))
    return _with_type(value, _TRIANGLE_TYPES, np.int64)


def _polygons(value):
    """The triangles, an array of shape (m, 3), or `_Polygons`."""
    if not isinstance(value, _Polygons):
        value = _rows_of_different_lengths(value) or value
    if not isinstance(value, _Polygons):
        rows = _integers("triangles", value)
        if rows.size == 0 and rows.ndim < 3:
            return rows.reshape(0, 3)
        if rows.ndim != 2 or rows.shape[1] < 3:
            raise ValueError("triangles must have the shape (n, 3), or (n, k) for polygons, not %s"
                             % (rows.shape,))
        if rows.shape[1] == 3:
            return rows
        value = _Polygons(rows.ravel(), np.full(len(rows), rows.shape[1]))
    corners, sizes = _integers("triangles", value.corners), np.asarray(value.sizes)
    if (sizes < 3).any():
        i = int(np.argmax(sizes < 3))
        raise ValueError("polygon %d has %d corners; at least 3 are needed" % (i, sizes[i]))
    if (sizes == 3).all():
        return corners.reshape(-1, 3)
    return _Polygons(corners, sizes)


def warn(message):
    """Warns in the line that calls the package."""
    frame, level = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, stacklevel=level)


class Surface:
    """The points, and the triangles or polygons, of a mesh of any kind."""

    __slots__ = ("points", "faces", "needs_core", "_warns", "_core")

    def __init__(self, points, faces, warns=True):
        self.points = None if points is None else points_array(points)
        self.faces = _polygons(faces)
        # The triangles of a run may differ from the faces if a face is a polygon, if there may be
        # tetrahedra, which have more faces for each point than surfaces, or if a point is infinite.
        self.needs_core = self.has_polygons or points is not None and (
            4 * len(self.faces) >= 9 * len(self.points) or not np.isfinite(self.points).all())
        self._warns = warns
        self._core = None

    def __reduce__(self):
        return Surface, (self.points, self.faces, False)

    @property
    def has_polygons(self):
        return isinstance(self.faces, _Polygons)

    @property
    def corners(self):
        """The corners of one face after the other."""
        return self.faces.corners if self.has_polygons else self.faces.ravel()

    @property
    def sizes(self):
        """The number of corners of each face."""
        return self.faces.sizes if self.has_polygons else np.full(len(self.faces), 3)

    def __len__(self):
        return len(self.faces.sizes if self.has_polygons else self.faces)

    @property
    def edges(self):
        """The two points of each edge of one face after the other, the smaller first."""
        corners = self.corners.astype(np.intp, copy=False)
        ends = np.cumsum(self.sizes)
        following = np.arange(1, len(corners) + 1)
        following[ends - 1] = ends - self.sizes
        return np.sort(np.stack([corners, corners[following]], axis=1), axis=1)

    @property
    def core(self):
        """The mesh for C++. Leaves out corners at points that are not finite, and triangles between
        tetrahedra, and warns of them.
        Raises ValueError if a corner is no point, or no face keeps three corners."""
        if self._core is None:
            corners = self.corners
            if corners.size > 0 and not (corners.min() >= 0 and corners.max() < len(self.points)):
                is_wrong = (corners < 0) | (corners >= len(self.points))
                i = np.searchsorted(np.cumsum(self.sizes), np.argmax(is_wrong), side="right")
                raise ValueError("triangle %d has a corner that is no index of a point" % i)
            self._core = _core.Polygons(
                np.ascontiguousarray(self.points, np.float64), self.points.dtype == np.float32,
                np.ascontiguousarray(corners, np.uint32),
                np.ascontiguousarray(self.sizes, np.uint32))
            for message in self._core.warnings if self._warns else ():
                warn(message)
        return self._core

    @property
    def triangles(self):
        return self.core.triangles if self.needs_core else self.faces

    def values_of_triangles(self, values):
        """For each triangle the value of its face."""
        return values[self.core.polygon_of_triangle] if self.needs_core else values

    def labels_of_faces(self, labels):
        """For each face the label with the largest area of its triangles, or of a neighbor."""
        return self.core.labels(labels.astype(np.uint32)) if self.needs_core else labels


def _polygons_with_counts(faces):
    """PyVista's: for each face the number of its corners, and these."""
    if faces.size % 4 == 0 and (faces[::4] == 3).all():
        return faces.reshape(-1, 4)[:, 1:]
    starts, i = [], 0
    while i < len(faces):
        starts.append(i)
        i += faces[i] + 1
    return _Polygons(np.delete(faces, starts), faces[starts])


def _polygons_of_cells(cells):
    """meshio's: a list of blocks of cells of one type. Points and lines are left out."""
    if isinstance(cells, dict):
        blocks = list(cells.items())
    else:
        blocks = [(block.type, block.data) for block in cells]
    corners, sizes = [np.empty(0, int)], [np.empty(0, int)]
    for kind, data in blocks:
        if kind in ("vertex", "line"):
            continue
        if kind not in ("triangle", "quad") and not kind.startswith("polygon"):
            raise ValueError("the mesh has cells of the type %s; only triangles and other polygons "
                             "are segmented" % kind)
        for rows in ([np.asarray(data)] if np.ndim(data) == 2 else map(np.atleast_2d, data)):
            corners.append(rows.ravel())
            sizes.append(np.full(len(rows), rows.shape[1]))
    return _Polygons(np.concatenate(corners), np.concatenate(sizes))


def _polygons_of_vtk(mesh):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if mesh.GetStrips().GetNumberOfCells() > 0:
        raise ValueError("the mesh has strips; vtkTriangleFilter makes triangles of them")
    points = mesh.GetPoints()
    polygons = mesh.GetPolys()
    return (np.empty((0, 3)) if points is None else vtk_to_numpy(points.GetData()),
            _Polygons(vtk_to_numpy(polygons.GetConnectivityArray()),
                      np.diff(vtk_to_numpy(polygons.GetOffsetsArray()))))


def _arrays_of_manifold(mesh):
    """manifold3d's, which has points several times where their properties differ."""
    points = np.asarray(mesh.vert_properties)[:, :3]
    same = np.arange(len(points))
    if len(getattr(mesh, "merge_from_vert", ())) > 0:
        same[np.asarray(mesh.merge_from_vert)] = mesh.merge_to_vert
    return points, same[np.asarray(mesh.tri_verts)]


def _tensor(attributes, name):
    """Open3D's, which an empty mesh lacks."""
    return attributes[name].numpy() if name in attributes else np.empty((0, 3), int)


def _arrays_of_mesh(mesh):
    """The points and polygons of an object, before they are checked."""
    if isinstance(mesh, (str, bytes, os.PathLike)):
        raise TypeError("a mesh is needed, not the name of a file: read(%r) reads it" % (mesh,))
    kind = type(mesh).__name__
    if isinstance(mesh, dict):
        mesh = SimpleNamespace(**{key: value for key, value in mesh.items()
                                  if isinstance(key, str)})

    def has(*names):
        return all(hasattr(mesh, name) for name in names)

    if has("vertices", "faces"): # trimesh
        return mesh.vertices, mesh.faces
    if has("vertices", "triangles"): # Open3D
        return mesh.vertices, mesh.triangles
    if has("points", "triangles"): # Mesh
        return mesh.points, mesh.triangles
    if has("GetPoints", "GetPolys", "GetStrips"): # VTK, and PyVista
        return _polygons_of_vtk(mesh)
    if has("points", "faces"): # PyVista
        faces = np.asarray(mesh.faces)
        return mesh.points, _polygons_with_counts(faces) if faces.ndim == 1 else faces
    if has("GetCells") or has("celltypes"): # VTK, PyVista
        raise TypeError("%s has cells in place of polygons; vtkGeometryFilter, or PyVista's "
                        "extract_surface(), makes a surface of it" % kind)
    if has("points", "cells"): # meshio
        return mesh.points, _polygons_of_cells(mesh.cells)
    if has("vertex", "triangle"): # Open3D's tensors
        return _tensor(mesh.vertex, "positions"), _tensor(mesh.triangle, "indices")
    if has("vert_properties", "tri_verts"): # manifold3d
        return _arrays_of_manifold(mesh)
    if has("to_mesh") and not has("geometry"): # manifold3d's Manifold
        return _arrays_of_manifold(mesh.to_mesh())
    if has("current_mesh"): # pymeshlab's MeshSet
        mesh = mesh.current_mesh()
    if has("vertex_matrix", "face_matrix"): # pymeshlab
        return mesh.vertex_matrix(), mesh.face_matrix()
    if has("geometry"): # trimesh
        raise TypeError("%s has several meshes; give one of them, such as scene.to_mesh()" % kind)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return mesh
    raise TypeError("triangles are missing, and %s is no mesh of a known kind: give a tuple "
                    "(points, triangles), or an object of trimesh, Open3D, PyVista, VTK, meshio, "
                    "manifold3d or pymeshlab" % kind)


def surface_of(points, triangles=None):
    """The checked arrays; `points` is a mesh if `triangles` is None."""
    if isinstance(points, Surface):
        return points
    if triangles is None:
        points, triangles = _arrays_of_mesh(points)
    if points is None:
        raise TypeError("points must be real numbers, not None")
    return Surface(points, triangles)


def surface_and_labels(points, triangles, labels, needs_points=False):
    """Returns the surface and the labels of a call with (mesh, labels), (points, triangles, labels)
    or, if the points are not needed, (triangles, labels)."""
    if labels is None:
        triangles, labels = None, triangles
    if labels is None:
        raise TypeError("labels are missing")
    is_pair = isinstance(points, tuple) and len(points) == 2 and np.ndim(points[0]) == 2
    if triangles is None and not needs_points and not is_pair and (
            isinstance(points, (list, np.ndarray)) or type(points) is tuple):
        surface = Surface(None, points)
    else:
        surface = surface_of(points, triangles)
    return surface, labels_array(labels, len(surface))


def is_flat(value):
    """Returns whether a value holds single numbers, at least one, like labels."""
    try:
        return np.ndim(next(iter(value))) == 0
    except (TypeError, StopIteration):
        return False


def labels_array(labels, number_of_faces):
    labels = array("labels", labels)
    if labels.dtype.kind not in "iu" and labels.size > 0:
        raise TypeError("labels must be integers, not %s" % labels.dtype)
    if labels.shape != (number_of_faces,):
        raise ValueError("labels must have the shape (%d,), one for each triangle, not %s"
                         % (number_of_faces, labels.shape))
    if labels.size > 0 and not (labels.min() >= 0 and labels.max() < number_of_faces):
        raise ValueError("labels must be from 0 to the number of triangles - 1")
    return labels.astype(np.intp, copy=False)
