// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSE_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSE_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A surface of the same shape and topology as another one, with fewer faces.
struct Coarse_surface
{
  Surface graph;               // has no weights
  std::vector<Index> faces;    // the face of the finer surface that each face is left from
  std::vector<Index> vertices; // the vertex of the graph for each vertex of the finer surface
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSE_SURFACE_H
