// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_GEOMETRIC_ORDER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_GEOMETRIC_ORDER_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the place of a point of a box on a curve that fills the box (Morton 1966).
inline std::uint64_t place_on_curve(const Vector& p, const Bounding_box& box)
{
  constexpr int bits = 20; // in each dimension
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double scale = extent > 0 ? ((1 << bits) - 1) / extent : 0;
  const Vector q = scale * (p - box.smallest);
  std::uint64_t result = 0;
  for (int bit = bits; bit-- > 0;)
    for (int i = 0; i < 3; ++i)
      result = 2 * result + (static_cast<std::uint64_t>(q[i]) >> bit & 1);
  return result;
}

// Rotates each face to start at its first point, and returns the faces in an order that depends on
// their points alone, and in which faces near in space are near in memory. Faces with equal points
// stay in their order.
inline std::vector<Index> geometric_order(Surface& surface)
{
  start_at_smallest_vertices(surface, [&](Index v, Index w)
    { return surface.points[v] < surface.points[w]; });
  const Bounding_box box(surface.points);
  std::vector<std::uint64_t> place;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    place.push_back(place_on_curve(surface.centroid(f), box));
  const auto point = [&](Index f, int i) { return surface.points[surface.corners[f][i]]; };
  std::vector<Index> result(surface.number_of_faces());
  std::iota(result.begin(), result.end(), Index(0));
  std::sort(result.begin(), result.end(), [&](Index f, Index g) {
    if (place[f] != place[g])
      return place[f] < place[g];
    return std::make_tuple(point(f, 0), point(f, 1), point(f, 2), f) <
           std::make_tuple(point(g, 0), point(g, 1), point(g, 2), g);
  });
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_GEOMETRIC_ORDER_H
