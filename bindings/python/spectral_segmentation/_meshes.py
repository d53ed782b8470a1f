# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrays of meshes, also of those of other libraries, which are known by their attributes."""

import numpy as np

# Types whose arrays are read without a copy
_POINT_TYPES = (np.float32, np.float64)
_TRIANGLE_TYPES = (np.int32, np.int64, np.uint32, np.uint64)


def _array(name, value):
    try:
        return np.asarray(value)
    except ValueError: # rows of different lengths
        raise ValueError("%s must be an array of shape (n, 3)" % name) from None


def _with_shape(name, array):
    if array.size == 0 and array.ndim < 3:
        return array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError("%s must have the shape (n, 3), not %s" % (name, array.shape))
    return array


def _with_type(array, types, other):
    """The array itself if it has one of the types, of the machine's order, and is aligned."""
    if array.dtype.type in types and array.dtype.isnative and array.flags.aligned:
        return array
    return array.astype(array.dtype.type if array.dtype.type in types else other)


def points_array(points):
    array = _array("points", points)
    if array.dtype.kind not in "fiu" and array.size > 0:
        raise TypeError("points must be real numbers, not %s" % array.dtype)
    return _with_shape("points", _with_type(array, _POINT_TYPES, np.float64))


def triangles_array(triangles):
    array = _array("triangles", triangles)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError("triangles must be integers, not %s" % array.dtype)
    return _with_shape("triangles", _with_type(array, _TRIANGLE_TYPES, np.int64))


def _faces_with_counts(faces):
    """PyVista's: for each face the number of its corners, and these."""
    if faces.size % 4 or np.any(faces[::4] != 3):
        raise ValueError("the mesh has faces that are not triangles; PyVista's triangulate() "
                         "makes triangles of them")
    return faces.reshape(-1, 4)[:, 1:]


def _triangles_of_cells(cells):
    """meshio's: a list of blocks of cells of one type. Points and lines are left out."""
    if isinstance(cells, dict):
        blocks = list(cells.items())
    else:
        blocks = [(block.type, block.data) for block in cells]
    blocks = [(kind, data) for kind, data in blocks if kind not in ("vertex", "line")]
    for kind, _ in blocks:
        if kind != "triangle":
            raise ValueError("the mesh has cells of the type %s; only triangles are segmented"
                             % kind)
    arrays = [np.asarray(data) for _, data in blocks]
    return arrays[0] if len(arrays) == 1 else np.concatenate([np.empty((0, 3), int), *arrays])


def _arrays_of_mesh(mesh):
    """The points and triangles of an object, before they are checked."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"): # trimesh
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "vertices") and hasattr(mesh, "triangles"): # Open3D
        return mesh.vertices, mesh.triangles
    if hasattr(mesh, "points") and hasattr(mesh, "triangles"): # Mesh
        return mesh.points, mesh.triangles
    if hasattr(mesh, "points") and hasattr(mesh, "faces"): # PyVista
        faces = np.asarray(mesh.faces)
        return mesh.points, _faces_with_counts(faces) if faces.ndim == 1 else faces
    if hasattr(mesh, "points") and hasattr(mesh, "cells"): # meshio
        return mesh.points, _triangles_of_cells(mesh.cells)
    if hasattr(mesh, "vertex") and hasattr(mesh, "triangle"): # Open3D's tensors
        return mesh.vertex["positions"].numpy(), mesh.triangle["indices"].numpy()
    raise TypeError("triangles are missing, and %s is no mesh of a known kind: it has neither "
                    "vertices and faces or triangles, nor points and triangles, faces or cells"
                    % type(mesh).__name__)


def arrays_of(points, triangles):
    """The checked arrays; `points` is a mesh if `triangles` is None."""
    if triangles is None:
        points, triangles = _arrays_of_mesh(points)
    return points_array(points), triangles_array(triangles)


def labels_array(labels, number_of_triangles):
    array = np.asarray(labels)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError("labels must be integers, not %s" % array.dtype)
    if array.shape != (number_of_triangles,):
        raise ValueError("labels must have the shape (%d,), one for each triangle, not %s"
                         % (number_of_triangles, array.shape))
    if array.size > 0 and not (array.min() >= 0 and array.max() < number_of_triangles):
        raise ValueError("labels must be from 0 to the number of triangles - 1")
    return array.astype(np.intp, copy=False)
