# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes vectors of the features of triangles."""

import numpy as np

from ._meshes import array

_LARGEST_NUMBER_OF_INDICATORS = 64


def _vectors_of_labels(labels):
    """Any two labels have about the same distance."""
    known, number = np.unique(labels, return_inverse=True)
    if len(known) <= _LARGEST_NUMBER_OF_INDICATORS:
        vectors = np.eye(len(known), dtype=np.float32)
    else:
        size = (len(known), _LARGEST_NUMBER_OF_INDICATORS)
        signs = np.random.RandomState(0).randint(2, size=size)
        vectors = (2 * signs - 1).astype(np.float32)
    return vectors[number]


def features_of_triangles(value, surface):
    """A vector for each triangle of the run, as an array of float32."""
    number_of_faces = len(surface)
    features = array("features", value)
    if features.dtype.kind not in "iuf":
        raise TypeError("features must be numbers, not %s" % features.dtype)
    if features.ndim not in (1, 2) or len(features) != number_of_faces:
        raise ValueError("features must have the shape (%d,) or (%d, d), one for each triangle, "
                         "not %s" % (number_of_faces, number_of_faces, features.shape))
    if features.ndim == 2 and features.shape[1] == 0:
        raise ValueError("features must have at least one number for each triangle")
    features = surface.values_of_triangles(features)
    number_of_triangles = len(features)
    if features.ndim == 1 and features.dtype.kind in "iu":
        return _vectors_of_labels(features)
    features = features.reshape(number_of_triangles, -1) if number_of_triangles > 0 else \
        np.empty((0, 1), np.float32)
    if not np.isfinite(features).all():
        faces = surface.values_of_triangles(np.arange(number_of_faces))
        raise ValueError("features has a number that is not finite, at face %d"
                         % faces[~np.isfinite(features).all(axis=1)][0])
    if features.dtype != np.float32 and number_of_triangles > 0:
        features = features.astype(np.float64, copy=False)
        features = features - features[0]  # float32 keeps digits of differences
        largest = np.abs(features).max()
        features = (features / largest if largest > 0 else features).astype(np.float32)
    return np.ascontiguousarray(features)
