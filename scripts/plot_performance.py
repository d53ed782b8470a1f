#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what benchmark/performance --benchmark_out=FILE.json measured: time and memory against the
number of faces, log-log. The exponent in a legend is the slope of the line that fits best.

  plot_performance.py FILE.json                      writes FILE.png
  plot_performance.py FILE.json --from 50000 -o picture.png

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


def parse_arguments():
    parser = argparse.ArgumentParser(
        description="Draws time and memory of benchmark/performance against the number of faces.")
    parser.add_argument("files", nargs="+", metavar="JSON", help="written by --benchmark_out")
    parser.add_argument("-o", "--output", metavar="PNG",
                        help="default: the name of the first file, ending in .png")
    parser.add_argument("--from", dest="smallest", type=int, default=20000, metavar="N",
                        help="number of faces from which exponents are fitted [20000]")
    parser.add_argument("--cpu", action="store_true",
                        help="processor time of all threads, for a machine with other work")
    return parser.parse_args()


def rows_of(paths):
    """The rows by name; of repetitions the median, and of files with the same row the last."""
    rows = {}
    for path in paths:
        for row in json.loads(pathlib.Path(path).read_text())["benchmarks"]:
            is_median = row.get("aggregate_name") == "median"
            if "faces" in row and (row["run_type"] == "iteration" or is_median):
                rows[row["run_name"]] = row
    return rows.values()


def series_of(rows, value):
    """The points of each METHOD/WHAT/threads:N, in the order of the sizes."""
    series = collections.defaultdict(dict)
    for row in rows:
        if value(row) > 0:
            name = [part for part in row["run_name"].split("/")
                    if not part.isdigit() and part not in ("real_time", "process_time")]
            series["/".join(name)][row["faces"]] = value(row)
    return {name: np.array(sorted(points.items())) for name, points in series.items()}


def exponent(points, smallest):
    fitted = points[points[:, 0] >= 0.99 * smallest]
    if len(fitted) < 2:
        return ""
    return f" $n^{{{np.polyfit(*np.log(fitted).T, 1)[0]:.2f}}}$"


def draw(axes, title, unit, series, smallest):
    for i, (name, points) in enumerate(series.items()):
        axes.loglog(*points.T, marker="o", markersize=3, color=f"C{i % 10}",
                    linestyle="-" if i < 10 else "--", label=name + exponent(points, smallest))
    axes.set_title(title)
    axes.set_xlabel("faces")
    axes.set_ylabel(unit)
    axes.grid(True, which="both", linewidth=0.3)
    axes.set_visible(bool(series))
    if series:
        axes.legend(fontsize=9)


def main():
    arguments = parse_arguments()
    rows = rows_of(arguments.files)
    clock = "cpu_time" if arguments.cpu else "real_time"
    times = series_of(rows, lambda row: row[clock] * MILLISECONDS[row["time_unit"]])
    memory = series_of(rows, lambda row: row.get("bytes_per_face", 0) * row["faces"] / 1e6)
    memory_per_face = series_of(rows, lambda row: row.get("bytes_per_face", 0))

    def times_where(condition):
        return {name: points for name, points in times.items() if condition(name)}

    def stages_of(method):
        return times_where(lambda name: name.startswith(method) and "/whole" not in name)

    figure, axes = plt.subplots(2, 3, figsize=(21, 13))
    unit = "ms of processor time" if arguments.cpu else "ms"
    panels = [("Whole runs", unit, times_where(lambda name: "/whole" in name)),
              ("Calibrated method, stages of the first cut", unit, stages_of("calibrated")),
              ("Paper's method, stages of the first cut", unit, stages_of("paper")),
              ("Shortest path trees", unit, stages_of("shortest_path_tree")),
              ("Peak memory beyond the mesh", "MB", memory),
              ("The same", "bytes a face", memory_per_face)]
    for panel, place in zip(panels, axes.flat):
        draw(place, *panel, arguments.smallest)
    figure.tight_layout()
    figure.savefig(arguments.output or pathlib.Path(arguments.files[0]).with_suffix(".png"),
                   dpi=80)


if __name__ == "__main__":
    main()
