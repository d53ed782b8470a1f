// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_PREPARE_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_PREPARE_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/levels/make_levels.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/orient_outward.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The caller's faces and unit in terms of the first level of a run. Faces of walls, which are no
// part of the mesh, follow those of the mesh.
struct Face_map
{
  double unit;             // the length of 1 in the coordinates of the caller
  std::vector<Index> face; // for each of the caller's; a duplicate has that of its original
};

// Returns the map of the caller's faces, given the original of each duplicate, or the face itself.
inline Face_map face_map(double unit, const std::vector<Index>& original, const Level& mesh,
                         const Level& walls)
{
  std::vector<Index> number(original.size(), null_index);
  for (Index f = 0; f < mesh.parent_face.size(); ++f)
    number[mesh.parent_face[f]] = f;
  for (Index f = 0; f < walls.parent_face.size(); ++f)
    number[walls.parent_face[f]] = static_cast<Index>(mesh.parent_face.size()) + f;
  return {unit, composed(original, number)};
}

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

inline void check_number(const Surface& mesh, const Options& o)
{
  if (!o.number_of_segments)
    return;
  const std::size_t number = *o.number_of_segments;
  const std::size_t least = o.keep_components_separate ? mesh.components.number : 1;
  if (number < least || number > mesh.number_of_faces())
    throw std::invalid_argument(
      "segment_spectral_recursive: number_of_segments is " + std::to_string(number) +
      ", but the mesh can have " + std::to_string(least) + " to " +
      std::to_string(mesh.number_of_faces()) + " segments");
}

// Returns the first level of a run, with its components.
inline Level first_level(Surface mesh)
{
  separate_groups(mesh);
  mesh.components = connected_components(mesh);
  const std::size_t n = mesh.number_of_faces();
  return {std::move(mesh), first_indices(n), {}};
}

// Prepares a connected mesh, and returns the map of the caller's faces.
inline Face_map prepare_surface(Level& mesh, const Run_data& d)
{
  reorder_vertices(mesh.surface);
  double unit = normalize(mesh.surface.points);
  orient_outward(mesh.surface);
  mesh.surface.groups.clear();
  unit *= move_and_order(mesh, d);
  check_number(mesh.surface, d.options);
  return face_map(unit, first_indices(mesh.parent_face.size()), mesh, {});
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_PREPARE_SURFACE_H
