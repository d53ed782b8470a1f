# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a row of a table from a mesh, for many_meshes.py and many_meshes_by_dask.py."""

import argparse
import csv
import io
import os
import pathlib
import time

import numpy as np
from spectral_segmentation import read, segment

COLUMNS = ["file", "status", "triangles", "segments", "areas", "seconds", "labels", "error"]
EXTENSIONS = (".off", ".obj", ".ply", ".stl")


def parse_arguments(description, *options):
    """Options are pairs of a name and the arguments of `add_argument()`."""
    parser = argparse.ArgumentParser(description=description, fromfile_prefix_chars="@")
    parser.add_argument("inputs", nargs="+", metavar="INPUT",
                        help="a mesh, a folder of them, or @LIST, a file with an INPUT a line")
    parser.add_argument("-o", "--output", required=True, metavar="DIR", type=os.path.abspath,
                        help="folder for table.csv and labels/")
    parser.add_argument("--segments", type=int, metavar="N", help="the number of segments")
    for name, rest in options:
        parser.add_argument(name, **rest)
    return parser.parse_intermixed_args()


def files_of(inputs):
    """Returns the absolute names of the files; of a folder all meshes below it. Each comes once."""
    files = {}
    for name in map(os.path.abspath, inputs):
        found = [name]
        if os.path.isdir(name):
            found = sorted(os.path.join(folder, file) for folder, _, names in os.walk(name)
                           for file in names if file.lower().endswith(EXTENSIONS))
        files.update(dict.fromkeys(found))
    return list(files)


def areas_of_segments(mesh, labels):
    a, b, c = np.moveaxis(mesh.points[mesh.triangles], 1, 0)
    return np.bincount(labels, np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)


def write_labels(path, labels):
    """Writes a line for each triangle. The file is complete or not there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name("%s.%d.tmp" % (path.name, os.getpid()))
    temporary.write_text("".join("%d\n" % label for label in labels))
    os.replace(temporary, path)


def failed_row(file, status, message):
    return {"file": file, "status": status, "error": " ".join(message.split())}


def segment_file(file, output, number_of_segments=None):
    """Returns the row of a mesh, after its labels have been written below `output`.

    The status is "ok"; "input" if the file cannot be opened; "mesh" if it has none, or the number
    of segments is impossible; or "memory". An error in writing labels is not one of the mesh.
    """
    start = time.perf_counter()
    try:
        mesh = read(file)
        labels = segment(mesh, number_of_segments=number_of_segments, threads=1)
    except OSError as error:
        return failed_row(file, "input", error.strerror or str(error))
    except (ValueError, OverflowError) as error:
        return failed_row(file, "mesh", str(error))
    except MemoryError:
        return failed_row(file, "memory", "there is not enough memory")
    path = pathlib.Path(file)
    path = pathlib.Path("labels", path.relative_to(path.anchor)).with_name(path.name + ".txt")
    write_labels(output / path, labels)
    areas = areas_of_segments(mesh, labels)
    return {"file": file, "status": "ok", "triangles": len(labels), "segments": len(areas),
            "areas": " ".join("%.6g" % area for area in areas),
            "seconds": "%.3f" % (time.perf_counter() - start), "labels": path, "error": ""}


class Table:
    """The file table.csv of a folder. A row is written as soon as it is added."""

    def __init__(self, folder):
        path = pathlib.Path(folder, "table.csv")
        path.parent.mkdir(parents=True, exist_ok=True)
        how = {"newline": "", "encoding": "utf-8", "errors": "surrogateescape"}
        self._file = open(path, "a+", **how)
        self._file.seek(0)
        text = self._file.read()
        whole = text[:text.rfind("\n") + 1] # without half a line of a run that was killed
        if whole != text:
            self._file.truncate(len(whole.encode(how["encoding"], how["errors"])))
        self._done = {row["file"] for row in csv.DictReader(io.StringIO(whole, newline=""))}
        self._writer = csv.DictWriter(self._file, COLUMNS, restval="", lineterminator="\n")
        if not whole:
            self._writer.writeheader()

    def missing(self, files):
        """Returns the files that have no row."""
        return [file for file in files if file not in self._done]

    def add_all(self, rows, number_of_rows):
        failed = 0
        for i, row in enumerate(rows, 1):
            self._writer.writerow(row)
            self._file.flush()
            failed += row["status"] != "ok"
            line = "%d/%d %s: %s" % (i, number_of_rows, os.path.basename(row["file"]),
                                     row["error"] or "segments: %d" % row["segments"])
            print(os.fsencode(line).decode("utf-8", "replace"), flush=True)
        print("%d meshes segmented, %d failed, %d done before"
              % (number_of_rows - failed, failed, len(self._done)))
