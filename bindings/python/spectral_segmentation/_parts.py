# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the parts, and labels of other meshes."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional

import numpy as np

from . import _core
from ._boundaries import _RAISES
from ._checks import integer
from ._files import Mesh
from ._meshes import labels_array, surface_of, warn

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_ARGUMENTS = """Parameters
    ----------
    mesh : mesh
        A mesh of any kind that `segment()` takes, such as a tuple (points, triangles).
    labels : array_like of integers, shape (m,)
        The label of each triangle or polygon, from 0 on."""


class Part(NamedTuple):
    """A mesh of one segment, which `split()` and `hulls()` return.

    Parameters
    ----------
    points : ndarray of float64, shape (n, 3)
    triangles : ndarray of int32, shape (m, 3)
        The indices of the corners in `points`.
    faces : ndarray of int, shape (m,)
        The triangle or polygon of the whole mesh to which each triangle belongs; -1 for the
        triangles of caps and hulls.
    report : dict
        A description of the part, always with its `label`. Closed parts have the report of the
        tool with `--close`: `is_solid`, `is_closed`, `is_manifold`, `is_outward_oriented`,
        `has_self_intersections` and `volume`. Hulls have `thickness`, which is 0 unless flat,
        `volume`, and `volume_ratio`, the volume divided by the volume of the part, or None.
    """

    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    faces: NDArray[np.intp]
    report: Dict[str, Any]


def _read(mesh, labels):
    """The surface, and the label of each of its triangles."""
    surface = surface_of(mesh)
    labels = labels_array(labels, len(surface)).astype(np.uint32)
    return surface, surface.values_of_triangles(labels)


def split(mesh: Any, labels: ArrayLike, close: bool = False) -> List[Part]:
    """Makes a mesh of each segment.

    {arguments}
    close : bool, default: False
        Whether parts are closed by caps, as 3D printing and Boolean operations require. Points that
        the mesh repeats at borders are joined. Closed parts fit together.

    Returns
    -------
    list of Part
        The parts, in the order of their labels.

    {raises}

    Warns
    -----
    UserWarning
        If closed parts bound no solid, with the reasons.
    """
    surface, labels = _read(mesh, labels)
    points, triangles = surface.points.astype(float, copy=False), surface.core.triangles
    faces, reports = surface.core.polygon_of_triangle, {}
    if close:
        (points, triangles, labels), report, message = _core.closed(surface.core, labels)
        reports = {each["label"]: each for each in json.loads(report)}
        faces = np.concatenate([faces, np.full(len(triangles) - len(faces), -1, faces.dtype)])
        if message:
            warn(message)
    order = np.argsort(labels, kind="stable")
    present, first = np.unique(labels[order], return_index=True)
    parts = []
    for label, places in zip(present.tolist(), np.split(order, first[1:])):
        used, corners = np.unique(triangles[places], return_inverse=True)
        parts.append(Part(points[used], corners.reshape(-1, 3).astype(np.int32), faces[places],
                          reports.get(label, {"label": label})))
    return parts


def hulls(mesh: Any, labels: ArrayLike, max_vertices: Optional[int] = None,
          close: bool = False) -> List[Part]:
    """Makes the convex hull of each segment, such as for the collisions of a simulation.

    A part that is flat to a 10^5th of the extent of the mesh gets a hull with a thickness of a
    1000th of the extent, because simulators refuse flat shapes.

    {arguments}
    max_vertices : int, default: None
        The largest number of vertices of a hull, at least 4. A hull with fewer vertices is larger,
        contains the part, and is convex. Unity takes at most 255 vertices, PhysX on a GPU 64.
    close : bool, default: False
        Whether the parts are also closed, which gives the hulls of solid parts a `volume_ratio`.

    Returns
    -------
    list of Part
        The hulls, in the order of their labels.

    {raises}
    """
    limit = sys.maxsize if max_vertices is None else integer("max_vertices", max_vertices)
    if limit < 4:
        raise ValueError("max_vertices must be at least 4, but is %d" % limit)
    parts = split(mesh, labels)
    volumes = {}
    if close:
        surface, labels = _read(mesh, labels)
        volumes = {each["label"]: each["volume"]
                   for each in json.loads(_core.closed(surface.core, labels)[1])
                   if each["is_solid"]}
    extent = _core.extent(np.concatenate([part.points for part in parts] or [np.empty((0, 3))]))
    if parts and not 0 < extent < np.inf:
        raise ValueError("the mesh has no hulls, because its extent is %g" % extent)
    result = []
    for part in parts:
        (points, triangles, _), thickness, volume = _core.hull(part.points, extent, limit)
        label = part.report["label"]
        ratio = volume / volumes[label] if label in volumes else None
        result.append(Part(points, triangles, np.full(len(triangles), -1),
                           {"label": label, "vertices": len(points), "faces": len(triangles),
                            "thickness": thickness, "volume": volume, "volume_ratio": ratio}))
    return result


def refine_boundaries(mesh: Any, labels: ArrayLike) -> Mesh:
    """Makes the boundaries of segments smooth curves, which pass through triangles.

    {arguments}

    Returns
    -------
    Mesh
        The mesh with the triangles along the boundaries cut, its `labels`, and the triangle or
        polygon to which each triangle belongs, as `polygon_of_triangle`.

    {raises}
    """
    surface, labels = _read(mesh, labels)
    (points, triangles, labels), faces = _core.refined(surface.core, labels)
    return Mesh(points, triangles, faces, labels.astype(np.intp))


def transfer_labels(mesh: Any, labels: ArrayLike, other_mesh: Any) -> NDArray[np.intp]:
    """Carries labels to another mesh of the same shape, such as a decimated or remeshed copy.

    Each triangle gets the label of the nearest triangle that faces alike. Both meshes must be at
    the same place and have the same unit.

    {arguments}
    other_mesh : mesh
        The mesh that gets the labels.

    Returns
    -------
    ndarray of int
        The label of each triangle or polygon of `other_mesh`.

    {raises}
    """
    surface, labels = _read(mesh, labels)
    other = surface_of(other_mesh)
    return other.labels_of_faces(
        _core.transferred(surface.core, labels, other.core).astype(np.intp))


for _function in (split, hulls, refine_boundaries, transfer_labels):
    if _function.__doc__: # there is none with python -OO
        _function.__doc__ = _function.__doc__.format(arguments=_ARGUMENTS, raises=_RAISES)
