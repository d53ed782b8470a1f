// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CHECK_SEGMENT_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CHECK_SEGMENT_H

#include <CGAL/Segmented_mesh/Closed_segment.h>
#include <CGAL/Segmented_mesh/internal/capping/Segment_capping.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/triangle_sides.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns the properties of the triangles of a closed segment, all but its id.
template <class Id>
Closed_segment<Id> check_segment(const std::vector<Vector>& points,
                                 const std::vector<Corners>& triangles)
{
  Closed_segment<Id> result;
  const std::vector<Triangle_side> sides = sorted_sides(triangles);
  result.is_closed = is_closed(sides);
  result.is_manifold = result.is_closed && is_manifold(triangles, sides);
  if (result.is_closed && !triangles.empty()) {
    const Vector origin = points[triangles[0][0]];
    for (const Corners& t : triangles)
      result.volume += tetrahedron_volume(origin, points[t[0]], points[t[1]], points[t[2]]);
  }
  result.is_outward_oriented = result.volume > 0;
  result.has_self_intersections =
    std::any_of(triangles.begin(), triangles.end(),
                [&](const Corners& t) { return is_degenerate(points, t); }) ||
    do_self_intersect(points, triangles);
  return result;
}

// Returns the properties of each segment, in the order of their ids.
template <class Id>
std::vector<Closed_segment<Id> > closed_segments(const Segment_capping& capping,
                                                 const std::vector<Id>& ids)
{
  std::vector<Closed_segment<Id> > result;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    result.push_back(
      check_segment<Id>(capping.points(), capping.triangles(static_cast<Index>(i))));
    result.back().id = ids[i];
    result.back().volume *= capping.unit() * capping.unit() * capping.unit();
  }
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CHECK_SEGMENT_H
