# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that `segment_mesh --html` writes, for files and notebooks."""

from __future__ import annotations

import html
import pathlib
from typing import Any, Optional

from . import _core
from ._checks import integer
from ._hierarchy import Hierarchy
from ._meshes import surface_of
from ._runs import segment_hierarchy

_FOLDER = pathlib.Path(__file__).parent / "page"
_has_sources = False


def _set_sources():
    global _has_sources
    if _has_sources:
        return
    sources = {path.name: path.read_bytes() for path in _FOLDER.glob("*") if path.is_file()}
    if "three.min.js" not in sources:
        raise RuntimeError("this build of spectral_segmentation has no page, because three.js "
                           "(Debian package libjs-three) was missing when it was made")
    _core.set_page_sources(sources)
    _has_sources = True


def page_of(surface, hierarchy, name, n=None):
    """The bytes of the page."""
    if not isinstance(hierarchy, Hierarchy):
        raise TypeError("a page needs a Hierarchy, which segment_hierarchy() returns, not %s"
                        % type(hierarchy).__name__)
    _set_sources()
    if hierarchy._core.number_of_faces != len(surface.triangles):
        raise ValueError("the hierarchy has %d triangles, but the mesh has %d"
                         % (hierarchy._core.number_of_faces, len(surface.triangles)))
    if len(surface) == 0:
        raise ValueError("the mesh has no triangles")
    if n is None:
        n = len(hierarchy.segments())
    is_probability = hierarchy._is_probability
    if is_probability is None: # of a file; only the calibrated method computes this factor
        is_probability = bool(hierarchy.factors["log_relative_part_area"].any())
    name = name.encode(errors="replace").decode()
    return _core.page(surface.core, hierarchy._core, name, n, is_probability)


class View:
    """A page that shows a segmented mesh. `view()` makes one, and notebooks display it."""

    def __init__(self, page, height):
        self._page = page
        self._height = height

    @property
    def html(self) -> str:
        """str: the page, which needs no other file and no network."""
        return self._page

    def __repr__(self):
        return "<View of %d bytes of HTML>" % len(self._page)

    def _repr_html_(self) -> str:
        page = html.escape(self._page).encode("ascii", "xmlcharrefreplace").decode()
        return ('<iframe srcdoc="%s" width="100%%" height="%d" style="border: 0" '
                'allow="fullscreen"></iframe>' % (page, self._height))


def view(mesh: Any, hierarchy: Optional[Hierarchy] = None, *, n: Optional[int] = None,
         name: str = "mesh", height: int = 600) -> View:
    """Shows a segmented mesh in a notebook, with a slider for the number of segments.

    It is the page of `segment_mesh --html` and `write("page.html", mesh, hierarchy)`.

    Parameters
    ----------
    mesh : mesh
        A mesh of any kind that `segment()` takes, such as a tuple (points, triangles).
    hierarchy : Hierarchy, default: segment_hierarchy(mesh)
        The cuts of the mesh.
    n : int, optional
        The number of segments that the page shows first, by default the number of the run.
    name : str, default: "mesh"
        The title of the page.
    height : int, default: 600
        The height in the notebook, in pixels.

    Returns
    -------
    View
        The last expression of a cell is displayed.

    Raises
    ------
    TypeError, ValueError
        If an argument has a wrong type, or the hierarchy has another number of triangles.
    RuntimeError
        If the package was built without three.js.

    Examples
    --------
    >>> view(mesh, segment_hierarchy(mesh))
    """
    surface = surface_of(mesh)
    if hierarchy is None:
        hierarchy = segment_hierarchy(surface)
    if n is not None:
        n = integer("n", n)
        if n < 1:
            raise ValueError("n must be at least 1")
    return View(page_of(surface, hierarchy, str(name), n).decode(), integer("height", height))
