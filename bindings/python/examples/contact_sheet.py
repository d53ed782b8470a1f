#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""One picture of all meshes of a table that many_meshes.py has written.

    contact_sheet.py out -o sheet.png

A mesh without labels has its status in place of a picture. Needs matplotlib, Debian's package
python3-matplotlib.
"""

import argparse
import csv
import math
import pathlib

import matplotlib.pyplot as plt
import numpy as np
from picture import draw
from spectral_segmentation import read


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="the folder with table.csv")
    parser.add_argument("-o", "--output", default="sheet.png", help="[%(default)s]")
    parser.add_argument("--columns", type=int, metavar="N", help="[as many as rows]")
    parser.add_argument("--up", choices="xyz", default="y", help="the axis upwards [%(default)s]")
    arguments = parser.parse_args()

    with open(arguments.folder / "table.csv", newline="", encoding="utf-8",
              errors="surrogateescape") as file:
        rows = sorted(csv.DictReader(file), key=lambda row: row["file"])
    columns = arguments.columns or math.ceil(math.sqrt(len(rows)))
    lines = math.ceil(len(rows) / columns)
    figure = plt.figure(figsize=(2 * columns, 2 * lines))
    for i, row in enumerate(rows, 1):
        axes = figure.add_subplot(lines, columns, i)
        axes.set_title("%s: %s" % (pathlib.Path(row["file"]).stem, row["segments"] or "none"),
                       fontsize=8)
        if row["status"] == "ok":
            labels = np.loadtxt(arguments.folder / row["labels"], int, ndmin=1)
            draw(axes, read(row["file"]), labels, arguments.up)
        else:
            axes.text(0.5, 0.5, row["status"], ha="center", va="center")
            axes.set_axis_off()
    figure.savefig(arguments.output, dpi=100, bbox_inches="tight")


if __name__ == "__main__":
    main()
