# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other libraries are taken as they are."""

from types import SimpleNamespace

import numpy as np
import pytest

from spectral_segmentation import segment

QUICK = {"number_of_segments": 3, "number_of_coarse_faces": 0}


@pytest.fixture(scope="module")
def expected(dumbbell):
    return segment(*dumbbell, **QUICK)


def assert_labels(mesh, expected):
    np.testing.assert_array_equal(segment(mesh, **QUICK), expected)


def test_stand_ins(dumbbell, expected):
    points, triangles = dumbbell
    counted = np.insert(triangles, 0, 3, axis=1).ravel()
    assert_labels(SimpleNamespace(vertices=points, faces=triangles), expected) # trimesh
    assert_labels(SimpleNamespace(points=points, faces=counted), expected) # PyVista
    assert_labels(SimpleNamespace(points=points, triangles=triangles), expected)
    counted[0] = 4
    with pytest.raises(ValueError, match="triangulate()"):
        segment(SimpleNamespace(points=points, faces=counted))
    with pytest.raises(TypeError, match="is no mesh of a known kind"):
        segment(SimpleNamespace(points=points))


def test_meshio(dumbbell, expected):
    meshio = pytest.importorskip("meshio")
    points, triangles = dumbbell
    cells = [("vertex", [[0]]), ("triangle", triangles[:10]), ("line", [[0, 1]]),
             ("triangle", triangles[10:])]
    assert_labels(meshio.Mesh(points, cells), expected)
    with pytest.raises(ValueError, match="cells of the type quad"):
        segment(meshio.Mesh(points, [("quad", [[0, 1, 2, 3]])]))


def test_open3d(dumbbell, expected):
    open3d = pytest.importorskip("open3d")
    points, triangles = dumbbell
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points),
                                        open3d.utility.Vector3iVector(triangles))
    assert_labels(mesh, expected)
    assert_labels(open3d.t.geometry.TriangleMesh.from_legacy(mesh), segment(
        points.astype(np.float32), triangles, **QUICK))
