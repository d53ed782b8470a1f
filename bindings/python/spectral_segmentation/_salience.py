# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The argument of a custom salience."""

from typing import NamedTuple

_FACTORS = {
    "size": "fraction of the area of the part, in [0, 1/2]",
    "cut_strength": "concavity of the cut, in [0, 1]",
    "protrusiveness": "at most 1",
    "log_relative_part_area":
        "logarithm of the fraction of the area of the mesh that the part has, at most 0",
    "concavity_near_cut": "in [0, 1]",
    "convexity_gain": "how much closer to convex the sides are than the part",
    "relative_convexity_gain": "logarithm of the ratio of convexity defects",
    "expansion_behind_cut":
        "how fast the rest widens behind the cut, about 1 on a cylinder, at most 4",
    "roundness": "1 for a circle, 0 for a straight line",
    "flatness_behind_cut": "1 if the rest is flat near the boundary, at least 0",
    "concavity_around_cut": "`concavity_near_cut` within twice the distance",
    "lower_quartile_of_concavity":
        "concavity that three quarters of the boundary reach, in [0, 1]",
    "expansion_before_cut":
        "`expansion_behind_cut` of the smaller side, within twice the distance",
    "number_of_common_neighbors": "how many other regions touch both",
    "number_of_other_neighbors": "how many other regions touch the side that fewer touch",
    "is_boundary": "whether the cut is the boundary of two regions that may be merged"}


class SalienceFactors(NamedTuple):
    size: float = 0.
    cut_strength: float = 0.
    protrusiveness: float = 0.
    log_relative_part_area: float = 0.
    concavity_near_cut: float = 0.
    convexity_gain: float = 0.
    relative_convexity_gain: float = 0.
    expansion_behind_cut: float = 0.
    roundness: float = 0.
    flatness_behind_cut: float = 0.
    concavity_around_cut: float = 0.
    lower_quartile_of_concavity: float = 0.
    expansion_before_cut: float = 0.
    number_of_common_neighbors: float = 0.
    number_of_other_neighbors: float = 0.
    is_boundary: bool = False


SalienceFactors.__doc__ = """The factors of a cut of a part into two sides.

`part_salience` is called with them. `size`, `cut_strength` and `protrusiveness` are the factors of
the paper. The others are 0 in its method, and those from `roundness` on are 0 unless `is_boundary`.

Parameters
----------
""" + "".join("%s : %s, default: %s\n    %s%s.\n"
              % (name, "bool" if name == "is_boundary" else "float",
                 SalienceFactors._field_defaults[name], text[0].upper(), text[1:])
              for name, text in _FACTORS.items()) + """
Examples
--------
>>> SalienceFactors(size=0.25, cut_strength=0.5).cut_strength
0.5
"""
for _name, _text in _FACTORS.items():
    getattr(SalienceFactors, _name).__doc__ = _text
