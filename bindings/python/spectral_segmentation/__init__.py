# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts a triangle mesh into the parts that a person would name.

    >>> from spectral_segmentation import read, segment
    >>> labels = segment(read("elephant.off"))
"""

from . import _core
from ._boundaries import boundary_edges, segment_adjacency, segment_colors
from ._files import Mesh, read, write
from ._hierarchy import Hierarchy
from ._page import View, view
from ._parts import Part, hulls, refine_boundaries, split, transfer_labels
from ._runs import segment, segment_hierarchy
from ._salience import SalienceFactors

__version__: str = _core.__version__

#: What `cut_state` in `Hierarchy.nodes` is an index of. In the default method every cut is known
#: and a node without one is a leaf.
CUT_STATES = ("not searched", "no cut", "rejected", "cut")

__all__ = ["CUT_STATES", "Hierarchy", "Mesh", "Part", "SalienceFactors", "View", "__version__",
           "boundary_edges", "hulls", "read", "refine_boundaries", "segment", "segment_adjacency",
           "segment_colors", "segment_hierarchy", "split", "transfer_labels", "view", "write"]

for _name in __all__:
    if hasattr(globals()[_name], "__module__"):
        globals()[_name].__module__ = __name__ # where users find it
