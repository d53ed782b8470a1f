# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong arguments are refused by an exception that names them."""

import re
import subprocess
import sys

import numpy as np
import pytest

from spectral_segmentation import (boundary_edges, segment, segment_adjacency, segment_colors,
                                   segment_hierarchy, write)

POINTS = [[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
TRIANGLES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


@pytest.mark.parametrize("points, error, words", [
    ([[0, 0], [1, 0], [0, 1]], ValueError, r"points must have the shape \(n, 3\), not \(3, 2\)"),
    ([0., 1, 2], ValueError, r"points must have the shape \(n, 3\), not \(3,\)"),
    (np.zeros((2, 2, 3)), ValueError, r"points .* not \(2, 2, 3\)"),
    (np.zeros((1, 0, 3)), ValueError, r"points .* not \(1, 0, 3\)"),
    (3, TypeError, "has no|points|neither"),
    ("abc", TypeError, "points must be real numbers"),
    (None, TypeError, "points must be real numbers"),
    ([[0, 0, 0], [1, 0]], (TypeError, ValueError), "points must be"),
    (np.zeros((4, 3), complex), TypeError, "points must be real numbers, not complex128"),
    (np.zeros((4, 3), bool), TypeError, "points must be real numbers, not bool"),
    (np.zeros((4, 3), "M8[s]"), TypeError, "points must be real numbers"),
    (np.full((4, 3), None), TypeError, "points must be real numbers, not object"),
    ([[np.nan, 0, 0]] * 4, ValueError, "no face with three corners; face 0 uses a point that is n"),
    ([[0, np.inf, 0]] * 4, ValueError, "not finite; corners left out: 12$"),
    (POINTS[:3], ValueError, "triangle 1 has a corner that is no index of a point"),
    ([], ValueError, "triangle 0 has a corner that is no index of a point"),
])
@pytest.mark.filterwarnings("ignore::numpy.VisibleDeprecationWarning")
def test_points(points, error, words):
    if isinstance(points, int):
        words = r"points must have the shape \(n, 3\), not \(\)"
        error = ValueError
    with pytest.raises(error, match=words):
        segment(points, TRIANGLES)


@pytest.mark.parametrize("triangles, error, words", [
    ([[0., 1, 2]], TypeError, "triangles must be integers, not float64"),
    ([[True, False, True]], TypeError, "triangles must be integers, not bool"),
    ([["0", "1", "2"]], TypeError, "triangles must be integers"),
    ([[0, 1]], ValueError, r"triangles must have the shape \(n, 3\), or \(n, k\) for .* \(1, 2\)"),
    ([0, 1, 2], ValueError, r"triangles must have the shape \(n, 3\), .* not \(3,\)"),
    ([[0, 1, 2], 3], (TypeError, ValueError), "triangles must be"),
    ([[0, 1, 4]], ValueError, "triangle 0 has a corner that is no index of a point"),
    ([[0, 1, 2], [0, -1, 2]], ValueError, "triangle 1 has a corner that is no index of a point"),
    (np.array([[0, 1, 2**63]], "u8"), ValueError, "triangle 0 has a corner that is no index"),
    ([[0, 1, 2**70]], (TypeError, ValueError), "triangle"),
])
@pytest.mark.filterwarnings("ignore::numpy.VisibleDeprecationWarning")
def test_triangles(triangles, error, words):
    with pytest.raises(error, match=words):
        segment(POINTS, triangles)


@pytest.mark.parametrize("parameters, error, words", [
    ({"method": "zhang"}, ValueError, "method must be 'calibrated' or 'paper', not 'zhang'"),
    ({"method": None}, ValueError, "method must be"),
    ({"method": ["paper"]}, ValueError, "method must be"),
    ({"methods": "paper"}, TypeError, "methods"),
    ({"number_of_segments": -2**80}, ValueError, "number_of_segments must be at least 1"),
    ({"number_of_segments": 5}, ValueError, "number_of_segments is 5, but .* can have 1 to 4"),
    ({"number_of_segments": 2**63}, OverflowError, "number_of_segments is too large"),
    ({"number_of_segments": 2.}, TypeError, "number_of_segments must be an integer, not float"),
    ({"number_of_segments": "2"}, TypeError, "number_of_segments must be an integer, not str"),
    ({"number_of_segments": True}, TypeError, "number_of_segments must be an integer, not a bool"),
    ({"number_of_segments": 2, "salience_threshold": 0.5}, ValueError,
     "number_of_segments goes neither"),
    ({"number_of_segments": 2, "maximum_number_of_segments": 3}, ValueError, "goes neither"),
    ({"salience_threshold": 2}, ValueError, r"must be in \[0, 1\], because it is a proba"),
    ({"salience_threshold": "0.5"}, TypeError, "threshold must be a number, not str"),
    ({"salience_threshold": False}, TypeError, "threshold must be a number, not bool"),
    ({"salience_threshold": 1j}, TypeError, "threshold must be a number, not complex"),
    ({"keep_components_separate": 1}, TypeError,
     "keep_components_separate must be a bool, not int"),
    ({"keep_components_separate": False, "method": "paper"}, ValueError,
     "keep_components_separate must be True with the method 'paper'"),
    ({"minimum_segment_size": 0.6}, ValueError, r"minimum_segment_size must be in \[0, 0.5\]"),
    ({"part_salience": 0.5}, TypeError, "part_salience must be callable, not float"),
    ({"part_salience": abs, "salience_weights": (1, 0, 0)}, ValueError, "does not go with"),
    ({"salience_weights": 1}, TypeError, "salience_weights must be three numbers"),
    ({"salience_weights": (1, 0)}, ValueError, "salience_weights must be three numbers, not 2"),
    ({"salience_weights": (1, "a", 0)}, TypeError, "salience_weights must be a number, not str"),
    ({"distance_weights": (0, -1, 0)}, ValueError, "distance_weights must be finite and not neg"),
    ({"random_seed": -1}, ValueError, "random_seed must not be negative"),
    ({"random_seed": 2**64}, OverflowError, "random_seed is too large"),
    ({"threads": 0}, ValueError, "threads must be at least 1"),
    ({"progress": 1}, TypeError, "progress must be callable, not int"),
    ({"face_seeds": [1, 2, 3]}, ValueError, r"face_seeds must have the shape \(4,\)"),
    ({"face_seeds": [1., 2, 3, 4]}, TypeError, "face_seeds must be integers, not float64"),
    ({"face_seeds": [1, 2, 1, 2], "method": "paper"}, ValueError,
     "^the method of the paper takes no constraints: use the calibrated method with them$"),
    ({"face_seeds": [1, 2, 3, 4], "number_of_segments": 2}, ValueError, "need 4 segments"),
    ({"face_groups": [1, 2, 3]}, ValueError, r"face_groups must have the shape \(4,\)"),
    ({"face_groups": [1., 2, 3, 4]}, TypeError, "face_groups must be integers, not float64"),
    ({"features": [1, 2, 3]}, ValueError, r"features must have the shape \(4,\) or \(4, d\)"),
    ({"features": [[], [], [], []]}, ValueError, "features must have at least one number"),
    ({"features": [[[1]]] * 4}, ValueError, r"not \(4, 1, 1\)"),
    ({"features": list("abcd")}, TypeError, "features must be numbers"),
    ({"features": [0., 1, np.nan, 2]}, ValueError, "not finite, at face 2"),
    ({"features": np.array([0, 1, np.inf, 2], np.float32)}, ValueError, "not finite, at face 2"),
    ({"features": [1, 2, 1, 2], "method": "paper"}, ValueError, "takes no features"),
    ({"constrained_edges": [0, 1]}, ValueError,
     r"constrained_edges must have the shape \(k, 2\), two points for each edge, not \(2,\)"),
    ({"uncuttable_edges": [[0., 1]]}, TypeError,
     "uncuttable_edges must be integers, not float64"),
    ({"uncuttable_edges": [[0, 1], [2, 2]]}, ValueError,
     r"uncuttable_edges has the edge \(2, 2\), which no triangle has"),
    ({"constrained_edges": [[0, 4]]}, ValueError, r"the edge \(0, 4\), which no triangle"),
    ({"constrained_edges": [[-1, 0]]}, ValueError, r"the edge \(-1, 0\), which no triangle"),
    ({"constrained_edges": [[0, 1], [1, 2]], "uncuttable_edges": [[1, 0]]}, ValueError,
     "triangles 0 and 1 is in both constrained_edges and uncuttable_edges"),
    ({"constrained_edges": [[0, 1]], "face_seeds": [1, 1, -1, -1]}, ValueError,
     "triangles 0 and 1"),
    ({"constrained_edges": [[0, 1]], "method": "paper"}, ValueError, "takes no constraints"),
])
def test_parameters(parameters, error, words):
    for function in (segment, segment_hierarchy):
        with pytest.raises(error, match=words) as raised:
            function(POINTS, TRIANGLES, **parameters)
        assert not re.search("segment_spectral_recursive|_map|zhang", str(raised.value)) or \
            parameters.get("method") == "zhang"


def test_missing_and_positional_arguments():
    with pytest.raises(TypeError):
        segment()
    with pytest.raises(TypeError, match="triangles are missing, and list is no mesh"):
        segment(POINTS)
    with pytest.raises(TypeError):
        segment(POINTS, TRIANGLES, "paper")
    for positional in ((POINTS, 3), ((POINTS, TRIANGLES), 3)):
        with pytest.raises(TypeError, match="named argument: number_of_segments=3"):
            segment(*positional)
    with pytest.raises(TypeError, match="segment.. has no parameter 'n_segments'; did you mean"):
        segment(POINTS, TRIANGLES, n_segments=7)


@pytest.mark.parametrize("labels, error, words", [
    ([0, 1, 2], ValueError, r"labels must have the shape \(4,\)"),
    ([0., 1, 2, 3], TypeError, "labels must be integers, not float64"),
    ([0, 1, 2, 4], ValueError, "labels must be from 0 to the number of triangles - 1"),
    ([0, 1, 2, -1], ValueError, "labels must be from 0"),
])
def test_labels(tmp_path, labels, error, words):
    for call in (lambda: boundary_edges(TRIANGLES, labels),
                 lambda: segment_adjacency(POINTS, TRIANGLES, labels),
                 lambda: segment_colors(TRIANGLES, labels),
                 lambda: write(tmp_path / "a.ply", POINTS, TRIANGLES, labels)):
        with pytest.raises(error, match=words):
            call()
    assert not list(tmp_path.iterdir())


def test_thresholds_that_are_no_probabilities():
    for parameters in ({"method": "paper"}, {"salience_weights": (1, 0, 0)},
                       {"part_salience": lambda factors: 3}):
        segment(POINTS, TRIANGLES, salience_threshold=2, **parameters)
    for threshold in (0, 1, -np.inf, np.inf, np.float32(0.5)):
        segment(POINTS, TRIANGLES, salience_threshold=threshold)


def test_hierarchy():
    hierarchy = segment_hierarchy(POINTS, TRIANGLES, number_of_segments=3)
    for call, error, words in (
            (lambda: hierarchy.labels(0), ValueError, "n must be at least 1"),
            (lambda: hierarchy.labels(-2**40), ValueError, "n must be at least 1"),
            (lambda: hierarchy.labels(salience_threshold=float("nan")), ValueError,
             "^the salience threshold is not a number"),
            (lambda: hierarchy.labels("3"), TypeError, "str"),
            (lambda: hierarchy.labels(2.5), TypeError, "float"),
            (lambda: hierarchy.labels(2**70), OverflowError, "n is too large"),
            (lambda: hierarchy.labels(1, 2), TypeError, r"labels\(\) takes from 1 to 2 positional"),
            (lambda: hierarchy.merge(1), TypeError, "missing 1 required positional argument: 'b'"),
            (lambda: hierarchy.labels_of_nodes(5), TypeError, "nodes must be integers, not int"),
            (lambda: hierarchy.split_leaf(3, "x"), TypeError, "part must be a Hierarchy, not str"),
            (lambda: hierarchy.from_json(5), TypeError, "text must be a str, not int"),
            (lambda: hierarchy.segments(salience_threshold="x"), TypeError, "str"),
            (lambda: hierarchy.faces(1000), ValueError, "there is no node 1000"),
            (lambda: hierarchy.faces(-1), ValueError, "there is no node -1"),
            (lambda: hierarchy.faces("x"), TypeError, "str"),
            (lambda: hierarchy.labels_of_nodes([0, -1]), ValueError, "there is no node -1"),
            (lambda: hierarchy.labels_of_nodes([]), ValueError, "in no segment"),
            (lambda: hierarchy.labels_of_nodes([0, 0]), ValueError, "different nodes"),
            (lambda: hierarchy.merge(0, 1), ValueError, ""),
            (lambda: hierarchy.merge(0, 1000), ValueError, "there is no node 1000"),
            (lambda: hierarchy.merge(-1, 0), ValueError, "there is no node -1"),
            (lambda: hierarchy.split_leaf(0, hierarchy), ValueError, "only a leaf"),
            (lambda: hierarchy.from_json("{"), ValueError, "not well-formed"),
            (lambda: hierarchy.from_json("[1]"), ValueError, "^this is not a hierarchy"),
            (lambda: type(hierarchy)(), TypeError, r"segment_hierarchy\(\), .* makes a Hierarchy")):
        with pytest.raises(error, match=words):
            call()
    stopped = segment_hierarchy(POINTS, TRIANGLES, method="paper", salience_threshold=0.9)
    with pytest.raises(ValueError, match="the run had a higher salience threshold|run ended"):
        stopped.labels(salience_threshold=-float("inf"))


def test_memory_error():
    """Runs in a process of its own, which is allowed little more memory than it has."""
    program = """
import resource
import numpy as np
from spectral_segmentation import segment
n = 1000
grid = np.stack(np.meshgrid(np.arange(n), np.arange(n)), -1).reshape(-1, 2)
points = np.column_stack([grid, np.sin(grid[:, 0] / 50)])
a = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
triangles = np.concatenate([np.stack([a, a + 1, a + n], 1), np.stack([a + 1, a + n + 1, a + n], 1)])
segment([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], threads=1)
pages = int(open("/proc/self/statm").read().split()[0])
limit = pages * resource.getpagesize() + 50_000_000
hard_limit = resource.getrlimit(resource.RLIMIT_AS)[1]
resource.setrlimit(resource.RLIMIT_AS, (limit, hard_limit))
try:
    segment(points, triangles, threads=1)
except MemoryError as error:
    resource.setrlimit(resource.RLIMIT_AS, (hard_limit, hard_limit))
    print(error, segment(np.eye(3), [[0, 1, 2]]))
"""
    if not sys.platform.startswith("linux"):
        pytest.skip("only Linux has /proc")
    done = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    assert done.stdout == "there is not enough memory for 1996002 triangles [0]\n", done.stderr
