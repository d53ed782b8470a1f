#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the data of the page of `segment_mesh --html`: page.py TOOL MESHES, with the directory of
CGAL's meshes."""

import base64
import collections
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "test/helpers"))
from mesh_files import read_off, read_ply, write_off
from meshes import area, dumbbell, tube

TOOL = None
MESHES = None


def integers(text):
    """Returns the integers that packed.h describes."""
    value, weight = 0, 1
    for byte in base64.b64decode(text, validate=True):
        value += (byte & 127) * weight
        weight *= 128
        if byte < 128:
            yield -(value + 1) // 2 if value % 2 else value // 2
            value, weight = 0, 1


def sums(text, stride=1):
    result = list(integers(text))
    for i in range(stride, len(result)):
        result[i] += result[i - stride]
    return result


def runs(text):
    numbers = list(integers(text))
    return [value for value, length in zip(numbers[::2], numbers[1::2]) for _ in range(length)]


def triples(numbers):
    return [tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)]


class Page:
    """The data that a page embeds."""

    def __init__(self, text):
        self.text = text
        (data,) = re.findall('<script type="application/json" id="data">(.*?)</script>', text,
                             re.DOTALL)
        self.data = json.loads(data)
        mesh = self.data["mesh"]
        self.unit = mesh["unit"]
        self.points = [tuple(c + mesh["unit"] * x for c, x in zip(mesh["corner"], p))
                       for p in triples(sums(mesh["points"], 3))]
        self.triangles = triples(sums(mesh["triangles"]))
        self.pieces = runs(mesh["pieces"])
        self.piece_of_face = runs(self.data["piece_of_face"])
        self.cuts = self.data["hierarchy"]["cut_nodes"]
        self.roots = self.data["hierarchy"]["roots"]

    def number_of_segments(self):
        return self.roots + len(self.cuts)

    def segments(self, n):
        """Returns the nodes of the pieces, for n segments."""
        parent = {self.roots + 2 * i + k: node for i, node in enumerate(self.cuts)
                  for k in range(2)}
        nodes = range(self.roots + len(parent))
        segments = [node for node in nodes if node not in self.cuts] # of pieces
        while max(segments) >= 2 * n - self.roots:
            segments = [s if s < 2 * n - self.roots else parent[s] for s in segments]
        return segments

    def labels(self, n):
        """Returns the labels of the faces of the input, for n segments."""
        segments = self.segments(n)
        exceptions = self.data["exceptions"].get(str(n))
        if exceptions:
            label = dict(zip(exceptions["segments"][::2], exceptions["segments"][1::2]))
        else:
            by_first = sorted(zip(self.data["hierarchy"]["first_triangles"], segments))
            label = {}
            for _, segment in by_first:
                label.setdefault(segment, len(label))
        result = [label.get(segments[piece]) for piece in self.piece_of_face]
        if exceptions:
            for face, value in zip(sums(exceptions["faces"]), runs(exceptions["labels"])):
                result[face] = value
        return result

    def boundaries(self, points, faces, labels):
        """Returns the edges between faces of two labels, with points on the grid of the page,
        because meshes repeat the points between segments."""
        grid = [tuple(round((x - c) / self.unit) for x, c in zip(p, self.data["mesh"]["corner"]))
                for p in points]
        found = {}
        for face, label in zip(faces, labels):
            for i in range(3):
                edge = frozenset((grid[face[i - 1]], grid[face[i]]))
                found.setdefault(edge, set()).add(label)
        return {edge for edge, beside in found.items() if len(beside) > 1 and len(edge) > 1}


class Page_test(unittest.TestCase):

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def run_tool(self, *arguments):
        """Runs the tool with one search; five take longer."""
        return subprocess.run([TOOL, "--searches", "1", *map(str, arguments)],
                              cwd=self.directory, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def output(self, *arguments):
        result = self.run_tool(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def page(self, *arguments):
        return Page(self.output(*arguments, "--html", "-", "--quiet"))

    def labels(self, *arguments):
        return [int(l) for l in self.output(*arguments, "--labels", "-", "--quiet").split()]

    def check_equal(self, labels, expected):
        """assertEqual() would print a difference of lists this long in no useful time."""
        self.assertEqual(len(labels), len(expected))
        self.assertEqual(sum(a != b for a, b in zip(labels, expected)), 0)

    def check_labels(self, path, numbers, *options):
        page = self.page(path, *options)
        for n in numbers:
            with self.subTest(n=n):
                self.check_equal(page.labels(n), self.labels(path, "--segments", n, *options))
        return page

    def test_mesh(self):
        points, faces = read_off(MESHES / "elephant.off")
        page = self.page(MESHES / "elephant.off", "--keep-faces")
        self.assertEqual(len(page.triangles), len(faces))
        self.assertEqual(len(page.points), len({v for face in faces for v in face}))
        for triangle, face in zip(page.triangles, faces):
            for v, w in zip(triangle, face):
                for x, y in zip(page.points[v], points[w]):
                    self.assertAlmostEqual(x, y, delta=0.51 * page.unit)
        self.assertEqual(page.pieces, page.piece_of_face)

    def test_refined_boundaries(self):
        points, faces = read_off(MESHES / "elephant.off")
        page = self.page(MESHES / "elephant.off")
        self.assertGreater(len(page.triangles), len(faces))
        self.assertEqual(len(page.piece_of_face), len(faces))
        plain = self.page(MESHES / "elephant.off", "--keep-faces")
        surfaces = [sum(area(p.points, t) for t in p.triangles) for p in (page, plain)]
        self.assertAlmostEqual(surfaces[0] / surfaces[1], 1, places=3)
        lengths = [self.boundary_length(p) for p in (page, plain)]
        self.assertLess(lengths[0], 0.95 * lengths[1])

    def boundary_length(self, page):
        return page.unit * sum(math.dist(*edge) for edge in
                               page.boundaries(page.points, page.triangles, page.pieces))

    def test_boundaries_equal_boundaries_of_meshes(self):
        """The page has them at the number of segments that is shown first."""
        for name, *options in [("cow.off",), ("bear.off", "--segments", "5")]:
            with self.subTest(name=name):
                page = self.page(MESHES / name, *options, "-o", "out.ply")
                segments = page.segments(page.data["segments"])
                ply = read_ply(self.directory / "out.ply")
                self.assertTrue(page.boundaries(page.points, page.triangles,
                                                [segments[piece] for piece in page.pieces]) ==
                                page.boundaries(ply.points, ply.faces, ply.segments))

    def test_pieces_stay(self):
        """Pieces stay that the boundaries of segments would remove. The surfaces are closed."""
        for name in ("anchor.off", "cross.off", "elephant.off"):
            with self.subTest(name=name):
                page = self.page(MESHES / name)
                self.assertEqual(set(page.pieces), set(page.piece_of_face))
                edges = collections.Counter(frozenset((t[i - 1], t[i])) for t in page.triangles
                                            for i in range(3))
                self.assertEqual(set(edges.values()), {2})

    def test_labels(self):
        page = self.check_labels(MESHES / "elephant.off", (1, 2, 7, 12, 20))
        self.assertEqual(page.number_of_segments(), 20)
        self.assertEqual(page.data["exceptions"], {})
        self.check_equal(page.labels(page.data["segments"]),
                         self.labels(MESHES / "elephant.off"))

    def test_more_segments_than_by_default(self):
        page = self.page(MESHES / "elephant.off", "--segments", "40")
        self.assertEqual(page.number_of_segments(), 40)
        self.assertEqual(page.data["segments"], 40)
        self.check_equal(page.labels(40), self.labels(MESHES / "elephant.off", "--segments", 40))

    def test_report_has_same_cuts(self):
        report = json.loads(self.output(MESHES / "elephant.off", "--json", "-", "--quiet"))
        page = self.page(MESHES / "elephant.off")
        tree = report["hierarchy"]["nodes"]
        for i, node in enumerate(page.cuts):
            self.assertEqual(tree[node]["children"], [1 + 2 * i, 2 + 2 * i])
            self.assertAlmostEqual(tree[node]["salience"],
                                   page.data["hierarchy"]["saliences"][i])
        self.assertEqual(page.data["hierarchy"]["areas"], [node["area"] for node in tree])

    def test_method_of_paper(self):
        page = self.page(MESHES / "elephant.off", "--method", "paper", "--segments", "6")
        self.assertEqual(page.data["salience"], "salience")
        self.check_equal(page.labels(4), self.labels(MESHES / "elephant.off", "--method", "paper",
                                                     "--segments", "4"))

    def test_polygons(self):
        """Polygons that boundaries cut, and one without area, whose label is borrowed. A hexagon
        spans the thinnest ring, at the middle of the neck."""
        points, faces = dumbbell()
        around = 16
        start = lambda z, i: 1 + z * around + i % around
        sides = [(start(z, i), start(z, i + 1), start(z + 1, i + 1), start(z + 2, i + 1),
                  start(z + 2, i), start(z + 1, i))
                 for z in range(1, 15, 2) for i in range(around)]
        sides += [(start(z, i), start(z, i + 1), start(z + 1, i + 1), start(z + 1, i))
                  for z in (0, 15) for i in range(around)]
        ends = [face for face in faces if 0 in face or len(points) - 1 in face]
        path = self.directory / "polygons.off"
        write_off(path, points, [(40, 40, 40)] + sides + ends)
        page = self.check_labels(path, (1, 2, 3, 6, 8))
        self.assertTrue(any(e["faces"] for e in page.data["exceptions"].values()))

    def test_components(self):
        points, faces = dumbbell()
        path = self.directory / "two.off"
        write_off(path, points + [(x + 30, y, z) for x, y, z in points],
                  faces + [tuple(v + len(points) for v in f) for f in faces])
        page = self.check_labels(path, (2, 3, 4), "--keep-components-separate")
        self.assertEqual(page.roots, 2)
        page = self.check_labels(path, (1, 2, 3))
        self.assertIsNone(page.data["hierarchy"]["saliences"][0]) # infinite

    def test_large_mesh_is_simplified(self):
        """Returns a tube of 320,000 faces; the area is that of a cylinder with two cones."""
        around, rings = 400, 400
        length = 6 * math.pi
        points, faces = tube([1.] * rings, around)
        points = [(x, y, z * length / rings) for x, y, z in points]
        path = self.directory / "tube.off"
        write_off(path, points, faces)
        page = self.page(path)
        self.assertEqual(len(page.piece_of_face), len(faces))
        self.assertEqual(page.data["input_triangles"], len(faces))
        self.assertLessEqual(len(page.triangles), 300000)
        self.assertGreater(len(page.triangles), 100000)
        exact = 2 * math.pi * length * (rings - 1) / rings + 2 * math.pi
        surface = sum(area(page.points, t) for t in page.triangles)
        self.assertAlmostEqual(surface / exact, 1, delta=0.01)
        self.check_equal(page.labels(3), self.labels(path, "--segments", 3))

    def test_page_needs_no_network(self):
        text = self.page(MESHES / "elephant.off").text
        self.assertNotRegex(text.split('id="data"')[0], "(src|href)=\"(?!data:)|@import|url\\(")
        self.assertNotRegex(text, "<script[^>]* src=|<link[^>]* href=\"http")
        self.assertLess(len(text), 2000000)

    def test_size_for_20000_faces(self):
        points, faces = tube([2 + math.sin(0.2 * i) for i in range(100)], 100)
        path = self.directory / "tube.off"
        write_off(path, points, faces)
        self.assertGreater(len(faces), 19900)
        self.assertLess(len(self.page(path).text), 2000000)

    def test_name_is_no_markup(self):
        path = self.directory / "a<b>&<script>.off"
        write_off(path, *dumbbell())
        page = self.page(path)
        self.assertEqual(page.data["name"], path.name)
        self.assertEqual(page.text.count("<script"), 4)
        self.assertIn("<title>a&lt;b>&amp;&lt;script>.off</title>", page.text)

    def test_output(self):
        path = self.directory / "mesh.off"
        write_off(path, *dumbbell())
        self.output(path, "--html", "page.html", "--quiet")
        self.assertTrue((self.directory / "page.html").read_text().startswith("<!DOCTYPE html>"))
        self.assertEqual(len(list(self.directory.iterdir())), 2)
        usage, output = 2, 7 # the statuses
        for status, options, reason in [
                (usage, ("--html", "a", "--labels", "a"), "two outputs have the name a"),
                (usage, ("--html", "-", "--json", "-"), "two outputs have the name -"),
                (usage, ("--html", "mesh.off"), "mesh.off is the input"),
                (output, ("--html", "none/a.html"), "there is no directory none"),
                (usage, ("--html", "a", "--out-dir", "b"), "choose the outputs with --outputs")]:
            with self.subTest(options=options):
                result = self.run_tool("mesh.off", *options)
                self.assertEqual(result.returncode, status)
                self.assertIn(reason, result.stderr)
        self.assertEqual(len(list(self.directory.iterdir())), 2)

    def test_batch(self):
        write_off(self.directory / "mesh.off", *dumbbell())
        self.output("mesh.off", "--out-dir", "out", "--outputs", "html", "--quiet")
        page = Page((self.directory / "out/mesh.off.html").read_text())
        self.assertEqual(page.data["name"], "mesh.off")
        self.assertEqual(page.labels(2), self.labels("mesh.off", "--segments", 2))


if __name__ == "__main__":
    TOOL = pathlib.Path(sys.argv.pop(1)).resolve()
    MESHES = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
