// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CHECK_SEGMENT_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CHECK_SEGMENT_H

#include <CGAL/Segmented_mesh/Closed_segment.h>
#include <CGAL/Segmented_mesh/internal/capping/Segment_capping.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/triangle_sides.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns the solid angle that a triangle takes up as seen from a point, positive from behind.
inline double solid_angle(const Vector& from, const Vector& p, const Vector& q, const Vector& r)
{
  const Vector a = (p - from).normalized(), b = (q - from).normalized(),
               c = (r - from).normalized();
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

// Returns whether the components of a closed manifold that does not intersect itself bound a
// solid, which is inside of components that are oriented outward, and outside of cavities, which
// are oriented inward. Therefore no other components, or one more outward than inward, are around
// a component.
inline bool bounds_solid(const std::vector<Vector>& points, const std::vector<Corners>& triangles,
                         const std::vector<Triangle_side>& sides)
{
  struct Component
  {
    std::vector<Corners> triangles;
    std::vector<Vector> points; // the corners of the triangles
    double volume = 0;
  };
  Face_components sets(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    sets.add(static_cast<Index>(t));
  for_each_edge(sides, [&](std::size_t i, std::size_t)
    { sets.join(sides[i].triangle(), sides[i + 1].triangle()); });
  std::map<Index, std::size_t> number; // of the component of a representative
  std::vector<Component> components;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [found, is_new] =
      number.emplace(sets.representative(static_cast<Index>(t)), components.size());
    if (is_new)
      components.emplace_back();
    Component& c = components[found->second];
    c.triangles.push_back(triangles[t]);
    for (Index v : triangles[t])
      c.points.push_back(points[v]);
    const std::size_t n = c.points.size();
    c.volume += tetrahedron_volume(c.points[0], c.points[n - 3], c.points[n - 2], c.points[n - 1]);
  }
  std::vector<Bounding_box> boxes;
  for (const Component& c : components)
    boxes.emplace_back(c.points);

  for (const Component& c : components) {
    const Vector& p = c.points[0];
    double angle = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
      bool is_in_box = &components[i] != &c;
      for (std::size_t k = 0; k < 3; ++k)
        is_in_box = is_in_box && boxes[i].smallest[k] < p[k] && p[k] < boxes[i].largest[k];
      if (is_in_box)
        for (const Corners& t : components[i].triangles)
          angle += solid_angle(p, points[t[0]], points[t[1]], points[t[2]]);
    }
    const double number_around = std::round(angle / 12.566370614359172); // the full solid angle
    if (c.volume == 0 || number_around != (c.volume > 0 ? 0 : 1))
      return false;
  }
  return true;
}

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
  result.has_self_intersections =
    std::any_of(triangles.begin(), triangles.end(),
                [&](const Corners& t) { return is_degenerate(points, t); }) ||
    do_self_intersect(points, triangles);
  result.is_outward_oriented =
    result.volume > 0 && (!result.is_manifold || result.has_self_intersections ||
                          bounds_solid(points, triangles, sides));
  return result;
}

// Returns the properties of each segment, in the order of their ids. The triangles of each segment
// with its caps are given.
template <class Id>
std::vector<Closed_segment<Id> >
closed_segments(const Segment_capping& capping,
                const std::vector<std::vector<Corners> >& triangles, const std::vector<Id>& ids)
{
  std::vector<Closed_segment<Id> > result;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    result.push_back(check_segment<Id>(capping.points(), triangles[i]));
    result.back().id = ids[i];
    result.back().volume *= capping.unit() * capping.unit() * capping.unit();
  }
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CHECK_SEGMENT_H
