# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the constraints of the caller, and makes arrays of them."""

import numpy as np

from ._meshes import array


def integers_of_triangles(name, value, number_of_triangles):
    integers = array(name, value)
    if integers.dtype.kind not in "iu":
        raise TypeError("%s must be integers, not %s" % (name, integers.dtype))
    if integers.shape != (number_of_triangles,):
        raise ValueError("%s must have the shape (%d,), one for each triangle, not %s"
                         % (name, number_of_triangles, integers.shape))
    return integers.astype(np.int64, copy=False)


def edges_arrays(constrained, uncuttable, surface):
    """The edges of `constrained_edges` and `uncuttable_edges`, the smaller point first."""
    if constrained is None and uncuttable is None:
        return None, None

    def keys_of(edges):
        return edges.min(axis=1) * number_of_points + edges.max(axis=1)

    corners, number_of_points = surface.corners, len(surface.points)
    if corners.size > 0 and not (corners.min() >= 0 and corners.max() < number_of_points):
        raise ValueError("triangles have corners that are no indices of points")
    known_keys = keys_of(surface.edges.astype(np.int64, copy=False))
    if surface.has_polygons:
        edges = surface.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        known_keys = np.concatenate([known_keys, keys_of(edges.astype(np.int64))])

    def read(name, value):
        edges = array(name, value)
        if edges.size == 0:
            return np.empty((0, 2), np.int64)
        if edges.dtype.kind not in "iu":
            raise TypeError("%s must be integers, not %s" % (name, edges.dtype))
        if edges.ndim != 2 or edges.shape[1] != 2:
            raise ValueError("%s must have the shape (k, 2), two points for each edge, not %s"
                             % (name, edges.shape))
        is_known = ((edges >= 0) & (edges < number_of_points)).all(axis=1)
        keys = keys_of(np.where(is_known[:, None], edges, 0).astype(np.int64))
        missing = np.flatnonzero(~is_known | ~np.isin(keys, known_keys))
        if missing.size > 0:
            raise ValueError("%s has the edge (%d, %d), which no triangle has"
                             % (name, *edges[missing[0]]))
        return np.sort(edges.astype(np.int64), axis=1)

    return [None if value is None else read(name, value)
            for name, value in (("constrained_edges", constrained),
                                ("uncuttable_edges", uncuttable))]
