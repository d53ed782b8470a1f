# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the segmentation."""

from __future__ import annotations

import difflib
import inspect
from typing import TYPE_CHECKING, Any, Callable, Literal, Optional, Sequence, TypeVar

import numpy as np

from . import _core
from ._checks import flag, function, integer, real, three_numbers
from ._constraints import edges_arrays, integers_of_triangles
from ._features import features_of_triangles
from ._hierarchy import Hierarchy
from ._meshes import surface_of, warn
from ._salience import SalienceFactors

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import ParamSpec
    _P = ParamSpec("_P")
    _R = TypeVar("_R")

_METHODS = {"calibrated": False, "paper": True}


def _random_seed(name, value):
    seed = integer(name, value, 2**64 - 1)
    if seed < 0:
        raise ValueError("%s must not be negative" % name)
    return seed


def _threads(value):
    number = integer("threads", value)
    if number < 1:
        raise ValueError("threads must be at least 1")
    return min(number, 1024)


_READ_KIND = {"integer": integer, "number": real, "boolean": flag}
# The functions that read the parameters of the core
_READ = {**{name: _READ_KIND[kind] for name, kind in _core.option_kinds().items()},
         "salience_weights": three_numbers, "distance_weights": three_numbers,
         "random_seed": _random_seed}

_PARAMETERS = """Parameters
    ----------
    points : array_like of real numbers, shape (n, 3), or mesh
        The points, in any unit; or a mesh: what `read()` returns, a tuple (points, triangles), or
        an object of trimesh, Open3D, PyVista, VTK, meshio, manifold3d or pymeshlab. Arrays of
        float32 and float64 are read without a copy.
    triangles : array_like of integers, shape (m, 3), or polygons, optional
        The indices of the corners in `points`. Arrays of 4 and 8 bytes an integer are read without
        a copy. Edges may have any number of triangles, and the orientation may vary. Polygons are
        an array of shape (m, k) or a list of rows; they are cut into triangles, and a polygon gets
        the label with the largest area. Corners at points that are not finite are left out. If
        fewer than three are left, the triangle or polygon gets the label of the neighbor with the
        longest common edge, and its seed, group and features mean nothing.
    method : {{"calibrated", "paper"}}, default: "calibrated"
        "calibrated" cuts where people cut; "paper" is the method of Zhang and Liu 2005,
        `zhang_liu_2005()` in C++.
    number_of_segments : int, optional
        Exactly this number, whatever the saliences are. Not together with the next two.
    maximum_number_of_segments : int, optional
        At most this number. By default there is no limit, but with the method "paper" 12 for a
        connected mesh, unless a `salience_threshold` is given.
    salience_threshold : float, default: 0.4, or 0.54 for weighted saliences such as the paper's
        The smallest salience of a cut. The salience of the calibrated method is the probability
        that people cut there; there the threshold is in [0, 1], or infinite for all cuts or none.
    keep_components_separate : bool, default: False, or True with the method "paper"
        Whether each connected component is a part from the start. Otherwise a component with less
        than a hundredth of the area belongs to the part with which it has the most contact, and
        the inner wall of a hollow body has the segments of the outer wall.
    face_groups : array_like of integers, shape (m,), optional
        The group of each triangle or polygon, such as an object of a file. Groups are treated
        like connected components.
    features : array_like, shape (m,) or (m, d), optional
        Features of each triangle or polygon: a vector of real numbers, such
        as a color or the output of a neural network; one real number; or an integer, a label that
        may be wrong. Cuts where features change are preferred. Features that do not
        depend on the parts, such as noise, have little effect at the default weight. Arrays of
        float32 are read without a copy. Not with the method "paper".
    feature_weight : float, default: 0.5
        The weight of the features, in [0, 1]: with 0 they are not used, with 1 the shape only
        breaks ties between cuts that the features do not distinguish.
    constrained_edges : array_like of integers, shape (k, 2), optional
        Edges by their points, as of `boundary_edges()`, that must be between segments. Edges of
        one triangle are ignored.
    uncuttable_edges : array_like of integers, shape (k, 2), optional
        Edges whose triangles must belong to one segment.
    face_seeds : array_like of integers, shape (m,), optional
        Triangles with the same number belong to one segment, and triangles with different numbers
        to different segments. Negative numbers mean nothing. Neither this nor the two for edges go
        with the method "paper".
    minimum_segment_size : float, default: 0.003, or 0.005 with the method "paper"
        The smallest area of a segment, as a fraction of the area of the mesh, in [0, 0.5].
    part_salience : callable, optional
        Your own salience of a cut, which takes `SalienceFactors` and returns a number. It is called
        from several threads, one at a time. Give `salience_threshold` with it.
    salience_weights : three floats, optional
        The weights of size, cut strength and protrusiveness in a weighted salience: not negative,
        with sum 1. Not together with `part_salience`.
    distance_weights : three floats, default: (0.03, 1, 0.1), or (0.01, 1, 0.1) with "paper"
        The weight of the geodesic distance, in [0, 1], and the factors of the angle distance at
        concave and at convex edges.
    number_of_coarse_faces : int, default: 3400, or 0 with the method "paper"
        Cuts are searched on a coarse mesh with this number of triangles, and at most 1000 more
        than the mesh has. 0 means the mesh itself.
    number_of_searches : int, default: 5, or 1 with the method "paper"
        The number of coarse meshes that are searched, at most 100. The cuts are those of the search
        that agrees best with the others. One search takes about a third of the time.
    number_of_reference_faces : int, default: 3, or 10 with the method "paper"
        The dimension of the context vector, at most 1000.
    number_of_smoothing_iterations : int, default: 0
        Steps of Laplacian smoothing before the search, at most 100000.
    reverse : bool, default: False
        Whether the surface is searched as if all its triangles were turned around. Closed
        components that point inward, and open ones with small holes, are turned around anyway.
    random_seed : int, optional
        Chooses reference faces at random, as in the paper. By default they are not random.
    threads : int, default: all that the machine has
        At most this number of threads. Wheels are built without TBB, and use one.
    progress : callable, optional
        Is called with the fraction of the run that is done, from 0 to 1, in the caller's thread. If
        it returns False, or another value but None that counts as false, the run ends, and the
        result has the cuts made so far. If it raises an exception, the run ends with that. So it
        does with KeyboardInterrupt after Ctrl-C.

    Returns
    -------
    {returns}

    Raises
    ------
    TypeError, ValueError
        If an argument has a wrong type, shape or range, or seeds and edges contradict each other.
        If points are not finite, and no triangle or polygon keeps three corners.
    OverflowError
        If a number is too large.
    MemoryError
        If there is not enough memory.

    Warns
    -----
    UserWarning
        If corners are left out, with the first triangle or polygon and the number of corners.

    Notes
    -----
    The same input gives the same result on every run, with any number of threads. The lock of
    Python is released: several threads may run at a time. The arrays must not change meanwhile.
    The manual of the C++ library has more."""


def segment_hierarchy(
        points: Any,
        triangles: Optional[ArrayLike] = None,
        *,
        method: Literal["calibrated", "paper"] = "calibrated",
        number_of_segments: Optional[int] = None,
        maximum_number_of_segments: Optional[int] = None,
        salience_threshold: Optional[float] = None,
        keep_components_separate: Optional[bool] = None,
        face_groups: Optional[ArrayLike] = None,
        features: Optional[ArrayLike] = None,
        feature_weight: float = 0.5,
        constrained_edges: Optional[ArrayLike] = None,
        uncuttable_edges: Optional[ArrayLike] = None,
        face_seeds: Optional[ArrayLike] = None,
        minimum_segment_size: Optional[float] = None,
        part_salience: Optional[Callable[[SalienceFactors], float]] = None,
        salience_weights: Optional[Sequence[float]] = None,
        distance_weights: Optional[Sequence[float]] = None,
        number_of_coarse_faces: Optional[int] = None,
        number_of_searches: Optional[int] = None,
        number_of_reference_faces: Optional[int] = None,
        number_of_smoothing_iterations: int = 0,
        reverse: bool = False,
        random_seed: Optional[int] = None,
        threads: Optional[int] = None,
        progress: Optional[Callable[[float], object]] = None) -> Hierarchy:
    """Cuts a mesh into parts, and returns all cuts with their salience.

    {parameters}

    Examples
    --------
    >>> hierarchy = segment_hierarchy(points, triangles)
    >>> hierarchy.labels(5)
    """
    arguments = dict(locals())
    if isinstance(triangles, int):
        raise TypeError("triangles must not be a number; the number of segments is a named "
                        "argument: number_of_segments=%d" % triangles)
    surface = surface_of(points, triangles)
    points, triangles = surface.points, surface.triangles
    if not isinstance(method, str) or method not in _METHODS:
        raise ValueError("method must be 'calibrated' or 'paper', not %r" % (method,))
    if number_of_segments is not None and not (maximum_number_of_segments is None and
                                               salience_threshold is None):
        raise ValueError("number_of_segments goes neither with maximum_number_of_segments nor "
                         "with salience_threshold")
    is_reversed = flag("reverse", reverse)
    function("part_salience", part_salience)
    is_probability = part_salience is None and salience_weights is None and not _METHODS[method]
    if part_salience is not None and salience_weights is not None:
        raise ValueError("part_salience does not go with salience_weights")
    given = {"uses_paper_method": _METHODS[method]}
    for name, read in _READ.items():
        if arguments[name] is not None:
            given[name] = read(name, arguments[name])
    constraints = [
        *edges_arrays(constrained_edges, uncuttable_edges, surface),
        *(None if value is None
          else surface.values_of_triangles(integers_of_triangles(name, value, len(surface)))
          for name, value in (("face_seeds", face_seeds), ("face_groups", face_groups)))]
    try:
        core = _core.segment(
            points, np.ascontiguousarray(triangles[:, ::-1]) if is_reversed else triangles, given,
            *constraints,
            None if features is None else features_of_triangles(features, surface),
            None if part_salience is None
            else lambda factors: part_salience(SalienceFactors._make(factors)),
            None if threads is None else _threads(threads), function("progress", progress))
    except MemoryError:
        raise MemoryError("there is not enough memory for %d triangles" % len(triangles)) from None
    warning = "" if is_reversed else surface.core.inward_warning # computed by each access
    if warning:
        warn(warning)
    return Hierarchy._of(core, surface if surface.needs_core else None, is_probability)


def _with_parameters_of(other: Callable[_P, Any]
                        ) -> Callable[[Callable[..., _R]], Callable[_P, _R]]:
    """Gives a function that passes its parameters on the signature of the other function."""
    def with_signature(function):
        function.__signature__ = inspect.signature(other).replace(
            return_annotation=function.__annotations__["return"])
        return function
    return with_signature


@_with_parameters_of(segment_hierarchy)
def segment(points, triangles=None, **parameters) -> NDArray[np.intp]:
    """Cuts a mesh into the parts that a person would name.

    `segment_hierarchy()` has the same parameters. Its result gives the labels for other numbers of
    segments without another run.

    {parameters}

    Examples
    --------
    >>> labels = segment(points, triangles)
    >>> labels = segment(mesh, number_of_segments=7)
    """
    known = inspect.signature(segment_hierarchy).parameters
    for name in parameters:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1, 0.4)
            raise TypeError("segment() has no parameter %r%s" % (
                name, "; did you mean %r?" % near[0] if near else ""))
    return segment_hierarchy(points, triangles, **parameters).labels()


for _function, _returns in ((segment, """ndarray of int, shape (m,)
        The label of each triangle or polygon, from 0 to the number of segments - 1. Segments are
        numbered by their first triangle."""),
                            (segment_hierarchy, """Hierarchy
        All cuts, and the labels for each number of segments.""")):
    if _function.__doc__: # there is none with python -OO
        _function.__doc__ = _function.__doc__.format(
            parameters=_PARAMETERS.format(returns=_returns))
