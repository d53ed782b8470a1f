# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is between segments: edges, neighbors, and colors that tell them apart."""

import numpy as np

from . import _core
from ._meshes import labels_array, points_array, triangles_array


def boundary_edges(triangles, labels):
    """The edges between different segments.

    triangles: array_like of integers, shape (m, 3).
    labels: array_like of integers, shape (m,), from 0 on.

    Returns two arrays of int of shape (k, 2): the points of each edge, and the two labels at it;
    the smaller one first. Edges are sorted by their points. An edge with three labels or more comes
    once for each label and the next larger one.

    Raises TypeError or ValueError if an argument has a wrong type, shape or range.
    """
    triangles = triangles_array(triangles).astype(np.intp, copy=False)
    labels = labels_array(labels, len(triangles))
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges.sort(axis=1)
    of_edge = np.tile(labels, 3)
    order = np.lexsort((of_edge, edges[:, 1], edges[:, 0]))
    edges, of_edge = edges[order], of_edge[order]
    between = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1) & (of_edge[1:] != of_edge[:-1]))
    return edges[between], np.stack([of_edge[between], of_edge[between + 1]], axis=1)


def segment_adjacency(points, triangles, labels):
    """Which segments have an edge in common.

    points, triangles: the mesh, as for `segment()`.
    labels: array_like of integers, shape (m,), from 0 on.

    Returns an array of int of shape (k, 2), the pairs of labels, sorted, and an array of float of
    shape (k,), the lengths of their common boundaries, in the unit of the points.

    Raises TypeError or ValueError if an argument has a wrong type, shape or range.
    """
    points = points_array(points).astype(float, copy=False)
    edges, labels = boundary_edges(triangles, labels)
    if edges.size > 0 and not (edges.min() >= 0 and edges.max() < len(points)):
        raise ValueError("triangles have corners that are no indices of points")
    pairs, place = np.unique(labels, axis=0, return_inverse=True)
    lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    return pairs, np.bincount(place.ravel(), lengths, len(pairs))


def _neighbors(triangles, labels, number_of_segments):
    """For each segment a list of those that it touches at a point."""
    corners = triangles.ravel()
    of_corner = np.repeat(labels, 3)
    first = np.empty(corners.max(initial=-1) + 1, np.intp) # label at each point
    first[corners[::-1]] = of_corner[::-1]
    pairs = np.stack([first[corners], of_corner], axis=1)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    pairs = np.unique(np.concatenate([pairs, pairs[:, ::-1]]), axis=0)
    ends = np.searchsorted(pairs[:, 0], np.arange(1, number_of_segments))
    return [part.tolist() for part in np.split(pairs[:, 1], ends)] if number_of_segments else []


def segment_colors(triangles, labels):
    """A color for each segment, unlike those of its neighbors, as the tool `segment_mesh` gives.

    triangles: array_like of integers, shape (m, 3).
    labels: array_like of integers, shape (m,), from 0 on.

    Returns an array of uint8 of shape (number of segments, 3): red, green and blue.

    Raises TypeError or ValueError if an argument has a wrong type, shape or range.
    """
    triangles = triangles_array(triangles).astype(np.intp, copy=False)
    labels = labels_array(labels, len(triangles))
    if triangles.size > 0 and triangles.min() < 0:
        raise ValueError("triangles have corners that are negative")
    return _core.segment_colors(_neighbors(triangles, labels, labels.max(initial=-1) + 1))
