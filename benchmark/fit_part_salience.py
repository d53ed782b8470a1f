#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits the network that judges the boundaries of regions by what it costs to cut there.

The risk of a segment s is |s|^2 - 2 sum_t |s and t|^2 - W (q - Q) over the segments t of a person,
the mean over all people. The sizes are fractions of the faces or, for meshes with known parts, of
the area. Without the last term, the risks of all segments sum to the Rand error less a constant,
and a false segment of a thousandth of the faces costs nothing. In this term each segment counts the
same, however small it is: q is the intersection over union with the most similar t if that is more
than 1/2, otherwise 0. With Q = 0.35, half of the usual panoptic quality, a segment pays if it
raises this quality. The risks are sums over segments. Therefore the best choice of cuts in a
hierarchy is found exactly, from the leaves up. The gain of a cut is the risk of its part left whole
less the least risks of its two sides. The network is fitted to the signs of the gains of all cuts,
each of which is weighted by the size of its gain.

The hierarchies are those of the meshes, of made shapes, machines and creatures, and of changed
copies of all meshes: stretched and noisy, subdivided, and in other triangulations. The network has
no influence on them: candidates, and the order of merging, have other coefficients. The measures
are those of categories of the benchmark, or of meshes, to which the network was not fitted. They
are compared with those of the package as it is. Outputs are calibrated: a logistic function of them
is the mean agreement of people with the cuts of the benchmark.

Needs python3-numpy, python3-scipy, and the Python package of bindings/python."""
import argparse
import heapq
import json
import math
import multiprocessing
import pathlib
import re

import numpy as np
import scipy.optimize
import scipy.sparse
import scipy.spatial
import spectral_segmentation

NUMBER_OF_FOLDS = 5
NUMBER_OF_UNITS = 12
NUMBER_OF_STARTS = 4  # of which the one with the least loss is taken
NUMBER_OF_CREATURES = 90
PART_WEIGHT = 0.05  # W in the risk
USUAL_QUALITY = 0.35  # Q in the risk
SIZE_OF_SCRAP = 0.01
PENALTY = 1e-4  # on the squares of the weights
LARGEST_DEVIATION = 4
MESHES_PER_CATEGORY = 20  # by their numbers, of the Princeton Segmentation Benchmark
OFFSETS = (0, 0.3, 0.4, 0.5, 1)
FOLDER = pathlib.Path(__file__).parent.parent / "include/CGAL/Spectral_segmentation"


class Mesh:
    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles

    def normals(self):
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return np.cross(b - a, c - a)

    def shares_of_area(self):
        areas = np.linalg.norm(self.normals(), axis=1)
        return areas / areas.sum()

    def centroids(self):
        return self.points[self.triangles].mean(1)


def read_off(file):
    numbers = re.sub(r"^OFF|#.*", "", file.read_text(), flags=re.M).split()
    n, m = int(numbers[0]), int(numbers[1])
    points = np.array(numbers[3:3 + 3 * n], float).reshape(n, 3)
    return Mesh(points, np.array(numbers[3 + 3 * n:3 + 3 * n + 4 * m], int).reshape(m, 4)[:, 1:])


def read_labels(file):
    return np.unique(np.loadtxt(file, int), return_inverse=True)[1]


def stretched_and_noisy(mesh, seed):
    """Stretches by up to a quarter along random axes; noise is none, .05 or .15 % of the extent."""
    random = np.random.default_rng(seed)
    axes, _ = np.linalg.qr(random.normal(size=(3, 3)))
    stretch = axes @ np.diag(np.exp(random.uniform(-0.25, 0.25, 3))) @ axes.T
    extent = np.linalg.norm(np.ptp(mesh.points, 0))
    noise = extent * random.choice([0, 0.0005, 0.0015]) * random.normal(size=mesh.points.shape)
    return Mesh(mesh.points @ stretch + noise, mesh.triangles)


def subdivided(mesh):
    """Divides each triangle in four; the four of triangle i are i, i + m, i + 2 m and i + 3 m."""
    t, n = mesh.triangles, len(mesh.points)
    edges = np.sort(np.vstack([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), 1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    middle = n + number.reshape(3, len(t))
    corners = [np.column_stack([t[:, k], middle[k], middle[k - 1]]) for k in range(3)]
    return Mesh(np.vstack([mesh.points, mesh.points[unique].mean(1)]),
                np.vstack([*corners, middle.T]))


def tube(curve, radius, is_closed, number_of_sides=12):
    """Returns a tube around points. Its frame is turned as little as possible from ring to ring."""
    n, m = len(curve), number_of_sides
    before, after = np.roll(curve, 1, 0), np.roll(curve, -1, 0)
    if not is_closed:
        before[0], after[-1] = curve[0], curve[-1]
    tangents = (after - before) / np.linalg.norm(after - before, axis=1, keepdims=True)
    normal = np.cross(tangents[0], [0.3, 0.5, 0.8])
    angles, rings = 2 * np.pi * np.arange(m) / m, []
    for point, tangent in zip(curve, tangents):
        normal = normal - (normal @ tangent) * tangent
        normal /= np.linalg.norm(normal)
        across = np.cross(tangent, normal)
        sides = np.outer(np.cos(angles), normal) + np.outer(np.sin(angles), across)
        rings.append(point + radius * sides)
    if is_closed:  # the last ring is joined to the side of the first that is nearest
        shift = np.linalg.norm(rings[0] - rings[-1][0], axis=1).argmin()
        return grid_mesh(np.array(rings), shift)
    caps = np.array([curve[0] - radius * tangents[0], curve[-1] + radius * tangents[-1]])
    mesh = grid_mesh(np.array(rings))
    ring = np.arange(m)
    ends = [np.column_stack([np.full(m, n * m), np.roll(ring, -1), ring]),
            (n - 1) * m + np.column_stack([np.full(m, m + 1), ring, np.roll(ring, -1)])]
    return Mesh(np.vstack([mesh.points, caps]), np.vstack([mesh.triangles, *ends]))


def grid_mesh(rings, shift=None):
    """Joins rings of points to a mesh; with a shift also the last ring to the first."""
    n, m = rings.shape[:2]
    index = np.arange(n * m).reshape(n, m)
    if shift is not None:
        index = np.vstack([index, np.roll(index[:1], -shift, 1)])
    a, c = index[:-1], index[1:]
    b, d = np.roll(a, -1, 1), np.roll(c, -1, 1)
    triangles = np.concatenate([np.dstack([a, b, d]), np.dstack([a, d, c])]).reshape(-1, 3)
    return Mesh(rings.reshape(-1, 3), triangles)


def plate(n, m, wave):
    """Returns a plate of 2 n m triangles, which is flat without a wave."""
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(m + 1) / n, indexing="ij")
    points = np.stack([x, y, wave * np.sin(5 * x)], -1)
    index = np.arange((n + 1) * (m + 1)).reshape(n + 1, m + 1)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[:-1, 1:], index[1:, 1:]
    triangles = np.concatenate([np.dstack([a, b, d]), np.dstack([a, d, c])]).reshape(-1, 3)
    return Mesh(points.reshape(-1, 3), triangles)


def open_box(n, m, k):
    """Returns the surface of n x m x k cubes without its top."""
    mesh, _ = cubes(box_of_cells((0, n), (0, m), (0, k)))
    is_top = (mesh.points[mesh.triangles][:, :, 2] == k).all(1)
    return Mesh(mesh.points, mesh.triangles[~is_top])


def plain_shapes():
    """Returns tori, knots, springs, bent bars, bars, plates and open boxes, which have no parts."""
    def turns(number, n):
        return 2 * np.pi * number * np.arange(n) / n

    def knot(p, q, n=150):
        t = turns(1, n)
        radius = 2 + np.cos(q * t)
        return np.column_stack([radius * np.cos(p * t), radius * np.sin(p * t), np.sin(q * t)])

    def spring(number, pitch, n=100):
        t = turns(number, n)
        return np.column_stack([np.cos(t), np.sin(t), pitch * t])

    meshes = [tube(knot(1, 0), radius, True, sides)
              for radius, sides in ((0.4, 8), (0.8, 12), (1.2, 16), (2, 20))]
    meshes += [tube(knot(p, q), radius, True)
               for p, q, radius in ((2, 3, 0.3), (2, 3, 0.6), (3, 2, 0.3), (3, 2, 0.5), (2, 5, 0.3),
                                    (3, 4, 0.25))]
    meshes += [tube(spring(number, pitch), radius, False)
               for number, pitch, radius in ((0.2, 0, 0.2), (0.4, 0, 0.3), (0.7, 0.05, 0.2),
                                             (1.5, 0.2, 0.2), (3, 0.15, 0.3), (5, 0.1, 0.2))]
    line = np.outer(np.linspace(0, 1, 20), [1, 0, 0])
    meshes += [tube(line, radius, False) for radius in (0.05, 0.2, 0.6)]
    meshes += [plate(1, 1, 0), plate(6, 4, 0), plate(12, 5, 0.05), plate(20, 20, 0.15)]
    meshes += [open_box(*size) for size in ((1, 1, 1), (4, 4, 4), (9, 3, 2), (6, 6, 12))]
    return [Sample(str(i), "plain", i % NUMBER_OF_FOLDS, mesh,
                   [np.zeros(len(mesh.triangles), int)]) for i, mesh in enumerate(meshes)]


def turned(profile, number_of_sides, is_closed=False):
    """Returns the mesh that a polyline of radii and heights makes around an axis, and the edge of
    the polyline for each triangle. An open polyline starts and ends on the axis."""
    m = number_of_sides
    angles = 2 * np.pi * np.arange(m) / m
    circle = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(m)])
    rings = [radius * circle + [0, 0, height]
             for radius, height in (profile if is_closed else profile[1:-1])]
    n = len(rings)
    mesh = grid_mesh(np.array(rings), 0 if is_closed else None)
    edge = np.tile(np.repeat(np.arange(n if is_closed else n - 1), m), 2)
    if is_closed:
        return mesh, edge
    ring = np.arange(m)
    ends = np.array([[0, 0, profile[0][1]], [0, 0, profile[-1][1]]])
    first = np.column_stack([np.full(m, n * m), np.roll(ring, -1), ring])
    last = (n - 1) * m + np.column_stack([np.full(m, m + 1), ring, np.roll(ring, -1)])
    return (Mesh(np.vstack([mesh.points, ends]), np.vstack([mesh.triangles, first, last])),
            np.concatenate([edge + 1, np.zeros(m, int), np.full(m, n)]))


def cubes(cells, period=None):
    """Returns the surface of a union of unit cubes, given as a dictionary of the part of each cube,
    and the part of each triangle. With a period, the first axis is closed to a circle."""
    number, triangles, part = {}, [], []
    for cell, part_of_cell in cells.items():
        for axis in range(3):
            for side in (0, 1):
                neighbor = list(cell)
                neighbor[axis] += 2 * side - 1
                neighbor[0] %= period or math.inf
                if tuple(neighbor) in cells:
                    continue
                corners = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += side
                    corner[(axis + 1) % 3] += a
                    corner[(axis + 2) % 3] += b
                    corner[0] %= period or math.inf
                    corners.append(number.setdefault(tuple(corner), len(number)))
                a, b, c, d = corners if side else corners[::-1]
                triangles += [(a, b, c), (a, c, d)]
                part += 2 * [part_of_cell]
    return Mesh(np.array(list(number), float), np.array(triangles)), np.array(part)


def box_of_cells(x, y, z, part=0):
    """Returns the cubes of the ranges x, y and z."""
    return {(i, j, k): part for i in range(*x) for j in range(*y) for k in range(*z)}


def machines():
    """Returns flanges, rings on cylinders, spools, bolts, shafts, tubes, gear rims, plates with
    holes or with posts, tables, and bent strips. Their parts meet in concave edges."""
    def solid(profile, parts, sides):
        mesh, edge = turned(profile, sides)
        return mesh, np.array(parts)[edge]

    result = []
    for size, sides in ((1, 24), (0.7, 32), (1.4, 48)):
        neck, ring, thin = 1.2 * size, 1.5 + 0.3 * size, 0.4 * size
        result += [
            solid([(0, 0), (3, 0), (3, thin), (neck, thin), (neck, 3), (0, 3)],
                  [0, 0, 0, 1, 1], sides),
            solid([(0, 0), (1, 0), (1, 2), (ring, 2), (ring, 2 + size), (1, 2 + size),
                   (1, 6), (0, 6)], [0, 0, 1, 1, 1, 2, 2], sides),
            solid([(0, 0), (2, 0), (2, thin), (size, thin), (size, 4), (2, 4), (2, 4 + thin),
                   (0, 4 + thin)], [0, 0, 0, 1, 2, 2, 2], sides),
            solid([(0, 0), (2, 0), (2, 1), (size, 1), (size, 6), (0, 6)], [0, 0, 0, 1, 1], sides),
            solid([(0, 0), (0.5, 0), (0.5, 2), (1, 2), (1, 4), (1 + size, 4), (1 + size, 7),
                   (0, 7)], [0, 0, 1, 1, 2, 2, 2], sides)]
        tube_profile = [(1, 0), (1 + thin, 0), (1 + thin, 5 * size), (1, 5 * size)]
        mesh, edge = turned(tube_profile, sides, True)
        result.append((mesh, 0 * edge))

        rim = box_of_cells((0, sides), (0, 1), (0, 1))
        for tooth in range(sides // 2):
            rim[2 * tooth, 1, 0] = 1 + tooth
        mesh, part = cubes(rim, sides)
        angle, height = 2 * np.pi / sides * mesh.points[:, 0], mesh.points[:, 1:]
        radius = 3 + height[:, 0]
        result.append((Mesh(np.column_stack([radius * np.cos(angle), radius * np.sin(angle),
                                             2 * size * height[:, 1]]), mesh.triangles), part))

        length = int(8 * size)
        with_holes = box_of_cells((0, length), (0, 5), (0, 1))
        for x in range(1, length - 1, 3):
            del with_holes[x, 2, 0]
        result.append(cubes(with_holes))
        with_post = box_of_cells((0, length), (0, 5), (0, 1))
        with_post.update(box_of_cells((1, 3), (2, 4), (1, length), 1))
        result.append(cubes(with_post))
        table = box_of_cells((0, length), (0, 6), (5, 6))
        for part, (x, y) in enumerate(((0, 0), (length - 1, 0), (0, 5), (length - 1, 5))):
            table.update(box_of_cells((x, x + 1), (y, y + 1), (0, 5), 1 + part))
        result.append(cubes(table))
        strip = plate(sides, 5, 0)
        angle = np.pi * size * strip.points[:, 0]
        strip.points = np.column_stack([np.cos(angle), np.sin(angle), strip.points[:, 1]])
        result.append((strip, np.zeros(len(strip.triangles), int)))
    return [Sample(str(i), "machines", i % NUMBER_OF_FOLDS, mesh, [part])
            for i, (mesh, part) in enumerate(result)]


def distances_to_cone(points, cone):
    """Returns the signed distances to a cone with round ends, given by two centers and radii."""
    a, b, radius_a, radius_b = cone
    t = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.linalg.norm(points - a - t[:, None] * (b - a), axis=1) - radius_a \
        - (radius_b - radius_a) * t


def smoothed(mesh, number_of_steps=20):
    """Smooths by the method of Taubin, which hardly shrinks."""
    t = mesh.triangles
    tails, heads = t.ravel(), t[:, [1, 2, 0]].ravel()
    n, points = len(mesh.points), mesh.points
    is_neighbor = scipy.sparse.csr_matrix((np.ones(len(tails)), (tails, heads)), (n, n)) > 0
    is_neighbor = is_neighbor.maximum(is_neighbor.T)
    mean = scipy.sparse.diags(1 / np.asarray(is_neighbor.sum(1)).ravel()) @ is_neighbor
    for _ in range(number_of_steps):
        for step in (0.6, -0.62):
            points = points + step * (mean @ points - points)
    return Mesh(points, t)


def without_bare_edges(is_inside):
    """Fills cubes until no two cubes have an edge in common of which the other two are missing."""
    is_inside = is_inside.copy()
    while True:
        number = is_inside.sum()
        for axes in ((0, 1, 2), (0, 2, 1), (1, 2, 0)):
            view = is_inside.transpose(axes)
            a, b, c, d = view[:-1, :-1], view[1:, 1:], view[1:, :-1], view[:-1, 1:]
            c |= a & b & ~d
            a |= c & d & ~b
        if is_inside.sum() == number:
            return is_inside


def solid_of_cones(parts):
    """Returns the smooth surface of cones, given for each part and larger than a few units, and the
    part of each triangle. What is inside several parts belongs to the first of them."""
    lows = [np.minimum(a - ra, b - rb) for cones in parts for a, b, ra, rb in cones]
    highs = [np.maximum(a + ra, b + rb) for cones in parts for a, b, ra, rb in cones]
    low, high = np.min(lows, 0) - 2, np.max(highs, 0) + 2
    shape = tuple(np.ceil(high - low).astype(int))
    grid = np.indices(shape).reshape(3, -1).T
    distances = np.array([np.min([distances_to_cone(grid + low + 0.5, cone) for cone in cones], 0)
                          for cones in parts])
    part = np.where(distances[0] <= 0, 0, distances.argmin(0))
    is_inside = without_bare_edges((distances.min(0) <= 0).reshape(shape)).ravel()
    mesh, labels = cubes(dict(zip(map(tuple, grid[is_inside].tolist()), part[is_inside].tolist())))
    return smoothed(mesh), labels


def creature(seed):
    """Returns a torso with limbs in pairs, head, neck or tail, and the part of each triangle. The
    torso is one part, although it has a waist and bulges."""
    random = np.random.default_rng(seed)
    u = random.uniform
    is_quadruped, is_biped = seed % 3 == 0, seed % 3 == 1  # the others have wings and fins
    n, length = 25, u(24, 36)
    x = np.linspace(0, 1, n)
    thickness = u(0.18, 0.3) * length
    waist = u(0, 0.3 if is_quadruped else 0.15) * np.exp(-((x - u(0.3, 0.7)) / u(0.08, 0.2)) ** 2)
    bulges = 0.03 * np.interp(x, np.linspace(0, 1, 7), random.normal(size=7))
    radius = thickness * (1 - waist) * (1 + bulges) * \
        (1 - u(0, 0.35) * (1 - x) ** 2) * (1 - u(0, 0.35) * x ** 2)
    spine = length * np.column_stack([x, 0 * x, u(-0.12, 0.12) * np.sin(np.pi * x)])
    parts = [[(spine[i], spine[i + 1], radius[i], radius[i + 1]) for i in range(n - 1)]]

    def add_limb(base, direction, limb_length, first, last):
        direction = np.array(direction) / np.linalg.norm(direction)
        parts.append([(base, base + limb_length * direction, first, last)])

    def add_pair(i, direction, limb_length, first, last):
        pose = u(-0.5, 0.5, 2) if u() < 0.5 else np.zeros(2)
        for side, angle in zip((-1, 1), pose):
            base = spine[i] + radius[i] * np.array([0, 0.6 * side, -0.4 if is_quadruped else 0])
            add_limb(base, (direction[0] + angle, side * direction[1], direction[2]), limb_length,
                     first, last)

    limb = u(0.2, 0.4) * thickness
    first, last = u(1, 1.3) * limb, u(0.7, 1) * limb
    if is_quadruped:
        for i in (1, n - 2):
            add_pair(i, (0, u(0, 0.3), -1), u(0.45, 0.9) * length, first, last)
        if u() < 0.8:
            add_limb(spine[-1], (1, u(-0.3, 0.3), u(-0.6, 0.6)), u(0.5, 1.2) * length,
                     u(0.6, 1) * limb, 0.5 * limb)
    elif is_biped:
        add_pair(2, (u(-0.3, 1), 1, 0), u(0.6, 1) * length, first, last)
        add_pair(n - 2, (1, u(0.2, 0.5), 0), u(0.7, 1.2) * length, 1.2 * first, 1.2 * last)
    else:
        add_pair(n // 3 + random.integers(4), (u(-0.1, 0.5), 1, u(-0.1, 0.2)),
                 u(0.8, 1.4) * length, first, last)
        add_pair(n - 2, (u(0, 0.5), 1, 0), u(0.3, 0.5) * length, 0.7 * first, 0.6 * last)
        return solid_of_cones(parts)
    neck = u(0.3, 0.55) * thickness
    forward = np.array([-1, 0, u(0.2, 1.2) if is_quadruped else 0.])
    forward /= np.linalg.norm(forward)
    if is_quadruped or u() < 0.5:
        to_head = radius[0] + (u(0.3, 0.9) if is_quadruped else u(0.1, 0.2)) * length
        add_limb(spine[0], forward, to_head, 1.2 * neck, neck)
        size = u(1.3, 1.7) * neck
    else:
        size = u(0.5, 0.8) * radius[0]
        to_head = radius[0] + 0.7 * size
    add_limb(spine[0] + to_head * forward, (-1, 0, u(-0.5, 0.2)), u(0.3, 0.9) * size, size,
             u(0.7, 0.95) * size)
    return solid_of_cones(parts)


def creatures():
    """Returns smooth creatures, whose torsos are one part."""
    made = [creature(seed) for seed in range(NUMBER_OF_CREATURES)]
    return [Sample(str(i), "creatures", i // 3 % NUMBER_OF_FOLDS, mesh, [part])
            for i, (mesh, part) in enumerate(made)]


class Sample:
    """A mesh with one or more truths. The number of segments may be given."""

    def __init__(self, name, group, fold, mesh, truths, number=None):
        self.name, self.group, self.fold, self.mesh = name, group, fold, mesh
        self.truths, self.number = truths, number


def read_benchmark(folder):
    result = []
    for file in sorted(folder.glob("off/*.off"), key=lambda f: int(f.stem)):
        people = sorted(folder.glob(f"seg/Benchmark/{file.stem}/*.seg"))
        truths = [read_labels(person) for person in people]
        if truths:  # the number of segments that most people make
            number = np.bincount([t.max() + 1 for t in truths]).argmax()
            fold = (int(file.stem) - 1) // MESHES_PER_CATEGORY % NUMBER_OF_FOLDS
            result.append(Sample(file.stem, "benchmark", fold, read_off(file), truths, number))
    return result


def read_known_parts(folder):
    """Reads NAME.off with all other files NAME.*, which have one label a line."""
    result = []
    for file in sorted(folder.glob("*.off")):
        truths = [read_labels(f) for f in sorted(folder.glob(file.stem + ".*")) if f != file]
        fold = sum(map(ord, file.stem)) % NUMBER_OF_FOLDS
        result.append(Sample(file.stem, folder.name, fold, read_off(file), truths))
    return result


def copies(sample, options):
    """Returns the mesh and its changed copies, each with truths and weights of its triangles."""
    mesh, is_by_face = sample.mesh, sample.group == "benchmark"
    result = [(mesh, sample.truths)]
    for seed in range(1, options.noisy_copies + 1):
        changed = stretched_and_noisy(mesh, 100 * sum(map(ord, sample.name)) + seed)
        result.append((changed, sample.truths))
    if not is_by_face:
        result.append((subdivided(mesh), [np.tile(t, 4) for t in sample.truths]))
    for folder in options.triangulation if is_by_face else []:
        changed = read_off(folder / (sample.name + ".off"))
        nearest = scipy.spatial.cKDTree(mesh.centroids()).query(changed.centroids())[1]
        result.append((changed, [t[nearest] for t in sample.truths]))

    def weights(m):
        has_benchmarks_faces = is_by_face and len(m.triangles) == len(mesh.triangles)
        n = len(m.triangles)
        return np.full(n, 1 / n) if has_benchmarks_faces else m.shares_of_area()

    return [(changed, truths, weights(changed)) for changed, truths in result]


class Tree:
    """A hierarchy with the risks of its nodes, and the inputs, the gains and people's agreement of
    its cuts."""

    def __init__(self, hierarchy, truths, weights):
        nodes, leaf = hierarchy["nodes"], np.array(hierarchy["leaf_of_face"])
        self.children = [node["children"] for node in nodes]
        self.roots = [i for i, node in enumerate(nodes) if node["parent"] is None]
        order = list(self.roots)  # parents first
        for node in order:
            order += self.children[node]
        self.cuts = [node for node in order if self.children[node]]
        self.area_risk, self.constant = np.zeros(len(nodes)), 0
        self.ratios = []  # for each person the intersection over union of nodes with parts
        agreement = np.zeros(len(nodes))
        for truth in truths:
            overlap = np.zeros((len(nodes), truth.max() + 1))
            np.add.at(overlap, (leaf, truth), weights)
            for node in reversed(self.cuts):
                a, b = (overlap[child] for child in self.children[node])
                overlap[node] = a + b
                agreement[node] += 1 - np.minimum(a, b).sum() / max(min(a.sum(), b.sum()), 1e-12)
            self.sizes, parts = overlap.sum(1), np.bincount(truth, weights)
            self.area_risk += self.sizes ** 2 - 2 * (overlap ** 2).sum(1)
            self.constant += (parts ** 2).sum()
            union = self.sizes[:, None] + parts[None] - overlap
            self.ratios.append(overlap / np.maximum(union, 1e-12))
        self.area_risk /= len(truths)
        self.constant /= len(truths)
        self.agreement = agreement[self.cuts] / len(truths)
        self.set_gains(PART_WEIGHT)
        self.inputs = np.array([inputs(nodes[node]["factors"]) for node in self.cuts]) \
            .reshape(len(self.cuts), len(NAMES) + 1)
        self.is_boundary = np.array([nodes[node]["factors"]["is_boundary"] for node in self.cuts],
                                    bool)  # and not between components
        saliences = [float(nodes[node]["salience"]) for node in self.cuts]
        self.choice_of_package = np.array(saliences) - hierarchy["salience_threshold"]

    def set_gains(self, part_weight):
        best = np.array([ratios.max(1) for ratios in self.ratios])
        quality = np.where(best > 0.5, best, 0).mean(0)
        risk = self.area_risk - part_weight * (quality - USUAL_QUALITY)
        least, gain = risk.copy(), np.zeros(len(risk))
        for node in reversed(self.cuts):
            of_sides = sum(least[child] for child in self.children[node])
            gain[node] = risk[node] - of_sides
            least[node] = min(risk[node], of_sides)
        self.gains = gain[self.cuts]

    def outputs(self, network):
        """Returns the outputs for all boundaries, and large numbers of the package's sign between
        components."""
        outputs = 1000 * self.choice_of_package
        outputs[self.is_boundary] = network(self.inputs[self.is_boundary])
        return outputs

    def applied_cuts(self, outputs):
        """Yields the cuts as they are applied, the highest output next, with their outputs."""
        output = dict(zip(self.cuts, outputs))
        queue = [(-output[root], root) for root in self.roots if root in output]
        heapq.heapify(queue)
        while queue:
            key, node = heapq.heappop(queue)
            yield node, -key
            for child in self.children[node]:
                if child in output:
                    heapq.heappush(queue, (-output[child], child))

    def segments(self, outputs, number=None):
        """Returns the nodes of the segments, of all cuts with positive outputs or of a number of
        segments."""
        result = set(self.roots)
        for node, output in self.applied_cuts(outputs):
            if output <= 0 if number is None else len(result) >= number:
                break
            result.remove(node)
            result.update(self.children[node])
        return sorted(result)

    def error(self, segments):
        """Returns the Rand error."""
        return self.constant + self.area_risk[segments].sum()

    def measures(self, segments):
        """Returns the Rand error, the panoptic quality, the fraction of the segments that somebody
        made, and the numbers of false segments, of scraps and of all segments."""
        ratios = [of_person[segments] for of_person in self.ratios]
        quality = [r[r > 0.5].sum() * 2 / sum(r.shape) for r in ratios]
        is_false = np.max([r.max(1) for r in ratios], 0) < 0.5
        is_scrap = is_false & (self.sizes[segments] < SIZE_OF_SCRAP)
        return np.array([self.error(segments), np.mean(quality), 1 - is_false.mean(),
                         is_false.sum(), is_scrap.sum(), len(segments)])

    def limited_by_parents(self, outputs):
        """Returns the least output of each cut and of those above it."""
        limited, least = {}, np.inf
        for node, output in self.applied_cuts(outputs):
            least = min(least, output)
            limited[node] = least
        return np.array([limited[node] for node in self.cuts])


def names_of_inputs():
    """Returns the names of the factors in the order of the network's inputs."""
    text = (FOLDER / "Salience_factors.h").read_text()
    return re.findall(r'\{"(\w+)", &Salience_factors', text)


NAMES = names_of_inputs()


def inputs(factors):
    side = math.log(factors["size"] or 1e-300) + factors["log_relative_part_area"]
    return [factors[name] for name in NAMES] + [side]


def make_trees(sample, options):
    """Returns the trees of a mesh and of its changed copies."""
    def tree(mesh, truths, weights):
        hierarchy = spectral_segmentation.segment_hierarchy(mesh.points, mesh.triangles, threads=1)
        return Tree(json.loads(hierarchy.to_json()), truths, weights)

    return [tree(*copy) for copy in copies(sample, options)]


class Network:
    """Hyperbolic tangents of linear functions of the standardized inputs, and a linear function."""

    def __init__(self, x, is_gain, weights):
        self.means, self.deviations = x.mean(0).round(5), x.std(0).round(5)
        z, w = self.standardized(x), weights / weights.sum()
        d, h = z.shape[1], NUMBER_OF_UNITS
        sizes = np.cumsum([d * h, h, h, d])

        def split(numbers):
            hidden, bias, out, linear, constant = np.split(numbers, sizes)
            return hidden.reshape(d, h), bias, out, linear, constant[0]

        def loss(numbers):
            hidden, bias, out, linear, constant = split(numbers)
            units = np.tanh(z @ hidden + bias)
            output = units @ out + z @ linear + constant
            slope = w * (1 / (1 + np.exp(-output)) - is_gain)
            of_units = np.outer(slope, out) * (1 - units ** 2)
            gradient = [(z.T @ of_units + 2 * PENALTY * hidden).ravel(), of_units.sum(0),
                        units.T @ slope + 2 * PENALTY * out, z.T @ slope + 2 * PENALTY * linear,
                        [slope.sum()]]
            penalty = PENALTY * ((hidden ** 2).sum() + out @ out + linear @ linear)
            return (w * (np.logaddexp(0, output) - is_gain * output)).sum() + penalty, \
                np.concatenate(gradient)

        random = np.random.default_rng(0)

        def local_minimum():
            start = np.concatenate([random.normal(0, 0.5 / d ** 0.5, d * h), np.zeros(h),
                                    random.normal(0, 0.3, h), np.zeros(d + 1)])
            return scipy.optimize.minimize(loss, start, jac=True, method="L-BFGS-B",
                                           options={"maxiter": 600})

        found = min((local_minimum() for _ in range(NUMBER_OF_STARTS)), key=lambda m: m.fun)
        self.hidden, self.bias, self.out, self.linear, self.constant = split(found.x)

    def standardized(self, x):
        z = (x - self.means) / self.deviations
        return np.clip(z, -LARGEST_DEVIATION, LARGEST_DEVIATION)

    def __call__(self, x):
        z = self.standardized(x)
        return np.tanh(z @ self.hidden + self.bias) @ self.out + z @ self.linear + self.constant

    def mean_changes(self, x):
        """Returns the mean change of the output if an input grows by a standard deviation."""
        z = self.standardized(x)
        slopes = (1 - np.tanh(z @ self.hidden + self.bias) ** 2) * self.out
        return self.linear + (slopes @ self.hidden.T).mean(0)

    def calibrate(self, scale, shift):
        """Makes the outputs scale * output + shift."""
        self.out, self.linear = scale * self.out, scale * self.linear
        self.constant = scale * self.constant + shift


def fit(samples, trees, weights, left_out=None):
    """Fits to all trees of all folds but one. The gains of a group sum to its weight."""
    rows, gains, row_weights = [], [], []
    totals = dict.fromkeys(weights, 0)
    for sample, of_sample in zip(samples, trees):
        totals[sample.group] += np.abs(of_sample[0].gains).sum()
    for sample, of_sample in zip(samples, trees):
        if sample.fold == left_out:
            continue
        for tree in of_sample:
            factor = weights[sample.group] / totals[sample.group] / len(of_sample)
            rows.append(tree.inputs[tree.is_boundary])
            gains.append(tree.gains[tree.is_boundary])
            row_weights.append(factor * np.abs(gains[-1]))
    return Network(np.vstack(rows), np.concatenate(gains) > 0, np.concatenate(row_weights))


def fit_calibration(outputs, agreement):
    """Returns the scale and the shift with which the logistic function of outputs is agreement."""
    def loss(numbers):
        logit = numbers[0] * outputs + numbers[1]
        slope = 1 / (1 + np.exp(-logit)) - agreement
        return (np.logaddexp(0, logit) - agreement * logit).mean(), \
            np.array([(slope * outputs).mean(), slope.mean()])
    return scipy.optimize.minimize(loss, [1, 0], jac=True).x


def print_measures(samples, trees, outputs):
    """Prints the means over held-out meshes, and the changes against the package as it is."""
    titles = ("Rand", "PQ", "made", "false", "scraps", "segments")
    print("held-out meshes".ljust(24) + "".join(title.rjust(9) for title in titles))

    def print_row(title, rows, before=()):
        print(title.ljust(24) + "".join(f"{x:9.4f}" for x in np.mean(rows, 0)))
        if len(before):
            changes = np.array(rows) - before
            errors = changes.std(0) / len(changes) ** 0.5
            for name, numbers in (("  change", changes.mean(0)), ("  +-", errors)):
                print(name.ljust(24) + "".join(f"{x:+9.4f}" for x in numbers))

    for group in dict.fromkeys(sample.group for sample in samples):
        of_group = [row for row in zip(samples, trees, outputs) if row[0].group == group]
        before = [t.measures(t.segments(t.choice_of_package)) for _, t, _ in of_group]
        print_row(f"{group}, {len(of_group)}: before", before)
        print_row("  best choice", [t.measures(t.segments(t.gains)) for _, t, _ in of_group])
        for offset in OFFSETS:
            print_row(f"  offset {offset}",
                      [t.measures(t.segments(o - offset)) for _, t, o in of_group],
                      () if offset else before)
        known = [row for row in of_group if row[0].number]
        if known:
            print_row("  number given",
                      [t.measures(t.segments(o, s.number)) for s, t, o in known],
                      [t.measures(t.segments(t.choice_of_package, s.number)) for s, t, _ in known])


def print_calibration(probabilities, agreement):
    print("\nprobability  cuts  people who cut there")
    for low in np.arange(0, 1, 0.1):
        is_here = (probabilities >= low) & (probabilities < low + 0.1)
        if is_here.any():
            people = agreement[is_here].mean()
            print(f"  {low:.1f} to {low + 0.1:.1f}  {is_here.sum():4}  {people:.2f}")


def write_table(file, network):
    def array(numbers):
        texts = [f"{number + 0:.5f}" for number in numbers]
        lines = [", ".join(texts[i:i + 8]) for i in range(0, len(texts), 8)]
        return "{{" + ",\n     ".join(lines) + "}}"

    units = "".join(f"  {{{bias:.5f},\n    {array(weights)},\n   {out:.5f}}},\n"
                    for bias, weights, out in zip(network.bias, network.hidden.T, network.out))
    target = FOLDER / "internal/base/calibrated_networks.h"
    before, _, after = re.split(r"(?<=calibrated_boundary_network = \{\n)(.*?)(?=\n  \}\}\};)",
                                target.read_text(), flags=re.S)
    file.write_text(before + f"""  // means and standard deviations of the inputs
    {array(network.means)},
    {array(network.deviations)},
  // the linear part
  {network.constant:.5f},
    {array(network.linear)},
  // the units
  {{{{
{units.rstrip()}""" + after)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("benchmark", type=pathlib.Path,
                        help="holds off/N.off and seg/Benchmark/N/*.seg")
    parser.add_argument("--known-parts", nargs=2, action="append", default=[],
                        metavar=("DIR", "WEIGHT"),
                        help="also fits to the meshes NAME.off of a folder; all other files NAME.* "
                             "have one label a line; the benchmark has the weight 1")
    parser.add_argument("--triangulation", type=pathlib.Path, action="append", default=[],
                        metavar="DIR",
                        help="N.off: other triangulations of the benchmark's meshes, as "
                             "segmentation_quality --cache writes them")
    parser.add_argument("--plain-weight", type=float, default=0.005,
                        help="of made shapes without parts, such as knots and plates [0.005]")
    parser.add_argument("--machine-weight", type=float, default=0.005,
                        help="of made machines, such as flanges and spools [0.005]")
    parser.add_argument("--creature-weight", type=float, default=0.02,
                        help="of made creatures, whose torsos are one part [0.02]")
    parser.add_argument("--noisy-copies", type=int, default=2, help="of each mesh [2]")
    parser.add_argument("--table", type=pathlib.Path, metavar="OUT.h",
                        help="writes the header with the network")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time [2]")
    return parser.parse_args()


def main():
    options = arguments()
    samples = read_benchmark(options.benchmark) + plain_shapes() + machines() \
        + creatures()
    weights = {"benchmark": 1, "plain": options.plain_weight, "machines": options.machine_weight,
               "creatures": options.creature_weight}
    for folder, weight in options.known_parts:
        samples += read_known_parts(pathlib.Path(folder))
        weights[pathlib.Path(folder).name] = float(weight)

    with multiprocessing.Pool(options.jobs) as pool:
        trees = pool.starmap(make_trees, [(sample, options) for sample in samples], chunksize=1)
        networks = pool.starmap(fit, [(samples, trees, weights, fold)
                                      for fold in range(NUMBER_OF_FOLDS)])
    meshes = [of_sample[0] for of_sample in trees]
    outputs = [tree.outputs(networks[sample.fold]) for sample, tree in zip(samples, meshes)]
    print_measures(samples, meshes, outputs)

    held_out = [(tree.limited_by_parents(o), tree.agreement)
                for sample, tree, o in zip(samples, meshes, outputs) if sample.group == "benchmark"]
    limited, agreement = (np.concatenate(columns) for columns in zip(*held_out))
    scale, shift = fit_calibration(limited, agreement)
    print_calibration(1 / (1 + np.exp(-scale * limited - shift)), agreement)
    print("\noffset  probability")
    for offset in OFFSETS:
        print(f"{offset:6}  {1 / (1 + np.exp(-scale * offset - shift)):.3f}")

    network = fit(samples, trees, weights)
    network.calibrate(scale, shift)
    rows = np.vstack([tree.inputs[tree.is_boundary] for tree in meshes])
    print("\nmean change of the logit if an input grows by one standard deviation")
    for name, change in zip(NAMES + ["fraction of the smaller side"], network.mean_changes(rows)):
        print(f"{name:28} {change:+.2f}")
    if options.table:
        write_table(options.table, network)


if __name__ == "__main__":
    main()
