#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes small files of a format, from which a fuzzer starts: make_corpus.py FORMAT FOLDER."""

import pathlib
import struct
import sys

POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1.25)]
FACES = [(3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
TRIANGLES = [(3, 2, 1), (3, 1, 0)] + FACES[1:]


def lines(rows, separator=" ", end="\n"):
    return end.join(separator.join(map(str, row)) for row in rows) + end


def off_text(keyword="OFF", more=(), colors=(), end="\n", header="%s\n%d %d 0\n"):
    text = header % (keyword, len(POINTS), len(FACES))
    text += lines([p + more for p in POINTS]) + lines([(len(f), *f) + colors for f in FACES])
    return text.replace("\n", end).encode()


def off_binary(keyword="OFF", more=0):
    data = keyword.encode() + b" BINARY\n" + struct.pack(">3i", len(POINTS), len(FACES), 0)
    for p in POINTS:
        data += struct.pack(">%df" % (3 + more), *p, *[0.5] * more)
    for i, f in enumerate(FACES):
        data += struct.pack(">%di" % (len(f) + 1), len(f), *f)
        data += struct.pack(">i%df" % (i % 5), i % 5, *[0.5] * (i % 5))
    return data


def off_files():
    return [off_text(), off_text(colors=(255, 0, 0)), off_text("COFF", (1, 0, 0, 1), end="\r\n"),
            off_text("STNOFF", (0, 0, 1, 0.5, 0.5)), off_text("nOFF", header="%s 3\n%d %d 0\n"),
            off_text(header="# a comment\n%s %d %d # no edges\n"),
            off_text("", header="%s%d %d 0\n"),
            off_binary(), off_binary("CNOFF", 7),
            b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n400000000 0 1 2\n",
            b"COFF\n3 1 0\n0 0 0 -7\n1 0 0 -7\n0 1 0 -7\n3 0 1 2\n"]


def obj_files():
    points = lines([("v",) + p for p in POINTS])
    normals = "vt 0 0\nvt 1 0.5\nvn 0 0 1\nvn 1e0 -1 nan\n"
    corners = ["%d", "%d/1", "%d//2", "%d/2/1"]
    faces = [lines([["f"] + [c % (v + 1) for v in f] for f in FACES]) for c in corners]
    backwards = lines([["f"] + [v - len(POINTS) for v in f] for f in FACES], "\t", "\r\n")
    texts = [points + normals + f for f in faces] + [faces[0] + points, points + backwards,
             "\ufeffmtllib a.mtl\no a b\ng c\nusemtl d\ns off\n" + points +
             "l 1 2\np 1\nf 1 2 \\\n 3\n"]
    return [text.encode() for text in texts]


PLY_CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int32": "i", "uint32": "I",
             "float": "f", "float64": "d"}


def ply_files():
    more = ["uchar red", "char a", "short b", "ushort c", "uint32 d", "float e"]
    strip = [0, 1, 4, 2, 3, -1, 3, 2, 1, 0]
    result = []
    for coordinate, size, corner, name in [("float", "uchar", "int32", "vertex_indices"),
                                           ("float64", "uint32", "uint32", "vertex_index"),
                                           ("int32", "char", "short", "vertex_indices")]:
        elements = [
            ("nothing", 9 * 10 ** 18, [], []),
            ("material", 1, ["list uchar float values", "uchar i"], [[[0.5, 1], 3]]),
            ("vertex", len(POINTS), [coordinate + " " + c for c in "xyz"] + more,
             [[*(map(int, p) if coordinate == "int32" else p), 255, -1, -2, 3, 4, 5.5]
              for p in POINTS]),
            ("face", len(FACES), ["list %s %s %s" % (size, corner, name), "uchar red",
                                  "list uchar float texcoord"], [[f, 7, [0.5]] for f in FACES]),
            ("tristrips", 1, ["list int32 int32 vertex_indices"], [[strip]])]
        for chosen in [elements, elements[2:4], elements[2:3] + elements[4:]]:
            result += ply_encodings(chosen)
    return result


def ply_encodings(elements):
    def header(encoding):
        result = "ply\nformat %s 1.0\ncomment for a fuzzer\n" % encoding
        for name, count, properties, _ in elements:
            result += "element %s %d\n" % (name, count)
            result += "".join("property %s\n" % p for p in properties)
        return result + "end_header\n"

    def body(put):
        for _, _, properties, rows in elements:
            for row in rows:
                for p, value in zip(properties, row):
                    types = p.split()[:-1]
                    if types[0] == "list":
                        put(types[1], len(value))
                        for number in value:
                            put(types[2], number)
                    else:
                        put(types[0], value)

    words = []
    body(lambda _, number: words.append(str(number)))
    result = [header("ascii").encode() + "\n".join(words).encode()]
    for encoding, order in [("binary_little_endian", "<"), ("binary_big_endian", ">")]:
        data = bytearray(header(encoding).encode())
        body(lambda type_, number: data.extend(struct.pack(order + PLY_CODES[type_], number)))
        result.append(bytes(data))
    return result


def stl_text(solid="solid", facet="facet", name=" a", end="\n"):
    text = solid + name + "\n"
    for t in TRIANGLES:
        text += " %s normal 0 0 nan\n  outer loop\n" % facet
        text += lines([("   vertex",) + POINTS[v] for v in t]) + "  endloop\n endfacet\n"
    return (text + "endsolid" + name + "\n").replace("\n", end).encode()


def stl_files():
    binary = struct.pack("<I", len(TRIANGLES))
    for t in TRIANGLES:
        binary += struct.pack("<12fH", 0, 0, 1, *(c for v in t for c in POINTS[v]), 0)
    return [stl_text(), stl_text("SOLID", "FACET"), stl_text(name="\ta b", end="\r\n"),
            b"\xef\xbb\xbf" + stl_text(name=" solid"), stl_text() + stl_text(name=""),
            b"solid a".ljust(80) + binary, bytes(80) + binary]


def main():
    files = {"off": off_files, "obj": obj_files, "ply": ply_files, "stl": stl_files}
    name, folder = sys.argv[1].lower(), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for i, data in enumerate(files[name]()):
        (folder / ("seed_%02d.%s" % (i, name))).write_bytes(data)


if __name__ == "__main__":
    main()
