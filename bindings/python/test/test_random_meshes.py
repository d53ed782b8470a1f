# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks properties of every run, on meshes that Hypothesis makes up."""

import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from conftest import bumpy_dumbbell_of
from spectral_segmentation import Hierarchy, segment, segment_hierarchy

pytestmark = pytest.mark.filterwarnings("ignore:the hierarchy has only")

METHODS = st.sampled_from(["calibrated", "paper"])


@st.composite
def soups(draw):
    """Makes any triangles: degenerate, equal, with many or no neighbors."""
    n = draw(st.integers(3, 10))
    coordinate = st.integers(-4, 4)
    points = draw(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=n, max_size=n))
    corner = st.integers(0, n - 1)
    triangles = draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=16))
    return np.array(points, float), np.array(triangles)


def canonical(labels):
    """Returns the labels of the same segments, numbered by their first triangle."""
    _, first, place = np.unique(labels, return_index=True, return_inverse=True)
    return np.argsort(np.argsort(first))[place]


def assert_segments_equal(labels, others):
    np.testing.assert_array_equal(canonical(labels), canonical(others))


def run(mesh, method):
    return segment_hierarchy(*mesh, method=method, number_of_coarse_faces=0,
                             salience_threshold=-np.inf, minimum_segment_size=0)


@given(soups(), METHODS)
def test_labels_are_numbered_by_the_first_triangle(mesh, method):
    for labels in (segment(*mesh, method=method, number_of_coarse_faces=0),
                   run(mesh, method).labels()):
        assert labels.shape == (len(mesh[1]),)
        np.testing.assert_array_equal(labels, canonical(labels))


@given(soups(), METHODS)
def test_a_hierarchy_is_nested(mesh, method):
    hierarchy = run(mesh, method)
    roots, leaves = hierarchy.number_of_roots, hierarchy.number_of_segments
    previous = hierarchy.labels(1)
    assert previous.max() + 1 == roots
    for n in range(1, leaves + 2):
        labels = hierarchy.labels(n)
        assert labels.max() + 1 == min(max(n, roots), leaves)
        # each segment is in one of those before
        pairs = np.unique(np.stack([labels, previous]), axis=1)
        assert pairs.shape[1] == labels.max() + 1
        previous = labels
    nodes, children = hierarchy.nodes, hierarchy.children
    for i, (a, b) in enumerate(children):
        assert (a < 0) == (b < 0)
        if a >= 0:
            assert (nodes["parent"][[a, b]] == i).all()
            both = np.concatenate([hierarchy.faces(a), hierarchy.faces(b)])
            np.testing.assert_array_equal(np.sort(both), np.sort(hierarchy.faces(i)))


@given(soups(), METHODS)
def test_saving_changes_nothing(mesh, method):
    hierarchy = run(mesh, method)
    for other in (Hierarchy.from_json(hierarchy.to_json()), pickle.loads(pickle.dumps(hierarchy))):
        assert other.to_json() == hierarchy.to_json()
        np.testing.assert_array_equal(other.nodes, hierarchy.nodes)
        for n in (1, 2, 5):
            np.testing.assert_array_equal(other.labels(n), hierarchy.labels(n))


@settings(max_examples=8)
@given(st.integers(0, 10**6), METHODS)
def test_order_and_place_do_not_matter(seed, method):
    points, triangles = bumpy_dumbbell_of(seed)

    def labels_of(points, triangles):
        return segment(points, triangles, method=method, number_of_segments=4,
                       number_of_coarse_faces=0)

    expected = labels_of(points, triangles)
    random = np.random.default_rng(seed)
    of_points, of_triangles = random.permutation(len(points)), random.permutation(len(triangles))
    assert_segments_equal(labels_of(points, triangles[of_triangles]), expected[of_triangles])
    other = np.empty_like(points)
    other[of_points] = points
    assert_segments_equal(labels_of(other, of_points[triangles]), expected)
    # A rigid motion without rounding
    moved = points[:, [1, 2, 0]] + [64, -128, 32]
    assert_segments_equal(labels_of(moved, triangles), expected)
