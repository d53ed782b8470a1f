// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_PREPARE_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_PREPARE_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/levels/make_levels.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns whether a method searches the points of a mesh as they are given.
inline bool keeps_points(const Surface& mesh, const Run_data& d)
{ return d.method.keeps_points && is_searched_itself(d, mesh.number_of_faces()); }

// Returns whether the components of a mesh are searched in parts. The method of the paper searches
// all together.
inline bool is_searched_in_parts(const Surface& mesh, const Run_data& d)
{ return d.options.method == Method::CALIBRATED && mesh.components.number > 1; }

// Returns the order in which faces are kept; empty for the order of the caller. A mesh that is only
// coarsened needs no order, because its coarse surface is put in one. Components that are searched
// by themselves need one, because ties go to the first of equal components.
inline std::vector<Index> order_of_faces(Surface& mesh, const Run_data& d)
{
  if (keeps_points(mesh, d))
    return locality_order(mesh);
  if (is_searched_in_parts(mesh, d) || d.options.number_of_coarse_faces == 0)
    return geometric_order(mesh);
  return {};
}

// Moves a mesh into a frame of its own, unless its points are kept, and orders its faces. A run
// that is stopped meanwhile leaves the order. Returns the length of 1 in the old unit.
inline double move_and_order(Level& mesh, const Run_data& d)
{
  const double unit = keeps_points(mesh.surface, d) ? 1 : move_to_frame(d.execution, mesh.surface);
  if (mesh.surface.components.number > 1) // thousands may meet at one vertex, with all their leaves
    separate_vertices(mesh.surface, mesh.surface.components);
  if (d.monitor.go_further()) {
    const std::vector<Index> order = order_of_faces(mesh.surface, d);
    d.monitor.advance(0.3);
    if (!order.empty() && d.monitor.go_further()) {
      reorder_faces(mesh.surface, order);
      mesh.parent_face = composed(order, mesh.parent_face);
    }
  }
  d.monitor.advance(0.3);
  return unit;
}

inline void prepare_part(Level& mesh, const Run_data& d)
{
  normalize(mesh.surface.points);
  set_areas(d.execution, mesh.surface);
  move_and_order(mesh, d);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_PREPARE_SURFACE_H
