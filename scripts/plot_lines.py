#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the plots that benchmark/paper_experiments writes.

  plot_lines.py salience.json                 writes salience.png
  plot_lines.py salience.json -o picture.png

A plot is an object of title, x and y (names of the axes), lines (of name, x and y) and, for a
logarithmic axis, logarithmic_x. Needs matplotlib.
"""

import argparse
import json
import pathlib

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt


def parse_arguments():
    parser = argparse.ArgumentParser(description="Draws lines that are given as JSON.")
    parser.add_argument("plots", nargs="+", metavar="JSON")
    parser.add_argument("-o", "--output", metavar="PNG",
                        help="of one plot; default: its name, ending in .png")
    arguments = parser.parse_args()
    if arguments.output and len(arguments.plots) > 1:
        parser.error("-o names one picture: give one plot")
    return arguments


def draw(plot, output):
    figure, axes = plt.subplots(figsize=(8, 5))
    few = max(len(line["x"]) for line in plot["lines"]) < 20
    for line in plot["lines"]:
        axes.plot(line["x"], line["y"], label=line["name"].replace("_", " "),
                  linewidth=1.2, marker="o" if few else None)
    if plot.get("logarithmic_x"):
        axes.set_xscale("log")
        axes.set_xticks(plot["lines"][0]["x"], [str(x) for x in plot["lines"][0]["x"]])
        axes.minorticks_off()
    axes.set_title(plot["title"])
    axes.set_xlabel(plot["x"])
    axes.set_ylabel(plot["y"])
    axes.grid(True, linewidth=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(output, dpi=100)


def main():
    arguments = parse_arguments()
    for path in map(pathlib.Path, arguments.plots):
        draw(json.loads(path.read_text()), arguments.output or path.with_suffix(".png"))


if __name__ == "__main__":
    main()
