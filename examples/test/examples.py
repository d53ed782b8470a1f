#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests an example: examples.py EXAMPLE MESHES, with the directory of CGAL's meshes."""

import collections
import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "test/helpers"))
from mesh_files import read_off, read_ply_rows, read_stl, write_off
from meshes import cross, directed_edges, dot, dumbbell, is_closed, minus, tube, volume

EXAMPLE = None
MESHES = None


def read_ply(path):
    """Returns the points, the triangles, and the other properties of triangles of a binary PLY."""
    rows = read_ply_rows(path)
    corners, = (name for name, value in rows["face"][0].items() if isinstance(value, tuple))
    faces = [row.pop(corners) for row in rows["face"]]
    assert all(len(face) == 3 for face in faces)
    return ([tuple(row.values())[:3] for row in rows["vertex"]], faces,
            {name: [row[name] for row in rows["face"]] for name in rows["face"][0]})


def connected_sets(faces):
    """Returns the faces, in one list for each set that is connected across edges."""
    faces_at = collections.defaultdict(list)
    for i, face in enumerate(faces):
        for a, b in directed_edges([face]):
            faces_at[min(a, b), max(a, b)].append(i)
    sets, is_seen = [], set()
    for start in range(len(faces)):
        if start in is_seen:
            continue
        is_seen.add(start)
        members = [start]
        for i in members:
            for a, b in directed_edges([faces[i]]):
                new = [j for j in faces_at[min(a, b), max(a, b)] if j not in is_seen]
                is_seen.update(new)
                members += new
        sets.append([faces[i] for i in members])
    return sets


def faces_of_segments(faces, labels):
    result = collections.defaultdict(list)
    for face, label in zip(faces, labels):
        result[label].append(face)
    return result


def outer_planes(points, faces):
    """Returns Point and outer normal of the plane of each face."""
    return [(points[a], cross(minus(points[b], points[a]), minus(points[c], points[a])))
            for a, b, c in faces]


def is_inside(point, planes, tolerance):
    return all(dot(minus(point, origin), normal) <= tolerance * dot(normal, normal) ** 0.5
               for origin, normal in planes)


class Example(unittest.TestCase):

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def run_example(self, *arguments):
        """Returns the output of the example, which reads the elephant if it has no arguments."""
        done = subprocess.run(
            [EXAMPLE, *map(str, arguments)], cwd=self.directory, text=True, check=False,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
            env={**os.environ, "CGAL_DATA_DIR": str(MESHES.parent), "CGAL_TEST_SUITE": "1",
                 "QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": str(self.directory)})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def numbers(self, pattern, output):
        """Returns the numbers in the only line of the output, which has the pattern."""
        match = re.fullmatch(pattern + r"\n", output)
        self.assertTrue(match, output)
        return [float(x) for x in match.groups()]

    def write(self, points, faces):
        write_off(self.directory / "mesh.off", points, faces)
        return "mesh.off"

    def ply(self):
        return read_ply(self.directory / "segments.ply")

    def check_segments(self, faces, labels, n):
        self.assertEqual(len(labels), len(faces))
        segments = faces_of_segments(faces, labels)
        self.assertEqual(sorted(segments), list(range(int(n))))
        for segment in segments.values():
            self.assertEqual(len(connected_sets(segment)), 1)

    def check_labels(self, read_labels):
        """Two balls are two segments, and an elephant is many."""
        points, faces = dumbbell()
        self.assertEqual(self.run_example(self.write(points, faces)), "2 segments\n")
        self.assertEqual(len(faces) % 2, 0)
        half = [0] * (len(faces) // 2)
        labels = read_labels()
        self.assertLessEqual(sum(a != b for a, b in zip(labels, half + [1 for _ in half])), 32)

        n, = self.numbers(r"(\d+) segments", self.run_example())
        self.assertGreater(n, 6)
        self.check_segments(read_off(MESHES / "elephant.off")[1], read_labels(), n)

    def labels_in_text(self):
        return [int(line) for line in (self.directory / "segments.txt").read_text().splitlines()]

    def test_segment_surface_mesh(self):
        self.check_labels(lambda: self.ply()[2]["segment"])
        values = self.ply()[2]
        colors = set(zip(values["segment"], values["red"], values["green"], values["blue"]))
        self.assertEqual(len(colors), len(set(values["segment"])))
        self.assertEqual(len({color[1:] for color in colors}), len(colors))

    def test_segment_polyhedron(self):
        self.check_labels(self.labels_in_text)

    def test_segment_linear_cell_complex(self):
        self.check_labels(self.labels_in_text)

    def test_segment_openmesh(self):
        n, = self.numbers(r"(\d+) segments", self.run_example())
        self.assertGreater(n, 6)
        header = (self.directory / "segments.ply").read_bytes().split(b"end_header")[0].decode()
        self.assertRegex(header, r"element face 5558\n.*\n(property uchar (red|green|blue)\n){3}")

    def test_segment_part_again(self):
        n, region, m = self.numbers(r"(\d+) segments; segment (\d+) is cut in (\d+) again",
                                    self.run_example())
        self.assertLess(region, n)
        self.assertGreater(m, 1)
        _, faces, properties = self.ply()
        self.check_segments(faces, properties["segment"], n + m - 1)

    def test_segment_with_constraints(self):
        n, m = self.numbers(r"(\d+) segments\n(\d+) segments with constraints", self.run_example())
        self.assertEqual(m, n - 1)
        _, faces, properties = self.ply()
        self.check_segments(faces, properties["segment"], m)

    def test_clean_noisy_labels(self):
        points, faces = dumbbell()
        half = len(faces) // 2
        right = [7] * half + [-3] * half
        random.seed(1)
        noisy = [random.choice([7, -3, 12]) if random.random() < 0.25 else label
                 for label in right]
        (self.directory / "noisy.txt").write_text("".join("%d\n" % label for label in noisy))

        def cleaned():
            return list(map(int, (self.directory / "labels.txt").read_text().split()))

        output = self.run_example(self.write(points, faces), "noisy.txt")
        self.assertEqual(output, "2 segments; the labels of %d of %d faces are changed\n"
                         % (sum(a != b for a, b in zip(noisy, cleaned())), len(faces)))
        self.assertLessEqual(sum(a != b for a, b in zip(cleaned(), right)), 32)

        self.run_example()
        faces = read_off(MESHES / "elephant.off")[1]
        noisy = list(map(int, (self.directory / "noisy_labels.txt").read_text().split()))
        pieces = [sum(len(connected_sets(s)) for s in faces_of_segments(faces, labels).values())
                  for labels in (noisy, cleaned())]
        self.assertGreater(pieces[0], 2 * pieces[1])

    def test_choose_number_of_segments(self):
        labels = {}
        for n in (3, 7):
            output = self.run_example(MESHES / "elephant.off", n)
            _, *cuts, last = output.splitlines()
            self.assertEqual(last, "%d segments are written" % n)
            _, faces, properties = self.ply()
            labels[n] = properties["segment"]
            self.check_segments(faces, labels[n], n)
        numbers, probabilities = zip(*(map(float, line.split()) for line in cuts))
        self.assertEqual(list(numbers), list(range(2, len(cuts) + 2)))
        self.assertEqual(list(probabilities), sorted(probabilities, reverse=True))
        self.assertTrue(all(0 <= p <= 1 for p in probabilities))
        self.assertEqual(len(set(zip(labels[3], labels[7]))), 7, "the few are unions of the many")

    def test_save_and_load_hierarchy(self):
        """One process saves, others load. The labels equal the labels of runs."""
        n, most = self.numbers(r"(\d+) segments, up to (\d+)", self.run_example())
        self.assertGreater(n, 6)
        labels = {}
        for wanted in (3, n, most, most + 1):
            written, = self.numbers(r"(\d+) segments are written",
                                    self.run_example(int(wanted)))
            self.assertEqual(written, min(wanted, most))
            labels[wanted] = self.labels_in_text()
            self.check_segments(read_off(MESHES / "elephant.off")[1], labels[wanted], written)
        self.assertEqual(len(set(zip(labels[3], labels[most]))), most)
        chooser = pathlib.Path(EXAMPLE).parent / "choose_number_of_segments"
        if chooser.exists():
            for wanted in (3, n, most):
                subprocess.run([chooser, MESHES / "elephant.off", str(int(wanted))], check=True,
                               cwd=self.directory, stdout=subprocess.DEVNULL, timeout=300)
                self.assertEqual(self.ply()[2]["segment"], labels[wanted])

    def test_edit_segments(self):
        """Two neighbors become one, then another segment becomes two."""
        n, merged, last = self.numbers(
            r"(\d+) segments, (\d+) after a merge, (\d+) after a cut", self.run_example())
        self.assertEqual(merged, n - 1)
        self.assertGreater(last, merged)
        _, faces, properties = self.ply()
        self.check_segments(faces, properties["segment"], last)

    def test_own_part_salience(self):
        pattern = r"(\d+) segments, .*"
        ball = [5., 8., 9.5, 10., 9.5, 8., 5.]
        rod = [1.] * 20
        self.assertEqual(
            self.numbers(pattern, self.run_example(self.write(*tube(ball + rod)))), [2])
        self.assertEqual(self.numbers(pattern, self.run_example(self.write(*dumbbell()))), [1])
        n, = self.numbers(pattern, self.run_example())
        _, faces, properties = self.ply()
        self.check_segments(faces, properties["segment"], n)

    def test_segment_points_and_triangles(self):
        pattern = r"(\d+) points, (\d+) triangles, (\d+) segments"
        points, faces = dumbbell()
        output = self.run_example(self.write(points, faces))
        self.assertEqual(self.numbers(pattern, output), [len(points), len(faces), 2])
        half = [0] * (len(faces) // 2)
        labels = self.labels_in_text()
        self.assertLessEqual(sum(a != b for a, b in zip(labels, half + [1 for _ in half])), 32)
        *_, n = self.numbers(pattern, self.run_example())
        self.assertGreater(n, 6)
        self.check_segments(read_off(MESHES / "elephant.off")[1], self.labels_in_text(), n)

    def long_tube(self):
        """Returns a mesh of 180,000 faces."""
        return self.write(*tube([10 + 5 * math.sin(i / 20) for i in range(300)], 300))

    def test_progress_and_cancel(self):
        *lines, last = self.run_example(MESHES / "elephant.off", 200).splitlines()
        self.assertRegex(last, r"^\d+ segments, finished$")
        matches = [re.fullmatch(r"(\d+) %, about (\d+\.\d) s to go", line) for line in lines]
        self.assertTrue(all(matches), lines)
        percents = [int(match[1]) for match in matches]
        self.assertGreater(len(percents), 20)
        self.assertEqual(percents, sorted(set(percents)))
        self.assertEqual(lines[-1], "100 %, about 0.0 s to go")
        for name, limit in ((MESHES / "elephant.off", 0), (self.long_tube(), 0.01)):
            *lines, last = self.run_example(name, limit).splitlines()
            self.assertRegex(last, r"^\d+ segments, stopped$")
            self.assertFalse(any(line.startswith("100 %") for line in lines))
            segments = set(self.ply()[2]["segment"])
            self.assertEqual(segments, set(range(int(last.split()[0]))))
            self.assertTrue(limit or last.startswith("1 "))

    def test_progress_dialog(self):
        n, = self.numbers(r"(\d+) segments, finished", self.run_example())
        self.check_segments(read_off(MESHES / "elephant.off")[1], self.ply()[2]["segment"], n)
        n, = self.numbers(r"(\d+) segments, canceled", self.run_example(self.long_tube(), 0.01))
        self.assertEqual(set(self.ply()[2]["segment"]), set(range(int(n))))

    def volumes_of_parts(self, output):
        volumes = []
        for i, line in enumerate(output.splitlines()):
            points, faces = read_off(self.directory / ("part_%d.off" % i))
            self.assertTrue(is_closed(faces), line)
            volumes.append(volume(points, faces))
            self.assertGreater(volumes[-1], 0)
            self.assertEqual(line, "part %d: volume %g" % (i, volumes[-1]))
        return volumes

    def test_parts_as_closed_meshes(self):
        self.assertGreater(len(self.volumes_of_parts(self.run_example())), 6)
        balls = dumbbell()
        volumes = self.volumes_of_parts(self.run_example(self.write(*balls)))
        self.assertEqual(len(volumes), 2)
        self.assertAlmostEqual(sum(volumes), volume(*balls), places=6)

    def test_remesh_segments(self):
        """The segments and the length of their seams stay, while the faces become others."""
        pattern = r"before: (\d+) segments, length of seams (\S+)\n" \
                  r"after: (\d+) segments, length of seams (\S+)"
        for name, old_faces in ((self.write(*dumbbell()), dumbbell()[1]),
                                (MESHES / "elephant.off",
                                 read_off(MESHES / "elephant.off")[1])):
            n, old_length, m, length = self.numbers(pattern, self.run_example(name))
            self.assertEqual(n, m)
            self.assertAlmostEqual(length / old_length, 1, places=5)
            points, faces, properties = self.ply()
            self.assertNotEqual(len(faces), len(old_faces))
            self.assertTrue(is_closed(faces))
            self.check_segments(faces, properties["segment"], n)
            segment_at = {edge: segment for face, segment in zip(faces, properties["segment"])
                          for edge in directed_edges([face])}
            seams = [minus(points[b], points[a]) for (a, b), segment in segment_at.items()
                     if segment < segment_at[b, a]]
            self.assertAlmostEqual(sum(dot(v, v) ** 0.5 for v in seams) / length, 1, places=5)
        self.assertGreater(n, 6)

    def test_graph_of_segments(self):
        pattern = r"(\d+) segments, (\d+) boundaries"
        self.assertEqual(self.numbers(pattern, self.run_example(self.write(*dumbbell()))), [2, 1])
        n, number_of_boundaries = self.numbers(pattern, self.run_example())
        text = (self.directory / "segments.dot").read_text()
        areas = re.findall(r'^\d+\[label="\d+\\narea (\S+)"\];$', text, re.MULTILINE)
        saliences = re.findall(r'^\d+--\d+ \[label="(\S+)", len=\S+\];$', text, re.MULTILINE)
        self.assertEqual((len(areas), len(saliences)), (n, number_of_boundaries))
        self.assertTrue(all(0.4 <= float(salience) <= 1 for salience in saliences))
        points, faces = read_off(MESHES / "elephant.off")
        area = sum(dot(normal, normal) ** 0.5 / 2 for _, normal in outer_planes(points, faces))
        self.assertAlmostEqual(sum(map(float, areas)) / area, 1, places=4)

    def test_color_by_embedding(self):
        first, last = map(int, self.numbers(
            r"samples: faces f(\d+) and f(\d+)", self.run_example()))
        _, faces, properties = read_ply(self.directory / "embedding.ply")
        self.assertEqual(len(faces), 5558)
        coordinates, red = properties["coordinate"], properties["red"]
        by_coordinate = [r for _, r in sorted(zip(coordinates, red))] # equal coordinates occur
        self.assertEqual(by_coordinate, sorted(by_coordinate))
        self.assertLess(red[first], 10) # the samples are at the ends of the line
        self.assertGreater(red[last], 245)

    def test_collision_shapes(self):
        n, number_of_faces, percentage = self.numbers(
            r"(\d+) convex shapes with (\d+) faces in place of 5558; "
            r"they take ([\d.]+) % of the space of one shape around all",
            self.run_example())
        shapes, hulls_volume, sum_of_faces = [], 0, 0
        for i in range(int(n)):
            points, faces = read_stl(self.directory / ("hull_%d.stl" % i))
            self.assertTrue(is_closed(faces))
            sum_of_faces += len(faces)
            hulls_volume += volume(points, faces)
            shapes.append(outer_planes(points, faces))
            self.assertTrue(all(is_inside(p, shapes[-1], 1e-6) for p in points))
        self.assertEqual(sum_of_faces, number_of_faces)
        self.assertFalse((self.directory / ("hull_%d.stl" % n)).exists())
        mesh_points, mesh_faces = read_off(MESHES / "elephant.off")
        for p in mesh_points:
            self.assertTrue(any(is_inside(p, planes, 1e-6) for planes in shapes))
        self.assertGreater(hulls_volume, volume(mesh_points, mesh_faces))
        self.assertLess(percentage, 100)

    def test_joints_of_parts(self):
        """The joint of two balls on the z axis is the ring between them."""
        self.assertEqual(self.run_example(self.write(*dumbbell())), "2 parts, 1 joints\n")
        result = json.loads((self.directory / "joints.json").read_text())
        joint, = result["joints"]
        self.assertEqual((joint["parts"], joint["is_loop"]), ([0, 1], True))
        for x, middle in zip(joint["center"], (0, 0, 8)):
            self.assertAlmostEqual(x, middle, delta=0.6)
        direction = 1 if result["parts"][1]["center"][2] > joint["center"][2] else -1
        self.assertGreater(direction * joint["axis"][2], 0.9)
        self.assertAlmostEqual(joint["length"] / (2 * math.pi * joint["radius"]), 1, delta=0.2)

        n, joints = self.numbers(r"(\d+) parts, (\d+) joints", self.run_example())
        result = json.loads((self.directory / "joints.json").read_text())
        self.assertEqual((len(result["parts"]), len(result["joints"])), (n, joints))
        points, faces = read_off(MESHES / "elephant.off")
        area = sum(dot(normal, normal) ** 0.5 / 2 for _, normal in outer_planes(points, faces))
        self.assertAlmostEqual(sum(part["area"] for part in result["parts"]) / area, 1, places=6)
        for joint in result["joints"]:
            self.assertLess(joint["parts"][0], joint["parts"][1])
            self.assertAlmostEqual(dot(joint["axis"], joint["axis"]), 1, places=6)

    def test_curve_skeleton_of_parts(self):
        self.assertEqual(self.run_example(self.write(*dumbbell())), "2 parts, 1 joints\n")
        text = (self.directory / "skeleton.polylines.txt").read_text()
        polylines = [[float(x) for x in line.split()] for line in text.splitlines()]
        self.assertEqual([line[0] for line in polylines], [3, 2, 2])
        ends = [z for line in polylines for z in line[3::3]]
        for z, expected in zip(ends, (3.5, 8, 12.5, 3.5, -0.5, 12.5, 16.5)):
            self.assertAlmostEqual(z, expected, delta=0.6)
        for line in polylines[:1]:
            self.assertTrue(all(abs(x) < 1e-4 for x in line[1::3] + line[2::3]))

        n, joints = self.numbers(r"(\d+) parts, (\d+) joints", self.run_example())
        self.assertGreater(n, 6)
        self.assertEqual(joints, n - 1)

    def test_read_any_file(self):
        """Polygons of a file, then triangles without common points, turned at random, one twice."""
        self.assertEqual(self.run_example(), "220 polygons, 466 triangles, 2 segments\n")
        random.seed(1)
        points, triangles = dumbbell()
        polygons = [list(t) for t in triangles]
        polygons.append(polygons[7])
        soup = [polygon[::random.choice((1, -1))] for polygon in polygons]
        corners = [points[v] for polygon in soup for v in polygon]
        name = self.write(corners, [range(3 * i, 3 * i + 3) for i in range(len(soup))])
        self.assertEqual(self.run_example(name), "%d polygons, %d triangles, 2 segments\n" %
                         (len(triangles), len(triangles)))
        repaired, faces, _ = self.ply()
        self.assertTrue(is_closed(faces))
        self.assertAlmostEqual(volume(repaired, faces), volume(points, triangles), places=6)

    def test_draw_segments(self):
        n, = self.numbers(r"(\d+) segments", self.run_example())
        _, faces, properties = self.ply()
        self.check_segments(faces, properties["segment"], n)
        colors = set(zip(properties["red"], properties["green"], properties["blue"]))
        pairs = set(zip(properties["segment"], properties["red"], properties["green"],
                        properties["blue"]))
        self.assertEqual((len(colors), len(pairs)), (n, n))


if __name__ == "__main__":
    EXAMPLE, MESHES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute()
    unittest.main(argv=[sys.argv[0], "Example.test_" + pathlib.Path(EXAMPLE).stem])
