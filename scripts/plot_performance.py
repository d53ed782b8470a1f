#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what benchmark/performance --benchmark_out=FILE.json measured: time and memory against the
number of faces, log-log. Prints the exponents of the lines that fit best, and ratios of times.

  plot_performance.py FILE.json                      writes FILE.png
  plot_performance.py FILE.json --from 3000 --to 50000 -o picture.png

Needs numpy and matplotlib.
"""

import argparse
import collections
import json
import pathlib

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
STAGES = ("initialization", "sampling", "embedding", "line_search", "merging", "projection")
RATIOS = (("sdf/threads:1", "calibrated/threads:1"),
          ("calibrated/threads:1", "calibrated/threads:2"),
          ("paper/threads:1", "paper/threads:2"))


def parse_arguments():
    parser = argparse.ArgumentParser(
        description="Draws time and memory of benchmark/performance against the number of faces.")
    parser.add_argument("files", nargs="+", metavar="JSON", help="written by --benchmark_out")
    parser.add_argument("-o", "--output", metavar="PNG",
                        help="default: the name of the first file, ending in .png")
    parser.add_argument("--from", dest="smallest", type=int, default=50000, metavar="N",
                        help="number of faces from which exponents are fitted [50000]")
    parser.add_argument("--to", dest="largest", type=int, default=3200000, metavar="N",
                        help="number of faces up to which exponents are fitted [3200000]")
    parser.add_argument("--cpu", action="store_true",
                        help="processor time of all threads, for a machine with other work")
    return parser.parse_args()


def name_and_size(row):
    name = row["run_name"].replace("/process_time", "").replace("/real_time", "")
    name, size = name.rsplit("/", 1)
    return name, int(size)


def rows_of(paths):
    """Returns the rows by name and size: the median of repetitions, the last of equal rows."""
    rows = collections.defaultdict(dict)
    for path in paths:
        for row in json.loads(pathlib.Path(path).read_text())["benchmarks"]:
            is_median = row.get("aggregate_name") == "median"
            if "faces" in row and (row["run_type"] == "iteration" or is_median):
                name, size = name_and_size(row)
                rows[name][size] = row
    return rows


def points_of(rows_by_size, value):
    """Faces and value of each row that has one."""
    return np.array([(row["faces"], value(row)) for _, row in sorted(rows_by_size.items())
                     if value(row) > 0])


def series_of(rows, value):
    series = {name: points_of(rows_by_size, value) for name, rows_by_size in rows.items()}
    return {name: points for name, points in series.items() if len(points) > 0}


def stages_of(rows, name):
    series = {stage: points_of(rows[name], lambda row: row.get(stage, 0)) for stage in STAGES}
    return {stage: points for stage, points in series.items() if len(points) > 0}


def exponent(points, arguments):
    faces = points[:, 0]
    fitted = points[(faces >= 0.99 * arguments.smallest) & (faces <= 1.01 * arguments.largest)]
    return np.polyfit(*np.log(fitted).T, 1)[0] if len(fitted) > 1 else None


def labels_of(series, arguments):
    for name, points in series.items():
        slope = exponent(points, arguments)
        yield name if slope is None else f"{name} $n^{{{slope:.2f}}}$"


def draw(axes, title, unit, series, labels):
    for points, label in zip(series.values(), labels):
        axes.loglog(*points.T, marker="o", markersize=3, label=label)
    axes.set_title(title)
    axes.set_xlabel("faces")
    axes.set_ylabel(unit)
    axes.grid(True, which="both", linewidth=0.3)
    axes.set_visible(bool(series))
    if series:
        axes.legend()


def print_exponents(times, arguments):
    print(f"time grows as faces to the, from {arguments.smallest} to {arguments.largest}:")
    for name, points in times.items():
        slope = exponent(points, arguments)
        if slope is not None:
            print(f"  {slope:5.2f}  {name}")


def print_ratios(times):
    for slow, fast in RATIOS:
        if slow in times and fast in times:
            of_fast = dict(times[fast])
            ratios = [f"{time / of_fast[faces]:.2f} ({faces:.0f})"
                      for faces, time in times[slow] if faces in of_fast]
            print(f"{slow} by {fast}, with so many faces:\n  {', '.join(ratios)}")


def main():
    arguments = parse_arguments()
    rows = rows_of(arguments.files)
    clock = "cpu_time" if arguments.cpu else "real_time"
    times = series_of(rows, lambda row: row[clock] * MILLISECONDS[row["time_unit"]])
    memory = series_of(rows, lambda row: row.get("bytes_per_face", 0) * row["faces"] / 1e6)
    memory_per_face = series_of(rows, lambda row: row.get("bytes_per_face", 0))
    print_exponents(times, arguments)
    print_ratios(times)

    runs = {name: points for name, points in times.items() if "/threads:" in name}
    others = {name: points for name, points in times.items() if name not in runs}
    unit = "ms of processor time" if arguments.cpu else "ms"
    figure, axes = plt.subplots(2, 3, figsize=(21, 13))
    panels = [("Whole runs", unit, runs),
              ("Stages, calibrated, one thread", "ms", stages_of(rows, "calibrated/threads:1")),
              ("Stages, paper, one thread", "ms", stages_of(rows, "paper/threads:1")),
              ("Another number of segments of a finished tree", unit, others),
              ("Peak memory beyond the mesh", "MB", memory)]
    for panel, place in zip(panels, axes.flat):
        draw(place, *panel, labels_of(panel[-1], arguments))
    draw(axes.flat[-1], "The same", "bytes a face", memory_per_face, memory_per_face)
    axes.flat[-1].set(yscale="linear", ylim=(0, None))
    figure.tight_layout()
    figure.savefig(arguments.output or pathlib.Path(arguments.files[0]).with_suffix(".png"),
                   dpi=80)


if __name__ == "__main__":
    main()
