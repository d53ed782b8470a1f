// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

inline double length(const std::vector<Vector>& loop)
{
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return result;
}

// Returns whether a loop is nearer than a distance to the plane through its middle with the mean
// normal of its triangles there.
inline bool is_flat(const std::vector<Vector>& loop, double distance)
{
  Vector middle, normal;
  for (const Vector& p : loop)
    middle += p / static_cast<double>(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
    normal += (loop[i] - middle).cross(loop[(i + 1) % loop.size()] - middle);
  return std::all_of(loop.begin(), loop.end(), [&](const Vector& p) {
    return std::abs((p - middle).dot(normal)) <= distance * normal.norm();
  });
}

// Returns a triangulation of a loop of points, whose triangles are given by places in the loop, in
// its direction. It is Delaunay in the plane of the loop if the loop is nearly flat, else a surface
// that bends little and has a small area. It is empty if CGAL finds none, or would take minutes.
inline std::vector<Corners> triangulated_loop(std::vector<Vector> loop)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  normalize(loop);
  const Bounding_box box(loop);
  const double diagonal = (box.largest - box.smallest).norm();
  if (!is_flat(loop, 0.1 * diagonal) && length(loop) > 50 * diagonal)
    return {}; // it fills space, where CGAL's search among tetrahedra is slow
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  for (const Vector& p : loop)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<CGAL::Triple<int, int, int> > triangles;
  PMP::triangulate_hole_polyline(
    points, std::back_inserter(triangles),
    CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
      .threshold_distance(0.1 * diagonal)
      .do_not_use_cubic_algorithm(true));
  std::vector<Corners> result;
  if (triangles.size() + 2 == loop.size())
    for (const auto& t : triangles) {
      result.push_back({Index(t.first), Index(t.second), Index(t.third)});
      std::sort(result.back().begin(), result.back().end());
    }
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
