// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_BASE_H
#define CGAL_SEGMENTED_MESH_INTERNAL_BASE_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

// The library uses the arrays of Spectral_segmentation, but none of its methods.
namespace CGAL::Spectral_segmentation::internal_np {}
namespace CGAL::Segmented_mesh::internal {
using namespace Spectral_segmentation::internal;
namespace internal_np = Spectral_segmentation::internal_np;
} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_BASE_H
