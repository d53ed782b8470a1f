# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other libraries are taken as they are, by all functions."""

from types import SimpleNamespace

import numpy as np
import pytest

from spectral_segmentation import (boundary_edges, read, segment, segment_adjacency,
                                   segment_colors, segment_hierarchy, write)

QUICK = {"number_of_segments": 3, "number_of_coarse_faces": 0}


@pytest.fixture(scope="module")
def expected(dumbbell):
    return segment(*dumbbell, **QUICK)


def assert_labels(mesh, expected):
    np.testing.assert_array_equal(segment(mesh, **QUICK), expected)


def test_stand_ins(dumbbell, expected):
    points, triangles = dumbbell
    counted = np.insert(triangles, 0, 3, axis=1).ravel()
    doubled = np.concatenate([points, points[:5]]) # manifold3d has points once for each property
    split = triangles.copy()
    split[0] = np.where(triangles[0] < 5, triangles[0] + len(points), triangles[0])
    assert (split != triangles).any()
    manifold = SimpleNamespace(vert_properties=np.column_stack([doubled, doubled]), tri_verts=split,
                               merge_from_vert=len(points) + np.arange(5),
                               merge_to_vert=np.arange(5))
    pymeshlab = SimpleNamespace(vertex_matrix=lambda: points, face_matrix=lambda: triangles)
    for mesh in ((points, triangles),
                 {"vertices": points, "faces": triangles},
                 SimpleNamespace(vertices=points, faces=triangles), # trimesh
                 SimpleNamespace(points=points, faces=counted), # PyVista
                 SimpleNamespace(points=points, triangles=triangles),
                 manifold, SimpleNamespace(to_mesh=lambda: manifold),
                 pymeshlab, SimpleNamespace(current_mesh=lambda: pymeshlab)):
        assert_labels(mesh, expected)
    for mesh, error, words in (
            (SimpleNamespace(points=points), TypeError, "is no mesh of a known kind"),
            ("a.off", TypeError, r"not the name of a file: read\('a.off'\) reads it"),
            (SimpleNamespace(geometry={}, to_mesh=None), TypeError, "has several meshes"),
            (SimpleNamespace(points=points, cells=[3], celltypes=[10]), TypeError,
             r"cells in place of polygons; .*extract_surface\(\)"),
            (np.ma.masked_less(points, 0), TypeError, "triangles are missing"),
            ((np.ma.masked_less(points, 0), triangles), ValueError, "points must not have masked"),
            ((points, np.ma.masked_less(triangles, 3)), ValueError, "triangles must not have mask"),
            ((points, [[0, 1, 2], [0, 1]]), ValueError, "polygon 1 has 2 corners; at least 3"),
            ((points, [[0, 1, 2], [0, 1, 2, 10**6]]), ValueError, "triangle 1 has a corner")):
        with pytest.raises(error, match=words):
            segment(mesh)
    assert_labels((np.ma.masked_less(points, -9), triangles), expected) # without a masked element


def test_all_functions_take_the_same(dumbbell, expected, tmp_path):
    points, triangles = dumbbell
    mesh = SimpleNamespace(vertices=points, faces=triangles)
    for function in (boundary_edges, segment_adjacency, segment_colors):
        results = [function(*arguments) for arguments in (
            (points, triangles, expected), (mesh, expected), ((points, triangles), expected))]
        if function is not segment_adjacency:
            results.append(function(triangles, expected))
            results.append(function(triangles.tolist(), labels=expected.tolist()))
        for result in results[1:]:
            for a, b in zip(results[0], result):
                np.testing.assert_array_equal(a, b)
        with pytest.raises(TypeError, match="labels are missing"):
            function(mesh)
    write(tmp_path / "a.ply", points, triangles, expected)
    write(tmp_path / "b.ply", mesh, expected)
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()


def test_polygons_have_labels(dumbbell, tmp_path):
    """Returns the quads of the dumbbell, whose triangles at the two ends are polygons too."""
    points, triangles = dumbbell
    first, second = triangles[24:-24].reshape(-1, 2, 24, 3).transpose(1, 0, 2, 3).reshape(2, -1, 3)
    quads = np.column_stack([first, second[:, 2]])
    rows = [*triangles[:24].tolist(), *quads.tolist(), *triangles[-24:].tolist()]
    hierarchy = segment_hierarchy(points, rows, **QUICK)
    labels = hierarchy.labels()
    assert labels.shape == (len(rows),) == (hierarchy.number_of_faces,)
    heights = np.array([points[row].mean(axis=0)[2] for row in rows])
    # Each of the balls and the bar is cut off by planes, near to where its neighbor begins.
    for label in range(3):
        mine = heights[labels == label]
        assert labels[(heights > mine.min()) & (heights < mine.max())].tolist() == \
            [label] * ((heights > mine.min()) & (heights < mine.max())).sum()
    nodes = hierarchy.segments()
    for label, node in enumerate(nodes):
        np.testing.assert_array_equal(hierarchy.faces(node), np.flatnonzero(labels == label))
    seeds = np.full(len(rows), -1)
    seeds[[0, 1]] = 0, 1
    seeded = segment(points, rows, face_seeds=seeds)
    assert seeded[0] != seeded[1]

    counted = np.concatenate([[len(row), *row] for row in rows])
    np.testing.assert_array_equal(segment((points, rows), **QUICK), labels)
    np.testing.assert_array_equal(segment(SimpleNamespace(points=points, faces=counted), **QUICK),
                                  labels)
    edges, _ = boundary_edges((points, rows), labels)
    sides = {tuple(sorted(pair)) for row in rows for pair in zip(row, row[1:] + row[:1])}
    assert len(edges) > 0 and {tuple(edge) for edge in edges.tolist()} <= sides
    write(tmp_path / "quads.ply", (points, rows), labels)
    mesh = read(tmp_path / "quads.ply")
    assert mesh.polygon_of_triangle[-1] == len(rows) - 1
    np.testing.assert_array_equal(mesh.labels, labels[mesh.polygon_of_triangle])


def test_meshio(dumbbell, expected):
    meshio = pytest.importorskip("meshio")
    points, triangles = dumbbell
    cells = [("vertex", [[0]]), ("triangle", triangles[:10]), ("line", [[0, 1]]),
             ("triangle", triangles[10:])]
    assert_labels(meshio.Mesh(points, cells), expected)
    assert len(segment(meshio.Mesh(points, [("quad", [[0, 1, 2, 3]]), ("triangle", triangles[:1]),
                                            ("polygon", [[0, 1, 2, 3, 4]])]))) == 3
    with pytest.raises(ValueError, match="cells of the type tetra"):
        segment(meshio.Mesh(points, [("tetra", [[0, 1, 2, 3]])]))


def test_open3d(dumbbell, expected):
    open3d = pytest.importorskip("open3d")
    points, triangles = dumbbell
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points),
                                        open3d.utility.Vector3iVector(triangles))
    assert_labels(mesh, expected)
    assert_labels(open3d.t.geometry.TriangleMesh.from_legacy(mesh), segment(
        points.astype(np.float32), triangles, **QUICK))
    for empty in (open3d.geometry.TriangleMesh(), open3d.t.geometry.TriangleMesh()):
        assert len(segment(empty)) == 0


def test_vtk(dumbbell, expected):
    vtk = pytest.importorskip("vtkmodules.all")
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    points, triangles = dumbbell
    mesh = vtk.vtkPolyData()
    assert len(segment(mesh)) == 0
    mesh.SetPoints(vtk.vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    cells = vtk.vtkCellArray()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(
        np.insert(triangles, 0, 3, axis=1).ravel().astype(np.int64), deep=True))
    mesh.SetPolys(cells)
    assert_labels(mesh, expected)
    with pytest.raises(TypeError, match="vtkUnstructuredGrid has cells in place of polygons"):
        segment(vtk.vtkUnstructuredGrid())
