# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""All cuts of a run."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterable, Optional, Union

import numpy as np

from . import _core
from ._checks import Path, integer, threshold
from ._meshes import warn
from ._replace_file import replace_file

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Hierarchy:
    """The cuts of a run, as a forest of binary trees.

    `segment_hierarchy()` makes a hierarchy, and so do `load()` and `from_json()`. Nodes are
    numbered from 0. A hierarchy can be pickled and copied.

    If the run was given polygons, labels and `faces()` refer to polygons: a polygon has the label
    with the largest area of its triangles, and a segment with the largest area of no polygon is
    missing. Nodes, JSON and files refer to the triangles. They lack triangles with a corner at a
    point that is not finite, which `labels()` and `faces()` give to the part of a neighbor.

    Examples
    --------
    >>> hierarchy = segment_hierarchy(mesh)
    >>> labels = hierarchy.labels(5)
    """

    __slots__ = ("_core", "_surface", "_is_probability", "__weakref__")

    def __init__(self):
        raise TypeError("segment_hierarchy(), Hierarchy.load() or Hierarchy.from_json() makes a "
                        "Hierarchy")

    @classmethod
    def _of(cls, core, surface=None, is_probability=None):
        """The hierarchy of triangles, or with a surface the one of its polygons. Whether the
        salience is a probability is not known of a file: `None`."""
        result = object.__new__(cls)
        result._core = core
        result._surface = surface
        result._is_probability = is_probability
        return result

    @classmethod
    def _restored(cls, text, surface, is_probability):
        return cls._of(_core.Hierarchy.from_json(text), surface, is_probability)

    def __copy__(self) -> Hierarchy:
        return Hierarchy._of(self._core.copy(), self._surface, self._is_probability)

    def __deepcopy__(self, memo: Dict[int, Any]) -> Hierarchy:
        return self.__copy__()

    def __reduce__(self):
        return Hierarchy._restored, (self.to_json(), self._surface, self._is_probability)

    def __repr__(self):
        return "<Hierarchy of %d faces, %d nodes>" % (self.number_of_faces, self.number_of_nodes)

    def _node(self, name, value):
        node = integer(name, value)
        if not 0 <= node < self.number_of_nodes:
            raise ValueError("%s: there is no node %d in a hierarchy of %d nodes"
                             % (name, node, self.number_of_nodes))
        return node

    @property
    def number_of_faces(self) -> int:
        """int: the number of triangles or polygons of the mesh."""
        return self._core.number_of_faces if self._surface is None else len(self._surface)

    @property
    def number_of_nodes(self) -> int:
        """int: the number of nodes, leaves too."""
        return self._core.number_of_nodes

    @property
    def number_of_roots(self) -> int:
        """int: the number of roots, which are the nodes from 0 to `number_of_roots - 1`."""
        return self._core.number_of_roots

    @property
    def number_of_segments(self) -> int:
        """int: the number of leaves, the most segments that can be asked for."""
        return self._core.number_of_segments

    @property
    def salience_threshold(self) -> float:
        """float: the salience threshold of the run."""
        return self._core.salience_threshold

    @property
    def nodes(self) -> NDArray[np.void]:
        """ndarray: a structured array with a row for each node, of which pandas makes a table.

        Its fields are `parent`, `first_child` (the side of smaller area, to which the factors
        belong) and `second_child`, which are -1 for none; `number_of_faces`; `area`, in the square
        of the unit of the points; `cut_state`, an index of `CUT_STATES`; `salience` of the best
        cut, 0 if there is none; and the factors of that cut, named as in `SalienceFactors`.
        """
        return self._core.nodes

    @property
    def children(self) -> NDArray[np.intp]:
        """ndarray of int, shape (number_of_nodes, 2): the children of each node, -1 for a leaf."""
        return self._core.children

    @property
    def saliences(self) -> NDArray[np.float64]:
        """ndarray of float, shape (number_of_nodes,): the salience of each node's best cut."""
        return self._core.saliences

    @property
    def factors(self) -> Dict[str, NDArray[np.float64]]:
        """dict of str to ndarray of float: the factors of each node's best cut, by name."""
        return self._core.factors

    def segments(self, n: Optional[int] = None, *,
                 salience_threshold: Optional[float] = None) -> NDArray[np.intp]:
        """Returns the node of each segment of `labels()` with the same arguments.

        Parameters
        ----------
        n, salience_threshold : optional
            See `labels()`.

        Returns
        -------
        ndarray of int, shape (number of segments,)
        """
        if n is not None:
            n = integer("n", n)
            if n < 1:
                raise ValueError("n must be at least 1")
        if salience_threshold is not None:
            salience_threshold = threshold(salience_threshold, self._is_probability)
        elif n is not None and n > self.number_of_segments:
            warn("the hierarchy has only %d segments, not %d; a run with number_of_segments=%d "
                 "makes exactly this number" % (self.number_of_segments, n, n))
        return self._core.segments(n, salience_threshold)

    def labels(self, n: Optional[int] = None, *,
               salience_threshold: Optional[float] = None) -> NDArray[np.intp]:
        """Returns the label of each triangle or polygon. Nothing is searched again.

        Parameters
        ----------
        n : int, optional
            The number of segments, from `number_of_roots` to `number_of_segments`, or else the
            nearest of these. With `salience_threshold`, the largest number of segments. By default
            it is the number of segments of the run.
        salience_threshold : float, optional
            The smallest salience of a cut, like in a run with this threshold.

        Returns
        -------
        ndarray of int, shape (number_of_faces,)

        Raises
        ------
        ValueError
            If a cut is needed that the run did not search, `n` is below 1, or `salience_threshold`
            is not a number, or not in [0, 1] although the salience of the run is a probability.

        Warns
        -----
        UserWarning
            If `n` is larger than `number_of_segments`, without `salience_threshold`. A run with
            `number_of_segments=n` makes exactly n segments.
        """
        return self._labels(self.segments(n, salience_threshold=salience_threshold))

    def _labels(self, nodes):
        labels = self._core.labels_of_nodes(nodes)
        return labels if self._surface is None else self._surface.labels_of_faces(labels)

    def labels_of_nodes(self, nodes: Iterable[int]) -> NDArray[np.intp]:
        """Returns the label of each triangle or polygon if the segments are these nodes.

        Parameters
        ----------
        nodes : iterable of int
            The node of each segment. Each triangle must be in exactly one of them.

        Returns
        -------
        ndarray of int, shape (number_of_faces,)

        Raises
        ------
        ValueError
            If there is no such node, or the nodes do not contain each triangle exactly once.
        """
        try:
            nodes = list(nodes)
        except TypeError:
            raise TypeError("nodes must be integers, not %s" % type(nodes).__name__) from None
        return self._labels([self._node("nodes", node) for node in nodes])

    def faces(self, node: int) -> NDArray[np.intp]:
        """Returns the triangles or polygons of a node.

        Parameters
        ----------
        node : int

        Returns
        -------
        ndarray of int
            Their indices, in ascending order.

        Raises
        ------
        ValueError
            If there is no such node.
        """
        faces = self._core.faces(self._node("node", node))
        if self._surface is None:
            return faces
        is_inside = np.zeros(self._core.number_of_faces, np.uint32)
        is_inside[faces] = 1
        return np.flatnonzero(self._surface.labels_of_faces(is_inside))

    def merge(self, a: int, b: int) -> int:
        """Makes two nodes the children of one node.

        If the nodes are not siblings, `b` moves to the place of `a`. No other node gets another
        number.

        Parameters
        ----------
        a, b : int
            Two nodes.

        Returns
        -------
        int
            Their parent.

        Raises
        ------
        ValueError
            If one contains the other, or they have different roots.
        """
        return self._core.merge(self._node("a", a), self._node("b", b))

    def split_leaf(self, leaf: int, part: Hierarchy) -> None:
        """Cuts a leaf as another hierarchy does.

        Parameters
        ----------
        leaf : int
            A node without children.
        part : Hierarchy
            The result of a run on `triangles[hierarchy.faces(leaf)]`.

        Raises
        ------
        ValueError
            If `leaf` is no leaf, or `part` has another number of triangles or several roots.
        """
        if not isinstance(part, Hierarchy):
            raise TypeError("part must be a Hierarchy, not %s" % type(part).__name__)
        if self._surface is not None and self._surface.has_polygons:
            raise ValueError("a hierarchy of polygons cannot be cut further; cut the polygons into "
                             "triangles before the first run")
        self._core.split_leaf(self._node("leaf", leaf), part._core)

    def to_json(self) -> str:
        """Returns the hierarchy as JSON, which the C++ library and its tool write and read too.

        Returns
        -------
        str
        """
        return self._core.to_json()

    @staticmethod
    def from_json(text: Union[str, bytes]) -> Hierarchy:
        """Reads a hierarchy from a text of `to_json()` or `segment_mesh --hierarchy`.

        Parameters
        ----------
        text : str or bytes

        Returns
        -------
        Hierarchy

        Raises
        ------
        ValueError
            If the text is not a hierarchy.
        """
        if isinstance(text, (bytes, bytearray)):
            text = text.decode(errors="replace")
        if not isinstance(text, str):
            raise TypeError("text must be a str, not %s" % type(text).__name__)
        return Hierarchy._of(_core.Hierarchy.from_json(text))

    def save(self, path: Path) -> None:
        """Writes the hierarchy to a file of JSON, which `load()` reads.

        An existing file is replaced only when the new one is complete.

        Parameters
        ----------
        path : path_like

        Raises
        ------
        OSError
            If the file cannot be written.
        """
        replace_file(os.fsdecode(path), self.to_json().encode())

    @staticmethod
    def load(path: Path) -> Hierarchy:
        """Reads a file of `save()` or `segment_mesh --hierarchy`.

        Parameters
        ----------
        path : path_like

        Returns
        -------
        Hierarchy

        Raises
        ------
        OSError
            If the file cannot be read.
        ValueError
            If it has no hierarchy.
        """
        path = os.fsdecode(path)
        with open(path, "rb") as file:
            contents = file.read()
        try:
            return Hierarchy.from_json(contents)
        except ValueError as error:
            raise ValueError("%s cannot be read: %s" % (path, error)) from None
