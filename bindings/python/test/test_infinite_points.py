# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays with points that are not finite: faces that use them get the label of a neighbor."""

import pickle
import warnings

import numpy as np
import pytest

from spectral_segmentation import (Hierarchy, boundary_edges, read, segment, segment_adjacency,
                                   segment_colors, segment_hierarchy, view, write)

RUN = {"number_of_segments": 3, "number_of_coarse_faces": 0}


@pytest.fixture(scope="module")
def spoiled(bumpy_dumbbell):
    """Returns points, triangles and whether their corners are finite. The first has none."""
    points = np.concatenate([bumpy_dumbbell[0], np.full((2, 3), np.nan)])
    points[17] = np.inf, 0, 0
    points[90, 2] = np.nan
    triangles = np.concatenate([[[17, 90, len(points) - 1]], bumpy_dumbbell[1]])
    return points, triangles, np.isfinite(points[triangles]).all(axis=(1, 2))


@pytest.fixture
def silent():
    """Makes every warning an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def warning_of(points, triangles, function):
    """Returns the result, and the message of the one warning, which is given in this file."""
    with pytest.warns(UserWarning) as caught:
        result = function()
    bad = ~np.isfinite(points).all(axis=1)
    assert [(w.filename, str(w.message)) for w in caught] == [
        (__file__, "face %d uses a point that is not finite; corners left out: %d"
         % (np.argmax(bad[triangles].any(axis=1)), bad[triangles].sum()))]
    return result


def expected_labels(triangles, is_usable, labels_of_usable):
    """Returns labels of usable triangles, and of the neighbor at the edge with finite points."""
    result = np.full(len(triangles), -1)
    result[is_usable] = labels_of_usable
    for i in np.flatnonzero(~is_usable):
        near = [j for j in np.flatnonzero(is_usable) if len({*triangles[i]} & {*triangles[j]}) == 2]
        assert len(near) == (i != 0)
        result[i] = result[near[0]] if near else result[is_usable][0]
    return result


def test_labels(spoiled):
    points, triangles, is_usable = spoiled
    assert 2 < (~is_usable).sum() < 20
    for kind in (np.float64, np.float32):
        some = points.astype(kind)
        labels = warning_of(points, triangles, lambda: segment(some, triangles, **RUN))
        usable = segment(np.nan_to_num(some, posinf=0), triangles[is_usable], **RUN)
        np.testing.assert_array_equal(labels, expected_labels(triangles, is_usable, usable))
        assert labels.max() == 2


def test_points_without_faces_do_not_matter(bumpy_dumbbell, silent):
    points, triangles = bumpy_dumbbell
    more = np.concatenate([points, np.full((2, 3), np.inf)])
    np.testing.assert_array_equal(segment(more, triangles, **RUN),
                                  segment(points, triangles, **RUN))


def test_hierarchy(spoiled):
    points, triangles, is_usable = spoiled
    hierarchy = warning_of(points, triangles,
                           lambda: segment_hierarchy(points, triangles, **RUN))
    assert hierarchy.number_of_faces == len(triangles)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        other = pickle.loads(pickle.dumps(hierarchy))
        for n in (1, 2, 5):
            labels = hierarchy.labels(n)
            np.testing.assert_array_equal(
                labels, expected_labels(triangles, is_usable, labels[is_usable]))
            np.testing.assert_array_equal(other.labels(n), labels)
            for label, node in enumerate(hierarchy.segments(n)):
                np.testing.assert_array_equal(hierarchy.faces(node),
                                              np.flatnonzero(labels == label))
        of_triangles = Hierarchy.from_json(hierarchy.to_json())
    np.testing.assert_array_equal(of_triangles.labels(5), hierarchy.labels(5)[is_usable])

    leaf = hierarchy.segments(10**6)[hierarchy.labels(10**6)[np.argmin(is_usable[1:]) + 1]]
    inside = triangles[hierarchy.faces(leaf)]
    part = warning_of(points, inside, lambda: segment_hierarchy(
        points, inside, number_of_segments=2, number_of_coarse_faces=0))
    expected = hierarchy.labels(10**6).max() + part.number_of_segments
    hierarchy.split_leaf(leaf, part)
    assert hierarchy.labels(10**6).max() + 1 == expected


def test_constraints_and_features(spoiled):
    points, triangles, is_usable = spoiled
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        # All edges between two arbitrary parts, also those at points that are not finite
        half = (np.arange(len(triangles)) % 2).astype(int)
        edges, _ = boundary_edges(triangles, half)
        assert not np.isfinite(points[edges]).all()
        labels = segment(points, triangles, constrained_edges=edges, salience_threshold=np.inf)
        usable_edges, _ = boundary_edges(triangles[is_usable], half[is_usable])
        assert {*map(tuple, usable_edges)} <= {
            *map(tuple, boundary_edges(triangles[is_usable], labels[is_usable])[0])}
        with pytest.raises(ValueError, match="which no triangle has"):
            segment(points, triangles, constrained_edges=[[0, len(points) - 2]])

        seeds = np.where(is_usable, -1, np.arange(len(triangles)))
        expected = segment(points, triangles, **RUN)
        np.testing.assert_array_equal(
            segment(points, triangles, face_seeds=seeds, face_groups=1 + seeds * 0, **RUN),
            expected)

        upper = np.nan_to_num(points, posinf=0)[triangles].mean(axis=1)[:, 2] > 0.3
        for kind in (np.float32, np.float64):
            features = np.where(is_usable, upper, np.nan).astype(kind)
            labels = segment(points, triangles, features=features, feature_weight=1,
                             number_of_segments=2, number_of_coarse_faces=0)
            of_usable = segment(points, triangles[is_usable], features=upper[is_usable] * 1.,
                                feature_weight=1, number_of_segments=2, number_of_coarse_faces=0)
            np.testing.assert_array_equal(labels[is_usable], of_usable)
            last = np.flatnonzero(is_usable)[-1]
            features[last] = np.nan
            with pytest.raises(ValueError, match="not finite, at face %d$" % last):
                segment(points, triangles, features=features)


def test_files(spoiled, tmp_path):
    points, triangles, is_usable = spoiled
    hierarchy = warning_of(points, triangles, lambda: segment_hierarchy(points, triangles, **RUN))
    for name in ("a.ply", "a.off", "a.obj", "a.glb"):
        warning_of(points, triangles,
                   lambda: write(tmp_path / name, points, triangles, hierarchy))
    mesh = read(tmp_path / "a.ply")
    np.testing.assert_array_equal(mesh.labels, hierarchy.labels()[is_usable])


def test_pages(spoiled, tmp_path):
    points, triangles, _ = spoiled
    hierarchy = warning_of(points, triangles, lambda: segment_hierarchy(points, triangles, **RUN))
    try:
        page = warning_of(points, triangles, lambda: view((points, triangles), hierarchy))
    except RuntimeError as error:
        pytest.skip(str(error)) # built without three.js
    assert page.html.startswith("<!DOCTYPE html>")
    warning_of(points, triangles, lambda: view((points, triangles)))
    warning_of(points, triangles,
               lambda: write(tmp_path / "a.html", points, triangles, hierarchy))


def test_boundaries(spoiled, silent):
    """They need no warning, because they leave out nothing but lengths."""
    points, triangles, is_usable = spoiled
    labels = (np.arange(len(triangles)) % 2).astype(int)
    assert segment_colors(points, triangles, labels).shape == (2, 3)
    edges, _ = boundary_edges(points, triangles, labels)
    pairs, lengths = segment_adjacency(points, triangles, labels)
    ends = points[edges][np.isfinite(points[edges]).all(axis=(1, 2))]
    assert len(ends) < len(edges) and pairs.tolist() == [[0, 1]]
    np.testing.assert_allclose(lengths, [np.sqrt(((ends[:, 0] - ends[:, 1])**2).sum(1)).sum()])


def test_polygons():
    """A quadrilateral that loses a corner stays as a triangle."""
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, np.nan], [2, 0, 0], [2, 1, 0]]
    polygons = [[0, 1, 2, 3], [1, 4, 5, 2]]
    with pytest.warns(UserWarning, match="^face 0 uses .* corners left out: 1$"):
        hierarchy = segment_hierarchy(points, polygons, number_of_segments=2,
                                      face_seeds=[1, 2], number_of_coarse_faces=0)
    assert hierarchy.labels().tolist() == [0, 1]
    areas = hierarchy.nodes["area"][hierarchy.segments()]
    np.testing.assert_allclose(areas, [0.5, 1])


def test_mesh_without_a_usable_face(tmp_path):
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [np.nan, 0, 0]]
    for call in (lambda faces: segment(points, faces),
                 lambda faces: write(tmp_path / "a.ply", points, faces)):
        for faces, words in (([[0, 1, 3], [3, 1, 2]], "face 0 .* left out: 2$"),
                             ([[0, 1, 3, 3]], "face 0 .* left out: 2$")):
            with pytest.raises(ValueError, match="no face with three corners; " + words):
                call(faces)
        with pytest.raises(ValueError, match="corner.* no ind"):
            call([[0, 1, 3], [0, 1, 4]])
    assert not list(tmp_path.iterdir())
