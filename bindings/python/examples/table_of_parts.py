#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of the parts of a mesh, by pandas: areas, neighbors, bounding boxes, saliences of cuts.

    table_of_parts.py elephant.off
    table_of_parts.py elephant.off --segments 6 --csv parts.csv

Columns: `node`, the node of the part in the hierarchy of cuts; `triangles`, `area` and its
`fraction` of the area of the mesh; `neighbors`, the parts with which it has edges in common, and
`boundary`, the length of these; `x_min` to `z_max`, the bounding box. Four columns describe the cut
that separated the part from its other side: `salience`, the probability that people cut there,
infinite where the sides did not touch; `size`, `cut_strength` and `protrusiveness`. Lengths are in
the unit of the mesh.

Needs pandas, Debian's package python3-pandas.
"""

import argparse

import numpy as np
import pandas as pd
from spectral_segmentation import read, segment_adjacency, segment_hierarchy

OF_CUT = ["salience", "size", "cut_strength", "protrusiveness"]


def neighbors_of_parts(mesh, labels):
    pairs, lengths = segment_adjacency(mesh.points, mesh.triangles, labels)
    both_ways = pd.DataFrame({"part": np.concatenate([pairs[:, 0], pairs[:, 1]]),
                              "neighbors": np.concatenate([pairs[:, 1], pairs[:, 0]]),
                              "boundary": np.tile(lengths, 2)})
    return both_ways.groupby("part").agg({"neighbors": sorted, "boundary": "sum"})


def boxes_of_parts(mesh, labels):
    corners = pd.DataFrame(mesh.points[mesh.triangles.ravel()], columns=["x", "y", "z"])
    boxes = corners.groupby(np.repeat(labels, 3)).agg(["min", "max"])
    boxes.columns = ["_".join(names) for names in boxes.columns]
    return boxes


def table_of_parts(mesh, number_of_segments=None):
    """Returns a row for each segment, in the order of their labels."""
    hierarchy = segment_hierarchy(mesh, number_of_segments=number_of_segments)
    labels = hierarchy.labels()
    nodes = pd.DataFrame(hierarchy.nodes)
    parts = nodes.loc[hierarchy.segments(), ["number_of_faces", "area", "parent"]]
    parts = parts.reset_index(names="node").rename(columns={"number_of_faces": "triangles"})
    parts["fraction"] = parts["area"] / parts["area"].sum()
    parts = parts.join(neighbors_of_parts(mesh, labels)).join(boxes_of_parts(mesh, labels))
    # A part that no cut made is a root, whose parent is -1.
    parts = parts.join(nodes[OF_CUT], on="parent").drop(columns="parent")
    parts["boundary"] = parts["boundary"].fillna(0)
    parts["neighbors"] = [" ".join(map(str, row)) if isinstance(row, list) else ""
                          for row in parts["neighbors"]]
    return parts.rename_axis("part")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", help="OFF, OBJ, PLY or STL")
    parser.add_argument("--segments", type=int, metavar="N", help="the number of segments")
    parser.add_argument("--csv", metavar="FILE", help="write the table to this file, too")
    arguments = parser.parse_args()

    table = table_of_parts(read(arguments.mesh), arguments.segments)
    print(table.to_string(float_format="%.3g"))
    if arguments.csv:
        table.to_csv(arguments.csv)


if __name__ == "__main__":
    main()
