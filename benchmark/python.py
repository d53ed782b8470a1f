#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""python.py labels SEGMENT_MESH MESH ...
python.py cost ARRAYS_CALL MESH ... [--runs N]
python.py threads MESH MESH [--runs N]
python.py import [--runs N]

Measures the Python package, which PYTHONPATH names or is installed.

labels: whether segment() has the labels of the tool, in both methods.
cost: segment() beside the C++ call, both with one thread, each run in a process of its own and one
    after the other: the ratios of the times, of those of the processor, and of the memory at the
    peak beyond the mesh.
threads: two runs at a time, each with one thread, against one after the other.
import: the time of the import beyond that of NumPy.

Medians, with a machine that has nothing else to do.
"""

import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import threading
import time

COST = """
import resource, sys, time
import numpy as np
from spectral_segmentation import segment
points = np.fromfile(sys.argv[1], np.float64).reshape(-1, 3)
triangles = np.fromfile(sys.argv[2], np.int32).reshape(-1, 3)
def bytes_of(name):
    line, = (line for line in open("/proc/self/status") if line.startswith(name))
    return 1024 * int(line.split()[1])
open("/proc/self/clear_refs", "w").write("5")
before, start, processor = bytes_of("VmRSS"), time.perf_counter(), time.process_time()
labels = segment(points, triangles, threads=1)
print(time.perf_counter() - start, time.process_time() - processor, bytes_of("VmHWM") - before,
      labels.max() + 1)
"""
IMPORT = "import time, numpy; t = time.perf_counter(); import spectral_segmentation; " \
         "print(time.perf_counter() - t)"


def numbers(*command):
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    return [float(word) for word in done.stdout.split()]


def compare_labels(tool, paths):
    from spectral_segmentation import read, segment
    same = different = refused = polygons = 0
    for path in paths:
        try:
            mesh = read(path)
        except (OSError, ValueError):
            mesh = None
        if mesh is not None and len(set(mesh.polygon_of_triangle)) < len(mesh.triangles):
            polygons += 1 # of which the tool has one label each
            continue
        for method in ("calibrated", "paper"):
            done = subprocess.run([tool, path, "--quiet", "--method", method, "--labels", "-"],
                                  check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            try:
                labels = None if mesh is None else segment(mesh, method=method)
            except ValueError:
                labels = None
            if labels is None and done.returncode != 0:
                refused += 1
            elif (labels is not None and done.returncode == 0 and
                  b"".join(b"%d\n" % label for label in labels) == done.stdout):
                same += 1
            else:
                different += 1
                print("different:", path, method)
    print("%d runs have the same labels, %d have not; both refuse %d; %d meshes have polygons"
          % (same, different, refused, polygons))


def measure_cost(program, paths, runs):
    import numpy as np
    from spectral_segmentation import read
    print("%-10s %-10s %-10s %-8s %s" % ("faces", "seconds", "processor", "memory",
                                         "ratios, Python / C++"))
    for path in paths:
        mesh = read(path)
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, name) for name in ("points", "triangles")]
            mesh.points.tofile(files[0])
            mesh.triangles.tofile(files[1])
            pairs = [(numbers(sys.executable, "-c", COST, *files), numbers(program, *files))
                     for _ in range(runs)]
        ratios = np.median([np.divide(*pair) for pair in pairs], axis=0)
        seconds = statistics.median(c[0] for _, c in pairs)
        print("%-10d %-10.3f %-10.3f %-8.3f C++ %.2f s" % (len(mesh.triangles), *ratios[:3],
                                                          seconds))


def measure_threads(paths, runs):
    from spectral_segmentation import read, segment
    meshes = [read(path) for path in paths]

    def alone():
        for mesh in meshes:
            segment(mesh, threads=1)

    def together():
        threads = [threading.Thread(target=segment, args=(mesh,), kwargs={"threads": 1})
                   for mesh in meshes]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def seconds(function):
        start = time.perf_counter()
        function()
        return time.perf_counter() - start

    ratios = [seconds(alone) / seconds(together) for _ in range(runs)]
    print("two at a time are %.2f times as fast" % statistics.median(ratios))


def main():
    arguments = sys.argv[1:]
    runs = 5
    if "--runs" in arguments:
        place = arguments.index("--runs")
        runs = int(arguments[place + 1])
        del arguments[place:place + 2]
    if arguments[:1] == ["labels"] and len(arguments) > 2:
        compare_labels(arguments[1], map(pathlib.Path, arguments[2:]))
    elif arguments[:1] == ["cost"] and len(arguments) > 2:
        measure_cost(arguments[1], arguments[2:], runs)
    elif arguments[:1] == ["threads"] and len(arguments) == 3:
        measure_threads(arguments[1:], runs)
    elif arguments == ["import"]:
        print("%.4f s" % statistics.median(numbers(sys.executable, "-c", IMPORT)[0]
                                           for _ in range(runs)))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
