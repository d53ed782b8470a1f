# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for tests in Python, as points and faces, and their measures."""

import math


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def volume(points, faces):
    return sum(dot(points[a], cross(points[b], points[c])) for a, b, c in faces) / 6


def directed_edges(faces):
    return [(face[i - 1], face[i]) for face in faces for i in range(3)]


def is_closed(faces):
    """Returns whether each edge has a face on both sides."""
    edges = set(directed_edges(faces))
    return len(edges) == 3 * len(faces) and edges == {(b, a) for a, b in edges}


def area(points, face):
    p, q, r = (points[v] for v in face)
    return math.hypot(*cross(minus(q, p), minus(r, p))) / 2


def tube(radii, around=16):
    """Returns a closed surface around the z axis: rings of these radii, a point at both ends."""
    points = [(0., 0., -0.5)]
    for z, radius in enumerate(radii):
        for i in range(around):
            angle = 2 * math.pi * (i + 0.5 * z) / around
            points.append((radius * math.cos(angle), radius * math.sin(angle), float(z)))
    points.append((0., 0., len(radii) - 0.5))
    faces = []
    for i in range(around):
        faces.append((0, 1 + (i + 1) % around, 1 + i))
    for z in range(len(radii) - 1):
        for i in range(around):
            a, b = 1 + z * around + i, 1 + z * around + (i + 1) % around
            c, d = a + around, b + around
            faces += [(a, b, c), (b, d, c)]
    last = 1 + (len(radii) - 1) * around
    for i in range(around):
        faces.append((last + i, last + (i + 1) % around, len(points) - 1))
    return points, faces


def dumbbell():
    """Returns two balls with a neck between them: the faces of one ball, then of the other one."""
    ball = [math.sin(math.pi * (i + 0.5) / 9) * 5 for i in range(9)]
    return tube(ball[:8] + [1.] + ball[1:])
