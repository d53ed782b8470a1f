// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CLOSED_SOLID_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CLOSED_SOLID_H

#include <CGAL/Segmented_mesh/Closed_segment.h>
#include <CGAL/Segmented_mesh/internal/capping/Segmented_solid.h>
#include <CGAL/Segmented_mesh/internal/capping/disc_caps.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_sides.h>
#include <CGAL/Segmented_mesh/internal/capping/wall_caps.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Closes a segment. Each edge of its border has another segment, because the surface is closed.
// With `null_index` it closes the surface.
inline void close(Segmented_solid& solid, Index segment, Crossings& crossings)
{
  const bool has_inside = segment != null_index;
  const Border border =
    has_inside ? solid.borders().border(segment) : solid.borders().border_of_surface();
  const Opening all(segment, border, split_into_loops(border));
  const std::size_t number_of_points = solid.points().size();
  std::vector<Cap> caps;
  std::vector<Loop> open = all.loops; // loops without a cap that intersects nothing
  const auto remove_closed = [&](auto make_cap) {
    open.erase(std::remove_if(open.begin(), open.end(), [&](const Loop& loop) {
      const Cap cap = make_cap(Opening(segment, border, {loop}));
      if (!cap.empty()) {
        solid.reserve(cap);
        caps.push_back(cap);
      }
      return !cap.empty();
    }), open.end());
  };
  if (has_inside) {
    remove_closed([&](const Opening& opening) { return strip(solid, opening, crossings); });
    for (const Cap& cap : rings(solid, open, segment, border, crossings))
      caps.push_back(cap);
  }
  remove_closed([&](const Opening& opening) { return disc(solid, opening, true); });
  if (!open.empty() && has_inside && all.has_disjoint_loops()) {
    const std::vector<Vector> points_of_caps(
      solid.points().begin() + static_cast<std::ptrdiff_t>(number_of_points),
      solid.points().end());
    solid.release(caps);
    solid.resize_points(number_of_points);
    const Cap cap = shell(solid, all);
    if (cap.empty())
      for (const Vector& p : points_of_caps)
        solid.add_point(p);
    else {
      caps.assign(1, cap);
      open.clear();
    }
    for (const Cap& c : caps)
      solid.reserve(c);
  }
  for (const Loop& loop : open) {
    caps.push_back(disc(solid, {segment, border, {loop}}, false));
    solid.reserve(caps.back());
    solid.set_has_forced_caps();
  }
  for (const Cap& cap : caps)
    solid.add(cap, segment);
  if (has_inside)
    solid.set_closed(segment);
}

// Closes segments one after the other, in the order of the solid but some first, or in the reverse
// order. Each border loop of a segment gets a cap, or loops on two walls of a hollow body get a
// ring. Their triangles, reversed, go to the segments on the other side, so that all segments fit
// together, even where three of them meet.
inline void close(Segmented_solid& solid, const std::set<Index>& first, bool is_reversed)
{
  Crossings crossings;
  close(solid, null_index, crossings);
  solid.set_orientation();
  std::vector<Index> order = solid.order();
  if (is_reversed)
    std::reverse(order.begin(), order.end());
  else
    std::stable_partition(order.begin(), order.end(),
                          [&first](Index s) { return first.count(s) > 0; });
  for (Index s : order)
    close(solid, s, crossings);
}

// Returns whether the components of a closed manifold that does not intersect itself are nested
// like the borders of a solid.
inline bool bounds_solid(const std::vector<Vector>& points, const std::vector<Corners>& triangles)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::map<Index, std::size_t> number; // the index of each corner in the mesh
  std::vector<Exact_predicates::Point_3> corners;
  std::vector<std::array<std::size_t, 3> > polygons;
  for (const Corners& t : triangles) {
    polygons.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto [place, is_new] = number.emplace(t[i], corners.size());
      if (is_new)
        corners.push_back(exact_point(points[t[i]]));
      polygons.back()[i] = place->second;
    }
  }
  CGAL::Surface_mesh<Exact_predicates::Point_3> mesh;
  PMP::polygon_soup_to_polygon_mesh(corners, polygons, mesh);
  return PMP::does_bound_a_volume(mesh);
}

// Returns whether no triangle is degenerate or intersects another one.
inline bool are_free_of_intersections(const std::vector<Vector>& points,
                                      const std::vector<Corners>& triangles)
{
  return std::none_of(triangles.begin(), triangles.end(),
                      [&points](const Corners& t) { return is_degenerate(points, t); }) &&
         !do_self_intersect(points, triangles);
}

// Returns the properties of a closed segment, except its id.
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
  result.has_self_intersections = !are_free_of_intersections(points, triangles);
  result.is_outward_oriented =
    result.volume > 0 && (!result.is_manifold || result.has_self_intersections ||
                          bounds_solid(points, triangles));
  return result;
}

// The closed segments, and their properties in the order of their ids.
template <class Id>
struct Closed_solid
{
  std::unique_ptr<Segmented_solid> solid;
  std::vector<Closed_segment<Id> > segments;
  std::size_t number_of_solids = 0;
};

// Closes the segments of a surface, which have numbers from 0 on, the smallest first. If caps had
// to intersect something, tries two other orders with other sectors: those that could be solids
// first, and the largest first. Returns the result with most solids. On demand turns a surface that
// is inside out.
template <class Id>
Closed_solid<Id> closed_solid(const std::vector<Vector>& points,
                              const std::vector<Corners>& triangles,
                              const std::vector<Index>& segment, const std::vector<Id>& ids,
                              bool is_turned_outward)
{
  Closed_solid<Id> best;
  std::set<Index> first;
  for (Sectors sectors : {Sectors::FLAT, Sectors::FLAT_OR_WITH_CHORDS, Sectors::NONE}) {
    Closed_solid<Id> result;
    result.solid = std::make_unique<Segmented_solid>(points, triangles, segment, ids.size());
    Segmented_solid& solid = *result.solid;
    const std::vector<std::vector<Corners> > given = solid.triangles();
    solid.set_sectors(sectors);
    close(solid, first, sectors == Sectors::NONE);
    if (is_turned_outward)
      solid.turn_outward();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      result.segments.push_back(check_segment<Id>(solid.points(), solid.triangles()[i]));
      Closed_segment<Id>& s = result.segments.back();
      s.id = ids[i];
      s.volume *= solid.unit() * solid.unit() * solid.unit();
      result.number_of_solids += s.is_solid();
      if (s.has_self_intersections && are_free_of_intersections(solid.points(), given[i]))
        first.insert(static_cast<Index>(i));
    }
    const bool is_done = solid.all_caps_are_free() || first.empty();
    if (!best.solid || result.number_of_solids > best.number_of_solids)
      best = std::move(result);
    if (is_done || best.number_of_solids == ids.size())
      break;
  }
  return best;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_CLOSED_SOLID_H
