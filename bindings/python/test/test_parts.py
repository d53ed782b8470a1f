# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the parts, and labels of other meshes."""

import json
import subprocess

import numpy as np
import pytest

from spectral_segmentation import (hulls, read, refine_boundaries, segment, split, transfer_labels,
                                   write)

# The points and the sides of a cube
CUBE = np.array([[x, y, z] for z in (0., 1) for y in (0., 1) for x in (0., 1)])
SQUARES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]


def volume(part):
    a, b, c = part.points[part.triangles].transpose(1, 0, 2)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def sides(triangles):
    """Returns the directed edges, sorted."""
    pairs = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return sorted(map(tuple, pairs.tolist()))


def is_closed(part):
    there = sides(part.triangles)
    return there == sides(part.triangles[:, ::-1]) and len(set(there)) == len(there)


def test_open_parts(dumbbell):
    points, triangles = dumbbell
    labels = segment(dumbbell, number_of_segments=3)
    parts = split(dumbbell, labels)
    assert len(parts) == labels.max() + 1 == 3
    for label, part in enumerate(parts):
        assert part.report == {"label": label}
        np.testing.assert_array_equal(part.faces, np.flatnonzero(labels == label))
        np.testing.assert_array_equal(part.points[part.triangles], points[triangles[part.faces]])
        assert len(np.unique(part.triangles)) == len(part.points)
        assert not is_closed(part)
    assert segment(parts[0]).shape == (len(parts[0].triangles),)


def test_closed_parts(dumbbell, tmp_path):
    whole = split(dumbbell, np.zeros(len(dumbbell[1]), int))[0]
    labels = segment(dumbbell, number_of_segments=3)
    parts = split(dumbbell, labels, close=True)
    for label, part in enumerate(parts):
        assert is_closed(part)
        assert part.report["label"] == label and part.report["is_solid"]
        assert part.report["volume"] == pytest.approx(volume(part), rel=1e-9)
        given = part.faces[part.faces >= 0]
        np.testing.assert_array_equal(given, np.flatnonzero(labels == label))
        assert (part.faces[len(given):] == -1).all() and len(given) < len(part.faces)
        write(tmp_path / "part.stl", part)
        assert len(read(tmp_path / "part.stl").triangles) == len(part.triangles)
    assert sum(map(volume, parts)) == pytest.approx(volume(whole), rel=1e-9)


def test_the_report_equals_the_report_of_the_tool(meshes, tool, tmp_path):
    path = meshes / "elephant.off"
    mesh = read(path)
    labels = segment(mesh)
    subprocess.run([tool, path, "--keep-faces", "--split-dir", tmp_path / "parts", "--close",
                    "--json", tmp_path / "report.json"], check=True, capture_output=True)
    report = json.loads((tmp_path / "report.json").read_text())["closed_segments"]
    parts = split(mesh, labels, close=True)
    assert [part.report for part in parts] == report
    part = read(next((tmp_path / "parts").glob("segment_000.*")))
    assert len(part.triangles) == len(parts[0].triangles)


def test_unwelded_parts_are_joined_and_closed():
    points = CUBE[np.concatenate(SQUARES)]
    parts = split((points, np.arange(24).reshape(6, 4)), [0, 1, 0, 0, 1, 1], close=True)
    assert [part.report["is_solid"] for part in parts] == [True, True]
    assert sum(map(volume, parts)) == pytest.approx(1)
    assert set(parts[0].faces[:6]) == {0, 2, 3}


def test_parts_that_are_no_solid_give_a_warning():
    cubes = np.concatenate([CUBE, CUBE + 3, CUBE + 3.5]), [
        [v + first for v in square] for first in (0, 8, 16) for square in SQUARES]
    with pytest.warns(UserWarning, match=r"1 of 2 closed.* no solid: 1 \(intersects i") as warned:
        parts = split(cubes, [0] * 6 + [1] * 12, close=True)
    assert warned[0].filename == __file__
    assert [part.report["is_solid"] for part in parts] == [True, False]


def test_labels_may_be_missing():
    mesh = (CUBE, SQUARES)
    parts = split(mesh, [0, 4, 0, 0, 4, 4])
    assert [part.report["label"] for part in parts] == [0, 4]
    assert split((np.empty((0, 3)), []), []) == hulls((np.empty((0, 3)), []), []) == []


def is_convex(part):
    """Returns whether all points are below the plane of each triangle."""
    a, b, c = part.points[part.triangles].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return (normals @ part.points.T - (normals * a).sum(axis=1)[:, None]).max() < 1e-12


def test_hulls(dumbbell):
    labels = segment(dumbbell, number_of_segments=3)
    for hull, part in zip(hulls(dumbbell, labels), split(dumbbell, labels)):
        assert is_closed(hull) and is_convex(hull) and hull.report["thickness"] == 0
        assert set(map(tuple, hull.points)) <= set(map(tuple, part.points))
        a, b, c = hull.points[hull.triangles].transpose(1, 0, 2)
        normals = np.cross(b - a, c - a)
        assert (part.points @ normals.T - (normals * a).sum(axis=1)).max() < 1e-12
        assert hull.report["label"] == part.report["label"]


def test_hulls_with_few_vertices(dumbbell):
    labels = segment(dumbbell, number_of_segments=3)
    full = hulls(dumbbell, labels)
    for limit in (np.int32(20), 64):
        for hull, large, part in zip(hulls(dumbbell, labels, max_vertices=limit), full,
                                     split(dumbbell, labels)):
            assert hull.report == {"label": part.report["label"], "vertices": len(hull.points),
                                   "faces": len(hull.triangles), "thickness": 0,
                                   "volume": pytest.approx(volume(hull)), "volume_ratio": None}
            assert len(hull.points) <= min(limit, len(large.points))
            assert is_closed(hull) and is_convex(hull)
            a, b, c = hull.points[hull.triangles].transpose(1, 0, 2)
            normals = np.cross(b - a, c - a)
            assert (part.points @ normals.T - (normals * a).sum(axis=1)).max() < 1e-9
            assert 1 - 1e-9 < volume(hull) / volume(large) < (1.5 if limit == 20 else 1.1)
    assert [len(hull.points) for hull in hulls(dumbbell, labels, max_vertices=2**62)] == [
        len(hull.points) for hull in full]
    with pytest.raises(ValueError, match="max_vertices must be at least 4, but is 3"):
        hulls(dumbbell, labels, max_vertices=3)
    with pytest.raises(TypeError, match="max_vertices must be an integer"):
        hulls(dumbbell, labels, max_vertices=8.)


def test_volumes_of_hulls_and_closed_parts(dumbbell):
    labels = segment(dumbbell, number_of_segments=3)
    for hull, part in zip(hulls(dumbbell, labels, close=True), split(dumbbell, labels, close=True)):
        assert hull.report["volume_ratio"] == pytest.approx(volume(hull) / volume(part))
    hull, = hulls((CUBE, SQUARES[1:]), np.zeros(5, int), close=True) # the cap is planar
    assert hull.report["volume_ratio"] == pytest.approx(1)
    points = np.concatenate([CUBE, CUBE + 0.5])
    squares = SQUARES + [[v + 8 for v in square] for square in SQUARES]
    hull, = hulls((points, squares), np.zeros(12, int), close=True)
    assert hull.report["volume_ratio"] is None # the part intersects itself


def test_hull_of_a_cube_with_a_dent():
    points = np.concatenate([CUBE, [[0.5, 0.5, 0.6]]])
    triangles = [*SQUARES[:1], *SQUARES[2:], [4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]]
    hull, = hulls((points, triangles), np.zeros(9, int))
    assert len(hull.points) == 8 and volume(hull) == pytest.approx(1, rel=1e-12)


def test_hull_of_planar_facets_is_the_same_in_any_order():
    """Returns a cube of 5^3 points, in a frame in which sides are planar exactly."""
    points = np.stack(np.meshgrid(*[np.arange(5.)] * 3), -1).reshape(-1, 3)
    points = points @ [[3, 4, 0], [-4, 3, 0], [0, 0, 5]] # turned
    first = None
    for seed in range(10):
        some = np.random.default_rng(seed).permutation(points)
        triangles = np.append(np.arange(125), 0).reshape(-1, 3)
        hull, = hulls((some, triangles), np.zeros(42, int))
        first = first or hull
        np.testing.assert_array_equal(hull.points, first.points)
        np.testing.assert_array_equal(hull.triangles, first.triangles)
        assert len(hull.points) == 8 and is_closed(hull)
        assert volume(hull) == pytest.approx(20**3)


@pytest.mark.parametrize("axis", [(0, 0, 1), (0, 1, 0), (1, 2, 3)])
def test_flat_hulls_have_a_thickness(axis):
    """Returns a square, and a triangle without an area, beside a cube."""
    axis = np.array(axis) / np.linalg.norm(axis)
    u = np.cross(axis, [0.3, 0.5, 0.7])
    u /= np.linalg.norm(u)
    v = np.cross(axis, u)
    square = 5 + np.array([0 * u, u, u + v, v])
    points = np.concatenate([CUBE, square])
    faces = [half for a, b, c, d in SQUARES + [[8, 9, 10, 11]] for half in ((a, b, c), (a, c, d))]
    faces.append([8, 9, 8])
    extent = np.linalg.norm(np.ptp(points, axis=0))
    cube, sheet, line = hulls((points, faces), [0] * 12 + [1, 1, 2])
    assert cube.report["thickness"] == 0
    for flat, dimensions in ((sheet, 1), (line, 2)):
        thickness = flat.report["thickness"]
        assert thickness == pytest.approx(extent / 1000)
        assert is_closed(flat) and is_convex(flat)
        assert volume(flat) == pytest.approx(thickness**dimensions)


def test_hulls_need_an_extent():
    with pytest.raises(ValueError, match="its extent is 0"):
        hulls(([[1., 1, 1]] * 3, [[0, 1, 2]]), [0])
    with pytest.raises(ValueError, match="its extent is inf"):
        hulls((np.eye(3) * 1.7e308, [[0, 1, 2]]), [0])


def test_refined_boundaries(dumbbell):
    points, triangles = dumbbell
    labels = (points[triangles].mean(axis=1) @ [0.3, 0.2, 1] > 0).astype(int) # with teeth
    refined = refine_boundaries(dumbbell, labels)
    assert len(refined.triangles) == len(refined.labels) == len(refined.polygon_of_triangle)
    assert len(refined.triangles) > len(triangles)
    np.testing.assert_array_equal(refined.points[:len(points)], points)

    def areas(points, triangles):
        a, b, c = points[triangles].transpose(1, 0, 2)
        return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2

    np.testing.assert_allclose(
        np.bincount(refined.polygon_of_triangle, areas(refined.points, refined.triangles)),
        areas(points, triangles), rtol=1e-9)
    assert set(refined.labels) == set(labels)
    parts = split(refined, refined.labels, close=True)
    assert all(part.report["is_solid"] for part in parts)


def test_transfer(dumbbell):
    points, triangles = dumbbell
    labels = segment(dumbbell, number_of_segments=3)
    np.testing.assert_array_equal(transfer_labels(dumbbell, labels, dumbbell), labels)
    # Each triangle cut into four
    ends = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    edges, place = np.unique(ends, axis=0, return_inverse=True)
    p, q, r = place.reshape(3, -1) + len(points)
    a, b, c = triangles.T
    finer = np.concatenate([np.stack(corners, axis=1)
                            for corners in ((a, p, r), (p, b, q), (r, q, c), (p, q, r))])
    finer_points = np.concatenate([points, points[edges].mean(axis=1)])
    there = transfer_labels(dumbbell, labels, (finer_points, finer))
    np.testing.assert_array_equal(there, np.tile(labels, 4))
    np.testing.assert_array_equal(
        transfer_labels((finer_points, finer), there, dumbbell), labels)


def test_transfer_to_a_mesh_that_is_no_manifold():
    mesh = (CUBE, SQUARES)
    labels = np.array([0, 1, 0, 0, 1, 1])
    # A square that comes twice, one that has collapsed, and a triangle at edges of others
    other = (np.concatenate([CUBE, [[0.5, -0.5, 0]]]),
             [*SQUARES[:3], *SQUARES[2:], [0, 0, 1, 1], [0, 1, 8]])
    there = transfer_labels(mesh, labels, other)
    np.testing.assert_array_equal(there[:7], labels[[0, 1, 2, 2, 3, 4, 5]])
    assert len(there) == 9


def test_arguments(dumbbell):
    labels = np.zeros(len(dumbbell[1]), int)
    for function in (split, hulls, refine_boundaries,
                     lambda mesh, labels: transfer_labels(mesh, labels, dumbbell)):
        with pytest.raises(ValueError, match="labels must have the shape"):
            function(dumbbell, labels[1:])
        with pytest.raises(TypeError, match="a mesh is needed, not the name of a file"):
            function("elephant.off", labels)
    with pytest.raises(ValueError, match="has no faces"):
        transfer_labels((np.empty((0, 3)), []), [], dumbbell)
