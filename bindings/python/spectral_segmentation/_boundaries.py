# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges between segments, neighbors of segments, and colors that distinguish them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np

from . import _core
from ._meshes import surface_and_labels

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_MESH = """points : array_like of real numbers, shape (n, 3), or mesh
        The points, or a mesh of any kind that `segment()` takes. Labels follow a mesh directly, as
        in `%s(mesh, labels)`.%s
    triangles : array_like of integers, shape (m, 3), or polygons, optional
        The indices of the corners in `points`.
    labels : array_like of integers, shape (m,)
        The label of each triangle or polygon, from 0 on."""
_RAISES = """Raises
    ------
    TypeError, ValueError
        If an argument has a wrong type, shape or range."""


def _described(function):
    """Fills in the parts that the functions have in common."""
    no_points = "" if function is segment_adjacency else \
        " The points are not needed: `%s(triangles, labels)` is enough." % function.__name__
    mesh = _MESH % (function.__name__, no_points and "\n       " + no_points)
    if function.__doc__: # there is none with python -OO
        function.__doc__ = function.__doc__.format(mesh=mesh, raises=_RAISES)
    return function


def _edges_between(surface, labels):
    """The points of each edge between different labels, and these labels."""
    edges = surface.edges
    of_edge = np.repeat(labels, surface.sizes)
    order = np.lexsort((of_edge, edges[:, 1], edges[:, 0]))
    edges, of_edge = edges[order], of_edge[order]
    between = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1) & (of_edge[1:] != of_edge[:-1]))
    return edges[between], np.stack([of_edge[between], of_edge[between + 1]], axis=1)


def boundary_edges(points: Any, triangles: Optional[ArrayLike] = None,
                   labels: Optional[ArrayLike] = None) -> Tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Returns the edges between different segments.

    Parameters
    ----------
    {mesh}

    Returns
    -------
    edges : ndarray of int, shape (k, 2)
        The points of each edge, the smaller one first. Edges are sorted by their points. An edge
        with three labels or more comes once for each label and the next larger one.
    labels : ndarray of int, shape (k, 2)
        The two labels at each edge, the smaller one first.

    {raises}
    """
    return _edges_between(*surface_and_labels(points, triangles, labels))


def segment_adjacency(points: Any, triangles: Optional[ArrayLike] = None,
                      labels: Optional[ArrayLike] = None
                      ) -> Tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Returns which segments have an edge in common.

    Parameters
    ----------
    {mesh}

    Returns
    -------
    pairs : ndarray of int, shape (k, 2)
        The pairs of labels, sorted.
    lengths : ndarray of float, shape (k,)
        The lengths of their common boundaries, in the unit of the points. Edges at points that
        are not finite do not count.

    {raises}
    """
    surface, labels = surface_and_labels(points, triangles, labels, needs_points=True)
    points = surface.points.astype(float, copy=False)
    edges, labels = _edges_between(surface, labels)
    if edges.size > 0 and not (edges.min() >= 0 and edges.max() < len(points)):
        raise ValueError("triangles have corners that are no indices of points")
    pairs, place = np.unique(labels, axis=0, return_inverse=True)
    ends = points[edges]
    ends[~np.isfinite(ends).all(axis=(1, 2))] = 0
    lengths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
    return pairs, np.bincount(place.ravel(), lengths, len(pairs))


def _neighbors(surface, labels, number_of_segments):
    """For each segment a list of those that it touches at a point."""
    corners = surface.corners
    of_corner = np.repeat(labels, surface.sizes)
    first = np.empty(corners.max(initial=-1) + 1, np.intp) # label at each point
    first[corners[::-1]] = of_corner[::-1]
    pairs = np.stack([first[corners], of_corner], axis=1)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    pairs = np.unique(np.concatenate([pairs, pairs[:, ::-1]]), axis=0)
    ends = np.searchsorted(pairs[:, 0], np.arange(1, number_of_segments))
    return [part.tolist() for part in np.split(pairs[:, 1], ends)] if number_of_segments else []


def colors_of(surface, labels):
    if surface.corners.min(initial=0) < 0:
        raise ValueError("triangles have corners that are negative")
    return _core.segment_colors(_neighbors(surface, labels, labels.max(initial=-1) + 1))


def segment_colors(points: Any, triangles: Optional[ArrayLike] = None,
                   labels: Optional[ArrayLike] = None) -> NDArray[np.uint8]:
    """Returns a color for each segment, unlike the colors of its neighbors, as the tool does.

    Colors of neighbors also differ for color-blind people.

    Parameters
    ----------
    {mesh}

    Returns
    -------
    ndarray of uint8, shape (number of segments, 3)
        Red, green and blue.

    {raises}
    """
    return colors_of(*surface_and_labels(points, triangles, labels))


for _function in (boundary_edges, segment_adjacency, segment_colors):
    _described(_function)
