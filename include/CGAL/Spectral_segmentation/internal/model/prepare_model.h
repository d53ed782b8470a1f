// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_PREPARE_MODEL_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_PREPARE_MODEL_H

#include <CGAL/Spectral_segmentation/internal/levels/prepare_surface.h>
#include <CGAL/Spectral_segmentation/internal/model/component_walls.h>
#include <CGAL/Spectral_segmentation/internal/model/model_components.h>
#include <CGAL/Spectral_segmentation/internal/model/weld_borders.h>
#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A part of a model of several components that is searched by itself: a large component, at its own
// scale, or all small components together, at the scale of the model.
struct Part_of_model
{
  Level mesh;
  double fraction_of_model = 1; // 1 unless it is searched at the scale of the model
};

// The mesh of a run, without duplicate faces and walls, in a frame of its own.
struct Model
{
  Level mesh;                       // the first level
  std::vector<Part_of_model> parts; // not empty if components are searched by themselves
  Component_fractions fractions;    // of the mesh, if it has several components
  Level walls;                      // the components that are walls of others
  // The caller's indices:
  std::vector<Index> outer_face;    // for each face of a wall, the nearest of the outer wall
  std::vector<Index> original_face; // of duplicates; empty if no components are merged
  std::vector<Index> neighbors;     // one per halfedge; only for smoothing

  double unit = 1;                  // the length of 1 in the coordinates of the caller

  // Returns the face of the mesh for each of the caller's faces. Those of walls follow.
  std::vector<Index> faces() const
  {
    const Index n = static_cast<Index>(mesh.parent_face.size());
    std::vector<Index> result(original_face.empty() ? n : original_face.size(), null_index);
    for (Index f = 0; f < n; ++f)
      result[mesh.parent_face[f]] = f;
    for (Index f = 0; f < walls.parent_face.size(); ++f)
      result[walls.parent_face[f]] = n + f;
    return original_face.empty() ? result : composed(original_face, result);
  }
};

// Returns some faces of a level, which ascend, with other points.
inline Level some_faces(const Level& level, const std::vector<Vector>& points,
                        const std::vector<Index>& faces)
{ return {submesh(level.surface, points, faces), composed(faces, level.parent_face), {}}; }

// Removes duplicate faces. Returns the face of which each face is a duplicate, or the face itself.
inline std::vector<Index> remove_duplicates(Level& mesh)
{
  std::vector<Index> original = originals_of_faces(mesh.surface);
  std::vector<Index> kept;
  for (Index f = 0; f < original.size(); ++f)
    if (original[f] == f)
      kept.push_back(f);
  if (kept.size() < original.size()) {
    mesh.surface = distinct_faces(mesh.surface, original);
    mesh.surface.components = connected_components(mesh.surface);
    mesh.parent_face = std::move(kept);
  }
  return original;
}

// Removes the components that are walls of others, unless they are constrained, or the rest has
// fewer faces than segments are asked for.
inline void remove_walls(Model& m, const std::vector<double>& volumes,
                         std::vector<Vector>& given_points, const Run_data& d)
{
  Surface& mesh = m.mesh.surface;
  const std::vector<char> is_constrained =
    constrained_faces(d.constraints, m.original_face, m.original_face.size());
  std::vector<char> may_be_wall(mesh.components.number, 1);
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (is_constrained[m.mesh.parent_face[f]])
      may_be_wall[mesh.components[f]] = 0;

  Wall_finder finder(mesh, volumes);
  const std::vector<Index> outer = finder(may_be_wall);
  std::vector<Index> kept, walls, outer_face;
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (const Index o = outer[mesh.components[f]]; o == null_index)
      kept.push_back(f);
    else {
      walls.push_back(f);
      outer_face.push_back(m.mesh.parent_face[finder.nearest_face(o, f)]);
    }
  if (walls.empty() || kept.size() < d.options.number_of_segments.value_or(0))
    return;
  m.outer_face = std::move(outer_face);
  m.walls = some_faces(m.mesh, mesh.points, walls);
  given_points = submesh(mesh, given_points, kept).points;
  m.mesh = some_faces(m.mesh, mesh.points, kept);
  set_areas(d.execution, m.walls.surface);
  set_areas(d.execution, mesh);
}

// Returns the parts of a model that are searched by themselves, with the points that the caller
// gave.
inline std::vector<Part_of_model> parts_of(const Level& mesh, const Component_fractions& fractions,
                                           const std::vector<Vector>& given_points)
{
  constexpr double least_fraction_of_large_component = 0.1;
  std::vector<std::vector<Index> > faces(mesh.surface.components.number);
  for (Index f = 0; f < mesh.surface.number_of_faces(); ++f)
    faces[mesh.surface.components[f]].push_back(f);
  std::vector<Part_of_model> result;
  const auto add_part = [&](const std::vector<Index>& faces_of_part, double fraction) {
    result.push_back({some_faces(mesh, given_points, faces_of_part), fraction});
  };
  std::vector<Index> small;
  double fraction = 0; // the area of the small components
  for (Index c = 0; c < faces.size(); ++c)
    if (fractions.fraction[c] < least_fraction_of_large_component) {
      small.insert(small.end(), faces[c].begin(), faces[c].end());
      fraction += fractions.fraction[c];
    }
    else
      add_part(faces[c], 1);
  std::sort(small.begin(), small.end());
  if (!small.empty())
    add_part(small, fraction > 0 ? (std::min)(fraction, 1.) : 1);
  return result;
}

// Returns the neighbors of the caller's faces for smoothing. The only neighbor of a duplicate face
// is its original. A constrained face is its own neighbor, so that its label stays.
inline std::vector<Index> neighbors_for_smoothing(const Model& m, const Constraints& constraints)
{
  const std::vector<Index> face = m.faces();
  std::vector<Index> callers_face = m.mesh.parent_face;
  callers_face.insert(callers_face.end(), m.walls.parent_face.begin(), m.walls.parent_face.end());
  const Index n = static_cast<Index>(m.mesh.parent_face.size());
  std::vector<Index> result(3 * face.size());
  for (Index h = 0; h < result.size(); ++h) {
    const Index f = face[h / 3];
    Index neighbor = f;
    if (callers_face[f] == h / 3) // else it is a duplicate
      neighbor = f < n ? m.mesh.surface.neighbor(3 * f + h % 3)
                       : n + m.walls.surface.neighbor(3 * (f - n) + h % 3);
    result[h] = callers_face[neighbor];
  }
  const std::vector<char> is_constrained =
    constrained_faces(constraints, face, callers_face.size());
  for (Index h = 0; h < result.size(); ++h)
    if (is_constrained[face[h / 3]])
      result[h] = h / 3;
  return result;
}

// Returns the fractions of components whose faces get these numbers.
inline Component_fractions renumbered(const Component_fractions& fractions,
                                      const std::vector<Index>& old_number,
                                      const std::vector<Index>& new_number)
{
  Component_fractions result = fractions;
  for (std::size_t i = 0; i < new_number.size(); ++i) {
    result.fraction[new_number[i]] = fractions.fraction[old_number[i]];
    result.is_surrounding[new_number[i]] = fractions.is_surrounding[old_number[i]];
  }
  return result;
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

// Prepares the mesh of a run: joins faces at borders that meet, removes duplicate faces and walls
// if components are merged, orients the components, and divides them into parts.
inline Model prepare_model(Surface surface, const Run_data& d)
{
  const std::size_t number_of_faces = surface.number_of_faces();
  d.start_phase(Phase_times(d, number_of_faces).reading);
  Model m;
  Surface& mesh = m.mesh.surface;
  mesh = std::move(surface);
  m.mesh.parent_face = first_indices(mesh.number_of_faces());
  separate_groups(mesh);
  mesh.components = connected_components(mesh);
  const auto are_merged = [&]
    { return !d.options.keep_components_separate && mesh.components.number > 1; };
  if (are_merged())
    m.original_face = remove_duplicates(m.mesh);
  const bool is_merged = are_merged(); // still
  if (mesh.components.number == 1) // else faces start at the same corners in soups and meshes
    reorder_vertices(mesh);
  const bool has_parts = is_searched_in_parts(mesh, d);
  std::vector<Vector> given_points;
  if (has_parts)
    given_points = mesh.points;
  m.unit = normalize(mesh.points);
  if (is_merged)
    weld_borders(mesh);
  const std::vector<double> volumes = orient_outward(mesh);
  mesh.groups.clear(); // they are components now
  if (is_merged)
    remove_walls(m, volumes, given_points, d);
  std::vector<Index> component; // of the caller's faces, before they are ordered
  if (has_parts || mesh.components.number > 1) {
    m.fractions = component_fractions(mesh);
    component.resize(number_of_faces);
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      component[m.mesh.parent_face[f]] = mesh.components[f];
  }
  if (has_parts)
    m.parts = parts_of(m.mesh, m.fractions, given_points);
  const double unit_of_frame = move_and_order(m.mesh, d);
  if (!component.empty())
    m.fractions = renumbered(m.fractions, composed(m.mesh.parent_face, component),
                             mesh.components.labels);
  m.unit *= unit_of_frame;
  for (double& area : m.walls.surface.areas)
    area /= unit_of_frame * unit_of_frame;
  check_number(mesh, d.options);
  if (d.options.smooth_boundaries)
    m.neighbors = neighbors_for_smoothing(m, d.constraints);
  return m;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_PREPARE_MODEL_H
