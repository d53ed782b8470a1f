# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads mesh files in the formats of the outputs, and writes some of them."""

import collections
import json
import operator
import struct
import xml.etree.ElementTree
import zipfile

Ply = collections.namedtuple("Ply", "points faces segments colors")


def read_off(path):
    lines = [line.split("#")[0] for line in path.read_text().splitlines()]
    words = iter(" ".join(lines).split())
    assert next(words) == "OFF"
    counts = [int(next(words)) for _ in range(3)]
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(counts[0])]
    faces = [tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(counts[1])]
    return points, faces


def write_off(path, points, faces):
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))]
    lines += ["%r %r %r" % tuple(p) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def read_ply_rows(path):
    """Returns the elements of a binary PLY of the tool, by name; each is a list of dictionaries."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    codes = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
             "float": "f", "double": "d"}
    elements = []
    for words in (line.split() for line in header.decode().splitlines()):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words)
    position = 0
    rows = {}
    for name, count, properties in elements:
        rows[name] = []
        for _ in range(count):
            row = {}
            for words in properties:
                size = 1
                if words[1] == "list":
                    (size,) = struct.unpack_from("<" + codes[words[2]], body, position)
                    position += struct.calcsize(codes[words[2]])
                numbers = struct.Struct("<%d%s" % (size, codes[words[-2]]))
                values = numbers.unpack_from(body, position)
                position += numbers.size
                row[words[-1]] = values if words[1] == "list" else values[0]
            rows[name].append(row)
    assert position == len(body)
    return rows


def read_ply(path):
    """Returns a binary PLY as the tool writes it; segments and colors are empty if it has none."""
    rows = read_ply_rows(path)
    color = operator.itemgetter("red", "green", "blue")
    faces = rows["face"]
    for vertex in rows["vertex"]:
        color(vertex)
    return Ply([(v["x"], v["y"], v["z"]) for v in rows["vertex"]],
               [f["vertex_indices"] for f in faces],
               [f["segment"] for f in faces if "segment" in f],
               [color(f) for f in faces if "red" in f])


def read_obj_rows(path):
    """Returns the points and vectors of an OBJ as "v", "vt" and "vn", and its faces as "f": lists
    of corners, which are tuples of indices from 0."""
    rows = {"v": [], "vt": [], "vn": [], "f": []}
    for words in map(str.split, path.read_text().splitlines()):
        if words and words[0] == "f":
            rows["f"].append([tuple(int(i) - 1 for i in word.split("/")) for word in words[1:]])
        elif words and words[0] in rows:
            rows[words[0]].append(tuple(map(float, words[1:])))
    return rows


def read_obj(path):
    rows = read_obj_rows(path)
    return rows["v"], [tuple(corner[0] for corner in face) for face in rows["f"]]


def read_glb(content):
    """Returns the JSON and the data of a binary glTF."""
    assert struct.unpack_from("<3I", content) == (0x46546c67, 2, len(content))
    (size,) = struct.unpack_from("<I", content, 12)
    assert size % 4 == 0
    return json.loads(content[20:20 + size]), content[28 + size:]


def read_stl(path):
    """Points and faces of a binary STL; equal points are one."""
    numbers, faces = {}, []
    for row in struct.iter_unpack("<12fH", path.read_bytes()[84:]):
        faces.append([numbers.setdefault(row[i:i + 3], len(numbers)) for i in (3, 6, 9)])
    return list(numbers), faces


Object_3mf = collections.namedtuple("Object_3mf", "name type color points triangles components")


def read_3mf(path):
    """Returns the objects of a 3MF by their ids, and the ids of those that are built."""
    core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    with zipfile.ZipFile(path) as file:
        assert file.testzip() is None
        # The sizes of ZIP64 are in further fields, which Assimp 5 does not read.
        assert not any(info.extra for info in file.infolist())
        model = xml.etree.ElementTree.fromstring(file.read("3D/3dmodel.model"))
    assert model.get("unit") == "millimeter"
    materials = {group.get("id"): [(base.get("name"), base.get("displaycolor")) for base in group]
                 for group in model.iter(core + "basematerials")}
    objects = {}
    for element in model.iter(core + "object"):
        name, color = element.get("name"), None
        if element.get("pid"):
            material, color = materials[element.get("pid")][int(element.get("pindex"))]
            assert material == name and color.endswith("FF")
            color = tuple(bytes.fromhex(color[1:7]))
        components = [c.get("objectid") for c in element.iter(core + "component")]
        assert all(c in objects for c in components) # they come before
        objects[element.get("id")] = Object_3mf(
            name, element.get("type"), color,
            [tuple(float(v.get(axis)) for axis in "xyz") for v in element.iter(core + "vertex")],
            [tuple(int(t.get(v)) for v in ("v1", "v2", "v3"))
             for t in element.iter(core + "triangle")], components)
    return objects, [item.get("objectid") for item in model.iter(core + "item")]


def write_ascii_stl(path, points, faces):
    lines = ["solid mesh"]
    for face in faces:
        lines.append("facet normal 0 0 0\nouter loop")
        lines += ["vertex %r %r %r" % points[v] for v in face]
        lines.append("endloop\nendfacet")
    path.write_text("\n".join(lines) + "\nendsolid mesh\n")


def write_binary_stl(path, points, faces):
    with open(path, "wb") as out:
        out.write(bytes(80) + struct.pack("<I", len(faces)))
        for face in faces:
            out.write(struct.pack("<3f", 0, 0, 0))
            for v in face:
                out.write(struct.pack("<3f", *points[v]))
            out.write(struct.pack("<H", 0))
