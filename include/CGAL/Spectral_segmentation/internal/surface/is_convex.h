// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <cmath>

namespace CGAL::Spectral_segmentation::internal {

// Returns whether a component is a convex solid: it is closed, its faces point outward, and no face
// rises above the plane of a neighbor by more than rounding errors of points that were given with
// about six digits.
inline bool is_convex(const Surface& surface, Index component = 0)
{
  constexpr double largest_height = 1e-5; // of the square root of the area
  double volume = 0, area = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (surface.components[f] == component)
      area += surface.areas[f];
  const double unit = std::sqrt(area);
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    if (surface.components[f] != component)
      continue;
    const Vector normal = surface.normal(f);
    volume += normal.dot(surface.centroid(f)) / 6;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Vector apex =
        surface.points[surface.target_vertex(Surface::next(surface.opposite[h]))];
      const double height = normal.dot(apex - surface.points[surface.source_vertex(h)]);
      if (surface.is_border(h) || height > largest_height * unit * normal.norm())
        return false;
    }
  }
  return volume > largest_height * area * unit;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_IS_CONVEX_H
