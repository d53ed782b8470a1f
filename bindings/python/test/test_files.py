# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of meshes."""

import html
import os
import random
import re
import subprocess

import numpy as np
import pytest

from spectral_segmentation import (Hierarchy, read, segment_colors, segment_hierarchy, view,
                                   write)

QUAD_AND_TRIANGLE = """OFF
5 2 0
0 0 0
1 0 0
1 1 0
0 1 0
0.5 2 0
4 0 1 2 3
3 3 2 4
"""


def test_polygons_are_cut_into_triangles(tmp_path):
    path = tmp_path / "house.off"
    path.write_text(QUAD_AND_TRIANGLE)
    mesh = read(path)
    assert mesh.points.shape == (5, 3) and mesh.points.dtype == np.float64
    assert mesh.triangles.dtype == np.int32
    assert mesh.polygon_of_triangle.tolist() == [0, 0, 1]
    assert set(mesh.triangles[:2].ravel()) == {0, 1, 2, 3} and set(mesh.triangles[2]) == {2, 3, 4}


@pytest.mark.parametrize("extension", [".ply", ".obj", ".off", ".stl"])
@pytest.mark.parametrize("kind", ["f4", "f8"])
def test_round_trips(dumbbell, tmp_path, extension, kind):
    points, triangles = dumbbell
    points = points.astype(kind)
    path = tmp_path / ("mesh" + extension)
    write(path, points, triangles)
    mesh = read(path)
    written = points.astype("f4") if extension == ".stl" else points
    if extension in (".obj", ".off"):
        np.testing.assert_allclose(mesh.points, written, rtol=1e-6, atol=1e-7)
        np.testing.assert_array_equal(mesh.triangles, triangles)
    else:
        np.testing.assert_array_equal(mesh.points[mesh.triangles], written[triangles])
    write(path, mesh) # a mesh in place of the arrays
    suffixes = {extension, ".mtl"} if extension == ".obj" else {extension}
    assert {p.suffix for p in tmp_path.iterdir()} == suffixes


def test_colors_are_read(dumbbell, tmp_path):
    points, triangles = dumbbell
    labels = segment_hierarchy(points, triangles).labels(3)
    write(tmp_path / "mesh.ply", points, triangles, labels) # with a color for each label
    colors = read(tmp_path / "mesh.ply").colors
    assert len(set(map(tuple, colors))) == 3
    assert len({(label, *color) for label, color in zip(labels, colors)}) == 3
    write(tmp_path / "plain.obj", points, triangles)
    assert read(tmp_path / "plain.obj").colors is None
    (tmp_path / "two.obj").write_text("v 0 0 0 0 0 1\nv 1 0 0 0 0 1\nv 0 1 0 .6 0 1\n"
                                      "v 0 0 1 .3 0 .7\nf 1 2 3\nf 1 4 2\n")
    np.testing.assert_allclose(read(tmp_path / "two.obj").colors, [[.2, 0, 1], [.1, 0, .9]])


def test_labels_are_read_back(dumbbell, tmp_path):
    points, triangles = dumbbell
    labels = segment_hierarchy(points, triangles).labels(3)
    write(tmp_path / "mesh.ply", points, triangles, labels)
    mesh = read(tmp_path / "mesh.ply")
    np.testing.assert_array_equal(mesh.points, points) # also of those that are on boundaries
    np.testing.assert_array_equal(mesh.triangles, triangles)
    np.testing.assert_array_equal(mesh.labels, labels)
    write(tmp_path / "mesh.obj", points, triangles, labels)
    mesh = read(tmp_path / "mesh.obj") # which has the triangles of one segment after the other
    order = np.argsort(labels, kind="stable")
    np.testing.assert_array_equal(mesh.triangles, triangles[order])
    np.testing.assert_array_equal(mesh.labels, labels[order])
    write(tmp_path / "mesh.off", points, triangles, labels)
    assert read(tmp_path / "mesh.off").labels is None


def test_names_may_be_bytes(dumbbell, tmp_path):
    """Checks also names that are no text."""
    path = os.fsencode(tmp_path) + b"/\xff.ply"
    write(path, *dumbbell)
    np.testing.assert_array_equal(read(path).triangles, dumbbell[1])
    hierarchy = segment_hierarchy(*dumbbell)
    hierarchy.save(path + b".json")
    assert Hierarchy.load(path + b".json").to_json() == hierarchy.to_json()


def test_written_colors_and_labels(dumbbell, tmp_path):
    points, triangles = dumbbell
    labels = (points[triangles].mean(axis=1)[:, 2] > 0).astype(int)
    colors = np.array([[1, 2, 3], [200, 100, 50]])
    path = tmp_path / "mesh.ply"
    write(path, points, triangles, labels, colors=colors)
    header, _, body = path.read_bytes().partition(b"end_header\n")
    assert b"segment" in header and b"red" in header
    for color in colors:
        assert bytes(color.tolist()) in body
    assert segment_colors(triangles, labels).shape == (2, 3)
    write(tmp_path / "mesh.glb", points, triangles, labels)
    assert (tmp_path / "mesh.glb").read_bytes()[:4] == b"glTF"
    with pytest.raises(ValueError, match="STL has no labels"):
        write(tmp_path / "mesh.stl", points, triangles, labels)
    with pytest.raises(ValueError, match=r"colors must be integers of shape \(2, 3\)"):
        write(path, points, triangles, labels, colors=[[0, 0, 0]])
    with pytest.raises(ValueError, match="colors must be from 0 to 255"):
        write(path, points, triangles, labels, colors=[[0, 0, 0], [0, 256, 0]])


def test_warnings(tmp_path):
    (tmp_path / "more.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nvw 0 0 1\n"
                                       "f 1 2 3\nf 2 1 4\n")
    with pytest.warns(UserWarning) as caught:
        mesh = read(tmp_path / "more.obj")
    assert mesh.triangles.tolist() == [[0, 1, 2]]
    messages = [str(w.message).split(": ", 1)[1] for w in caught]
    assert messages == ["line 5: 'vw' is not a statement of OBJ",
                        "face 1 uses a point that is not finite; corners left out: 1"]
    (tmp_path / "none.obj").write_text("v 0 0 0\nv 1 0 0\nv nan 0 0\nf 1 2 3\n")
    with pytest.raises(ValueError, match="different corners; face 0 uses a point"):
        read(tmp_path / "none.obj")


def test_errors(tmp_path, dumbbell):
    with pytest.raises(FileNotFoundError):
        read(tmp_path / "missing.off")
    with pytest.raises(ValueError, match="the name must end in"):
        read(tmp_path / "mesh.xyz")
    with pytest.raises(ValueError, match="mesh.glb; for other formats .* trimesh.load"):
        read(tmp_path / "mesh.glb")
    (tmp_path / "text.off").write_text("Dear Sir")
    with pytest.raises(ValueError, match="text.off cannot be read: line 1"):
        read(tmp_path / "text.off")
    (tmp_path / "none.off").write_text("OFF 0 0 0")
    with pytest.raises(ValueError, match="has no face with three different corners"):
        read(tmp_path / "none.off")
    kept = tmp_path / "kept.ply"
    kept.write_text("kept")
    for points in (np.full((3, 3), np.nan), np.zeros((2, 3))):
        with pytest.raises(ValueError):
            write(kept, points, [[0, 1, 2]])
    for path in (tmp_path / "missing" / "mesh.ply", tmp_path / "none.ply"):
        (tmp_path / "none.ply").mkdir(exist_ok=True)
        with pytest.raises(OSError) as raised:
            write(path, *dumbbell)
        assert (raised.value.filename, raised.value.filename2) == (str(path), None)
        assert "None" not in str(raised.value)
    (tmp_path / "none.ply").rmdir()
    assert kept.read_text() == "kept" and len(list(tmp_path.iterdir())) == 3


def test_damaged_files_give_a_mesh_or_a_message(meshes, tmp_path):
    contents = (meshes / "octahedron.off").read_bytes()
    rng = random.Random(1)
    for i in range(300):
        damaged = bytearray(contents)
        for _ in range(rng.randint(1, 6)):
            damaged[rng.randrange(len(damaged))] = rng.randrange(256)
        path = tmp_path / ("damaged" + (".off", ".obj", ".ply", ".stl")[i % 4])
        path.write_bytes(damaged)
        try:
            mesh = read(path)
        except ValueError as error:
            assert str(path) in str(error)
        else:
            assert mesh.triangles.max() < len(mesh.points)


def test_written_files_equal_the_files_of_the_tool(meshes, tool, tmp_path):
    source = meshes / "elephant.off"
    subprocess.run([tool, source, "--quiet", "--keep-faces", "-o", tmp_path / "tool.off",
                    "--labels", tmp_path / "labels"], check=True)
    labels = np.loadtxt(tmp_path / "labels", int)
    mesh = read(source)
    write(tmp_path / "own.off", mesh.points, mesh.triangles, labels)
    assert (tmp_path / "own.off").read_bytes() == (tmp_path / "tool.off").read_bytes()


def test_the_page_is_the_one_of_the_tool(meshes, tool, tmp_path):
    source = meshes / "elephant.off"
    subprocess.run([tool, source, "--quiet", "--html", tmp_path / "tool.html"], check=True)
    mesh = read(source)
    shown = view(mesh, segment_hierarchy(mesh), name="elephant.off")
    assert shown.html.encode() == (tmp_path / "tool.html").read_bytes()
    source_of_frame = re.search('srcdoc="([^"]*)"', shown._repr_html_()).group(1)
    assert source_of_frame.isascii() # for any charset of the notebook
    assert html.unescape(source_of_frame) == shown.html


def test_pages(dumbbell, tmp_path):
    points, triangles = dumbbell
    hierarchy = segment_hierarchy(points, triangles, method="paper", number_of_segments=3)
    path = tmp_path / "dumbbell.html"
    try:
        write(path, (points, triangles), hierarchy)
    except RuntimeError as error:
        pytest.skip(str(error))
    page = path.read_text()
    assert "<title>dumbbell" in page and '"salience":"salience"' in page
    assert '"segments":2,' in view(dumbbell, hierarchy, n=2).html
    calibrated = Hierarchy.from_json(segment_hierarchy(dumbbell).to_json())
    assert '"salience":"probability"' in view(dumbbell, calibrated).html
    weighted = segment_hierarchy(dumbbell, salience_weights=(0.1, 0.6, 0.3))
    assert '"salience":"salience"' in view(dumbbell, weighted).html
    for labels, words in ((hierarchy.labels(), "needs a Hierarchy, .* not ndarray"),
                          (None, "needs a Hierarchy, .* not NoneType")):
        with pytest.raises(TypeError, match=words):
            write(path, points, triangles, labels)
    with pytest.raises(ValueError, match="the hierarchy has %d triangles" % len(triangles)):
        view((points, triangles[1:]), hierarchy)
    assert path.read_text() == page
