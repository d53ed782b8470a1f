// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CAPPING_TRIANGULATED_LOOP_H

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A triangulation of a loop of points, whose triangles are given by places in it, in its direction:
// Delaunay in the plane of the loop if that is nearly flat, else a surface that bends little and
// has a small area. Empty if CGAL finds none, or would take minutes.
inline std::vector<Corners> triangulated_loop(std::vector<Vector> loop)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  normalize(loop);
  const Bounding_box box(loop);
  const double diagonal = (box.largest - box.smallest).norm();
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  if (length > 50 * diagonal) // it fills space, where CGAL's search among tetrahedra is slow
    return {};
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

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
