// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_VERSION_H
#define CGAL_SPECTRAL_SEGMENTATION_VERSION_H

/// \file
/// Defines the version of the package. CMake reads the version from this file.

#define CGAL_SPECTRAL_SEGMENTATION_VERSION "0.1.0"

#endif // CGAL_SPECTRAL_SEGMENTATION_VERSION_H
