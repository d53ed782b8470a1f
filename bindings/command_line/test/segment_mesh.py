#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the command line tool: segment_mesh.py TOOL MESHES, with the directory of CGAL's meshes."""

import base64
import collections
import contextlib
import itertools
import json
import math
import os
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "test/helpers"))
from mesh_files import (read_3mf, read_glb, read_obj, read_obj_rows, read_off, read_ply,
                        read_ply_rows, write_ascii_stl, write_binary_stl, write_off)
from meshes import area, cross, dot, dumbbell, is_closed, minus, volume

TOOL = None
MESHES = None

STATUSES = ["ok", "bug", "usage", "input", "mesh", "memory", "time", "output", "some failed"]


class Tool_test(unittest.TestCase):

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def run_tool(self, *arguments):
        """Runs the tool, with one search unless it is asked for more, which take longer."""
        number = [] if "--searches" in arguments else ["--searches", "1"]
        return subprocess.run([TOOL, *number, *map(str, arguments)], cwd=self.directory, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=300, check=False)

    def segment(self, mesh, *arguments):
        """Returns the labels of a run without errors, which also writes out.ply, with the faces of
        the mesh, and out.json."""
        done = self.run_tool(mesh, "-o", "out.ply", "--labels", "out.seg", "--json", "out.json",
                             "--keep-faces", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), mesh)
        return self.labels()

    def labels(self):
        return [int(line) for line in (self.directory / "out.seg").read_text().splitlines()]

    def ply(self):
        return read_ply(self.directory / "out.ply")

    def nodes_of_glb(self):
        return read_glb((self.directory / "out.glb").read_bytes())[0]["nodes"]

    def report(self):
        return json.loads((self.directory / "out.json").read_text())

    def assert_same_parts(self, labels, expected):
        """Checks that the partitions are equal, however the segments are numbered."""
        self.assertEqual(len(labels), len(expected))
        pairs = set(zip(labels, expected))
        self.assertEqual(len(pairs), len(set(labels)))
        self.assertEqual(len(pairs), len(set(expected)))

    def write_off(self, points, faces, name="in.off"):
        write_off(self.directory / name, points, faces)
        return name

    def assert_failure(self, status, *arguments, message=""):
        before = sorted(self.directory.rglob("*"))
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, STATUSES.index(status), arguments)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"\Asegment_mesh: .+\n\Z")
        self.assertIn(message, done.stderr)
        self.assertEqual(sorted(self.directory.rglob("*")), before, arguments)


class Real_meshes(Tool_test):

    def test_outputs_agree(self):
        for name in ("elephant.off", "bones.off", "hand.off", "blobby_3cc.off", "mushroom.off"):
            with self.subTest(name):
                points, faces = read_off(MESHES / name)
                labels = self.segment(MESHES / name)
                ply, report = self.ply(), self.report()
                number = max(labels) + 1
                self.assertEqual(set(labels), set(range(number)))
                self.assertEqual(report["segments"], number)
                self.assertEqual(report["input_faces"], len(faces))
                self.assertEqual(report["faces"], len(ply.faces))
                self.assertEqual(report["vertices"], len({v for f in faces for v in f}))
                self.assertEqual(ply.segments, labels)
                self.assertEqual(len(set(zip(ply.segments, ply.colors))), number)
                self.assertEqual(len(set(ply.colors)), number)
                for face, written in zip(faces, ply.faces):
                    self.assertEqual([points[v] for v in face], [ply.points[v] for v in written])

    def test_tree_has_the_segments(self):
        labels = self.segment(MESHES / "elephant.off", "--method", "paper")
        points, faces = read_off(MESHES / "elephant.off")
        report = self.report()
        nodes = report["hierarchy"]["nodes"]
        leaves = [n for n in nodes if not n["children"]]
        self.assertEqual(sorted(n["faces"] for n in leaves),
                         sorted(collections.Counter(labels).values()))
        for i, node in enumerate(nodes):
            self.assertEqual(node["id"], i)
            self.assertEqual(node["cut_state"] == "cut", bool(node["children"]))
            for child in node["children"]:
                self.assertEqual(nodes[child]["parent"], i)
            if node["children"]:
                parts = [nodes[child] for child in node["children"]]
                self.assertEqual(sum(n["faces"] for n in parts), node["faces"])
                self.assertAlmostEqual(sum(n["area"] for n in parts) / node["area"], 1)
            if node["factors"]:
                factors = node["factors"]
                self.assertAlmostEqual(node["salience"],
                                       0.1 * factors["size"] + 0.6 * factors["cut_strength"] +
                                       0.3 * factors["protrusiveness"])
                self.assertEqual(node["salience"] >= report["parameters"]["salience_threshold"],
                                 node["cut_state"] == "cut")
        whole = sum(area(points, face) for face in faces)
        self.assertAlmostEqual(nodes[0]["area"] / whole, 1)

    def test_tree_has_the_probability_of_each_cut(self):
        labels = self.segment(MESHES / "elephant.off")
        report = self.report()
        self.assertEqual(report["parameters"]["method"], "calibrated")
        cuts = [n for n in report["hierarchy"]["nodes"] if n["children"]]
        # of about 20 regions
        self.assertGreaterEqual(len(cuts), 16)
        self.assertLessEqual(len(cuts), 22)
        for node in cuts:
            self.assertTrue(0 <= node["salience"] <= 1)
            self.assertGreater(node["factors"]["expansion_behind_cut"], 0)
        made = [n for n in cuts
                if n["salience"] >= report["parameters"]["salience_threshold"]]
        self.assertEqual(len(made), max(labels))
        self.assertEqual([n for n in cuts if n["is_applied"]], made)
        self.assertEqual(self.segment(MESHES / "elephant.off", "--method", "calibrated"), labels)

    def test_segments_are_described(self):
        labels = self.segment(MESHES / "elephant.off", "--hierarchy", "out.hierarchy.json")
        points, faces = read_off(MESHES / "elephant.off")
        hierarchy = json.loads((self.directory / "out.hierarchy.json").read_text())
        del hierarchy["text"]
        leaf_of_face = hierarchy.pop("leaf_of_face")
        self.assertEqual(hierarchy, self.report()["hierarchy"])
        segments, nodes = hierarchy["segments"], hierarchy["nodes"]
        self.assertEqual(len(segments), max(labels) + 1)

        segment_of_node = {s["node"]: s["id"] for s in segments}
        for label, leaf in zip(labels, leaf_of_face):
            self.assertEqual(nodes[leaf]["children"], [])
            while leaf not in segment_of_node:
                leaf = nodes[leaf]["parent"]
            self.assertEqual(segment_of_node[leaf], label)

        segments_at_edge = collections.defaultdict(set)
        for face, label in zip(faces, labels):
            for i in range(3):
                segments_at_edge[frozenset((face[i - 1], face[i]))].add(label)
        for k, segment in enumerate(segments):
            part = [face for face, label in zip(faces, labels) if label == k]
            corners = [points[v] for face in part for v in face]
            self.assertEqual(segment["id"], k)
            self.assertEqual(segment["faces"], len(part))
            self.assertAlmostEqual(segment["area"] / sum(area(points, f) for f in part), 1)
            self.assertEqual(segment["bounding_box"],
                             [[bound(axis) for axis in zip(*corners)] for bound in (min, max)])
            self.assertEqual(segment["neighbors"],
                             sorted(set().union(*(s for s in segments_at_edge.values()
                                                  if k in s)) - {k}))

    def test_defaults_follow_the_method(self):
        manual = (pathlib.Path(__file__).parents[3] / "include" / "CGAL" /
                  "segment_spectral_recursive.h").read_text()
        probability = float(re.search(r"default_probability_threshold`, `([\d.]+)`",
                                      manual).group(1))
        for method, threshold, size in (("calibrated", probability, 0.003),
                                        ("paper", 0.54, 0.005)):
            self.segment(MESHES / "hand.off", "--method", method)
            parameters = self.report()["parameters"]
            self.assertEqual(parameters["method"], method)
            self.assertEqual(parameters["salience_threshold"], threshold)
            self.assertEqual(parameters["minimum_segment_size"], size)
        self.segment(MESHES / "hand.off", "--method", "paper", "--minimum-segment-size", 0)
        self.assertEqual(self.report()["parameters"]["minimum_segment_size"], 0)

    def test_seconds(self):
        self.segment(MESHES / "elephant.off", "--threads", 1)
        seconds = self.report()["seconds"]
        total = seconds.pop("total")
        phases = {name: seconds.pop(name)
                  for name in ("reading", "joining", "segmentation", "writing")}
        self.assertLessEqual(sum(phases.values()), total)
        self.assertTrue(all(s > 0 for s in phases.values()))
        self.assertEqual(set(seconds), {"initialization", "sampling", "embedding",
                                        "line_search", "merging", "projection"})
        self.assertTrue(all(s >= 0 for s in seconds.values()))
        self.assertLessEqual(sum(seconds.values()), phases["segmentation"])

    def test_number_of_segments(self):
        for method in ("calibrated", "paper"):
            for n in (1, 2, 7, 40):
                self.segment(MESHES / "elephant.off", "--method", method, "--segments", n)
                self.assertEqual(self.report()["segments"], n)
        threshold = ("--salience-threshold", 0.7)
        labels = self.segment(MESHES / "elephant.off", "--maximum-segments", 15, *threshold)
        self.assertLess(self.report()["segments"], 15)
        self.assertTrue(labels == self.segment(MESHES / "elephant.off", *threshold))
        self.segment(MESHES / "elephant.off", "--maximum-segments", 5)
        self.assertEqual(self.report()["segments"], 5)

    def test_every_run_is_the_same(self):
        for options in ((), ("--seed", 5), ("--smooth", 2)):
            labels = self.segment(MESHES / "elephant.off", "--threads", 1, *options)
            for threads in (1, 2):
                if threads == 2 and "without TBB" in self.run_tool(
                        MESHES / "elephant.off", "--threads", 2).stderr:
                    self.skipTest("the tool was built without TBB")
                again = self.segment(MESHES / "elephant.off", "--threads", threads, *options)
                self.assertEqual(again, labels, (threads, options))

    def test_options_reach_the_function(self):
        plain = self.segment(MESHES / "elephant.off")
        for options in (("--seed", 5), ("--smooth", 10)):
            self.assertNotEqual(self.segment(MESHES / "elephant.off", *options), plain, options)

    def test_refined_boundaries(self):
        plain = self.segment(MESHES / "elephant.off")
        ply = self.ply()
        input_faces = [[ply.points[v] for v in face] for face in ply.faces]
        self.assertIs(self.report()["parameters"]["keep_faces"], True)
        done = self.run_tool(MESHES / "elephant.off", "-o", "refined.ply", "--labels",
                             "refined.seg", "--json", "refined.json", "--split-dir", "refined")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        labels = [int(line) for line in (self.directory / "refined.seg").read_text().split()]
        self.assertEqual(labels, plain) # of the faces of the input
        refined = read_ply(self.directory / "refined.ply")
        self.assertGreater(len(refined.faces), len(input_faces))
        self.assertEqual(set(refined.segments), set(plain))
        files = sorted((self.directory / "refined").glob("*.ply"))
        areas = [0.] * len(input_faces)
        same_label = 0
        for i, file in enumerate(files):
            part = read_ply(file)
            self.assertEqual(len(part.faces), refined.segments.count(i))
            for face, row in zip(part.faces, read_ply_rows(file)["face"]):
                areas[row["face"]] += area(part.points, face)
                same_label += plain[row["face"]] == i
        self.assertGreater(same_label / len(refined.faces), 0.9)
        for whole, face in zip(areas, input_faces):
            self.assertAlmostEqual(whole, area(face, range(len(face))))
        report = json.loads((self.directory / "refined.json").read_text())
        self.assertIs(report["parameters"]["keep_faces"], False)
        self.assertEqual(report["faces"], len(input_faces))

    def assert_tree_of_cuts(self, nodes, children, root):
        """The nodes, by a name, are the nodes of the report's tree that the labels come from."""
        tree = self.report()["hierarchy"]["nodes"]
        sizes = collections.Counter("segment_%03d" % label for label in self.labels())
        seen = []

        def number_of_faces(name):
            seen.append(name)
            if name in sizes:
                self.assertEqual(children[name], [])
                return sizes[name]
            node = tree[int(name[5:])]
            numbers = [number_of_faces(child) for child in children[name]]
            self.assertEqual(numbers, [tree[i]["faces"] for i in node["children"]])
            for child in children[name]:
                if child.startswith("part_"):
                    self.assertIn(int(child[5:]), node["children"])
            return sum(numbers)

        self.assertEqual(number_of_faces(root), len(self.labels()))
        self.assertEqual(sorted(seen), sorted(nodes))
        self.assertEqual(len([name for name in seen if name.startswith("segment_")]), len(sizes))

    def test_nodes_are_the_cuts(self):
        for options in ((), ("--method", "paper"), ("--segments", 25), ("--close",),
                        ("--close", "--keep-faces")):
            self.segment(MESHES / "elephant.off",
                         *(o for o in options if o not in ("--close", "--keep-faces")))
            done = self.run_tool(MESHES / "elephant.off", "-o", "out.glb", *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            nodes = self.nodes_of_glb()
            names = [n["name"] for n in nodes]
            children = {n["name"]: [names[i] for i in n.get("children", [])] for n in nodes}
            self.assertEqual(names[0], "segments")
            self.assertEqual(children["segments"], ["part_000"])
            self.assert_tree_of_cuts(names[1:], children, "part_000")
            self.assertEqual([n["mesh"] for n in nodes if n["name"].startswith("segment_")],
                             list(range(len(set(self.labels())))))

    def test_nodes_of_components(self):
        for mesh, options, top in (("blobby_3cc.off", ("--keep-components-separate",), 3),
                                   ("elephant.off", (), 1)):
            labels = self.segment(MESHES / mesh, *options)
            done = self.run_tool(MESHES / mesh, "-o", "out.glb", *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            nodes = self.nodes_of_glb()
            self.assertEqual(len(nodes[0]["children"]), top)
            self.assertEqual(sorted(n["name"] for n in nodes if "mesh" in n),
                             ["segment_%03d" % i for i in range(max(labels) + 1)])

    def write_3mf(self, mesh, *options):
        done = self.run_tool(mesh, "--keep-faces", "-o", "out.3mf", *options)
        if "lib3mf" in done.stderr:
            self.assertEqual(done.returncode, STATUSES.index("usage"))
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertFalse((self.directory / "out.3mf").exists())
            self.skipTest("the tool was built without lib3mf")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return read_3mf(self.directory / "out.3mf")

    def test_3mf(self):
        points, faces = read_off(MESHES / "elephant.off")
        labels = self.segment(MESHES / "elephant.off")
        colors = dict(zip(labels, self.ply().colors))
        objects, built = self.write_3mf(MESHES / "elephant.off")
        content = (self.directory / "out.3mf").read_bytes()
        self.write_3mf(MESHES / "elephant.off")
        self.assertEqual((self.directory / "out.3mf").read_bytes(), content)

        by_name = {o.name: o for o in objects.values()}
        self.assertEqual(len(by_name), len(objects))
        self.assertEqual([objects[i].name for i in built], ["part_000"])
        self.assert_tree_of_cuts(
            list(by_name), {o.name: [objects[i].name for i in o.components]
                            for o in objects.values()}, "part_000")
        for label in set(labels):
            part = by_name["segment_%03d" % label]
            self.assertEqual((part.type, part.color), ("surface", colors[label]))
            corners = [[points[v] for v in f] for f, l in zip(faces, labels) if l == label]
            self.assertEqual(len(part.triangles), len(corners))
            self.assertEqual({v for t in part.triangles for v in t}, set(range(len(part.points))))
            for triangle, face in zip(part.triangles, corners):
                for v, p in zip(triangle, face):
                    for x, y in zip(part.points[v], p):
                        self.assertAlmostEqual(x, y, delta=2e-6)

    def test_closed_3mf(self):
        labels = self.segment(MESHES / "elephant.off")
        objects, built = self.write_3mf(MESHES / "elephant.off", "--close")
        parts = [o for o in objects.values() if o.triangles]
        self.assertEqual(sorted(o.name for o in parts),
                         ["segment_%03d" % i for i in range(max(labels) + 1)])
        for part in parts:
            self.assertEqual(part.type, "model")
            self.assertTrue(is_closed(part.triangles), part.name)
            self.assertEqual({v for t in part.triangles for v in t}, set(range(len(part.points))))

    def test_3mf_of_parts(self):
        self.segment(MESHES / "hand.off")
        objects, _ = self.write_3mf(MESHES / "hand.off", "--split-dir", "parts", "--split-format",
                                    "3mf")
        for whole in objects.values():
            if whole.triangles:
                parts, built = read_3mf(self.directory / "parts" / (whole.name + ".3mf"))
                self.assertEqual([parts[i] for i in built], [whole])
                self.assertEqual(len(parts), 1)

    def test_own_3mf_is_read(self):
        labels = self.segment(MESHES / "elephant.off")
        self.write_3mf(MESHES / "elephant.off")
        again = self.segment("out.3mf")
        self.assertEqual(len(again), len(labels))
        points, faces = read_off(MESHES / "elephant.off")
        ply = self.ply()
        surfaces = [sorted(area(p, face) for face in f) for p, f in
                    ((points, faces), (ply.points, ply.faces))]
        for given, read in zip(*surfaces):
            self.assertAlmostEqual(given, read, places=6)
        (self.directory / "bad.3mf").write_bytes((self.directory / "out.3mf").read_bytes()[:5000])
        self.assert_failure("mesh", "bad.3mf", "--labels", "x", message="cannot be read")

    def test_coordinates_beyond_the_numbers_of_a_format(self):
        stl = ("--split-dir", "parts", "--split-format", "stl")
        for mesh, factor, output, message in (
                ("elephant.off", 1e40, stl, "too large for the numbers of STL"),
                ("hand.off", 1e12, ("-o", "a.3mf"), "too large for the numbers of 3MF"),
                ("elephant.off", 1e-7, ("-o", "a.3mf"), "too small for")):
            points, faces = read_off(MESHES / mesh)
            self.write_off([tuple(factor * x for x in p) for p in points], faces)
            if "a.3mf" in output:
                self.write_3mf(MESHES / mesh) # which skips the test without lib3mf
            self.assert_failure("output", "in.off", *output, message=message)

    def test_faces_that_point_inward(self):
        """A closed mesh has the same parts if all or some of its faces are turned around."""
        points, faces = read_off(MESHES / "elephant.off")
        turned = [face[::-1] for face in faces]
        labels = [self.segment(self.write_off(points, given))
                  for given in (faces, turned, faces[:1] + turned[1:])]
        self.assertEqual(labels[0], labels[1])
        self.assertEqual(labels[0], labels[2])

    def test_obj_needs_a_name_in_one_line(self):
        self.assert_failure("usage", MESHES / "elephant.off", "-o", "a\nb.obj",
                            message="line break")

    def test_closed_parts_fill_the_mesh(self):
        points, faces = read_off(MESHES / "elephant.off")
        for options in ((), ("--keep-faces",)):
            done = self.run_tool(MESHES / "elephant.off", "--close", "--split-dir", "parts",
                                 "--labels", "labels", *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            labels = (self.directory / "labels").read_text().split()
            self.assertEqual(len(labels), len(faces))
            volumes = []
            for file in sorted((self.directory / "parts").glob("*.ply")):
                part = read_ply(file)
                self.assertTrue(is_closed(part.faces), file)
                volumes.append(volume(part.points, part.faces))
                self.assertGreater(volumes[-1], 0)
            self.assertEqual(len(volumes), len(set(labels)))
            self.assertAlmostEqual(sum(volumes) / volume(points, faces), 1, places=9)

    def test_split_files_have_all_faces(self):
        labels = self.segment(MESHES / "elephant.off", "--split-dir", "parts")
        ply = self.ply()
        corners = collections.defaultdict(list)
        for face, label in zip(ply.faces, ply.segments):
            corners[label].append([ply.points[v] for v in face])
        files = sorted((self.directory / "parts").glob("*.ply"))
        self.assertEqual([f.name for f in files],
                         ["segment_%03d.ply" % i for i in range(max(labels) + 1)])
        for i, file in enumerate(files):
            part = read_ply(file)
            self.assertEqual([[part.points[v] for v in face] for face in part.faces], corners[i])

    def test_polygons(self):
        for name in ("cube_quad.off", "cube_poly.off", "torus_quad.off"):
            points, faces = read_off(MESHES / name)
            labels = self.segment(MESHES / name)
            ply = self.ply()
            self.assertEqual(len(labels), len(faces))
            self.assertEqual(labels, ply.segments)
            self.assertEqual([len(f) for f in ply.faces], [len(f) for f in faces])
            self.assertEqual(self.report()["faces"], sum(len(f) - 2 for f in faces))
            if self.report()["segments"] == 1:
                self.assertEqual(set(labels), {0})

    def test_other_formats(self):
        for name in ("pig.stl", "sphere.ply", "dino.off"):
            self.assertEqual(len(self.segment(MESHES / name)), self.report()["input_faces"])
        points, faces = read_off(MESHES / "hand.off")
        expected = self.segment(MESHES / "hand.off")
        obj = ["v %r %r %r" % p for p in points]
        obj += ["f " + " ".join(str(v + 1) for v in f) for f in faces]
        (self.directory / "hand.OBJ").write_text("\n".join(obj))
        self.assertEqual(self.segment("hand.OBJ"), expected)
        (self.directory / "out.ply").rename(self.directory / "hand.ply")
        self.assertEqual(self.segment("hand.ply"), expected)


class Formats(Tool_test):

    def setUp(self):
        super().setUp()
        points, self.faces = read_off(MESHES / "hand.off")
        # Numbers that float has too, so that all formats mean the same points.
        self.points = [struct.unpack("3f", struct.pack("3f", *p)) for p in points]
        self.expected = self.segment(self.write_off(self.points, self.faces))
        self.assertGreater(max(self.expected), 1)

    def test_standard_input_and_output(self):
        for name in ("in.off", "out.ply"):
            done = subprocess.run([TOOL, "--searches", "1", "-", "--labels", "-"],
                                  cwd=self.directory, capture_output=True, timeout=300, check=False,
                                  input=(self.directory / name).read_bytes())
            self.assertEqual(done.returncode, 0, name)
            self.assertEqual([int(line) for line in done.stdout.split()], self.expected)

    def test_contents_determine_the_format(self):
        content = (self.directory / "in.off").read_bytes()
        for name in ("in.ply", "in.fbx", "in.xyz", "in"):
            (self.directory / name).write_bytes(content)
            self.assertEqual(self.segment(name), self.expected)
        (self.directory / "in.obj").write_bytes(b"glTF")
        self.assert_failure("mesh", "in.obj", message="it is binary glTF, which is read only from")

    @unittest.skipUnless(hasattr(os, "mkfifo"), "this system has no named pipes")
    def test_named_pipe(self):
        os.mkfifo(self.directory / "pipe")
        with subprocess.Popen([TOOL, "--searches", "1", "pipe", "--labels", "-", "--quiet"],
                              cwd=self.directory, stdout=subprocess.PIPE) as run:
            (self.directory / "pipe").write_bytes((self.directory / "in.off").read_bytes())
            self.assertEqual([int(line) for line in run.stdout], self.expected)

    def test_written_formats(self):
        for name in ("out.ply", "out.obj", "out.GLB", "out.off"):
            done = self.run_tool("in.off", "--keep-faces", "-o", name)
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            self.assertTrue((self.directory / name).exists(), name)
        self.assert_same_parts(self.segment("out.off"), self.expected)

    def test_several_outputs(self):
        """One run has several outputs, also in the directory of segments."""
        (self.directory / "parts").mkdir()
        done = self.run_tool("in.off", "-o", "out.ply", "-o", "out.obj", "--split-dir", "parts",
                             "--labels", "parts/labels.seg", "--json", "parts/report.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        number = max(self.expected) + 1
        self.assertEqual(len(list((self.directory / "parts").iterdir())), number + 3)
        for name in ("out.ply", "out.obj", "out.mtl", "parts/labels.seg", "parts/report.json"):
            self.assertTrue((self.directory / name).exists(), name)
        done = self.run_tool("in.off", "--out-dir", "out", "--outputs", "ply,glb")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(sorted(p.name for p in (self.directory / "out").iterdir()),
                         [".lock", "in.off.glb", "in.off.json", "in.off.ply",
                          "parameters.json", "table.jsonl"])

    def test_caps_have_no_face_of_the_input(self):
        done = self.run_tool("in.off", "--close", "--keep-faces", "--split-dir", "parts", "-o",
                             "plain.ply")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(read_ply(self.directory / "plain.ply").faces), len(self.faces))
        numbers = []
        for i in range(max(self.expected) + 1):
            rows = read_ply_rows(self.directory / "parts" / ("segment_%03d.ply" % i))["face"]
            numbers += [row["face"] for row in rows if row["face"] >= 0]
            is_cap = [row["face"] == -1 for row in rows]
            self.assertEqual(is_cap, sorted(is_cap)) # they come last
            self.assertIn(True, is_cap)
        self.assertEqual(sorted(numbers), list(range(len(self.faces))))

    def test_closed_segments_are_reported(self):
        # Two tetrahedra that intersect, as one segment
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        points += [tuple(x + 0.2 for x in p) for p in points]
        faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
        faces += [tuple(v + 4 for v in face) for face in faces]
        write_off(self.directory / "two.off", points, faces)
        for name, is_solid in (("in.off", True), ("two.off", False)):
            done = self.run_tool(name, "--close", "--split-dir", "parts", "--json", "report.json",
                                 "--segments", 1 if name == "two.off" else 4)
            self.assertEqual(done.returncode, 0)
            self.assertEqual("bounds no solid: 0 (intersects itself)" in done.stderr, not is_solid)
            told = json.loads((self.directory / "report.json").read_text())["closed_segments"]
            index = json.loads((self.directory / "parts/segments.json").read_text())
            self.assertEqual(told, index["closed_segments"])
            self.assertEqual([s["label"] for s in told], list(range(len(told))))
            self.assertEqual({s["is_solid"] for s in told}, {is_solid})
            self.assertEqual({s["has_self_intersections"] for s in told}, {not is_solid})

    def test_intersections_of_the_input_are_counted(self):
        tetrahedron = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
        large = [(-10, -10, 0), (0, 10, 0), (10, -10, 0), (0, 0, -20)]
        spike = [(-1, -1, 5), (1, -1, 5), (0, 1, 5), (0, 0, -1)] # three sides pass through a face
        beside = [(x, y, 1 - z) for x, y, z in large] # touches nothing
        mirrored = [large[0], large[1], (-20, 0, 20), (-20, 0, 5)] # has an edge in common
        at_edge = [(0, 4, 1), (0, 1, 5), (1, 4, 5), (0, 5, 4)]
        repeated = [face if i < 4 else tuple(v + 4 for v in face)
                    for i, face in enumerate(2 * tetrahedron)]
        for points, faces, pairs in (
                (large + spike, repeated, 3), (large + beside, repeated, 0),
                (large + mirrored, repeated, 0),
                (large + mirrored[2:], tetrahedron + at_edge, 0)):
            write_off(self.directory / "two.off", points, faces)
            done = self.run_tool("two.off", "--close", "--split-dir", "parts", "--json",
                                 "out.json", "--segments", 1)
            self.assertEqual(done.returncode, 0)
            self.assertEqual(self.report()["intersecting_pairs"], pairs)
            first = done.stderr.split("\n")[0]
            self.assertEqual("warning: two.off: the input intersects itself in 3 pairs of faces; "
                             in first, pairs == 3, first)
        self.run_tool("in.off", "--json", "out.json")
        self.assertIsNone(self.report()["intersecting_pairs"])

    def test_closing_needs_separate_segments(self):
        for options in ((), ("-o", "out.ply")):
            self.assert_failure("usage", "in.off", "--close", *options,
                                message="--close needs an output of separate segments")
        done = self.run_tool("in.off", "--close", "-o", "out.glb")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_unit_and_scale(self):
        def extent(points):
            return [max(x) - min(x) for x in zip(*points)]

        def extent_of(*arguments):
            done = self.run_tool("in.off", "--keep-faces", *arguments)
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
            name = self.directory / arguments[1]
            if name.suffix == ".ply":
                return extent(read_ply(name).points)
            if name.suffix == ".3mf":
                return extent([p for o in read_3mf(name)[0].values() for p in o.points])
            accessors = read_glb(name.read_bytes())[0]["accessors"]
            return extent([a[end] for a in accessors if "min" in a for end in ("min", "max")])

        def check(factor, *arguments):
            for x, expected in zip(extent_of(*arguments), extent(self.points)):
                self.assertAlmostEqual(x / expected, factor, delta=1e-5 * factor)

        check(1, "-o", "out.glb")
        check(0.0254, "-o", "out.glb", "--unit", "in")
        check(1, "-o", "out.ply", "-o", "out.glb", "--unit", "in")
        check(3, "-o", "out.ply", "--scale", "3", "--labels", "out.seg", "--json", "out.json")
        self.assertEqual(self.labels(), self.expected)
        self.assertEqual(self.report()["parameters"]["scale"], 3)
        check(3, "-o", "out.glb", "--unit", "mm", "--scale", "3000")
        for options, message in ((("--unit", "in"), "--unit needs an output that has a unit"),
                                  (("-o", "a.glb", "--unit", "yard"), "--unit"),
                                  (("-o", "a.glb", "--scale", "0"), "--scale"),
                                  (("-o", "a.glb", "--scale", "nan"), "--scale")):
            self.assert_failure("usage", "in.off", *options, message=message)
        if "lib3mf" not in self.run_tool("in.off", "-o", "out.3mf").stderr:
            check(1, "-o", "out.3mf")
            check(25.4, "-o", "out.3mf", "--unit", "in")
            check(500, "-o", "out.3mf", "--unit", "m", "--scale", "0.5")

    def test_3mf_needs_lib3mf(self):
        done = self.run_tool("in.off", "-o", "out.3mf", "--split-dir", "parts", "--split-format",
                             "3mf")
        if done.returncode == 0:
            self.skipTest("the tool was built with lib3mf")
        for options in (("-o", "new.3mf"), ("--split-dir", "parts", "--split-format", "3mf")):
            self.assert_failure("usage", "in.off", *options, message="lib3mf")

    def test_formats_of_parts(self):
        for form in ("ply", "obj", "off", "stl", "glb"):
            done = self.run_tool("in.off", "--split-dir", "parts", "--split-format", form)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            names = sorted(p.name for p in (self.directory / "parts").iterdir())
            self.assertEqual(names, ["segment_%03d.%s" % (i, form)
                                     for i in range(max(self.expected) + 1)] + ["segments.json"])

    def test_hulls(self):
        done = self.run_tool("in.off", "--hulls", "hulls", "--split-dir", "parts", "--json",
                             "out.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = self.report()["hulls"]
        self.assertEqual(len(report), max(self.expected) + 1)
        self.assertEqual(sorted(p.name for p in (self.directory / "hulls").iterdir()),
                         ["segment_%03d.obj" % i for i in range(len(report))] + ["segments.json"])
        for i, row in enumerate(report):
            points, faces = read_obj(self.directory / "hulls" / ("segment_%03d.obj" % i))
            part = read_ply(self.directory / "parts" / ("segment_%03d.ply" % i))
            self.assertAlmostEqual(row.pop("volume") / volume(points, faces), 1)
            self.assertEqual(row, {"label": i, "vertices": len(points), "faces": len(faces),
                                   "thickness": 0, "volume_ratio": None})
            self.assertLessEqual(set(points), set(part.points))
            self.assertTrue(is_closed(faces))
            self.assertGreater(volume(points, faces), 0)
            for a, b, c in faces:
                normal = cross(minus(points[b], points[a]), minus(points[c], points[a]))
                length = math.hypot(*normal)
                for p in part.points: # on the inner side of each face
                    self.assertLess(dot(normal, minus(p, points[a])), 1e-9 * length)

    def test_hulls_with_few_vertices(self):
        """They contain their parts, and are hardly larger than the hulls without a limit."""
        for name in ("elephant.off", "camel.off", "fandisk_large.off", "anchor_dense.off"):
            arguments = (MESHES / name, "--keep-faces", "--split-dir", "parts", "--split-format",
                         "obj", "--hulls", "hulls", "--json", "out.json")
            self.run_tool(*arguments)
            full = [row["volume"] for row in self.report()["hulls"]]
            for limit, largest_ratio in ((64, 1.1), (16, 1.4)):
                self.run_tool(*arguments, "--hull-vertices", limit)
                self.assertEqual(self.report()["parameters"]["hull_vertices"], limit)
                for row, volume_without_limit in zip(self.report()["hulls"], full):
                    file = "segment_%03d.obj" % row["label"]
                    points, faces = read_obj(self.directory / "hulls" / file)
                    self.assertLessEqual(len(points), limit)
                    self.assertTrue(is_closed(faces))
                    self.assertLess(1 - 1e-9, row["volume"] / volume_without_limit)
                    self.assertLess(row["volume"] / volume_without_limit, largest_ratio)
                    part, _ = read_obj(self.directory / "parts" / file)
                    size = max(max(c) - min(c) for c in zip(*part))
                    for a, b, c in faces:
                        normal = cross(minus(points[b], points[a]), minus(points[c], points[a]))
                        length = math.hypot(*normal)
                        if length > 1e-10 * size**2: # otherwise it has no plane
                            highest = max(dot(normal, p) for p in part) - dot(normal, points[a])
                            self.assertLess(highest, 1e-9 * size * length)
        for limit in (3, 0, -1):
            self.assert_failure("usage", "in.off", "--hulls", "hulls", "--hull-vertices", limit,
                                message="--hull-vertices: Value %d not in range 4" % limit)
        self.assert_failure("usage", "in.off", "-o", "out.ply", "--hull-vertices", 8,
                            message="--hull-vertices needs --hulls")

    def test_volumes_of_hulls_and_closed_parts(self):
        """The dumbbell has two parts, whose volumes sum up to that of the whole."""
        done = self.run_tool("in.off", "--hulls", "hulls", "--close", "--json", "out.json",
                             "--searches", "5")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = self.report()
        for row, part in zip(report["hulls"], report["closed_segments"]):
            self.assertAlmostEqual(row["volume_ratio"], row["volume"] / part["volume"])
            self.assertGreaterEqual(row["volume_ratio"], 1)
        whole = sum(row["volume"] / row["volume_ratio"] for row in report["hulls"])
        self.assertAlmostEqual(whole / volume(self.points, self.faces), 1)

    def test_hulls_of_flat_parts_have_a_thickness(self):
        self.write_off([(0, 0, 0), (3, 0, 0), (3, 4, 0), (0, 4, 0)], [(0, 1, 2), (0, 2, 3)])
        done = self.run_tool("in.off", "--hulls", "hulls", "--json", "out.json")
        self.assertEqual(done.stderr, "segment_mesh: warning: in.off: flat segments got a hull of "
                                      "the thickness 0.005: 0\n")
        row, = self.report()["hulls"]
        self.assertAlmostEqual(row.pop("volume"), 3 * 4 * 0.005)
        self.assertEqual(row, {"label": 0, "vertices": 8, "faces": 12, "thickness": 0.005,
                               "volume_ratio": None})
        points, faces = read_obj(self.directory / "hulls/segment_000.obj")
        self.assertTrue(is_closed(faces))
        self.assertAlmostEqual(volume(points, faces), 3 * 4 * 0.005)

    def test_formats_of_hulls(self):
        for form in ("ply", "off", "stl", "glb"):
            done = self.run_tool("in.off", "--hulls", "hulls", "--split-format", form)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            names = sorted(p.name for p in (self.directory / "hulls").iterdir())
            self.assertEqual(names, ["segment_%03d.%s" % (i, form)
                                     for i in range(max(self.expected) + 1)] + ["segments.json"])
        self.assert_failure("usage", "in.off", "--hulls", "x", "--split-dir", "./x/",
                            message="two outputs")
        self.run_tool("in.off", "--out-dir", "out", "--outputs", "hulls")
        self.assertTrue((self.directory / "out/in.off.hulls/segment_000.obj").exists())

    def test_labels_of_another_mesh(self):
        """Are those of the nearest faces: each face of the other mesh is a quarter of one."""
        faces, points, quarters, expected = self.faces, list(self.points), [], []
        middle = {}
        for face, label in zip(faces, self.expected):
            between = []
            for i in range(3):
                edge = tuple(sorted((face[i], face[(i + 1) % 3])))
                if edge not in middle:
                    middle[edge] = len(points)
                    points.append(tuple(sum(c) / 2 for c in zip(*(points[v] for v in edge))))
                between.append(middle[edge])
            a, b, c = between
            quarters += [(face[0], a, c), (a, face[1], b), (c, b, face[2]), (a, b, c)]
            expected += 4 * [label]
        write_off(self.directory / "other.off", points, quarters)
        done = self.run_tool("in.off", "--transfer-to", "other.off", "--keep-faces", "--labels",
                             "out.seg", "-o", "out.ply", "-o", "out.glb", "--split-dir", "parts",
                             "--hierarchy", "h.json", "--json", "out.json", "--scale", "2")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.labels(), expected)
        mesh = self.ply()
        self.assertEqual([[tuple(c / 2 for c in mesh.points[v]) for v in f] for f in mesh.faces],
                         [[points[v] for v in f] for f in quarters])
        self.assertEqual(mesh.segments, expected)
        self.assertEqual(self.report()["parameters"]["transfer_to"], "other.off")
        self.assertEqual(self.report()["input_faces"], len(faces)) # the hierarchy is that of IN
        self.assertEqual(len(json.loads((self.directory / "h.json").read_text())["leaf_of_face"]),
                         len(faces))
        sizes = [len(read_ply(path).faces)
                 for path in sorted((self.directory / "parts").glob("segment_*"))]
        self.assertEqual(sizes, [expected.count(s) for s in range(max(expected) + 1)])

    def test_segments_that_another_mesh_lacks(self):
        """The other mesh is a part."""
        self.run_tool("in.off", "--keep-faces", "--split-dir", "parts")
        done = self.run_tool("in.off", "--transfer-to", "parts/segment_001.ply", "--labels",
                             "out.seg", "--split-dir", "again", "--hulls", "hulls")
        self.assertEqual(done.returncode, 0)
        number = max(self.expected)
        self.assertIn("segment_001.ply: %d segments are smaller" % number, done.stderr)
        self.assertEqual(set(self.labels()), {1})
        for folder, extension in (("again", "ply"), ("hulls", "obj")):
            self.assertEqual([path.name for path in (self.directory / folder).glob("segment_*")],
                             ["segment_001." + extension])

    def test_wrong_transfers(self):
        self.assert_failure("usage", "in.off", "--transfer-to", "in.off", "--html", "out.html",
                            message="--transfer-to needs an output of the other mesh")
        self.assert_failure("usage", "in.off", "--transfer-to", "in.off", "--out-dir", "out",
                            message="not with --out-dir")
        self.assert_failure("input", "in.off", "--transfer-to", "no.off", "--labels", "out.seg",
                            message="there is no file no.off")
        self.assert_failure("usage", "in.off", "--transfer-to", "out.ply", "-o", "out.ply",
                            message="out.ply is the input")
        self.write_off([], [], "empty.off")
        self.assert_failure("mesh", "in.off", "--transfer-to", "empty.off", "--labels", "out.seg",
                            message="empty.off has no faces")

    def test_outputs_that_are_no_colored_meshes(self):
        self.assert_failure("usage", "in.off", "-o", "out.stl", message="--split-format")
        for name in ("out.png", "out.SVG"):
            self.assert_failure("usage", "in.off", "-o", name, message="--html FILE")
            self.assert_failure("usage", "in.off", "-o", name, message="scripts/render.py")
        self.assertTrue((pathlib.Path(__file__).parents[3] / "scripts/render.py").exists())

    def test_further_properties_are_kept(self):
        header = ("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                  "property float z\nproperty uchar quality\nelement face %d\n"
                  "property list uchar int vertex_indices\nproperty short id\nend_header\n" %
                  (len(self.points), len(self.faces)))
        (self.directory / "in.ply").write_text(
            header + "".join("%r %r %r 7\n" % p for p in self.points) +
            "".join("3 %d %d %d %d\n" % (*f, i - 9) for i, f in enumerate(self.faces)))
        self.assertEqual(self.segment("in.ply"), self.expected)
        header = (self.directory / "out.ply").read_bytes().split(b"end_header")[0]
        self.assertIn(b"property float z\n", header)
        self.assertIn(b"property uchar quality\n", header)
        self.assertIn(b"property short id\n", header)

    def test_refined_boundaries_keep_properties_of_points(self):
        """New points have the means of the values around them: linear functions stay linear."""
        z = [p[2] for p in self.points]
        height = lambda z0: round(200 * (z0 - min(z)) / (max(z) - min(z)))
        header = ("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
                  "property double z\nproperty double plane\nproperty uchar height\n"
                  "element face %d\nproperty list uchar int vertex_indices\nproperty int id\n"
                  "end_header\n" % (len(self.points), len(self.faces)))
        (self.directory / "in.ply").write_text(
            header + "".join("%r %r %r %r %d\n" % (*p, 2 * p[0] - p[1], height(p[2]))
                             for p in self.points) +
            "".join("3 %d %d %d %d\n" % (*f, i) for i, f in enumerate(self.faces)))
        done = self.run_tool("in.ply", "-o", "out.ply", "--labels", "out.seg")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = read_ply_rows(self.directory / "out.ply")
        self.assertGreater(len(rows["face"]), len(self.faces))
        self.assertEqual({row["id"] for row in rows["face"]}, set(range(len(self.faces))))
        for row in rows["vertex"]:
            self.assertAlmostEqual(row["plane"], 2 * row["x"] - row["y"])
            self.assertAlmostEqual(row["height"], height(row["z"]), delta=2)

        obj = ["v %r %r %r" % p for p in self.points]
        obj += ["vt %r %r" % (p[0] + 5 * p[2], p[1]) for p in self.points]
        obj += ["vn %r %r %r" % tuple(x / math.hypot(*p) for x in p) for p in self.points]
        obj += ["f " + " ".join("%d/%d/%d" % (v + 1, v + 1, v + 1) for v in f) for f in self.faces]
        (self.directory / "in.obj").write_text("\n".join(obj))
        done = self.run_tool("in.obj", "-o", "out.obj")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        v, vt, vn, faces = read_obj_rows(self.directory / "out.obj").values()
        self.assertGreater(len(v), len(self.points))
        self.assertEqual((len(vt), len(vn)), (len(v), len(v))) # one mean of each at a new point
        for face in faces:
            for i, j, k in face:
                self.assertAlmostEqual(vt[j][0], v[i][0] + 5 * v[i][2])
                self.assertAlmostEqual(vt[j][1], v[i][1])
                self.assertAlmostEqual(math.hypot(*vn[k]), 1)

    def test_refined_boundaries_keep_polygons_and_joined_borders(self):
        """Only quadrangles at the boundary are cut. Each has its own points in the file, and its
        texture."""
        around, rings = 16, 24
        radius = lambda z: 1 + 0.7 * math.cos(2 * math.pi * z / (rings - 1)) + 0.02 * (z % 3)
        angle = lambda i: 2 * math.pi * (i % around) / around # the same points at both ends
        # oblique, so that no ring of edges is a boundary
        place = lambda z, i: (radius(z) * math.cos(angle(i)), radius(z) * math.sin(angle(i)),
                              0.4 * z + 0.2 * radius(z) * math.cos(angle(i)))
        quads = [[place(z, i), place(z, i + 1), place(z + 1, i + 1), place(z + 1, i)]
                 for z in range(rings - 1) for i in range(around)]
        obj, number = [], 0
        for quad in quads:
            obj += ["v %r %r %r" % p for p in quad] + ["vt %r %r" % (p[2], p[0]) for p in quad]
            obj.append("f " + " ".join("%d/%d" % (number + i, number + i) for i in range(1, 5)))
            number += 4
        (self.directory / "in.obj").write_text("\n".join(obj))
        done = self.run_tool("in.obj", "--segments", 2, "-o", "out.obj", "--split-dir", "parts")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        v, vt, _, faces = read_obj_rows(self.directory / "out.obj").values()
        sizes = collections.Counter(map(len, faces))
        self.assertGreater(sizes[4], len(quads) - 4 * around)
        self.assertGreater(sizes[3], 2 * around)
        for face in faces:
            for i, j in face:
                self.assertAlmostEqual(vt[j][0], v[i][2])
                self.assertAlmostEqual(vt[j][1], v[i][0])
        # Closed parts are closed for programs, too, which distinguish points by their numbers.
        done = self.run_tool("in.obj", "--segments", 2, "--close", "--split-dir", "closed")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for part in (self.directory / "closed").glob("*.ply"):
            count = collections.Counter(frozenset((face[i - 1], face[i]))
                                        for face in read_ply(part).faces for i in range(len(face)))
            self.assertEqual(set(count.values()), {2})
        # The border between the parts is at the same points on both sides.
        edges = [set(), set()]
        for part, found in enumerate(edges):
            ply = read_ply(self.directory / "parts" / ("segment_%03d.ply" % part))
            count = collections.Counter(
                frozenset(tuple(round(x, 9) for x in ply.points[w]) for w in (face[i - 1], face[i]))
                for face in ply.faces for i in range(len(face)))
            found.update(edge for edge, n in count.items() if n == 1)
        self.assertGreaterEqual(len(edges[0] & edges[1]), around)
        self.assertEqual(len(edges[0] ^ edges[1]), 2 * around) # the ends of the tube

    def test_other_formats_need_assimp(self):
        self.run_tool("in.off", "--keep-faces", "-o", "in.glb")
        done = self.run_tool("in.glb", "--labels", "out.seg")
        if done.returncode != 0:
            self.assertIn("Assimp", done.stderr)
            self.skipTest("the tool was built without Assimp")
        self.assertEqual(len(self.labels()), len(self.faces))
        content = (self.directory / "in.glb").read_bytes()
        (size,) = struct.unpack_from("<I", content, 12)
        description = content[20:20 + size].rstrip()
        description += b" " * (len(description) % 4 == 0) # so that it is not filled up
        (self.directory / "in.glb").write_bytes(
            content[:8] + struct.pack("<2I", 20 + len(description) + len(content[20 + size:]),
                                      len(description)) +
            content[16:20] + description + content[20 + size:])
        self.assertEqual(len(self.segment("in.glb")), len(self.faces))


# A mesh at a node; the points are those before the node's translation along z.
Node = collections.namedtuple("Node", "name mesh_name z points faces")


def gltf(nodes, uri):
    """Returns a description of glTF for data at an address, or in a file of GLB; and the data."""
    data, views, accessors = b"", [], []

    def add(content, count, component_type, kind, **further):
        nonlocal data
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
        accessors.append({"bufferView": len(accessors), "componentType": component_type,
                          "count": count, "type": kind, **further})
        data += content
        return len(accessors) - 1

    meshes = []
    for node in nodes:
        points = add(b"".join(struct.pack("<3f", *p) for p in node.points), len(node.points), 5126,
                     "VEC3", min=[min(x) for x in zip(*node.points)],
                     max=[max(x) for x in zip(*node.points)])
        corners = add(b"".join(struct.pack("<3I", *f) for f in node.faces), 3 * len(node.faces),
                      5125, "SCALAR")
        meshes.append({"name": node.mesh_name, "primitives": [
            {"attributes": {"POSITION": points}, "indices": corners}]})
    buffer = {"byteLength": len(data)}
    if uri:
        buffer["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": [{"name": n.name, "mesh": i, "translation": [0, 0, n.z]}
                  for i, n in enumerate(nodes)],
        "meshes": meshes, "accessors": accessors, "bufferViews": views,
        "buffers": [buffer]}).encode(), data


def glb(nodes):
    return glb_of(*gltf(nodes, False))


def glb_of(text, data):
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data)) +
            struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(data), b"BIN\0") + data)


def numbers(rows):
    return " ".join("%r" % x for row in rows for x in row)


def collada(nodes):
    geometries, instances = "", ""
    for i, n in enumerate(nodes):
        geometries += (
            '<geometry id="%s"><mesh><source id="s%d"><float_array id="a%d" count="%d">%s'
            '</float_array><technique_common><accessor source="#a%d" count="%d" stride="3"><param '
            'name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>'
            '</accessor></technique_common></source><vertices id="v%d"><input semantic="POSITION" '
            'source="#s%d"/></vertices><triangles count="%d"><input semantic="VERTEX" '
            'source="#v%d" offset="0"/><p>%s</p></triangles></mesh></geometry>'
            % (n.mesh_name, i, i, 3 * len(n.points), numbers(n.points), i, len(n.points), i, i,
               len(n.faces), i, numbers(n.faces)))
        instances += ('<node id="%s"><translate>0 0 %r</translate><instance_geometry url="#%s"/>'
                      '</node>' % (n.name, n.z, n.mesh_name))
    return ('<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" '
            'version="1.4.1"><asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset>'
            '<library_geometries>%s</library_geometries><library_visual_scenes><visual_scene '
            'id="scene">%s</visual_scene></library_visual_scenes><scene><instance_visual_scene '
            'url="#scene"/></scene></COLLADA>' % (geometries, instances)).encode()


def ac3d(nodes):
    lines = ["AC3Db", 'MATERIAL "m" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 0 trans 0',
             "OBJECT world", "kids %d" % len(nodes)]
    for n in nodes:
        lines += ["OBJECT poly", 'name "%s"' % n.name, "loc 0 0 %r" % n.z,
                  "numvert %d" % len(n.points)]
        lines += ["%r %r %r" % tuple(p) for p in n.points]
        lines.append("numsurf %d" % len(n.faces))
        for f in n.faces:
            lines += ["SURF 0x10", "mat 0", "refs 3"] + ["%d 0 0" % v for v in f]
        lines.append("kids 0")
    return ("\n".join(lines) + "\n").encode()


def fbx(nodes):
    objects, connections = "", ""
    for i, n in enumerate(nodes):
        ends = [(a, b, -c - 1) for a, b, c in n.faces]
        objects += (
            'Geometry: %d, "Geometry::%s", "Mesh" {\nVertices: *%d {\na: %s\n}\n'
            'PolygonVertexIndex: *%d {\na: %s\n}\n}\nModel: %d, "Model::%s", "Mesh" {\n'
            'Version: 232\nProperties70: {\nP: "Lcl Translation", "Lcl Translation", "", "A",0,0,%r'
            '\n}\n}\n' % (10 + i, n.mesh_name, 3 * len(n.points),
                         numbers(n.points).replace(" ", ","), 3 * len(ends),
                         numbers(ends).replace(" ", ","), 20 + i, n.name, n.z))
        connections += 'C: "OO",%d,%d\nC: "OO",%d,0\n' % (10 + i, 20 + i, 20 + i)
    return ("; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\n"
            "FBXVersion: 7400\n}\nObjects: {\n%s}\nConnections: {\n%s}\n" %
            (objects, connections)).encode()


def autodesk_3ds(nodes):
    """Returns the file of a scene. Only key frames have translations. The z axis is up, and Assimp
    turns it to y."""
    def chunk(number, *contents):
        content = b"".join(contents)
        return struct.pack("<HI", number, 6 + len(content)) + content

    objects = []
    for n in nodes:
        points = [(x, -z - n.z, y) for x, y, z in n.points]
        objects.append(chunk(
            0x4000, n.name.encode() + b"\0", chunk(
                0x4100,
                chunk(0x4110, struct.pack("<H", len(points)),
                      *(struct.pack("<3f", *p) for p in points)),
                chunk(0x4120, struct.pack("<H", len(n.faces)),
                      *(struct.pack("<4H", *f, 7) for f in n.faces)))))
    return chunk(0x4d4d, chunk(2, struct.pack("<I", 3)), chunk(0x3d3d, *objects))


WRITERS = {"gltf": lambda nodes: gltf(nodes, True)[0], "glb": glb, "dae": collada, "ac": ac3d,
           "fbx": fbx, "3ds": autodesk_3ds}


class Scenes(Tool_test):
    """Files that Assimp reads."""

    def setUp(self):
        super().setUp()
        points, faces = dumbbell()
        points = [tuple(round(256 * x) / 256 for x in p) for p in points] # exact as float
        middle = len(faces) // 2
        self.nodes, self.points, self.faces = [], [], []
        for name, z, part in (("left", 0., faces[:middle]), ("right", 8., faces[middle:])):
            used = sorted({v for f in part for v in f})
            number = {v: i for i, v in enumerate(used)}
            own = [points[v] for v in used]
            local = [tuple(number[v] for v in f) for f in part]
            self.nodes.append(Node(name, name + "_ball", z,
                                   [(x, y, c - z) for x, y, c in own], local))
            self.faces += [tuple(v + len(self.points) for v in f) for f in local]
            self.points += own
        name = self.write("glb", glb(self.nodes))
        if "Assimp at build time" in self.run_tool(name).stderr:
            self.assert_failure("mesh", name, message=name)
            self.skipTest("the tool was built without Assimp")

    def write(self, extension, content):
        name = "in." + extension
        (self.directory / name).write_bytes(content)
        return name

    def test_nodes_and_meshes(self):
        expected = self.segment(self.write_off(self.points, self.faces), "--segments", 2)
        self.assertEqual(set(expected), {0, 1})
        for extension, writer in WRITERS.items():
            with self.subTest(extension):
                name = self.write(extension, writer(self.nodes))
                self.assertEqual(self.segment(name, "--segments", 2), expected)
                rows, report = read_ply_rows(self.directory / "out.ply")["face"], self.report()
                names = [n.name for n in self.nodes for _ in n.faces]
                meshes = [n.mesh_name for n in self.nodes for _ in n.faces]
                self.assert_same_parts([row["node"] for row in rows], names)
                self.assert_same_parts([row["mesh"] for row in rows], names)
                if extension != "3ds": # whose names Assimp does not keep
                    self.assertEqual([report["node_names"][row["node"]] for row in rows], names)
                if extension not in ("3ds", "ac"): # AC3D has names of nodes only
                    self.assertEqual([report["mesh_names"][row["mesh"]] for row in rows], meshes)
                points = self.ply().points
                for face, written in zip(self.faces, self.ply().faces):
                    self.assertEqual([self.points[v] for v in face], [points[v] for v in written])

    def quantized(self, component_type, is_normalized):
        """The description and the data of a file with integer points, of which each has two bytes
        before it, and these points in the scene."""
        code, largest = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767),
                         5123: ("H", 65535)}[component_type]
        text, data = gltf(self.nodes, False)
        scene, points = json.loads(text), []
        for node, mesh, n in zip(scene["nodes"], scene["meshes"], self.nodes):
            low = min(min(p) for p in n.points)
            size = max(max(p) for p in n.points) - low
            origin = low if code.isupper() else low + size / 2
            unit = (size if code.isupper() else size / 2) / largest
            rows = [[round((x - origin) / unit) for x in p] for p in n.points]
            content = b"".join((b"xx" + struct.pack("<3" + code, *row)).ljust(8) for row in rows)
            mesh["primitives"][0]["attributes"]["POSITION"] = len(scene["accessors"])
            scene["accessors"].append(
                {"bufferView": len(scene["bufferViews"]), "byteOffset": 2, "type": "VEC3",
                 "componentType": component_type, "count": len(rows), "normalized": is_normalized})
            scene["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteStride": 8,
                                         "byteLength": len(content)})
            data += content
            node.update(scale=[unit * (largest if is_normalized else 1)] * 3,
                        translation=[origin, origin, origin + n.z])
            points += [(x * unit + origin, y * unit + origin, z * unit + origin + n.z)
                       for x, y, z in rows]
        scene["buffers"][0]["byteLength"] = len(data)
        scene["extensionsUsed"] = scene["extensionsRequired"] = ["KHR_mesh_quantization"]
        return json.dumps(scene).encode(), data, points

    def test_quantized_points(self):
        for component_type, is_normalized in itertools.product(range(5120, 5124), (False, True)):
            with self.subTest(component_type, is_normalized=is_normalized):
                text, data, expected = self.quantized(component_type, is_normalized)
                self.segment(self.write("glb", glb_of(text, data)), "--segments", 2)
                points = self.ply().points
                for face, written in zip(self.faces, self.ply().faces):
                    for v, w in zip(face, written):
                        self.assertLess(math.dist(expected[v], points[w]), 1e-5)
        text, data, _ = self.quantized(5123, False)
        for old, new in (('"count": %d,' % len(self.nodes[1].points), '"count": 99999,'),
                         ('"byteStride": 8', '"byteStride": 99'),
                         ('"byteOffset": 2,', '"byteOffset": -2,'),
                         ('"componentType": 5123', '"componentType": 5124')):
            self.assertIn(old.encode(), text)
            self.write("glb", glb_of(text.replace(old.encode(), new.encode()), data))
            self.assert_failure("mesh", "in.glb", "-o", "out.ply", message="cannot be read: it")

    def test_instances(self):
        """Each is a node below theirs."""
        nodes = self.nodes[:1]
        text, data = gltf(nodes, False)
        scene = json.loads(text)
        scene["accessors"].append({"bufferView": 2, "componentType": 5126, "count": 3,
                                   "type": "VEC3"})
        scene["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": 36})
        places = [(0, 0, 0), (9, 0, 0), (0, 9, 0)]
        data += b"".join(struct.pack("<3f", *p) for p in places)
        scene["buffers"][0]["byteLength"] = len(data)
        scene["extensionsUsed"] = ["EXT_mesh_gpu_instancing"]
        scene["nodes"][0]["extensions"] = {
            "EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}
        self.write("glb", glb_of(json.dumps(scene).encode(), data))
        self.segment("in.glb")
        mesh, number = self.ply(), len(nodes[0].points)
        self.assertEqual(mesh.points, [tuple(map(sum, zip(p, place)))
                                       for place in places for p in nodes[0].points])
        self.assertEqual(mesh.faces, [tuple(v + i * number for v in face)
                                      for i in range(3) for face in nodes[0].faces])

    def test_required_extensions(self):
        for name, message in (("EXT_meshopt_compression", "gltf-transform copy IN.glb OUT.glb"),
                              ("KHR_made_up", "'KHR_made_up' of glTF, which is not read")):
            scene = json.loads(gltf(self.nodes, True)[0])
            scene["extensionsRequired"] = ["KHR_materials_unlit", name]
            self.write("gltf", json.dumps(scene).encode())
            self.assert_failure("mesh", "in.gltf", "-o", "out.ply", message=message)
        scene["extensionsRequired"] = ["KHR_materials_unlit"]
        self.segment(self.write("gltf", json.dumps(scene).encode()))

    def test_draco(self):
        """A box of 2 by 1 by 4, of which an encoder has made these bytes."""
        data = base64.b64decode(
            "RFJBQ08CAgEBAAAACAwACwAAA19LFQEBEAH/AAABAAkDAAACAQEBAA8DARArAQgBKAQAuhyB/z8AAAAAAABg"
            "AAAA/j8A+P//PwAA////JwDg/wcAAAAAAAAA/z8AAAAAAAAAAAAAAAAAAAAAgEAO")
        name = "KHR_draco_mesh_compression"
        scene = {
            "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "extensionsUsed": [name], "extensionsRequired": [name],
            "meshes": [{"primitives": [{
                "attributes": {"POSITION": 1}, "indices": 0,
                "extensions": {name: {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}],
            "buffers": [{"byteLength": len(data)}],
            "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
            "accessors": [{"type": "SCALAR", "componentType": 5125, "count": 36},
                          {"type": "VEC3", "componentType": 5126, "count": 8}]}
        for component_type in (5123, 5125):
            scene["accessors"][0]["componentType"] = component_type
            self.write("glb", glb_of(json.dumps(scene).encode(), data))
            done = self.run_tool("in.glb", "-o", "out.ply")
            if "KHR_draco" in done.stderr:
                self.assertIn("gltf-transform copy IN.glb OUT.glb", done.stderr)
                self.skipTest("the tool was built without Draco")
            mesh = self.ply()
            self.assertEqual({tuple(round(x, 3) for x in p) for p in mesh.points}, # of 14 bits
                             set(itertools.product((0, 2), (0, 1), (0, 4))))
            self.assertTrue(is_closed(mesh.faces))
            self.assertAlmostEqual(volume(mesh.points, mesh.faces), 8, 2)
        for i in range(len(data)): # damage is an error, or other points
            damaged = data[:i] + bytes([data[i] ^ 0x55]) + data[i + 1:]
            self.write("glb", glb_of(json.dumps(scene).encode(), damaged))
            done = self.run_tool("in.glb", "--time-limit", "60")
            self.assertIn(done.returncode, (0, STATUSES.index("mesh")), done.stderr)

    def test_collada_with_blanks(self):
        """Before numbers, also those of a color."""
        effect = ('<library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong>'
                  '<diffuse><color>  0.5 0.5 0.5  1.0 </color></diffuse></phong></technique>'
                  '</profile_COMMON></effect></library_effects>')
        plain = collada(self.nodes).decode()
        expected = self.segment(self.write("dae", plain.encode()))
        blanks = re.sub(">(?=[-0-9])", ">\n  ", plain).replace("<library_g", effect + "<library_g")
        self.assertNotEqual(blanks.count("\n"), 0)
        self.assertEqual(self.segment(self.write("dae", blanks.encode())), expected)

    def test_animations_are_skipped(self):
        """Also those that are no glTF."""
        text, data = gltf(self.nodes, False)
        expected = self.segment(self.write("glb", glb_of(text, data)))
        scene = json.loads(text)
        scene["animations"] = [{"channels": [{"sampler": 0, "target": {"path": 5, "node": 99}}],
                                "samplers": "none"}]
        text = json.dumps(scene).encode()
        self.assertEqual(self.segment(self.write("glb", glb_of(text, data))), expected)

    def test_files_outside_of_the_folder(self):
        """They are read on request only, whatever way a file names them."""
        text, data = gltf(self.nodes, False)
        (self.directory / "in").mkdir()
        (self.directory / "inside").mkdir() # begins like the folder
        for place in ("outside.bin", "inside/outside.bin", "in/beside.bin"):
            (self.directory / place).write_bytes(data)
        (self.directory / "in/link.bin").symlink_to("../outside.bin")
        (self.directory / "in/link_beside.bin").symlink_to("beside.bin")
        os.mkfifo(self.directory / "in/pipe.bin")
        name = "in/a.gltf"

        def run(uri, *options):
            buffer = b'"buffers": [{"uri": "%s", ' % str(uri).encode()
            (self.directory / name).write_bytes(text.replace(b'"buffers": [{', buffer))
            return self.run_tool(name, "--labels", "out.seg", "--quiet", *options)

        self.assertEqual((run("beside.bin").returncode, run("link_beside.bin").returncode), (0, 0))
        expected = self.labels()
        for uri in ("../outside.bin", "../inside/outside.bin", "link.bin"):
            done = run(uri)
            self.assertEqual(done.returncode, STATUSES.index("mesh"), uri)
            self.assertIn("--allow-external-files reads it", done.stderr)
            self.assertEqual(run(uri, "--allow-external-files").returncode, 0)
            self.assertEqual(self.labels(), expected)
        for uri in ("pipe.bin", self.directory / "outside.bin"):
            self.assertEqual(run(uri).returncode, STATUSES.index("mesh"), uri)
        start = time.monotonic() # the time limit holds for the reader, too
        done = run("pipe.bin", "--allow-external-files", "--time-limit", "1")
        self.assertEqual(done.returncode, STATUSES.index("time"), done.stderr)
        self.assertLess(time.monotonic() - start, 20)

    def test_damaged_files(self):
        cases = {extension: [writer(self.nodes)[:-3000], b"", b"Dear Sir"]
                 for extension, writer in WRITERS.items()}
        text = gltf(self.nodes, True)[0]
        cases["gltf"] += [text.replace(b'"mesh": 1', b'"mesh": 7'),
                          text.replace(b"data:application/octet-stream;base64,", b"missing.bin?")]
        cases["dae"].append(collada(self.nodes).replace(b"#a1", b"#nothing"))
        for extension, contents in cases.items():
            for i, content in enumerate(contents):
                with self.subTest(extension, case=i):
                    name = self.write(extension, content)
                    self.assert_failure("mesh", name, "-o", "out.ply", "--labels", "out.seg",
                                        message=name + " cannot be read: ")
        for extension in ("gltf", "glb"):
            content = WRITERS[extension](self.nodes).replace(b"}", b"]", 1)
            self.assert_failure("mesh", self.write(extension, content),
                                message="its description is no JSON")


def png(red):
    """Returns the bytes of a picture of one pixel."""
    def chunk(kind, content):
        return (struct.pack(">I", len(content)) + kind + content +
                struct.pack(">I", zlib.crc32(kind + content)))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", 1, 1, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes([0, red, 0, 0]))) + chunk(b"IEND", b""))


# A triangle, the bytes of its texture, and the name of its material. A corner is a point, texture
# coordinates and a normal in one tuple.
Textured = collections.namedtuple("Textured", "corners image material")


def rotated(corners):
    """Returns the corners of a triangle, from the smallest."""
    i = corners.index(min(corners))
    return (*corners[i:], *corners[:i])


def read_textured_obj(path):
    """Returns the triangles of an OBJ, sorted; and by materials the statements without textures."""
    rows, triangles, images, statements, used = read_obj_rows(path), [], {}, {}, None
    faces = iter(rows["f"])
    for line in path.read_text().splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "mtllib":
            for row in (path.parent / rest).read_text().splitlines():
                key, _, value = row.partition(" ")
                if key == "newmtl":
                    name = value
                    images[name], statements[name] = None, []
                elif key == "map_Kd":
                    images[name] = (path.parent / value).read_bytes()
                else:
                    statements[name].append(row)
        elif kind == "usemtl":
            used = rest
        elif kind == "f":
            triangles.append(Textured(rotated([
                sum((rows[name][i] for name, i in zip(("v", "vt", "vn"), corner)), ())
                for corner in next(faces)]), images[used], used))
    return sorted(triangles), statements


def read_textured_glb(path):
    """The triangles of a GLB, sorted; and its materials by their names. Corners as in OBJ."""
    json_, data = read_glb(path.read_bytes())

    def view(i):
        v = json_["bufferViews"][i]
        return data[v["byteOffset"]:v["byteOffset"] + v["byteLength"]]

    def rows(i):
        accessor = json_["accessors"][i]
        code = {"SCALAR": "<I", "VEC2": "<2f", "VEC3": "<3f"}[accessor["type"]]
        result = list(struct.iter_unpack(code, view(accessor["bufferView"])))
        assert len(result) == accessor["count"]
        return result

    def image_of(material):
        texture = material.get("pbrMetallicRoughness", {}).get("baseColorTexture")
        if texture is None:
            return None
        image = json_["images"][json_["textures"][texture["index"]]["source"]]
        assert image["mimeType"] == "image/png"
        return view(image["bufferView"])

    triangles = []
    for node in json_["nodes"]: # whose transformations are empty
        primitives = json_["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []
        for p in primitives:
            material = json_["materials"][p["material"]]
            vertices = [position + (uv[0], 1 - uv[1]) + normal for position, uv, normal in zip(
                *(rows(p["attributes"][kind]) for kind in ("POSITION", "TEXCOORD_0", "NORMAL")))]
            for corners in zip(*[iter(rows(p["indices"]))] * 3):
                triangles.append(Textured(rotated([vertices[v] for v, in corners]),
                                          image_of(material), material["name"]))
    return sorted(triangles), {m["name"]: m for m in json_["materials"]}


class Materials(Tool_test):
    """Two balls with a neck, which have materials and pictures of their own."""

    def setUp(self):
        super().setUp()
        points, faces = dumbbell()
        exact = lambda x: round(1024 * x) / 1024 # as float
        points = [tuple(map(exact, p)) for p in points]
        self.images = {"left": png(10), "right, or so": png(20)}
        (self.directory / "in").mkdir()
        for file, (name, image) in zip(("a b.png", "c.png"), self.images.items()):
            (self.directory / "in" / file).write_bytes(image)
        lines = ["mtllib the materials.mtl"]
        lines += ["v %r %r %r" % p for p in points]
        lines += ["vt %r %r" % (exact(p[0] / 16), exact(p[2] / 32)) for p in points]
        # Their lengths as float are 1.
        lines += ["vn 1 0 0", "vn 0 0 -1"]
        for i, f in enumerate(faces):
            if i % (len(faces) // 2) == 0:
                lines.append("usemtl " + list(self.images)[2 * i // len(faces)])
            lines.append("f " + " ".join("%d/%d/%d" % (v + 1, v + 1, 1 + i % 2) for v in f))
        (self.directory / "in/in.obj").write_text("\n".join(lines))
        self.statements = {"left": ["Kd 1 0.5 0.25", "illum 2"], "right, or so": ["Ks 1 1 1"]}
        (self.directory / "in/the materials.mtl").write_text(
            "newmtl left\nKd 1 0.5 0.25\nillum 2\nmap_Kd .\\a b.png\n\n"
            "newmtl right, or so\nmap_Kd /home/me/c.png\nKs 1 1 1\n")
        # The tool of tests reads the names of files plainly.
        plain = self.directory / "plain"
        plain.mkdir()
        (plain / "in.obj").write_text("\n".join(["mtllib m.mtl", *lines[1:]]))
        (plain / "m.mtl").write_text("newmtl left\nmap_Kd 1.png\nnewmtl right, or so\nmap_Kd 2.png")
        for i, image in enumerate(self.images.values()):
            (plain / ("%d.png" % (i + 1))).write_bytes(image)
        self.expected, _ = read_textured_obj(plain / "in.obj")
        self.assertEqual({t.image for t in self.expected}, set(self.images.values()))

    def run_well(self, *arguments):
        done = self.run_tool(*arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)

    def test_obj(self):
        self.run_well("in/in.obj", "--keep-faces", "-o", "out.obj", "--keep-materials",
                      "--split-dir", "parts", "--split-format", "obj")
        triangles, statements = read_textured_obj(self.directory / "out.obj")
        self.assertEqual(triangles, self.expected)
        self.assertEqual(statements, self.statements)
        parts = [read_textured_obj(p) for p in (self.directory / "parts").glob("*.obj")]
        self.assertGreater(len(parts), 1)
        self.assertEqual(sorted(sum((triangles for triangles, _ in parts), [])), self.expected)
        for triangles, statements in parts: # without materials of others
            self.assertEqual(statements.keys(), {t.material for t in triangles})
        self.run_well("out.obj", "--keep-faces", "-o", "again.obj", "--keep-materials")
        self.assertEqual(read_textured_obj(self.directory / "again.obj"),
                         read_textured_obj(self.directory / "out.obj"))
        self.run_well("in/in.obj", "--split-dir", "parts") # which removes the pictures
        self.assertEqual({p.suffix for p in (self.directory / "parts").iterdir()},
                         {".ply", ".json"})

    def test_refined_and_closed(self):
        """New points have texture coordinates, and caps have a plain material."""
        self.run_well("in/in.obj", "--close", "--split-dir", "parts", "--split-format", "obj")
        number_of_caps = 0
        for path in (self.directory / "parts").glob("*.obj"):
            triangles, _ = read_textured_obj(path)
            for t in triangles:
                if t.material == "plain":
                    number_of_caps += 1
                    self.assertEqual(({len(c) for c in t.corners}, t.image), ({3}, None))
                    continue
                for x, _, z, u, v, *_ in t.corners:
                    self.assertAlmostEqual(16 * u, x, delta=0.02)
                    self.assertAlmostEqual(32 * v, z, delta=0.04)
                self.assertEqual(t.image, self.images[t.material])
        self.assertGreater(number_of_caps, 0)

    def test_glb(self):
        self.run_well("in/in.obj", "--keep-faces", "-o", "out.glb", "--keep-materials",
                      "--split-dir", "parts", "--split-format", "glb")
        triangles, materials = read_textured_glb(self.directory / "out.glb")
        self.assertEqual(triangles, self.expected)
        surface = materials["left"]["pbrMetallicRoughness"]
        self.assertEqual((surface["metallicFactor"], surface["roughnessFactor"]), (0, 1))
        linear = lambda c: ((c + 0.055) / 1.055) ** 2.4 # of sRGB
        for c, expected in zip(surface["baseColorFactor"], (1, linear(0.5), linear(0.25), 1)):
            self.assertAlmostEqual(c, expected)
        parts = [read_textured_glb(p) for p in (self.directory / "parts").glob("*.glb")]
        self.assertGreater(len(parts), 1)
        self.assertEqual(sorted(sum((triangles for triangles, _ in parts), [])), self.expected)
        for triangles, materials in parts: # without materials of others
            self.assertEqual(materials.keys(), {t.material for t in triangles})
        names = [node["name"] for node in self.nodes_of_glb()]
        self.run_well("in/in.obj", "--keep-faces", "-o", "out.glb") # has the same tree
        self.assertEqual([node["name"] for node in self.nodes_of_glb()], names)

    def textured_gltf(self):
        """Writes the triangles as glTF below a node that is translated: one picture is a file, the
        other one in the buffer."""
        data, views, accessors, primitives = b"", [], [], []

        def add(content):
            nonlocal data
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
            data += content + bytes(-len(content) % 4)
            return len(views) - 1

        for material, name in enumerate(self.images):
            corners = [c for t in self.expected if t.material == name for c in t.corners]
            columns = [[(x, y, z - 8) for x, y, z, *_ in corners],
                       [(u, 1 - v) for _, _, _, u, v, *_ in corners], [c[5:] for c in corners]]
            for rows in columns:
                accessors.append({
                    "bufferView": add(b"".join(struct.pack("<%df" % len(r), *r) for r in rows)),
                    "componentType": 5126, "count": len(rows), "type": "VEC%d" % len(rows[0])})
            accessors[-3].update(min=list(map(min, zip(*columns[0]))),
                                 max=list(map(max, zip(*columns[0]))))
            primitives.append({"material": material, "attributes": {
                kind: 3 * material + i for i, kind in enumerate(("POSITION", "TEXCOORD_0",
                                                                 "NORMAL"))}})
        image = add(self.images["left"])
        materials = [
            {"name": "left", "doubleSided": True, "alphaMode": "MASK", "alphaCutoff": 0.25,
             "pbrMetallicRoughness": {
                 "baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": 0.75,
                 "roughnessFactor": 0.5, "baseColorTexture": {"index": 0, "extensions": {
                     "KHR_texture_transform": {"offset": [0.25, 0.5], "rotation": 0.5,
                                               "scale": [2, 4]}}}},
             "emissiveFactor": [0, 0.5, 1], "normalTexture": {"index": 1, "scale": 0.5}},
            {"name": "right, or so", "pbrMetallicRoughness": {"baseColorTexture": {"index": 1}},
             "extensions": {"KHR_materials_clearcoat": {
                 "clearcoatFactor": 0.5, "clearcoatTexture": {"index": 0}}}}]
        text = json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, "translation": [0, 0, 8]}],
            "meshes": [{"primitives": primitives}], "materials": materials,
            "accessors": accessors, "bufferViews": views,
            "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
            "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}],
            "images": [{"bufferView": image, "mimeType": "image/png"}, {"uri": "c%20%25.png"}],
            "extensionsUsed": ["KHR_texture_transform", "KHR_materials_clearcoat"],
            "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," +
                         base64.b64encode(data).decode()}]})
        (self.directory / "in/in.gltf").write_text(text)
        (self.directory / "in/c %.png").write_bytes(self.images["right, or so"])

    def test_gltf(self):
        self.textured_gltf()
        command = ("in/in.gltf", "--keep-faces", "-o", "out.glb", "-o", "out.obj",
                   "--keep-materials", "--split-dir", "parts", "--split-format", "glb")
        if "Assimp at build time" in self.run_tool(*command).stderr:
            self.skipTest("the tool was built without Assimp")
        self.run_well(*command)
        triangles, materials = read_textured_glb(self.directory / "out.glb")
        self.assertEqual(triangles, self.expected)
        left, right = (materials[name] for name in self.images)
        surface = left["pbrMetallicRoughness"]
        self.assertEqual(surface["baseColorFactor"], [0.5, 0.25, 0.125, 1])
        self.assertEqual((surface["metallicFactor"], surface["roughnessFactor"]), (0.75, 0.5))
        transform = surface["baseColorTexture"]["extensions"]["KHR_texture_transform"]
        for key, expected in (("offset", [0.25, 0.5]), ("rotation", [0.5]), ("scale", [2, 4])):
            values = transform[key] if key != "rotation" else [transform[key]]
            for value, x in zip(values, expected):
                self.assertAlmostEqual(value, x, places=6)
        self.assertEqual((left["alphaMode"], left["alphaCutoff"], left["doubleSided"],
                          left["emissiveFactor"], left["normalTexture"]["scale"]),
                         ("MASK", 0.25, True, [0, 0.5, 1], 0.5))
        self.assertIs(right["doubleSided"], False)
        coat = right["extensions"]["KHR_materials_clearcoat"]
        self.assertEqual((coat["clearcoatFactor"], "clearcoatTexture" in coat), (0.5, True))
        content = (self.directory / "out.glb").read_bytes()
        self.assertIn(b'"extensionsUsed":["KHR_materials_clearcoat","KHR_texture_transform"]',
                      content)
        self.assertIn(b'{"magFilter":9728,"wrapS":33071,"wrapT":33648}', content)
        parts = [read_textured_glb(p) for p in (self.directory / "parts").glob("*.glb")]
        self.assertEqual(sorted(sum((triangles for triangles, _ in parts), [])), self.expected)
        mtl = (self.directory / "out.mtl").read_text().splitlines()
        for line in ("newmtl left", "newmtl right, or so", "Pm 0.75", "Pr 0.5",
                     "norm out_texture_001.png", "map_Kd out_texture_001.png"):
            self.assertIn(line, mtl)
        self.assertTrue(any(line.startswith("Kd 0.7353") for line in mtl), mtl) # of sRGB
        # A GLB of the tool is read again.
        self.run_well("out.glb", "--keep-faces", "-o", "again.glb", "--keep-materials")
        triangles, again = read_textured_glb(self.directory / "again.glb")
        self.assertEqual((triangles, again.keys()), (self.expected, materials.keys()))

    def test_missing_files(self):
        """They are reported. Files of other folders are only read on request."""
        (self.directory / "in/c.png").rename(self.directory / "c.png")
        mtl = self.directory / "in/the materials.mtl"
        mtl.write_text(mtl.read_text().replace("/home/me/c.png", "../c.png"))
        command = ("in/in.obj", "--keep-faces", "-o", "out.obj", "--keep-materials", "--json",
                   "out.json")
        done = self.run_tool(*command)
        self.assertEqual((done.returncode, done.stderr),
                         (0, "segment_mesh: warning: '../c.png' cannot be read in the folder of "
                             "in/in.obj\n"))
        self.assertEqual(self.report()["missing_files"], ["../c.png"])
        self.assertEqual((self.directory / "out.mtl").read_text(),
                         "newmtl left\nKd 1 0.5 0.25\nillum 2\nmap_Kd out_texture_000.png\n"
                         "newmtl right, or so\nmap_Kd ../c.png\nKs 1 1 1\n")
        self.run_well(*command, "--allow-external-files")
        self.assertEqual(read_textured_obj(self.directory / "out.obj")[0], self.expected)
        mtl.unlink()
        done = self.run_tool(*command)
        self.assertIn("'the' and other files of materials cannot be read", done.stderr)
        self.assertEqual((self.directory / "out.mtl").read_text(),
                         "newmtl left\nnewmtl right, or so\n")

    def test_wrong_usage(self):
        for options in ((), ("-o", "out.ply")):
            self.assert_failure("usage", "in/in.obj", "--keep-materials", *options,
                                message="--keep-materials needs -o with .obj or .glb")


class Soups(Tool_test):

    def setUp(self):
        super().setUp()
        self.points, self.faces = dumbbell()
        self.expected = self.segment(self.write_off(self.points, self.faces), "--segments", 2)
        self.assertEqual(set(self.expected), {0, 1})

    def test_stl(self):
        write_ascii_stl(self.directory / "in.stl", self.points, self.faces)
        self.assert_same_parts(self.segment("in.stl", "--segments", 2), self.expected)
        self.assertEqual(self.report()["vertices"], len(self.points))
        write_binary_stl(self.directory / "in.STL", self.points, self.faces)
        self.assert_same_parts(self.segment("in.STL", "--segments", 2), self.expected)
        self.assertEqual(self.report()["vertices"], len(self.points))

    def test_stl_of_a_surface_that_touches_itself(self):
        points, faces = read_off(MESHES / "cow.off")
        self.assertLess(len(set(points)), len(points))
        write_ascii_stl(self.directory / "in.stl", points, faces)
        self.assertEqual(self.segment("in.stl"), self.segment(MESHES / "cow.off"))

    def test_flipped_faces(self):
        for seed in range(5):
            choose = random.Random(seed)
            faces = [f[::-1] if choose.random() < 0.4 else f for f in self.faces]
            with self.subTest(seed=seed):
                labels = self.segment(self.write_off(self.points, faces), "--segments", 2)
                self.assert_same_parts(labels, self.expected)

    def test_points_repeated_for_each_face(self):
        points = [self.points[v] for f in self.faces for v in f]
        faces = [(i, i + 1, i + 2) for i in range(0, len(points), 3)]
        labels = self.segment(self.write_off(points, faces), "--segments", 2)
        self.assert_same_parts(labels, self.expected)
        self.assertEqual(self.report()["vertices"], len(self.points))

    def test_faces_that_cannot_be_in_a_mesh(self):
        end = len(self.points) - 1
        extra = [(0, 0, 1), (end, end, end), (end, end - 1), (0, 1, 0, 1)]
        faces = extra + self.faces
        labels = self.segment(self.write_off(self.points, faces), "--segments", 2)
        self.assert_same_parts(labels[4:], self.expected)
        self.assertEqual(labels[:4], [labels[4], labels[-1], labels[-1], labels[4]])
        self.assertEqual(self.report()["faces"], len(self.faces))

    def test_random_soups(self):
        for seed in range(30):
            choose = random.Random(seed)
            points = [tuple(choose.randrange(3) for _ in range(3))
                      for _ in range(choose.randrange(3, 12))]
            faces = [(0, 1, 2)] + [tuple(choose.randrange(len(points))
                                         for _ in range(choose.choice((3, 3, 3, 4, 5, 6))))
                                   for _ in range(choose.randrange(40))]
            with self.subTest(seed=seed):
                labels = self.segment(self.write_off(points, faces))
                self.assertEqual(len(labels), len(faces))
                number = self.report()["segments"]
                self.assertTrue(all(0 <= label < number for label in labels))
                self.assertEqual(self.ply().segments, labels)

    def test_polygon_takes_the_label_with_the_largest_area(self):
        # The shorter diagonal leaves a small triangle with the last point and a large one. Each is
        # a segment, numbered in the order in which they are clipped, the first corner first.
        points = [(0, 0, 0), (4, 0, 0), (2, 10, 0), (2, -1, 0)]
        for polygon, label in (((0, 3, 1, 2), 1), ((1, 2, 0, 3), 0)):
            self.assertEqual(self.segment(self.write_off(points, [polygon]), "--segments", 2),
                             [label])
            self.assertEqual(self.report()["segments"], 2)


class Constraints(Tool_test):

    def setUp(self):
        super().setUp()
        self.points, self.faces = dumbbell()
        self.mesh = self.write_off(self.points, self.faces)

    def write(self, name, lines):
        (self.directory / name).write_text("".join(line + "\n" for line in lines))
        return name

    def test_seeds_join_segments(self):
        self.assertEqual(max(self.segment(self.mesh)), 1)
        seeds = [-1] * len(self.faces)
        seeds[0] = seeds[-1] = 4
        self.write("seeds", map(str, seeds))
        self.assertEqual(max(self.segment(self.mesh, "--seeds", "seeds")), 0)
        self.assertEqual(self.report()["parameters"]["seeds"], "seeds")

    def test_labels_are_seeds(self):
        labels = [int(f > 100) for f in range(len(self.faces))]
        self.write("seeds", map(str, labels))
        self.assertEqual(self.segment(self.mesh, "--seeds", "seeds"), labels)

    def test_edges(self):
        labels = self.segment(self.mesh)
        faces_at = {}
        for f, face in enumerate(self.faces):
            for i in range(3):
                faces_at.setdefault(tuple(sorted((face[i], face[i - 2]))), []).append(f)
        seam = [e for e, (f, g) in faces_at.items() if labels[f] != labels[g]]
        self.write("edges", ["%d %d keep" % e for e in seam])
        labels = self.segment(self.mesh, "--edges", "edges")
        for e in seam:
            f, g = faces_at[e]
            self.assertEqual(labels[f], labels[g])
        ring = [(1 + 3 * 16 + i, 1 + 3 * 16 + (i + 1) % 16) for i in range(16)]
        self.write("edges", ["%d %d cut" % e for e in ring])
        labels = self.segment(self.mesh, "--edges", "edges")
        for e in ring:
            f, g = faces_at[tuple(sorted(e))]
            self.assertNotEqual(labels[f], labels[g])

    def test_features(self):
        is_left = [sum(self.points[v][0] for v in face) > 0 for face in self.faces]
        n = len(self.faces)
        without = self.segment(self.mesh)
        names = [self.write("labels.csv", ("-7" if left else "4" for left in is_left)),
                 self.write("numbers.csv", ["stress; angle"] +
                            ["%d;1e-3 " % (1e6 + left) for left in is_left])]
        numbers = [x for left in is_left for x in (2.5 if left else 1.5, 7.)]
        for name, kind, order, shape, values in (
                ("c.npy", "f8", "False", (n, 2), numbers),
                ("f.npy", "f4", "True", (n, 2), numbers[::2] + numbers[1::2]),
                ("i.npy", "i4", "False", (n,), list(map(int, is_left)))):
            header = "{'descr': '<%s', 'fortran_order': %s, 'shape': %s, }\n" % (kind, order, shape)
            code = "<%d%s" % (len(values), {"f8": "d", "f4": "f", "i4": "i"}[kind])
            (self.directory / name).write_bytes(
                b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() +
                struct.pack(code, *values))
            names.append(name)
        for name in names:
            labels = self.segment(self.mesh, "--features", name, "--feature-weight", 1,
                                  "--segments", 2)
            number = sum(bool(label) == left for label, left in zip(labels, is_left))
            self.assertGreater(max(number, n - number), 0.9 * n)
            self.assertEqual(self.report()["parameters"]["features"], name)
            self.assertEqual(
                self.segment(self.mesh, "--features", name, "--feature-weight", 0), without)
        self.segment(self.mesh)
        self.assertIsNone(self.report()["parameters"]["feature_weight"])

    def test_colors(self):
        """A ball is cut where its color changes, in any format, and without colors not at all."""
        n = 24
        points = [(0, 0, 1), (0, 0, -1)] + [
            (math.sin(t) * math.cos(a), math.sin(t) * math.sin(a), math.cos(t))
            for t in (math.pi * i / 16 for i in range(1, 16))
            for a in (2 * math.pi * k / n for k in range(n))]
        at = lambda i, k: 2 + n * i + k % n
        faces = [f for k in range(n) for f in ((0, at(0, k), at(0, k + 1)),
                                               (1, at(14, k + 1), at(14, k)))]
        faces += [f for i in range(14) for k in range(n)
                  for f in ((at(i, k), at(i + 1, k), at(i + 1, k + 1)),
                            (at(i, k), at(i + 1, k + 1), at(i, k + 1)))]
        is_red = lambda f: sum(points[v][2] for v in f) > 0
        colors = [(200, 40, 40) if is_red(f) else (20, 20, 220) for f in faces]
        dyes = [(.8, .1, .1) if p[2] > 0 else (.1, .1, .8) for p in points]
        numbers = lambda values: " ".join(map(str, values))
        ply = ["ply", "format ascii 1.0", "element vertex %d" % len(points)] + [
            "property float " + c for c in "xyz"]
        of_faces = ["property uchar " + c for c in ("red", "green", "blue")]
        of_polygons = ["element face %d" % len(faces), "property list uchar int vertex_indices"]
        sizes = "%d %d 0" % (len(points), len(faces))
        self.write("colors.mtl", ["newmtl a", "Kd .8 .1 .1", "newmtl b", "Kd .1 .1 .8"])
        obj = ["v " + numbers(p) for p in points]
        corners = [" ".join(str(v + 1) for v in f) for f in faces]
        dyed = [numbers(p + d) for p, d in zip(points, dyes)]
        indices = ["3 " + numbers(f) for f in faces]
        for name, lines in (
                ("faces.ply", ply + of_polygons + of_faces + ["end_header"] +
                 [numbers(p) for p in points] +
                 [i + " " + numbers(c) for i, c in zip(indices, colors)]),
                ("points.ply", ply + ["property float " + c for c in ("red", "green", "blue")] +
                 of_polygons + ["end_header"] + dyed + indices),
                ("faces.off", ["OFF", sizes] + [numbers(p) for p in points] +
                 [i + " " + numbers(c) for i, c in zip(indices, colors)]),
                ("points.off", ["COFF", sizes] + [d + " 1" for d in dyed] + indices),
                ("points.obj", ["v " + d for d in dyed] + ["f " + c for c in corners]),
                ("materials.obj", ["mtllib colors.mtl"] + obj +
                 [line for f, c in zip(faces, corners)
                  for line in ("usemtl " + "ba"[is_red(f)], "f " + c)])):
            with self.subTest(name=name):
                mesh = self.write(name, lines)
                self.assertEqual(set(self.segment(mesh)), {0})
                labels = self.segment(mesh, "--features", "colors")
                self.assertEqual(len(set(zip(labels, map(is_red, faces)))), len(set(labels)))
                self.assertEqual(set(labels), {0, 1})
        self.assert_failure("input", self.mesh, "--features", "colors", message="no colors")
        self.write("colors.mtl", ["newmtl a", "map_Kd picture.png", "newmtl b"])
        self.assert_failure("input", "materials.obj", "--features", "colors",
                            message="images are not read")

    def test_bad_features(self):
        n = len(self.faces)
        for lines, kind, message in (
                (["1"], "usage", "1 vectors, but the mesh has"),
                (["1 2"] * (n - 1) + ["1"], "input", "line %d has 1 numbers" % n),
                (["1"] * (n - 1) + ["x"], "input", "'x', which is no number"),
                (["1", ""] + ["1"] * n, "input", "line 2 has 0 numbers"),
                (["nan"] * n, "usage", "not finite"), ([], "usage", "0 vectors")):
            self.write("features", lines)
            self.assert_failure(kind, self.mesh, "--features", "features", message=message)
        for header, message in (("{'descr': '<f4', 'fortran_order': False, 'shape': (%d,), }" % n,
                                  "too short"), ("{}", "has no shape"),
                                 ("{'descr': '<c8', 'fortran_order': False, 'shape': (0, 1)}",
                                  "'c8'"),
                                 ("{'descr': '>f4', 'fortran_order': False, 'shape': (0,)}",
                                  "byte order"),
                                 ("{'shape': (1, 2, 3)}", "not the shape")):
            (self.directory / "f.npy").write_bytes(
                b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode())
            self.assert_failure("input", self.mesh, "--features", "f.npy", message=message)
        (self.directory / "f.npy").write_bytes(b"\x93NUMPY\x01\x00\xff\xff{")
        self.assert_failure("input", self.mesh, "--features", "f.npy",
                            message="ends in its header")
        self.assert_failure("input", self.mesh, "--features", "nothing", message="cannot be read")

    def test_bad_files(self):
        n = len(self.faces)
        for lines, message in ((["1"], "1 lines"), (["x"] * n, "line 1: a seed is"),
                                (["1 2"] * n, "line 1: there is more")):
            self.write("seeds", lines)
            self.assert_failure("usage", self.mesh, "--seeds", "seeds", message=message)
        for line, message in (("1 2", "line 1: an edge is"), ("1 2 glue", "line 1: an edge is"),
                               ("1 -2 cut", "line 1: an edge is"), ("0 1 cut x", "more than"),
                               ("0 99999 cut", "line 1: an edge is"), ("0 60 cut", "no edge")):
            self.write("edges", [line])
            self.assert_failure("usage", self.mesh, "--edges", "edges", message=message)
        self.assert_failure("input", self.mesh, "--edges", "nothing", message="cannot be read")
        self.write("edges", ["0 1 cut"])
        self.write("seeds", ["3"] * n)
        self.assert_failure("usage", self.mesh, "--seeds", "seeds", "--edges", "edges",
                            message="is constrained")
        self.assert_failure("usage", self.mesh, "--seeds", "seeds", "--out-dir", "out",
                            message="of one mesh")


class Failures(Tool_test):

    def setUp(self):
        super().setUp()
        self.mesh = MESHES / "hand.off"

    def test_open_mesh_that_points_inward(self):
        points, faces = read_off(MESHES / "head.off")
        for name, written, is_warned_of in (("inward.off", faces, True),
                                            ("outward.off", [f[::-1] for f in faces], False)):
            write_off(self.directory / name, points, written)
            done = self.run_tool(name, "--json", "out.json")
            for text in (done.stderr, " ".join(self.report()["warnings"])):
                self.assertEqual("seem to point inward" in text, is_warned_of)
            self.assertEqual(self.report()["segments"], 3)

    def test_reversed_mesh(self):
        """An open part of a dumbbell has its parts from outside only."""
        points, faces = dumbbell()
        part = [f for f in faces if sum(points[v][2] for v in f) < 36]
        write_off(self.directory / "part.off", points, part)
        write_off(self.directory / "reversed.off", points, [f[::-1] for f in part])
        labels = [self.run_tool(*arguments, "--labels", "-", "--quiet").stdout for arguments in
                  (("part.off",), ("reversed.off", "--reverse"), ("reversed.off",))]
        self.assertEqual(labels[0], labels[1])
        self.assertNotEqual(labels[0], labels[2])

    def test_faces_of_tetrahedra(self):
        """A dumbbell of cells, each of six tetrahedra: faces of the surface occur once."""
        cells = [(x, y, z) for x in range(10) for y in range(3) for z in range(3)
                 if not 3 <= x < 7 or y == z == 1]
        points, faces = {}, []
        for cell in cells:
            for order in itertools.permutations(range(3)):
                corners = [cell]
                for axis in order:
                    corners.append(tuple(c + (k == axis) for k, c in enumerate(corners[-1])))
                indices = [points.setdefault(p, len(points)) for p in corners]
                faces += itertools.combinations(indices, 3)
        number = collections.Counter(map(frozenset, faces))
        surface = [f for f in faces if number[frozenset(f)] == 1]
        write_off(self.directory / "surface.off", list(points), surface)
        expected = self.run_tool("surface.off", "--labels", "-", "-o", "surface_out.off",
                                 "--quiet").stdout.split()
        self.assertEqual(set(expected), {"0", "1", "2"})
        distinct = [tuple(f) for f in number]
        for written in (faces, distinct):
            write_off(self.directory / "in.off", list(points), written)
            done = self.run_tool("in.off", "--labels", "labels.txt", "-o", "out.off")
            self.assertIn("tetrahedra", done.stderr)
            self.assertIn("left out: %d\n" % (len(written) - len(surface)), done.stderr)
            labels = (self.directory / "labels.txt").read_text().split()
            label_of_face = dict(zip(map(frozenset, written), labels))
            self.assertEqual([label_of_face[frozenset(f)] for f in surface], expected)
            number_of_polygons = [(self.directory / name).read_text().split()[2]
                                  for name in ("out.off", "surface_out.off")]
            self.assertEqual(*number_of_polygons)

    def test_points_that_are_not_finite(self):
        """Leave the faces beside them with the label of a neighbor, and a warning."""
        points, faces = read_off(self.mesh)
        spoiled = [17, 300]
        lines = ["v nan inf -inf" if i in spoiled else "v %r %r %r" % tuple(p)
                 for i, p in enumerate(points)] + ["v nan nan nan"]
        lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
        (self.directory / "in.obj").write_text("\n".join(lines))
        outputs = [option for name in ("ply", "obj", "off", "glb", "html")
                   for option in ("--html" if name == "html" else "-o", "out." + name)]
        done = self.run_tool("in.obj", "--labels", "out.seg", "--json", "out.json", *outputs)
        self.assertEqual(done.returncode, 0, done.stderr)
        spoiled_faces = [i for i, face in enumerate(faces) if set(face) & set(spoiled)]
        message = ("face %d uses a point that is not finite; corners left out: %d"
                    % (spoiled_faces[0], sum(v in spoiled for face in faces for v in face)))
        self.assertEqual(done.stderr, "segment_mesh: warning: in.obj: " + message + "\n")
        self.assertEqual(self.report()["warnings"], [message])
        labels = self.labels()
        self.assertEqual(len(labels), len(faces))
        for i in spoiled_faces:
            others = [labels[j] for j, face in enumerate(faces)
                      if j not in spoiled_faces and len(set(face) & set(faces[i])) == 2]
            self.assertTrue(not others or labels[i] in others, i)
        for name in ("ply", "obj", "off"):
            done = self.run_tool("out." + name)
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)

    def test_input_that_is_no_mesh(self):
        empty = "OFF\n0 0 0\n"
        triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
        cases = {
            "nothing.off": "", "nothing.obj": "", "nothing.ply": "", "nothing.stl": "",
            "text.off": "Dear Sir", "text.obj": "Dear Sir", "text.ply": "Dear Sir",
            "text.stl": "Dear Sir", "empty.off": empty, "cut.off": triangle[:-6],
            "huge.off": triangle.replace("3 1", "4000000000 4000000000"),
            "index.off": triangle.replace("0 1 2", "0 1 3"),
            "negative.off": triangle.replace("0 1 2", "0 1 -1"),
            "index.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
            "points.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
            "nan.off": triangle.replace("1 0 0", "nan 0 0"),
            "inf.off": triangle.replace("1 0 0", "inf 0 0"),
            "overflow.off": triangle.replace("1 0 0", "1e999 0 0"),
            "degenerate.off": triangle.replace("0 1 2", "0 1 1"),
            "name.xyz": "0 0 0\n", "name": "Dear Sir", "page.glb": "<html>", "text.gz": "\x1f",
        }
        for name, text in cases.items():
            (self.directory / name).write_text(text)
            with self.subTest(name):
                self.assert_failure("mesh", name, "-o", "out.ply", "--labels", "out.seg",
                                    message=name)
        self.assert_failure("input", "missing.off", message="there is no file missing.off")

    def test_folders_are_searched(self):
        (self.directory / "scans/deep/.hidden").mkdir(parents=True)
        points, faces = read_off(self.mesh)
        write_off(self.directory / "scans/a.off", points, faces)
        write_binary_stl(self.directory / "scans/deep/b.STL", points, faces)
        write_off(self.directory / "scans/deep/.hidden/c.off", points, faces)
        for name in ("notes.txt", "scene.xml", "off", "deep/table.csv"):
            (self.directory / "scans" / name).write_text("no mesh")
        run = ("scans", "--out-dir", "scans/results", "--outputs", "ply")
        for summary in ("3 meshes segmented, 0 failed, 0 done before",
                        "0 meshes segmented, 0 failed, 3 done before"):
            done = self.run_tool(*run)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(summary, done.stdout)
            rows = (self.directory / "scans/results/table.jsonl").read_text().splitlines()
            self.assertEqual(sorted(json.loads(row)["input"] for row in rows),
                             ["scans/a.off", "scans/deep/.hidden/c.off", "scans/deep/b.STL"])
        (self.directory / "empty").mkdir()
        self.assert_failure("usage", "scans", "-o", "out.ply",
                            message="scans is a folder; --out-dir DIR segments the meshes in it")
        self.assert_failure("usage", "scans", "--out-dir", ".", message="another --out-dir")
        self.assert_failure("input", "empty", "--out-dir", "out", message="no mesh in empty")

    def test_wrong_usage(self):
        for arguments in ((), ("--unknown", self.mesh), (self.mesh, self.mesh),
                          (self.mesh, "--segments"), (self.mesh, "--segments", "0"),
                          (self.mesh, "--segments", "-3"), (self.mesh, "--segments", "many"),
                          (self.mesh, "--segments", "2.5"), (self.mesh, "--segments", "9" * 30),
                          (self.mesh, "--salience-threshold", "nan"),
                          (self.mesh, "--method", "best"),
                          (self.mesh, "--salience-threshold", "high"),
                          (self.mesh, "--seed", "-1"), (self.mesh, "--threads", "0"),
                          (self.mesh, "--salience-threshold", "2"),
                          (self.mesh, "--out-dir", "out", "--labels", "out.seg"),
                          (self.mesh, "--outputs", "ply"), (self.mesh, "--jobs", "2"),
                          ("a/in.off", "../a/in.off", "--out-dir", "out"),
                          (self.mesh, "--smooth", "-1"), (self.mesh, "-o"),
                          (self.mesh, "-o", "", "--labels", "out.seg"),
                          (self.mesh, "-o", "out.stl"), (self.mesh, "-o", "out"), ("",)):
            self.assert_failure("usage", *arguments)
        for word, option in (("--segment", "--segments"), ("--output", "-o"), ("-n", "--segments"),
                             ("--parts", "--segments"), ("--threshold=1", "--salience-threshold"),
                             ("--lables", "--labels")):
            self.assert_failure("usage", self.mesh, word, "5",
                                message="unknown option %s; did you mean %s?" % (word, option))
        self.assert_failure("usage", self.mesh, "--unknown", message="--unknown; see --help")
        for options in (("--salience-threshold", "0.5"), ("--maximum-segments", "7")):
            self.assert_failure("usage", self.mesh, "--segments", "5", *options,
                                message="--maximum-segments N limits the number")
        self.assert_failure("usage", self.mesh, "--segments", "1000000", message="1 to 2390")

    def test_output_that_cannot_be_written(self):
        (self.directory / "directory.ply").mkdir()
        (self.directory / "file").write_text("kept")
        for option, name in (("-o", "missing/out.ply"), ("-o", "directory.ply"),
                             ("--labels", "missing/out.seg"), ("--labels", "/dev/full"),
                             ("--json", "."), ("--json", "file/out.json"),
                             ("--split-dir", "file"), ("--split-dir", "missing/parts")):
            self.assert_failure("output", self.mesh, option, name, message="cannot")
        self.assert_failure("usage", self.mesh, "--labels", "x", "--json", "./x",
                            message="two outputs")
        self.assert_failure("usage", self.mesh, "--labels", "-", "--json", "-",
                            message="two outputs")
        (self.directory / "in.off").write_bytes(self.mesh.read_bytes())
        self.assert_failure("usage", "in.off", "--labels", "./in.off", message="is the input")
        self.assertEqual((self.directory / "file").read_text(), "kept")

    def test_time_limit(self):
        self.assert_failure("time", self.mesh, "--time-limit", "0.001", message="time limit")
        for limit in ("nan", "0"):
            self.assert_failure("usage", self.mesh, "--time-limit", limit)

    def test_memory_limit(self):
        for limits in (("nan",), ("100", "--threads", "2")):
            self.assert_failure("usage", self.mesh, "--memory-limit", *limits)
        if b"__asan_init" in pathlib.Path(TOOL).read_bytes():
            self.skipTest("the sanitizer needs address space without a limit")
        self.assert_failure("memory", self.mesh, "--memory-limit", "1", message="memory")
        for limit in (20, 30, 36, 40, 50): # somewhere on the way
            done = self.run_tool(self.mesh, "--memory-limit", limit, "--quiet")
            self.assertIn(done.returncode, (0, STATUSES.index("memory")), limit)
        done = self.run_tool(self.mesh, "--out-dir", "out", "--memory-limit", "1")
        self.assertEqual((done.returncode, done.stderr), (STATUSES.index("some failed"), ""))
        table = json.loads((self.directory / "out/table.jsonl").read_text())
        self.assertEqual(table["status"], "memory")

    def test_report_of_a_failure(self):
        (self.directory / "text.off").write_text("Dear Sir")
        done = self.run_tool("text.off", "--json", "out.json", "-o", "out.ply")
        self.assertEqual(done.returncode, STATUSES.index("mesh"))
        self.assertEqual(self.report()["status"], "mesh")
        self.assertEqual("segment_mesh: " + self.report()["message"] + "\n", done.stderr)
        self.assertFalse((self.directory / "out.ply").exists())


class Printing(Tool_test):

    def test_summary(self):
        mesh = MESHES / "hand.off"
        done = self.run_tool(mesh)
        self.assertEqual((done.returncode, done.stderr, done.stdout.count("\n")), (0, "", 1))
        self.assertIn("%d faces" % len(read_off(mesh)[1]), done.stdout)
        self.assertEqual(list(self.directory.iterdir()), [])

    @unittest.skipUnless(hasattr(os, "openpty"), "this system has no terminals")
    def test_terminal_shows_how_to_write_a_file(self):
        for arguments, is_shown in (((), True), (("--quiet",), False),
                                    (("--labels", "out.seg"), False)):
            screen, terminal = os.openpty()
            subprocess.run([TOOL, MESHES / "hand.off", *arguments], cwd=self.directory,
                           stdout=subprocess.DEVNULL, stderr=terminal, timeout=300, check=True)
            os.close(terminal)
            lines = []
            with open(screen, errors="replace") as text, contextlib.suppress(OSError):
                for line in text: # fails at the end
                    lines.append(line)
            self.assertEqual(any("--html FILE" in line for line in lines), is_shown, lines)

    def test_quiet(self):
        done = self.run_tool(MESHES / "hand.off", "--quiet")
        self.assertEqual((done.returncode, done.stderr, done.stdout), (0, "", ""))

    def test_version_and_help(self):
        done = self.run_tool("--version")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"\Asegment_mesh \d+\.\d+\.\d+\n\Z")
        done = self.run_tool("--help")
        self.assertEqual(done.returncode, 0)
        for option in ("-o", "--labels", "--json", "--split-dir", "--segments", "--seed",
                       "--method", "--salience-threshold", "--threads", "--smooth",
                       "--keep-faces", "--quiet", "--version", "--hulls",
                       "scripts/render.py"):
            self.assertIn(option, done.stdout)
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)


if __name__ == "__main__":
    TOOL, MESHES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
