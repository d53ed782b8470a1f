#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests --urdf and --mjcf of the command line tool: robot_descriptions.py TOOL MESHES."""

import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

TOOL = None
MESHES = None

BOX_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]

# The attributes that each element may have, from the specification of URDF and MuJoCo's reference
URDF = {"robot": {"name"}, "link": {"name"}, "inertial": set(), "origin": {"xyz", "rpy"},
        "mass": {"value"}, "inertia": {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}, "visual": set(),
        "collision": set(), "geometry": set(), "mesh": {"filename", "scale"}, "material": {"name"},
        "color": {"rgba"}, "joint": {"name", "type"}, "parent": {"link"}, "child": {"link"}}
MJCF = {"mujoco": {"model"}, "asset": set(), "mesh": {"name", "file", "scale"}, "worldbody": set(),
        "body": {"name", "pos"}, "freejoint": set(), "inertial": {"pos", "mass", "fullinertia"},
        "geom": {"type", "mesh", "pos", "contype", "conaffinity", "group", "rgba"}}


def box(size, center=(0, 0, 0)):
    points = [tuple(c + s * (k - 0.5) for c, s, k in zip(center, size, (x, y, z)))
              for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    return points, BOX_FACES


def surface_of_revolution(radii, heights, around=48):
    """Returns a closed surface around the z axis; the first and the last radius are 0."""
    points = [(0., 0., heights[0])]
    for radius, z in list(zip(radii, heights))[1:-1]:
        points += [(radius * math.cos(2 * math.pi * i / around),
                    radius * math.sin(2 * math.pi * i / around), z) for i in range(around)]
    points.append((0., 0., heights[-1]))
    faces, last = [], 1 + (len(radii) - 3) * around
    for i in range(around):
        j = (i + 1) % around
        faces += [(0, 1 + j, 1 + i), (last + i, last + j, len(points) - 1)]
        for start in range(1, last, around):
            faces += [(start + i, start + j, start + j + around),
                      (start + i, start + j + around, start + i + around)]
    return points, faces


def ball(radius):
    angles = [math.pi * i / 40 for i in range(41)]
    return surface_of_revolution([radius * math.sin(a) for a in angles],
                                 [-radius * math.cos(a) for a in angles])


def dumbbell():
    """Returns two balls of different size, and a bar between them."""
    heights = [-3 + i / 16 for i in range(88)]
    radii = [math.sqrt(max(1 - (z + 2)**2, 0.5**2 - (z - 2)**2, 0.2**2 if -2 < z < 2 else 0))
             for z in heights]
    return surface_of_revolution([0] + radii[1:-1] + [0], heights)


def write_off(path, points, faces):
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))]
    lines += ["%r %r %r" % tuple(map(float, p)) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def read_stl(path):
    """Returns the triangles of a binary STL."""
    content = path.read_bytes()
    (number,) = struct.unpack_from("<I", content, 80)
    assert len(content) == 84 + 50 * number
    return [(v[3:6], v[6:9], v[9:12]) for v in struct.iter_unpack("<12fxx", content[84:])]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def numbers(text):
    return [float(word) for word in text.split()]


def determinant(m):
    return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
            m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
            m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))


def is_positive(m):
    """Returns whether a symmetric matrix is positive definite, by its minors."""
    return m[0][0] > 0 and m[0][0] * m[1][1] > m[0][1]**2 and determinant(m) > 0


def around_origin(body):
    """Returns the inertia around the origin, by the theorem of parallel axes."""
    c = body["center"]
    square = sum(x * x for x in c)
    return [[body["inertia"][i][j] + body["mass"] * ((i == j) * square - c[i] * c[j])
             for j in range(3)] for i in range(3)]


def sampled(triangles, density):
    """Returns the mass, and the inertia around the origin, of a solid. The integrals over the
    tetrahedra to the origin are means over points: x x is exact at these four."""
    a, b = (5 - math.sqrt(5)) / 20, (5 + 3 * math.sqrt(5)) / 20
    mass, inertia = 0, [[0.] * 3 for _ in range(3)]
    for triangle in triangles:
        part = density * determinant(triangle) / 6
        mass += part
        for weights in ((a, a, a), (b, a, a), (a, b, a), (a, a, b)):
            p = [sum(w * corner[k] for w, corner in zip(weights, triangle)) for k in range(3)]
            square = sum(x * x for x in p)
            for i in range(3):
                for j in range(3):
                    inertia[i][j] += part / 4 * ((i == j) * square - p[i] * p[j])
    return mass, inertia


class Robot_test(unittest.TestCase):

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def run_tool(self, *arguments, status=0):
        done = subprocess.run([TOOL, *map(str, arguments)], cwd=self.directory, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=300, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stderr

    def check_attributes(self, element, allowed):
        for e in element.iter():
            self.assertLessEqual(set(e.keys()), allowed[e.tag], e.tag)

    def read_urdf(self, name):
        """Returns the bodies by their names, with centers in the frame of the mesh."""
        path = self.directory / name
        robot = xml.etree.ElementTree.parse(path).getroot()
        self.check_attributes(robot, URDF)
        bodies, joints = {}, {}
        for joint in robot.findall("joint"):
            self.assertEqual(joint.get("type"), "fixed")
            joints[joint.find("child").get("link")] = (
                joint.find("parent").get("link"), numbers(joint.find("origin").get("xyz")))
        for link in robot.findall("link"):
            body = {"name": link.get("name"), "parent": joints.get(link.get("name"), (None,))[0]}
            origin, here = [0, 0, 0], link.get("name")
            for _ in range(len(joints) + 1):
                if here in joints:
                    origin = plus(origin, joints[here][1])
                    here = joints[here][0]
            self.assertNotIn(here, joints) # there is no cycle
            body["origin"] = origin
            body["center"] = plus(origin, numbers(link.find("inertial/origin").get("xyz")))
            body["mass"] = float(link.find("inertial/mass").get("value"))
            i = {key: float(value) for key, value in link.find("inertial/inertia").items()}
            body["inertia"] = [[i["ixx"], i["ixy"], i["ixz"]], [i["ixy"], i["iyy"], i["iyz"]],
                               [i["ixz"], i["iyz"], i["izz"]]]
            for kind in ("visual", "collision"):
                for place in numbers(link.find(kind + "/origin").get("xyz")), origin:
                    self.assertEqual(len(place), 3)
                for x, y in zip(plus(numbers(link.find(kind + "/origin").get("xyz")), origin),
                                (0, 0, 0)): # the mesh is where it was
                    self.assertAlmostEqual(x, y)
                mesh = link.find(kind + "/geometry/mesh")
                body[kind] = path.parent / mesh.get("filename")
                body["scale"] = numbers(mesh.get("scale", "1 1 1"))
                self.assertTrue(body[kind].is_file(), body[kind])
            bodies[body["name"]] = body
        self.assertEqual(len(bodies), len(joints) + 1)
        return bodies

    def read_mjcf(self, name):
        path = self.directory / name
        model = xml.etree.ElementTree.parse(path).getroot()
        self.check_attributes(model, MJCF)
        files = {mesh.get("name"): path.parent / mesh.get("file")
                 for mesh in model.findall("asset/mesh")}
        scales = {tuple(numbers(mesh.get("scale", "1 1 1")))
                  for mesh in model.findall("asset/mesh")}
        self.assertEqual(len(scales), 1)
        bodies = {}

        def read(element, parent, origin):
            origin = plus(origin, numbers(element.get("pos")))
            body = {"name": element.get("name"), "parent": parent, "origin": origin,
                    "scale": list(*scales)}
            inertial = element.find("inertial")
            body["mass"] = float(inertial.get("mass"))
            body["center"] = plus(origin, numbers(inertial.get("pos")))
            xx, yy, zz, xy, xz, yz = numbers(inertial.get("fullinertia"))
            body["inertia"] = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
            visual, collision = element.findall("geom")
            self.assertEqual((visual.get("contype"), visual.get("conaffinity")), ("0", "0"))
            self.assertIsNone(collision.get("contype"))
            for kind, geom in (("visual", visual), ("collision", collision)):
                self.assertEqual(geom.get("type"), "mesh")
                body[kind] = files.pop(geom.get("mesh"))
                self.assertTrue(body[kind].is_file())
                for x in plus(numbers(geom.get("pos")), origin):
                    self.assertAlmostEqual(x, 0)
            self.assertEqual(element.find("freejoint") is not None, parent is None)
            bodies[body["name"]] = body
            for child in element.findall("body"):
                read(child, body["name"], origin)

        only, = model.findall("worldbody/body")
        read(only, None, [0, 0, 0])
        self.assertEqual(files, {})
        return bodies

    def read(self, name="robot"):
        """Returns the bodies that both files have."""
        bodies, others = self.read_urdf(name + ".urdf"), self.read_mjcf(name + ".xml")
        self.assertEqual(bodies.keys(), others.keys())
        for key, body in bodies.items():
            self.assert_close(body.pop("origin"), others[key].pop("origin"), 1e-9)
            self.assert_close(body["center"], others[key].pop("center"), 1e-9)
            self.assertEqual({k: v for k, v in body.items() if k != "center"}, others[key])
            self.assertGreater(body["mass"], 0)
            i = body["inertia"]
            self.assertTrue(is_positive(i))
            # Two principal moments are larger than the third one.
            half = (i[0][0] + i[1][1] + i[2][2]) / 2
            self.assertTrue(is_positive([[(j == k) * half - i[j][k] for k in range(3)]
                                         for j in range(3)]))
        self.assertEqual([body["parent"] for body in bodies.values()].count(None), 1)
        return bodies

    def assert_close(self, values, expected, tolerance):
        self.assertEqual(len(values), len(expected))
        for x, y in zip(values, expected):
            self.assertLess(abs(x - y), tolerance, (values, expected))

    def run_on(self, mesh, *options):
        write_off(self.directory / "in.off", *mesh)
        return self.run_tool("in.off", "--urdf", "robot.urdf", "--mjcf", "robot.xml", *options)

    def test_box(self):
        """The inertia of a box with the edges a, b and c is m / 12 (b^2 + c^2) around a."""
        size, center = (0.2, 0.3, 0.5), (1., -2., 30.)
        for factor, options, density in ((1, (), 1000), (100, ("--unit", "cm"), 1000),
                                         (1, ("--density", "2700"), 2700),
                                         (1000, ("--scale", "0.001"), 1000)):
            points, faces = box(size, center)
            errors = self.run_on(([[factor * x for x in p] for p in points], faces), "--segments",
                                 1, *options)
            self.assertEqual(errors, "")
            (name, body), = self.read().items()
            self.assertEqual((name, body["parent"]), ("segment_000", None))
            mass = density * math.prod(size)
            self.assertAlmostEqual(body["mass"] / mass, 1, places=9)
            self.assert_close(body["center"], center, 1e-9)
            for i in range(3):
                for j in range(3):
                    expected = mass / 12 * (sum(x * x for x in size) - size[i]**2) * (i == j)
                    self.assertAlmostEqual(body["inertia"][i][j] / mass, expected / mass, places=9)
            scale = 0.01 if "cm" in options else 1
            self.assertEqual(body["scale"], [scale] * 3)
            corners = [x for kind in ("visual", "collision") for t in read_stl(body[kind])
                       for corner in t for x in corner]
            self.assertAlmostEqual(max(corners) * scale, 30.25, places=5)

    def test_ball(self):
        """The mass of a ball is 4 / 3 pi r^3 density, and its inertia 2 / 5 m r^2."""
        self.assertEqual(self.run_on(ball(0.5), "--segments", 1), "")
        body, = self.read().values()
        mass = 4 / 3 * math.pi * 0.5**3 * 1000
        self.assertAlmostEqual(body["mass"] / mass, 1, delta=0.01)
        self.assert_close(body["center"], (0, 0, 0), 1e-9)
        for i in range(3):
            for j in range(3):
                expected = (i == j) * 0.4 * 0.5**2
                self.assertAlmostEqual(body["inertia"][i][j] / body["mass"], expected, delta=0.001)

    def test_parts_sum_up(self):
        """The parts have the mass and the inertia of the whole, and are joined at their neck."""
        for mesh, options in ((dumbbell(), ("--segments", 3)), (dumbbell(), ("--keep-faces",))):
            self.assertEqual(self.run_on(mesh, *options), "")
            bodies = self.read()
            points, faces = mesh
            mass, inertia = sampled([[points[v] for v in face] for face in faces], 1000)
            self.assertAlmostEqual(sum(b["mass"] for b in bodies.values()) / mass, 1, places=6)
            for i in range(3):
                for j in range(3):
                    parts = sum(around_origin(b)[i][j] for b in bodies.values())
                    self.assertAlmostEqual(parts / inertia[2][2], inertia[i][j] / inertia[2][2],
                                           places=5)
            for b in bodies.values():
                whole, _ = sampled(read_stl(b["visual"]), 1000)
                self.assertAlmostEqual(whole / b["mass"], 1, places=4)
                hull, _ = sampled(read_stl(b["collision"]), 1000)
                self.assertGreater(hull / b["mass"], 1 - 1e-5)
            heaviest = max(bodies.values(), key=lambda b: b["mass"])
            self.assertIsNone(heaviest["parent"])
        self.run_on(dumbbell(), "--segments", 3)
        urdf = self.read_urdf("robot.urdf")
        by_height = sorted(urdf.values(), key=lambda b: b["center"][2])
        large, bar, small = by_height
        self.assertEqual((large["parent"], bar["parent"], small["parent"]),
                         (None, large["name"], bar["name"]))
        self.assert_close(bar["origin"], (0, 0, -1.02), 0.2)
        self.assert_close(small["origin"], (0, 0, 1.54), 0.2)
        self.assertEqual(large["origin"], [0, 0, 0])

    def test_segments_that_do_not_touch(self):
        meshes = [box((1, 1, 1)), box((2, 2, 2), (5, 0, 0)), box((0.5, 0.5, 0.5), (0, 7, 0))]
        points, faces = [], []
        for p, f in meshes:
            faces += [tuple(v + len(points) for v in face) for face in f]
            points += p
        self.assertEqual(self.run_on((points, faces), "--keep-components-separate"), "")
        urdf = self.read_urdf("robot.urdf")
        self.read()
        masses = {b["name"]: b["mass"] for b in urdf.values()}
        root, = (b for b in urdf.values() if b["parent"] is None)
        self.assertAlmostEqual(root["mass"], 8000)
        self.assertEqual(sorted(round(m) for m in masses.values()), [125, 1000, 8000])
        for b in urdf.values():
            if b is not root:
                self.assertEqual(b["parent"], root["name"])
                self.assert_close(b["origin"], b["center"], 1e-9)

    def test_segments_that_are_no_solid(self):
        """Two sheets at the same place have no inside, and neither have two tetrahedra that
        intersect. A sheet becomes a thin solid."""
        sheet = [(0, 0, 0), (3, 0, 0), (3, 4, 0), (0, 4, 0)]
        self.assertNotIn("no solid", self.run_on((sheet, [(0, 1, 2), (0, 2, 3)])))
        body, = self.read().values()
        whole, _ = sampled(read_stl(body["visual"]), 1000)
        self.assertAlmostEqual(body["mass"] / whole, 1, places=5)
        warned = self.run_on((sheet, [(0, 1, 2), (0, 2, 3), (2, 1, 0), (3, 2, 0)]))
        self.assertIn("bound no solid have the mass and inertia of their hulls: 0", warned)
        body, = self.read().values()
        self.assertAlmostEqual(body["mass"] / (1000 * 3 * 4 * 0.005), 1, places=6)
        self.assertEqual(body["visual"], body["collision"])
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
        warned = self.run_on((points + [plus(p, (0.2,) * 3) for p in points],
                              faces + [tuple(v + 4 for v in f) for f in faces]), "--segments", 1)
        self.assertIn("mass and inertia of their hulls: 0", warned)
        body, = self.read().values()
        hull, _ = sampled(read_stl(body["collision"]), 1000)
        self.assertAlmostEqual(body["mass"] / hull, 1, places=6)
        self.assertNotEqual(body["visual"], body["collision"])

    def test_folders(self):
        write_off(self.directory / 'a&"b.off', *dumbbell())
        (self.directory / "robots").mkdir()
        self.run_tool('a&"b.off', "--urdf", "robots/a&b.urdf", "--mjcf", "model.xml", "--hulls",
                      "my_hulls", "--hull-vertices", 20, "--split-format", "obj")
        bodies = list(self.read_urdf("robots/a&b.urdf").values())
        root = xml.etree.ElementTree.parse(self.directory / "robots/a&b.urdf").getroot()
        self.assertEqual(root.get("name"), 'a&"b')
        names = [mesh.get("filename") for mesh in root.findall("link/*/geometry/mesh")]
        self.assertEqual(names[:2],
                         ["a&b_parts/%s.obj" % bodies[0]["name"],
                          "../my_hulls/%s.obj" % bodies[0]["name"]])
        files = [b["collision"].resolve() for b in bodies]
        self.assertEqual([b["collision"].resolve() for b in self.read_mjcf("model.xml").values()],
                         files)
        for file in files:
            self.assertLessEqual(file.read_text().count("\nv "), 20)
        write_off(self.directory / "in.off", *box((1, 1, 1)))
        self.run_tool("in.off", "--out-dir", "out", "--outputs", "urdf,mjcf")
        self.assertEqual(self.read_urdf("out/in.off.urdf").keys(),
                         self.read_mjcf("out/in.off.xml").keys())

    def test_wrong_usage(self):
        write_off(self.directory / "in.off", *box((1, 1, 1)))
        for options, message in (
                (("--urdf", "-"), "--urdf and --mjcf need a file"),
                (("--mjcf", "x.xml", "--split-format", "ply"), "need --split-format stl or obj"),
                (("--urdf", "x.urdf", "--density", "0"), "--density"),
                (("--urdf", "x.urdf", "--density", "nan"), "must be numbers"),
                (("--urdf", "x.urdf", "--mjcf", "./x.urdf"), "two outputs")):
            self.assertIn(message, self.run_tool("in.off", *options, status=2))
            self.assertEqual([p.name for p in self.directory.iterdir()], ["in.off"])

    def test_real_meshes(self):
        for name in ("elephant.off", "camel.off", "triceratops.off", "hand.off"):
            self.run_tool(MESHES / name, "--urdf", "robot.urdf", "--mjcf", "robot.xml",
                          "--hull-vertices", 64)
            self.assertGreater(len(self.read()), 3)


if __name__ == "__main__":
    TOOL = str(pathlib.Path(sys.argv[1]).resolve())
    MESHES = pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
