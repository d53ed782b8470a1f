# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hierarchies: their labels, nodes and files."""

import copy
import json
import pickle
import subprocess

import numpy as np
import pytest

from spectral_segmentation import CUT_STATES, Hierarchy, read, segment, segment_hierarchy


@pytest.fixture(scope="module")
def elephant(meshes):
    return read(meshes / "elephant.off")


@pytest.fixture(scope="module")
def hierarchy(elephant):
    return segment_hierarchy(elephant)


def is_refinement(fine, coarse):
    """Returns whether each segment of the finer labels lies in one of the coarser labels."""
    return len(np.unique(np.stack([fine, coarse]), axis=1).T) == fine.max() + 1


def test_labels_of_each_number_are_nested(hierarchy):
    previous = hierarchy.labels(1)
    assert (previous == 0).all()
    for n in range(2, hierarchy.number_of_segments + 1):
        labels = hierarchy.labels(n)
        first = np.unique(labels, return_index=True)[1] # segments are numbered by first triangle
        assert labels.max() + 1 == n and (np.diff(first) > 0).all()
        assert is_refinement(labels, previous)
        previous = labels
    with pytest.warns(UserWarning, match="has only %d segments, not 1000000000; a run"
                      % hierarchy.number_of_segments) as warned:
        np.testing.assert_array_equal(hierarchy.labels(10**9), previous)
    assert [each.filename for each in warned] == [__file__]


def test_labels_equal_the_labels_of_runs(elephant, hierarchy):
    np.testing.assert_array_equal(hierarchy.labels(), segment(elephant))
    np.testing.assert_array_equal(hierarchy.labels(7), segment(elephant, number_of_segments=7))
    np.testing.assert_array_equal(hierarchy.labels(salience_threshold=0.7),
                                  segment(elephant, salience_threshold=0.7))
    np.testing.assert_array_equal(
        hierarchy.labels(4, salience_threshold=0.1),
        segment(elephant, salience_threshold=0.1, maximum_number_of_segments=4))


def test_thresholds_of_probabilities(elephant, hierarchy):
    for each in (hierarchy, copy.copy(hierarchy), pickle.loads(pickle.dumps(hierarchy))):
        for threshold in (2, -0.5):
            with pytest.raises(ValueError, match=r"in \[0, 1\], because it is a probability"):
                each.labels(salience_threshold=threshold)
        assert (each.labels(salience_threshold=np.inf) == 0).all()
    for options in ({"method": "paper"}, {"part_salience": lambda factors: 3}):
        labels = segment_hierarchy(elephant, **options).labels(salience_threshold=4)
        assert (labels == 0).all()


def test_nodes(elephant, hierarchy):
    nodes = hierarchy.nodes
    points, triangles = elephant.points, elephant.triangles
    corners = points[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]),
                           axis=1) / 2
    assert len(nodes) == hierarchy.number_of_nodes and hierarchy.number_of_roots == 1
    assert nodes["parent"][0] == -1
    for i, node in enumerate(nodes):
        faces = hierarchy.faces(i)
        assert len(faces) == node["number_of_faces"]
        assert node["area"] == pytest.approx(areas[faces].sum())
        children = hierarchy.children[i]
        assert tuple(children) == (node["first_child"], node["second_child"])
        if children[0] >= 0:
            assert (nodes["parent"][children] == i).all()
            assert sorted(faces) == sorted(np.concatenate([hierarchy.faces(c) for c in children]))
            assert CUT_STATES[node["cut_state"]] == "cut"
    np.testing.assert_array_equal(nodes["salience"], hierarchy.saliences)
    for name, factor in hierarchy.factors.items():
        np.testing.assert_array_equal(nodes[name], factor)
    written = json.loads(hierarchy.to_json())["nodes"][0]["factors"]
    assert {name: factor[0] for name, factor in hierarchy.factors.items()} == {
        name: value for name, value in written.items() if name != "is_boundary"}


def test_segments_are_nodes(hierarchy):
    for arguments, options in (((), {}), ((5,), {}), ((), {"salience_threshold": 0.8})):
        labels, segments = (f(*arguments, **options)
                            for f in (hierarchy.labels, hierarchy.segments))
        assert labels.max() + 1 == len(segments)
        for label, node in enumerate(segments):
            np.testing.assert_array_equal(np.sort(hierarchy.faces(node)),
                                          np.flatnonzero(labels == label))
        np.testing.assert_array_equal(hierarchy.labels_of_nodes(segments), labels)


def test_merge_and_cut_again(elephant, hierarchy):
    edited = copy.deepcopy(hierarchy)
    first, second = edited.segments(4)[:2]
    expected = np.sort(np.concatenate([edited.faces(first), edited.faces(second)]))
    np.testing.assert_array_equal(np.sort(edited.faces(edited.merge(first, second))), expected)
    assert hierarchy.to_json() != edited.to_json() # a copy has nodes of its own

    whole = segment_hierarchy(elephant, number_of_segments=1)
    edited = pickle.loads(pickle.dumps(hierarchy))
    is_large_leaf = (edited.children[:, 0] < 0) & (edited.nodes["number_of_faces"] > 50)
    leaf = int(np.flatnonzero(is_large_leaf)[0])
    part = segment_hierarchy(elephant.points, elephant.triangles[edited.faces(leaf)],
                             number_of_segments=2)
    number = edited.number_of_segments
    edited.split_leaf(leaf, part)
    assert edited.number_of_segments == number + part.number_of_segments - 1
    with pytest.raises(ValueError):
        edited.split_leaf(leaf, whole)


@pytest.mark.parametrize("method", ["calibrated", "paper"])
def test_round_trips(elephant, tmp_path, method):
    hierarchy = segment_hierarchy(elephant, method=method)
    hierarchy.save(tmp_path / "h.json")
    for other in (pickle.loads(pickle.dumps(hierarchy)), copy.copy(hierarchy),
                  Hierarchy.from_json(hierarchy.to_json()), Hierarchy.load(tmp_path / "h.json")):
        assert other.to_json() == hierarchy.to_json()
        np.testing.assert_array_equal(other.nodes, hierarchy.nodes)
        np.testing.assert_array_equal(other.labels(), hierarchy.labels())
    assert [path.name for path in tmp_path.iterdir()] == ["h.json"]
    (tmp_path / "text").write_bytes(b"\xff\xfe")
    with pytest.raises(ValueError, match="text cannot be read"):
        Hierarchy.load(tmp_path / "text")
    with pytest.raises(OSError):
        Hierarchy.load(tmp_path / "missing")
    with pytest.raises(OSError):
        hierarchy.save(tmp_path / "missing" / "h.json")


def test_files_of_the_tool(meshes, tool, tmp_path, hierarchy):
    subprocess.run([tool, meshes / "elephant.off", "--quiet", "--hierarchy", tmp_path / "h.json"],
                   check=True)
    other = Hierarchy.load(tmp_path / "h.json")
    np.testing.assert_array_equal(other.labels(), hierarchy.labels())
    for n in (1, 2, 9):
        np.testing.assert_array_equal(other.labels(n), hierarchy.labels(n))
    own = json.loads(hierarchy.to_json())
    of_tool = json.loads((tmp_path / "h.json").read_text())
    assert own.keys() <= of_tool.keys()
