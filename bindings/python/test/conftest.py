# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and functions for all tests. MESHES is the folder of libcgal-demo's meshes, and
SEGMENT_MESH the tool. The tests that need them are skipped without."""

import os
import pathlib

import hypothesis
import numpy as np
import pytest

# The same examples on every run, and no folder of those that failed
hypothesis.settings.register_profile("project", database=None, derandomize=True, deadline=None,
                                     max_examples=60)
hypothesis.settings.load_profile("project")


def surface_of_revolution(radii, heights, around=24):
    """Returns points and triangles of a closed surface, oriented outwards."""
    angles = 2 * np.pi * np.arange(around) / around
    rings = [np.stack([r * np.cos(angles), r * np.sin(angles), np.full(around, z)], axis=1)
             for r, z in zip(radii[1:-1], heights[1:-1])]
    points = np.concatenate([[[0, 0, heights[0]]], *rings, [[0, 0, heights[-1]]]])
    here = np.arange(around)
    there = (here + 1) % around
    triangles = [np.stack([np.zeros(around, int), 1 + there, 1 + here], axis=1)]
    for k in range(len(rings) - 1):
        a, b = 1 + k * around, 1 + (k + 1) * around
        triangles.append(np.stack([a + here, a + there, b + there], axis=1))
        triangles.append(np.stack([a + here, b + there, b + here], axis=1))
    last = 1 + (len(rings) - 1) * around
    top = np.full(around, len(points) - 1)
    triangles.append(np.stack([last + here, last + there, top], axis=1))
    return points, np.concatenate(triangles)


def dumbbell_of(rings, around):
    """Returns two balls of radius 1 around -2 and 2, with a bar of radius 0.25 between them."""
    heights = np.linspace(-3, 3, rings)
    radii = np.maximum(np.sqrt(np.maximum(1 - (np.abs(heights) - 2)**2, 0)),
                       np.where(np.abs(heights) < 2, 0.25, 0))
    return surface_of_revolution(radii, heights, around)


@pytest.fixture(scope="session")
def dumbbell():
    return dumbbell_of(49, 24)


def bumpy_dumbbell_of(seed):
    """Returns a small one without symmetries, on a grid, so that small sums are exact."""
    points, triangles = dumbbell_of(21, 10)
    points = points + np.random.default_rng(seed).uniform(-0.03, 0.03, points.shape)
    return np.round(points * 2.**20) / 2.**20, triangles


@pytest.fixture(scope="session")
def bumpy_dumbbell():
    return bumpy_dumbbell_of(1)


@pytest.fixture(scope="session")
def meshes():
    folder = pathlib.Path(os.environ.get("MESHES", ""))
    if not (folder / "elephant.off").exists():
        pytest.skip("no meshes of libcgal-demo: MESHES names their folder")
    return folder


@pytest.fixture(scope="session")
def tool():
    path = os.environ.get("SEGMENT_MESH")
    if not path:
        pytest.skip("no tool: SEGMENT_MESH names it")
    return path
