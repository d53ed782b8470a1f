# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts the constraints of the caller to triangles and pairs of triangles for the engine."""

import itertools

import numpy as np


def integers_of_triangles(name, value, number_of_triangles):
    integers = np.asarray(value)
    if integers.dtype.kind not in "iu":
        raise TypeError("%s must be integers, not %s" % (name, integers.dtype))
    if integers.shape != (number_of_triangles,):
        raise ValueError("%s must have the shape (%d,), one for each triangle, not %s"
                         % (name, number_of_triangles, integers.shape))
    return integers.astype(np.int64, copy=False)


def groups_array(value, number_of_triangles):
    """The groups, numbered from 0; None if there is only one."""
    groups = integers_of_triangles("face_groups", value, number_of_triangles)
    names, numbers = np.unique(groups, return_inverse=True)
    return numbers.astype(np.int64) if len(names) > 1 else None


class Edges:
    """The edges of triangles by their points, in an order in which those of a name are found."""

    def __init__(self, triangles, number_of_points):
        if triangles.size > 0 and not (triangles.min() >= 0 and
                                       triangles.max() < number_of_points):
            raise ValueError("triangles have corners that are no indices of points")
        self._number_of_points = number_of_points
        triangles = triangles.astype(np.int64, copy=False)
        keys = self._keys(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2))
        self._order = np.argsort(keys, kind="stable")
        self._keys_in_order = keys[self._order]

    def _keys(self, edges):
        return edges.min(axis=1) * self._number_of_points + edges.max(axis=1)

    def pairs_of_triangles(self, name, value):
        """The triangles at each of these edges, which are given by their points, in pairs."""
        edges = np.asarray(value)
        if edges.size == 0:
            return np.empty((0, 2), np.int64)
        if edges.dtype.kind not in "iu":
            raise TypeError("%s must be integers, not %s" % (name, edges.dtype))
        if edges.ndim != 2 or edges.shape[1] != 2:
            raise ValueError("%s must have the shape (k, 2), two points for each edge, not %s"
                             % (name, edges.shape))
        is_known = ((edges >= 0) & (edges < self._number_of_points)).all(axis=1)
        keys = self._keys(np.where(is_known[:, None], edges, 0).astype(np.int64))
        first = np.searchsorted(self._keys_in_order, keys, "left")
        last = np.searchsorted(self._keys_in_order, keys, "right")
        missing = np.flatnonzero(~is_known | (first == last))
        if missing.size > 0:
            raise ValueError("%s has the edge (%d, %d), which no triangle has"
                             % (name, *edges[missing[0]]))
        has_two = last - first == 2
        pairs = [np.stack([self._order[first[has_two]], self._order[first[has_two] + 1]], axis=1)]
        for a, b in zip(first[last - first > 2], last[last - first > 2]):
            pairs.append(list(itertools.combinations(self._order[a:b], 2)))
        pairs = np.concatenate(pairs) // 3
        return np.unique(np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1), axis=0)


def pairs_at_edges(constrained, uncuttable, triangles, number_of_points):
    """The pairs of triangles at the edges of `constrained_edges`, `uncuttable_edges`."""
    if constrained is None and uncuttable is None:
        return None, None
    edges = Edges(triangles, number_of_points)
    both = [None if value is None else edges.pairs_of_triangles(name, value)
            for name, value in (("constrained_edges", constrained),
                                ("uncuttable_edges", uncuttable))]
    if constrained is not None and uncuttable is not None:
        pairs, counts = np.unique(np.concatenate(both), axis=0, return_counts=True)
        if counts.max(initial=0) > 1:
            raise ValueError("the edge between the triangles %d and %d is in both "
                             "constrained_edges and uncuttable_edges"
                             % tuple(pairs[counts > 1][0]))
    return both
