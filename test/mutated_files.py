#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the command line tool on damaged files: mutated_files.py TOOL MESHES [--count N] [--seed S].

MESHES is the directory of CGAL's meshes. Each run has to end in time with exit code 0 and a label
for each face, or with exit code 4 and a sentence of its own, and to take no more memory than a
small multiple of the file. What fails is kept in --keep, if it is given.
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import struct
import subprocess
import sys
import tempfile

MESH = "octahedron.off"  # small, so that most of a file is structure
SECONDS = 10
IS_SANITIZED = False  # the tool
LIBRARY_WORDS = ["std::", "vector", "basic_string", "bad_alloc", "terminate", "CGAL", "filesystem",
                 "runtime error", "Sanitizer", "stoi", "stod"]
EXTREMES = ["0", "-0", "-1", "1", "255", "256", "65536", "2147483647", "-2147483648", "4294967295",
            "4294967296", "9000000000000000000", "18446744073709551616", "1e308", "-1e309",
            "1e-320",
            "nan", "inf", "-inf", "0x10", "1.5", "+3", "1e", "", "x"]
BINARY_EXTREMES = [struct.pack(order + code, number) for order in "<>" for code, number in [
    ("i", 0), ("i", -1), ("i", 2 ** 31 - 1), ("i", -2 ** 31), ("i", 4 * 10 ** 8), ("H", 65535),
    ("f", float("nan")), ("f", float("inf")), ("f", 3e38), ("d", 1e308), ("d", float("nan"))]]
WORDS = ["OFF", "COFF", "NOFF", "STOFF", "nOFF", "BINARY", "#", "\\", "v", "vn", "vt", "f", "l",
         "g", "//", "ply", "ascii", "binary_little_endian", "binary_big_endian", "element",
         "property",
         "vertex", "face", "tristrips", "list", "char", "uchar", "int", "uint", "float", "double",
         "vertex_indices", "x", "end_header", "solid", "facet", "outer", "loop", "endloop",
         "endfacet", "endsolid"]


# Files

def read_off(path):
    lines = [line.split("#")[0] for line in path.read_text().splitlines()]
    words = iter(" ".join(lines).split())
    assert next(words) == "OFF"
    counts = [int(next(words)) for _ in range(3)]
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(counts[0])]
    faces = [tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(counts[1])]
    return points, faces


def text(*rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()


def off_files(points, faces):
    counted = [(len(f), *f) for f in faces]
    yield text(["OFF"], [len(points), len(faces), 0], *points, *counted)
    yield text(["COFF"], [len(points), len(faces), 0], *[p + (255, 0, 0, 255) for p in points],
               *[f + (7,) for f in counted])
    binary = struct.pack(">3i", len(points), len(faces), 0)
    binary += b"".join(struct.pack(">6f", *p, 0, 0, 1) for p in points)
    binary += b"".join(struct.pack(">%di" % (len(f) + 2), len(f), *f, 0) for f in faces)
    yield b"NOFF BINARY\n" + binary


def obj_files(points, faces):
    vertices = [("v", *p) for p in points]
    yield text(*vertices, *[["f"] + [v + 1 for v in f] for f in faces])
    yield text(["g", "all"], ["vt", 0, 1], ["vn", 0, 0, 1], *vertices, ["usemtl", "red"],
               *[["f"] + ["%d/1/1" % (v - len(points)) for v in f] for f in faces], ["l", 1, 2])


def ply_files(points, faces):
    for encoding, order in [("ascii", None), ("binary_little_endian", "<"),
                            ("binary_big_endian", ">")]:
        for coordinate, size in [("float", "uchar"), ("double", "uint")]:
            header = [["ply"], ["format", encoding, "1.0"], ["comment", "a", "mesh"],
                      ["element", "vertex", len(points)],
                      *[["property", coordinate, c] for c in "xyz"], ["property", "uchar", "red"],
                      ["element", "face", len(faces)],
                      ["property", "list", size, "int", "vertex_indices"], ["end_header"]]
            if order is None:
                body = text(*[p + (255,) for p in points], *[(len(f), *f) for f in faces])
            else:
                body = b"".join(struct.pack("%s3%sB" % (order, coordinate[0]), *p, 255)
                                for p in points)
                body += b"".join(struct.pack("%s%s%di" % (order, {"uchar": "B", "uint": "I"}[size],
                                                          len(f)), len(f), *f) for f in faces)
            yield text(*header) + body


def stl_files(points, faces):
    facets = []
    for f in faces:
        facets += [["facet", "normal", 0, 0, 1], ["outer", "loop"],
                   *[("vertex", *points[v]) for v in f], ["endloop"], ["endfacet"]]
    yield text(["solid", "a"], *facets, ["endsolid", "a"])
    yield b"\xef\xbb\xbf" + text(["SOLID"], *facets, ["endsolid"])
    for header in [b"solid a", b"a\0"]:
        yield header.ljust(80) + struct.pack("<I", len(faces)) + b"".join(
            struct.pack("<12fH", 0, 0, 1, *(c for v in f for c in points[v]), 0) for f in faces)


def base_files(points, faces):
    """Pairs of the extension and the bytes."""
    files = {"off": off_files, "obj": obj_files, "ply": ply_files, "stl": stl_files}
    return [(name, data) for name, make in files.items() for data in make(points, faces)]


# What damages them. Each function takes and returns bytes.

def change_numbers(data, rng, choose):
    """Replaces one number of a text."""
    numbers = list(re.finditer(rb"(?<![\w.])[-+]?\d[\w.+-]*", data))
    if not numbers:
        return data
    number = rng.choice(numbers)
    return data[:number.start()] + choose(number.group()) + data[number.end():]


def place(data, rng):
    return rng.randrange(len(data) + 1)


def piece(data, rng):
    begin = place(data, rng)
    return begin, min(len(data), begin + rng.choice([1, 2, 4, 13, 50, 200]))


def flip_bits(data, rng):
    result = bytearray(data)
    for _ in range(rng.choice([1, 1, 3, 20]) if data else 0):
        result[rng.randrange(len(result))] ^= 1 << rng.randrange(8)
    return bytes(result)


def delete(data, rng):
    begin, end = piece(data, rng)
    return data[:begin] + data[end:]


def double(data, rng):
    begin, end = piece(data, rng)
    return data[:end] + data[begin:]


def insert(data, rng):
    at = place(data, rng)
    return data[:at] + rng.choice([rng.randbytes(rng.choice([1, 4, 40])), b"\0" * 8, b"\t", b"\r",
                                   b"\n", b" " * 60, b"9" * 400]) + data[at:]


def truncate(data, rng):
    return data[:place(data, rng)]


def put_extreme(data, rng):
    return change_numbers(data, rng, lambda _: rng.choice(EXTREMES).encode())


def put_binary_extreme(data, rng):
    extreme = rng.choice(BINARY_EXTREMES)
    at = place(data, rng)
    return data[:at] + extreme + data[at + len(extreme):]


def change_count(data, rng):
    """A small change of an integer: a count, or the number of a point."""
    def other(number):
        return b"%d" % (int(number) + rng.choice([-1, 1, 7])) if number.isdigit() else number
    head = rng.choice([len(data), min(len(data), 250)])
    return change_numbers(data[:head], rng, other) + data[head:]


def swap_lines(data, rng):
    lines = data.split(b"\n")
    i, k = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[i], lines[k] = lines[k], lines[i]
    return b"\n".join(lines)


def exchange_word(data, rng):
    words = list(re.finditer(rb"[A-Za-z_]+", data))
    if not words:
        return data
    word = rng.choice(words)
    return data[:word.start()] + rng.choice(WORDS).encode() + data[word.end():]


def change_line_ends(data, rng):
    return data.replace(b"\n", rng.choice([b"\r\n", b"\r", b"\n\n", b" ", b" # \n", b"\\\n"]))


MUTATORS = [flip_bits, delete, double, insert, truncate, put_extreme, put_binary_extreme,
            change_count, swap_lines, exchange_word, change_line_ends]


def cases(bases, count, seed):
    """The untouched files first. Tuples of what was done, the extension and the bytes."""
    for i, (name, data) in enumerate(bases):
        yield "file %d untouched" % i, name, data
    for number in range(count):
        rng = random.Random("%d %d" % (seed, number))
        i = rng.randrange(len(bases))
        name, data = bases[i]
        mutators = rng.choices(MUTATORS, k=rng.choice([1, 1, 1, 2, 4]))
        for mutate in mutators:
            data = mutate(data, rng)
        yield "file %d, %d: %s" % (i, number, ", ".join(m.__name__ for m in mutators)), name, data


# Runs

def limit_memory(size, is_sanitized):
    if not is_sanitized: # AddressSanitizer reserves terabytes
        limit = 64 * size + 600 * 10 ** 6
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def check_labels(path, number_of_faces):
    labels = path.read_text().split("\n")[:-1] if path.exists() else []
    if not labels or not all(label.isdigit() for label in labels):
        return "no labels"
    if number_of_faces is not None and len(labels) != number_of_faces:
        return "%d labels of %d faces" % (len(labels), number_of_faces)
    return None


def check_sentence(error):
    word = next((w for w in LIBRARY_WORDS if w in error), None)
    if word:
        return "the error names %r" % word
    if not re.fullmatch(r"[^\n]*\w[^\n]*\n", error):
        return "the error is not one line"
    return None


def run(tool, folder, number, case, number_of_faces):
    """What is wrong, or None; and the exit code."""
    _, name, data = case
    path, labels = folder / ("%d.%s" % (number, name)), folder / ("%d.labels" % number)
    path.write_bytes(data)
    written = folder / ("%d.out.%s" % (number, ("ply", "obj", "off", "glb")[number % 4]))
    try:
        done = subprocess.run([tool, path, "--labels", labels, "--quiet", "--threads", "1",
                               "--method", ("paper", "calibrated")[number % 8 == 0], "-o", written],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=SECONDS,
                              preexec_fn=lambda: limit_memory(len(data), IS_SANITIZED), check=False)
    except subprocess.TimeoutExpired:
        return "over %d seconds" % SECONDS, None
    error = done.stderr.decode(errors="replace").replace(str(path), "FILE")
    if done.returncode == 0:
        wrong = check_labels(labels, number_of_faces) or (error and "an error with exit code 0")
    elif done.returncode == 4:
        wrong = check_sentence(error) or (number_of_faces is not None and "a sound file is refused")
        wrong = wrong or (labels.exists() and "labels with exit code 4")
    elif done.returncode == 7 and "a coordinate is too large for the numbers of GLB" in error:
        wrong = check_sentence(error) or (labels.exists() and "labels with exit code 7")
    else:
        wrong = "exit code %d" % done.returncode
    path.unlink()
    for output in (labels, written, written.with_suffix(".mtl")):
        output.unlink(missing_ok=True)
    return wrong and "%s: %s" % (wrong, error.strip()[:200]), done.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tool", type=os.path.abspath)
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()

    global IS_SANITIZED
    IS_SANITIZED = b"__asan_init" in pathlib.Path(options.tool).read_bytes()

    points, faces = read_off(options.meshes / MESH)
    bases = base_files(points, faces)
    all_cases = list(cases(bases, options.count, options.seed))
    with tempfile.TemporaryDirectory() as folder, \
         concurrent.futures.ThreadPoolExecutor(max_workers=2) as executor:
        results = list(executor.map(
            lambda i: run(options.tool, pathlib.Path(folder), i, all_cases[i],
                          len(faces) if i < len(bases) else None), range(len(all_cases))))
    failures = 0
    for i, ((what, name, data), (wrong, _)) in enumerate(zip(all_cases, results)):
        if wrong:
            failures += 1
            print("%s (%s): %s" % (what, name, wrong))
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / ("%d.%s" % (i, name))).write_bytes(data)
    codes = [code for _, code in results]
    print("%d files, %d read, %d refused, %d failures" % (
        len(results), codes.count(0), codes.count(4), failures))
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
