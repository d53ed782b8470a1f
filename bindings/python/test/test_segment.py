# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares labels with the labels of the tool, and with the parts that a person sees."""

import itertools
import subprocess
import warnings

import numpy as np
import pytest

from spectral_segmentation import SalienceFactors, boundary_edges, read, segment, segment_hierarchy


def labels_of_tool(tool, path, *options):
    done = subprocess.run([tool, path, "--quiet", "--labels", "-", *options], check=True,
                          stdout=subprocess.PIPE)
    return np.array(done.stdout.split(), int)


@pytest.mark.parametrize("method", ["calibrated", "paper"])
@pytest.mark.parametrize("name", ["elephant", "hand", "cube", "blobby_3cc", "camel", "bones"])
def test_labels_equal_the_labels_of_the_tool(meshes, tool, name, method):
    path = meshes / (name + ".off")
    np.testing.assert_array_equal(segment(read(path), method=method),
                                  labels_of_tool(tool, path, "--method", method))


def test_parameters_do_the_same_as_in_the_tool(meshes, tool):
    path = meshes / "elephant.off"
    mesh = read(path)
    np.testing.assert_array_equal(
        segment(mesh, number_of_segments=9, number_of_smoothing_iterations=3),
        labels_of_tool(tool, path, "--segments", "9", "--smooth", "3"))
    np.testing.assert_array_equal(
        segment(mesh, salience_threshold=0.6, maximum_number_of_segments=5,
                minimum_segment_size=0.02),
        labels_of_tool(tool, path, "--maximum-segments", "5", "--salience-threshold", "0.6",
                       "--minimum-segment-size", "0.02"))
    np.testing.assert_array_equal(segment(mesh, number_of_searches=2),
                                  labels_of_tool(tool, path, "--searches", "2"))
    np.testing.assert_array_equal(
        segment(mesh, method="paper", random_seed=7, threads=1),
        labels_of_tool(tool, path, "--method", "paper", "--seed", "7"))


def test_closed_triangles_that_point_inward_have_the_parts_of_the_outward_ones(dumbbell):
    points, triangles = dumbbell
    np.testing.assert_array_equal(segment(points, np.asarray(triangles)[:, ::-1]),
                                  segment(points, triangles))


def test_open_triangles_that_point_inward_are_turned_around(dumbbell):
    points, triangles = dumbbell
    with_hole = triangles[40:]
    bowl = triangles[points[triangles][:, :, 2].mean(axis=1) < -2]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for quiet in (with_hole, bowl, bowl[:, ::-1]):
            segment(points, quiet)
    with pytest.warns(UserWarning, match="seem to point inward") as caught:
        labels = segment(points, with_hole[:, ::-1])
    np.testing.assert_array_equal(labels, segment(points, with_hole))
    assert caught[0].filename == __file__


def test_reversed_triangles_are_searched_as_the_others(dumbbell):
    """Half of a dumbbell has its parts from outside only."""
    points, triangles = dumbbell
    half = triangles[points[triangles][:, :, 1].mean(axis=1) < 0]
    np.testing.assert_array_equal(segment(points, half[:, ::-1], reverse=True),
                                  segment(points, half))
    assert (segment(points, half[:, ::-1]) != segment(points, half)).any()
    with pytest.raises(TypeError, match="reverse"):
        segment(points, half, reverse="yes")


def test_triangles_between_tetrahedra_are_left_out():
    """Each cell of a grid is six tetrahedra; the faces outside are those that occur once."""
    cells = [(x, y, z) for x in range(10) for y in range(3) for z in range(3)
             if not 3 <= x < 7 or y == z == 1]
    tetrahedra = [np.cumsum([cell, *np.eye(3, dtype=int)[list(order)]], axis=0)
                  for cell in cells for order in itertools.permutations(range(3))]
    corners = np.array([np.delete(t, i, axis=0) for t in tetrahedra for i in range(4)])
    points, indices = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    triangles = indices.reshape(-1, 3)
    _, first, number = np.unique(np.sort(triangles), axis=0, return_index=True, return_counts=True)
    outside = np.sort(first[number == 1])
    alone = segment(points, triangles[outside])
    assert alone.max() == 2
    for chosen in (np.arange(len(triangles)), np.sort(first)): # each tetrahedron's, each once
        with pytest.warns(UserWarning, match="tetrahedra.*: %d" % (len(chosen) - len(outside))):
            labels = segment(points, triangles[chosen])
        assert len(labels) == len(chosen)
        np.testing.assert_array_equal(labels[np.isin(chosen, outside)], alone)


def test_groups_are_kept_apart_as_by_the_tool(dumbbell, tool, tmp_path):
    points, triangles = dumbbell
    groups = np.where(points[triangles].mean(axis=1)[:, 0] > 0, 7, -2)
    path = tmp_path / "groups.obj"
    with path.open("w") as file:
        for point in points:
            file.write("v %r %r %r\n" % tuple(map(float, point)))
        for triangle, group in zip(triangles, groups):
            file.write("g %d\nf %d %d %d\n" % (group, *(triangle + 1)))
    labels = segment(points, triangles, face_groups=groups)
    np.testing.assert_array_equal(labels, labels_of_tool(tool, path, "--keep-groups"))
    assert not set(labels[groups == 7]) & set(labels[groups == -2])
    np.testing.assert_array_equal(segment(points, triangles), labels_of_tool(tool, path))


def test_features_decide_with_the_shape(dumbbell):
    points, triangles = dumbbell
    is_left = points[triangles].mean(axis=1)[:, 0] > 0
    rows = np.random.RandomState(1).rand(len(triangles), 70)
    without = segment(points, triangles)
    for features in (np.full(len(triangles), 5), np.full((len(triangles), 3), .1)):
        np.testing.assert_array_equal(segment(points, triangles, features=features), without)
    # Noise moves no more than single faces along the cuts.
    assert np.mean(segment(points, triangles, features=rows) != without) < .002
    rows[:, 3] += 10 * is_left
    for features in (is_left.astype(int), 1e9 + is_left, rows, rows.astype(np.float32)):
        labels = segment(points, triangles, features=features, feature_weight=1,
                         number_of_segments=2)
        assert np.mean((labels == labels[is_left.argmax()]) == is_left) > .9
        np.testing.assert_array_equal(
            segment(points, triangles, features=features, feature_weight=0), without)


def test_dumbbell_is_two_balls_and_a_bar_or_less(dumbbell):
    points, triangles = dumbbell
    heights = points[triangles].mean(axis=1)[:, 2]
    labels = segment(points, triangles, number_of_segments=2)
    assert labels.dtype == np.intp and labels.shape == (len(triangles),)
    assert len(set(labels[heights > 1.2])) == len(set(labels[heights < -1.2])) == 1
    assert labels[heights.argmin()] != labels[heights.argmax()]


def test_types_and_strides_make_no_difference(bumpy_dumbbell):
    points, triangles = bumpy_dumbbell
    points = points.astype(np.float32).astype(np.float64) # representable in both

    def run(points, triangles):
        return segment(points, triangles, number_of_segments=3, number_of_coarse_faces=0)

    expected = run(points, triangles)
    records = np.zeros(len(points), [("flag", "u1"), ("xyz", "<f8", 3)]) # not aligned
    records["xyz"] = points
    for other in (points.astype(np.float32), points.astype(np.longdouble), points.astype(">f8"),
                  np.asfortranarray(points), np.repeat(points, 2, axis=0)[::2], records["xyz"],
                  points.tolist(), tuple(map(tuple, points))):
        np.testing.assert_array_equal(run(other, triangles), expected)
    for kind in ("i2", "u2", "i4", "u4", "i8", "u8", ">i4", object):
        other = triangles.tolist() if kind is object else triangles.astype(kind)
        np.testing.assert_array_equal(run(points, other), expected)
    np.testing.assert_array_equal(run(points, np.asfortranarray(triangles)), expected)
    flipped = np.ascontiguousarray(triangles[:, ::-1])[:, ::-1] # a negative stride
    np.testing.assert_array_equal(run(points, flipped), expected)


def test_arrays_of_common_types_are_not_copied():
    from spectral_segmentation._meshes import Surface, points_array
    for kind in ("f4", "f8"):
        array = np.zeros((8, 3), kind)[::2]
        assert points_array(array) is not None
        assert np.shares_memory(points_array(array), array)
    for kind in ("i4", "u4", "i8", "u8"):
        array = np.zeros((8, 6), kind)[:, ::2]
        assert np.shares_memory(Surface(None, array).triangles, array)


def test_arguments_are_not_changed_and_may_be_read_only(dumbbell):
    points, triangles = (array.copy() for array in dumbbell)
    points.flags.writeable = triangles.flags.writeable = False
    segment(points, triangles, method="paper")
    np.testing.assert_array_equal(points, dumbbell[0])


def test_empty_mesh_has_no_segments():
    for points, triangles in (([], []), (np.empty((0, 3)), np.empty((0, 3), int)),
                              ([[0, 0, 0]], [])):
        assert segment(points, triangles).shape == (0,)


def test_seeds_hold(dumbbell):
    points, triangles = dumbbell
    heights = points[triangles].mean(axis=1)[:, 2]
    lowest, highest = heights.argmin(), heights.argmax()
    seeds = np.full(len(triangles), -1)
    seeds[[lowest, highest]] = 5
    labels = segment(points, triangles, face_seeds=seeds)
    assert labels[lowest] == labels[highest]
    seeds[highest] = 6
    labels = segment(points, triangles, face_seeds=seeds, salience_threshold=float("inf"))
    assert labels[lowest] != labels[highest]


def rows(array):
    return set(map(tuple, array.tolist()))


def test_edges_hold(meshes):
    """Constraints hold in the segmentation of the run, and in all finer ones of the hierarchy."""
    mesh = read(meshes / "elephant.off")
    free = rows(boundary_edges(mesh.triangles, segment(mesh))[0])
    all_edges, _ = boundary_edges(mesh.triangles, np.arange(len(mesh.triangles)))
    random = np.random.default_rng(1)
    constrained = all_edges[random.choice(len(all_edges), 4, replace=False)]
    uncuttable = np.array(sorted(free - rows(constrained)))[::3]
    hierarchy = segment_hierarchy(mesh, constrained_edges=constrained[:, ::-1],
                                  uncuttable_edges=uncuttable)
    for n in range(hierarchy.labels().max() + 1, hierarchy.number_of_segments + 1):
        made = rows(boundary_edges(mesh.triangles, hierarchy.labels(n))[0])
        assert rows(constrained) <= made
        assert not rows(uncuttable) & made
    assert not rows(constrained) <= free


def test_edges_of_one_triangle_and_of_three():
    points = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 1, 0], [-1, -1, 0]]
    triangles = [[0, 1, 2], [0, 1, 3], [0, 1, 4]]

    def labels(threshold, **constraints):
        return segment(points, triangles, salience_threshold=threshold, **constraints).tolist()

    assert labels(np.inf) == [0, 0, 0] and labels(-np.inf) == [0, 1, 2]
    assert labels(np.inf, constrained_edges=[[1, 0]]) == [0, 1, 2]
    assert labels(-np.inf, uncuttable_edges=[[1, 0]]) == [0, 0, 0]
    for border in ([[1, 2]], np.empty((0, 2), int)):
        assert labels(np.inf, constrained_edges=border) == [0, 0, 0]
        assert labels(-np.inf, uncuttable_edges=border) == [0, 1, 2]


def test_own_salience(dumbbell):
    seen = []

    def salience(factors):
        seen.append((factors.size, factors.cut_strength, factors.protrusiveness))
        return factors.size

    hierarchy = segment_hierarchy(*dumbbell, method="paper", part_salience=salience,
                                  salience_threshold=0.2)
    cut = hierarchy.nodes[hierarchy.children[:, 0] >= 0]
    assert len(cut) > 0 and (cut["salience"] == cut["size"]).all() and (cut["size"] >= 0.2).all()
    sizes, strengths, _ = np.array(seen).T
    assert 0 <= sizes.min() and sizes.max() <= 0.5
    assert 0 <= strengths.min() and strengths.max() <= 1
    as_weights = segment(*dumbbell, method="paper", salience_weights=(1, 0, 0),
                         salience_threshold=0.2)
    np.testing.assert_array_equal(hierarchy.labels(), as_weights)
    with pytest.raises(ValueError, match="part_salience returned NaN"):
        segment(*dumbbell, method="paper", part_salience=lambda factors: float("nan"))
    assert salience(SalienceFactors(size=0.25)) == 0.25


def test_numbers_of_numpy_are_numbers(dumbbell):
    expected = segment(*dumbbell, number_of_segments=3, minimum_segment_size=0.01,
                       keep_components_separate=True)
    given = segment(*dumbbell, number_of_segments=np.uint8(3),
                    keep_components_separate=np.bool_(True),
                    minimum_segment_size=np.float64(0.01))
    np.testing.assert_array_equal(given, expected)
