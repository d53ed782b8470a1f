# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the segmentation."""

import difflib
import inspect

from . import _core
from ._checks import flag, function, integer, real, three_numbers
from ._constraints import edges_arrays, integers_of_triangles
from ._hierarchy import Hierarchy
from ._meshes import arrays_of
from ._salience import SalienceFactors

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
    if number > 1 and not _core.HAS_THREADS:
        raise ValueError("this build has no threads, as it is without TBB")
    return min(number, 1024)


def segment_hierarchy(points, triangles=None, *, method="calibrated", number_of_segments=None,
                      maximum_number_of_segments=None, salience_threshold=None,
                      keep_components_separate=None, face_groups=None,
                      constrained_edges=None, uncuttable_edges=None,
                      face_seeds=None, minimum_segment_size=None, part_salience=None,
                      salience_weights=None, distance_weights=None, number_of_coarse_faces=None,
                      number_of_reference_faces=None, number_of_smoothing_iterations=None,
                      smooth_boundaries=None, random_seed=None, threads=None, progress=None):
    """Cuts a triangle mesh into parts, and returns all cuts with their salience.

    The same input gives the same result on every run, with any number of threads. The lock of
    Python is released: several threads may run at a time. The arrays must not change meanwhile.

    Parameters, all but the mesh being optional; the manual of the C++ library tells more:

    points: array_like of real numbers, shape (n, 3), in any unit; or a mesh: what `read()` returns,
        or an object of trimesh, Open3D, PyVista or meshio. Arrays of float32 and float64 are read
        without a copy.
    triangles: array_like of integers, shape (m, 3), the indices of the corners in `points`. Arrays
        of 4 and 8 bytes an integer are read without a copy. Edges may have any number of
        triangles, and the orientation may vary.
    method: "calibrated", which cuts where people cut, or "paper", that of Zhang and Liu 2005,
        `zhang_liu_2005()` in C++.
    number_of_segments: exactly this number, whatever the saliences are; not together with the next
        two.
    maximum_number_of_segments: at most this number.
    salience_threshold: the smallest salience of a cut; by default 0.48, the probability that people
        cut there, or 0.54 for weighted saliences such as the paper's.
    keep_components_separate: whether each connected component is a part from the start; by default
        False, with the method "paper" True. By default a component with less than a hundredth of
        the area belongs to the part with which it has the most contact.
    face_groups: array_like of integers, shape (m,): the group of each triangle, such as an object
        of a file. Groups are kept apart like connected components.
    constrained_edges: array_like of integers, shape (k, 2): edges by their points, as of
        `boundary_edges()`, that must be between segments. Edges of one triangle are ignored.
    uncuttable_edges: array_like of integers, shape (k, 2): edges whose triangles must be of
        one segment.
    face_seeds: array_like of integers, shape (m,). Triangles with the same number are of one
        segment, those with different numbers are not; negative numbers mean nothing. Neither
        this nor the two for edges go with the method "paper".
    minimum_segment_size: the least share of the area of the mesh for each side of a cut, in
        [0, 0.5]; by default 0.003, with the method "paper" 0.005.
    part_salience: your own salience of a cut, a callable that takes `SalienceFactors` and returns a
        number. It is called from several threads, one at a time. Give `salience_threshold` with it.
    salience_weights: three numbers, not negative, with sum 1: the weights of size, cut strength and
        protrusiveness in a weighted salience. Not together with `part_salience`.
    distance_weights: three numbers: the weight of the geodesic distance, in [0, 1], and the factors
        of the angle distance at concave and at convex edges; by default 0.03, 1, 0.1, with the
        method "paper" 0.01, 1, 0.1.
    number_of_coarse_faces: cuts are searched on a coarse mesh with this number of triangles, by
        default 4000, and at most 1000 more than the mesh has; 0 means the mesh itself, the default
        of the method "paper".
    number_of_reference_faces: the dimension of the context vector, by default 10.
    number_of_smoothing_iterations: steps of Laplacian smoothing before the search, by default 0.
    smooth_boundaries: whether boundaries of segments are smoothed, by default False.
    random_seed: chooses reference faces at random, as in the paper.
    threads: at most this number of threads; by default all that the machine has.
    progress: is called with the share of the run that is done, from 0 to 1, in the caller's thread.
        If it returns False, or another value but None that counts as false, the run ends, and the
        result has the cuts made so far. If it raises an exception, the run ends with that. So it
        does with KeyboardInterrupt after Ctrl-C.

    Raises TypeError or ValueError if an argument has a wrong type, shape or range, or seeds and
    edges contradict each other; OverflowError if a number is too large; MemoryError if there is not
    enough memory. Warns with UserWarning if the triangles are a closed surface that points inwards:
    turned around, it may have other parts.
    """
    points, triangles = arrays_of(points, triangles)
    if not isinstance(method, str) or method not in _METHODS:
        raise ValueError("method must be 'calibrated' or 'paper', not %r" % (method,))
    if number_of_segments is not None and not (maximum_number_of_segments is None and
                                               salience_threshold is None):
        raise ValueError("number_of_segments goes neither with maximum_number_of_segments nor "
                         "with salience_threshold")
    function("part_salience", part_salience)
    if part_salience is not None and salience_weights is not None:
        raise ValueError("part_salience does not go with salience_weights")
    for name, value in (("constrained_edges", constrained_edges),
                        ("uncuttable_edges", uncuttable_edges),
                        ("face_seeds", face_seeds)):
        if value is not None and _METHODS[method]:
            raise ValueError("%s does not go with the method 'paper'" % name)
    given = {"uses_paper_method": _METHODS[method]}
    for read, parameters in (
            (integer, {"number_of_segments": number_of_segments,
                        "maximum_number_of_segments": maximum_number_of_segments,
                        "number_of_coarse_faces": number_of_coarse_faces,
                        "number_of_reference_faces": number_of_reference_faces,
                        "number_of_smoothing_iterations": number_of_smoothing_iterations}),
            (real, {"salience_threshold": salience_threshold,
                     "minimum_segment_size": minimum_segment_size}),
            (flag, {"keep_components_separate": keep_components_separate,
                     "smooth_boundaries": smooth_boundaries}),
            (three_numbers, {"salience_weights": salience_weights,
                              "distance_weights": distance_weights}),
            (_random_seed, {"random_seed": random_seed})):
        for name, value in parameters.items():
            if value is not None:
                given[name] = read(name, value)
    constraints = [*edges_arrays(constrained_edges, uncuttable_edges, triangles, len(points)),
              None if face_seeds is None
              else integers_of_triangles("face_seeds", face_seeds, len(triangles)),
              None if face_groups is None
              else integers_of_triangles("face_groups", face_groups, len(triangles))]
    try:
        return Hierarchy._of(_core.segment(
            points, triangles, given, *constraints,
            None if part_salience is None
            else lambda factors: part_salience(SalienceFactors._make(factors)),
            None if threads is None else _threads(threads), function("progress", progress)))
    except MemoryError:
        raise MemoryError("there is not enough memory for %d triangles" % len(triangles)) from None


def segment(points, triangles=None, **parameters):
    """Cuts a triangle mesh into the parts that a person would name.

    Returns the label of each triangle, an array of int of shape (m,). Labels go from 0 to the
    number of segments - 1; segments are numbered by their first triangle.

    The parameters and exceptions are those of `segment_hierarchy()`, whose result gives the labels
    for other numbers of segments without another run.
    """
    known = _SIGNATURE.parameters
    for name in parameters:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1, 0.4)
            raise TypeError("segment() has no parameter %r%s" % (
                name, "; did you mean %r?" % near[0] if near else ""))
    return segment_hierarchy(points, triangles, **parameters).labels()


_SIGNATURE = inspect.signature(segment_hierarchy)
segment.__signature__ = _SIGNATURE # for help() and inspect
