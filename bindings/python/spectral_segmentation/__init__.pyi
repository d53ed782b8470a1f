# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

import os
from typing import (Any, Callable, Dict, Iterable, Literal, NamedTuple, Optional, Sequence, Tuple,
                    Union)

import numpy as np
from numpy.typing import ArrayLike, NDArray

CUT_STATES: Tuple[str, str, str, str]
__version__: str
__all__ = ["CUT_STATES", "Hierarchy", "Mesh", "SalienceFactors", "View", "__version__",
           "boundary_edges", "read", "segment", "segment_adjacency", "segment_colors",
           "segment_hierarchy", "view", "write"]

_Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]

class SalienceFactors(NamedTuple):
    size: float = 0.0
    cut_strength: float = 0.0
    protrusiveness: float = 0.0
    log_relative_part_area: float = 0.0
    concavity_near_cut: float = 0.0
    convexity_gain: float = 0.0
    relative_convexity_gain: float = 0.0
    expansion_behind_cut: float = 0.0
    roundness: float = 0.0
    flatness_behind_cut: float = 0.0
    concavity_around_cut: float = 0.0
    lower_quartile_of_concavity: float = 0.0
    expansion_before_cut: float = 0.0
    number_of_common_neighbors: float = 0.0
    is_boundary: bool = False

class Hierarchy:
    @property
    def number_of_faces(self) -> int: ...
    @property
    def number_of_nodes(self) -> int: ...
    @property
    def number_of_roots(self) -> int: ...
    @property
    def number_of_segments(self) -> int: ...
    @property
    def salience_threshold(self) -> float: ...
    @property
    def nodes(self) -> NDArray[np.void]: ...
    @property
    def children(self) -> NDArray[np.intp]: ...
    @property
    def saliences(self) -> NDArray[np.float64]: ...
    @property
    def factors(self) -> Dict[str, NDArray[np.float64]]: ...
    def labels(self, n: Optional[int] = None, *,
               salience_threshold: Optional[float] = None) -> NDArray[np.intp]: ...
    def segments(self, n: Optional[int] = None, *,
                 salience_threshold: Optional[float] = None) -> NDArray[np.intp]: ...
    def labels_of_nodes(self, nodes: Iterable[int]) -> NDArray[np.intp]: ...
    def faces(self, node: int) -> NDArray[np.intp]: ...
    def merge(self, a: int, b: int) -> int: ...
    def split_leaf(self, leaf: int, part: Hierarchy) -> None: ...
    def to_json(self) -> str: ...
    @staticmethod
    def from_json(text: Union[str, bytes]) -> Hierarchy: ...
    def save(self, path: _Path) -> None: ...
    @staticmethod
    def load(path: _Path) -> Hierarchy: ...
    def __copy__(self) -> Hierarchy: ...
    def __deepcopy__(self, memo: Dict[int, Any]) -> Hierarchy: ...

class Mesh(NamedTuple):
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    polygon_of_triangle: NDArray[np.int32]
    labels: Optional[NDArray[np.intp]] = None

class View:
    @property
    def html(self) -> str: ...
    def _repr_html_(self) -> str: ...

# `points` may be a mesh of another library, which has no type in common with the others.
def segment(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    *,
    method: Literal["calibrated", "paper"] = "calibrated",
    number_of_segments: Optional[int] = None,
    maximum_number_of_segments: Optional[int] = None,
    salience_threshold: Optional[float] = None,
    keep_components_separate: Optional[bool] = None,
    face_groups: Optional[ArrayLike] = None,
    features: Optional[ArrayLike] = None,
    feature_weight: float = 0.5,
    constrained_edges: Optional[ArrayLike] = None,
    uncuttable_edges: Optional[ArrayLike] = None,
    face_seeds: Optional[ArrayLike] = None,
    minimum_segment_size: Optional[float] = None,
    part_salience: Optional[Callable[[SalienceFactors], float]] = None,
    salience_weights: Optional[Sequence[float]] = None,
    distance_weights: Optional[Sequence[float]] = None,
    number_of_coarse_faces: Optional[int] = None,
    number_of_reference_faces: int = 10,
    number_of_smoothing_iterations: int = 0,
    smooth_boundaries: bool = False,
    random_seed: Optional[int] = None,
    threads: Optional[int] = None,
    progress: Optional[Callable[[float], object]] = None,
) -> NDArray[np.intp]: ...

def segment_hierarchy(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    *,
    method: Literal["calibrated", "paper"] = "calibrated",
    number_of_segments: Optional[int] = None,
    maximum_number_of_segments: Optional[int] = None,
    salience_threshold: Optional[float] = None,
    keep_components_separate: Optional[bool] = None,
    face_groups: Optional[ArrayLike] = None,
    features: Optional[ArrayLike] = None,
    feature_weight: float = 0.5,
    constrained_edges: Optional[ArrayLike] = None,
    uncuttable_edges: Optional[ArrayLike] = None,
    face_seeds: Optional[ArrayLike] = None,
    minimum_segment_size: Optional[float] = None,
    part_salience: Optional[Callable[[SalienceFactors], float]] = None,
    salience_weights: Optional[Sequence[float]] = None,
    distance_weights: Optional[Sequence[float]] = None,
    number_of_coarse_faces: Optional[int] = None,
    number_of_reference_faces: int = 10,
    number_of_smoothing_iterations: int = 0,
    smooth_boundaries: bool = False,
    random_seed: Optional[int] = None,
    threads: Optional[int] = None,
    progress: Optional[Callable[[float], object]] = None,
) -> Hierarchy: ...

def boundary_edges(
    points: Any, triangles: Optional[ArrayLike] = None, labels: Optional[ArrayLike] = None
) -> Tuple[NDArray[np.intp], NDArray[np.intp]]: ...
def segment_adjacency(
    points: Any, triangles: Optional[ArrayLike] = None, labels: Optional[ArrayLike] = None
) -> Tuple[NDArray[np.intp], NDArray[np.float64]]: ...
def segment_colors(
    points: Any, triangles: Optional[ArrayLike] = None, labels: Optional[ArrayLike] = None
) -> NDArray[np.uint8]: ...
def view(
    mesh: Any,
    hierarchy: Optional[Hierarchy] = None,
    *,
    n: Optional[int] = None,
    name: str = "mesh",
    height: int = 600,
) -> View: ...
def read(path: _Path) -> Mesh: ...
def write(
    path: _Path,
    points: Any,
    triangles: Union[ArrayLike, Hierarchy, None] = None,
    labels: Union[ArrayLike, Hierarchy, None] = None,
    *,
    colors: Optional[ArrayLike] = None,
) -> None: ...
