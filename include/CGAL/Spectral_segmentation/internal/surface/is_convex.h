// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

namespace CGAL::Spectral_segmentation::internal {

// Returns whether a connected surface in its frame, with area 1, bounds a convex solid: it is
// closed, it encloses a volume, and no face rises above the plane of a neighbor by more than
// rounding explains.
inline bool is_convex(const Surface& surface)
{
  constexpr double largest_height = 1e-5; // points are rounded to 1e-6
  double volume = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    const Vector normal = surface.normal(f);
    volume += normal.dot(surface.centroid(f)) / 6;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Vector apex =
        surface.points[surface.target_vertex(Surface::next(surface.opposite[h]))];
      const double height = normal.dot(apex - surface.points[surface.source_vertex(h)]);
      if (surface.is_border(h) || height > largest_height * normal.norm())
        return false;
    }
  }
  return volume > largest_height;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H
