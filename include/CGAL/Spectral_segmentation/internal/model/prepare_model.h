// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_PREPARE_MODEL_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_PREPARE_MODEL_H

#include <CGAL/Spectral_segmentation/internal/levels/prepare_surface.h>
#include <CGAL/Spectral_segmentation/internal/model/component_walls.h>
#include <CGAL/Spectral_segmentation/internal/model/surrounding_components.h>
#include <CGAL/Spectral_segmentation/internal/model/weld_borders.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <algorithm>
#include <cstddef>
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

// A mesh of several components, besides its faces.
struct Assembled_model
{
  std::vector<Part_of_model> parts; // not empty if components are searched by themselves
  Component_fractions fractions;    // of the mesh, if it has several components
  Level walls;                      // the components that are walls of others
  std::vector<Index> outer_face;    // of the caller, the nearest to each face of a wall
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
inline void remove_walls(Assembled_model& m, Level& level, const std::vector<double>& volumes,
                         const std::vector<Index>& original, std::vector<Vector>& given_points,
                         const Run_data& d)
{
  Surface& mesh = level.surface;
  const std::vector<char> is_constrained =
    constrained_faces(d.constraints, original, original.size());
  std::vector<char> may_be_wall(mesh.components.number, 1);
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (is_constrained[level.parent_face[f]])
      may_be_wall[mesh.components[f]] = 0;

  Wall_finder finder(mesh, volumes);
  const std::vector<Index> outer = finder(may_be_wall);
  std::vector<Index> kept, walls, outer_face;
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (const Index o = outer[mesh.components[f]]; o == null_index)
      kept.push_back(f);
    else {
      walls.push_back(f);
      outer_face.push_back(level.parent_face[finder.nearest_face(o, f)]);
    }
  if (walls.empty() || kept.size() < d.options.number_of_segments.value_or(0))
    return;
  m.outer_face = std::move(outer_face);
  m.walls = some_faces(level, mesh.points, walls);
  given_points = submesh(mesh, given_points, kept).points;
  level = some_faces(level, mesh.points, kept);
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

// Prepares a mesh of several components: removes duplicate faces, joins faces at borders that meet
// and removes walls if components are merged, orients the components, and divides them into parts.
// Sets the map of the caller's faces.
inline Assembled_model prepare_model(Level& level, Face_map& map, const Run_data& d)
{
  Surface& mesh = level.surface;
  const std::size_t number_of_faces = mesh.number_of_faces();
  const bool are_kept = d.options.keep_components_separate;
  const std::vector<Index> original = are_kept ? first_indices(number_of_faces)
                                               : remove_duplicates(level);
  const bool is_merged = !are_kept && mesh.components.number > 1; // still
  if (mesh.components.number == 1) // else faces start at the same corners in soups and meshes
    reorder_vertices(mesh);
  const bool has_parts = is_searched_in_parts(mesh, d);
  std::vector<Vector> given_points;
  if (has_parts)
    given_points = mesh.points;
  double unit = normalize(mesh.points);
  if (is_merged)
    weld_borders(mesh);
  const std::vector<double> volumes = orient_outward(mesh);
  mesh.groups.clear(); // they are components now
  Assembled_model m;
  if (is_merged)
    remove_walls(m, level, volumes, original, given_points, d);
  std::vector<Index> component(number_of_faces); // of the caller's faces, before they are ordered
  if (has_parts || mesh.components.number > 1) {
    m.fractions = component_fractions(mesh);
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      component[level.parent_face[f]] = mesh.components[f];
  }
  if (has_parts)
    m.parts = parts_of(level, m.fractions, given_points);
  const double unit_of_frame = move_and_order(level, d);
  if (has_parts || mesh.components.number > 1)
    m.fractions = renumbered(m.fractions, composed(level.parent_face, component),
                             mesh.components.labels);
  unit *= unit_of_frame;
  for (double& area : m.walls.surface.areas)
    area /= unit_of_frame * unit_of_frame;
  check_number(mesh, d.options);
  map = face_map(unit, original, level, m.walls);
  return m;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_PREPARE_MODEL_H
