// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_WELD_BORDERS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_WELD_BORDERS_H

#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the group of each vertex, to which all its faces belong; 0 if there are no groups.
inline std::vector<Index> groups_of_vertices(const Surface& surface)
{
  std::vector<Index> result(surface.points.size(), 0);
  for (Index f = 0; f < surface.groups.size(); ++f)
    for (Index v : surface.corners[f])
      result[v] = surface.groups[f];
  return result;
}

// Returns a number for each vertex, which vertices of one group at one point have in common.
inline std::vector<Index> numbers_of_points(const Surface& surface,
                                            const std::vector<Index>& group = {})
{
  const auto place = [&](Index v) {
    const Vector& p = surface.points[v];
    return std::make_tuple(p.x(), p.y(), p.z(), group.empty() ? 0 : group[v]);
  };
  std::vector<Index> order = first_indices(surface.points.size()), result(order.size());
  std::sort(order.begin(), order.end(), [&](Index v, Index w)
    { return std::make_pair(place(v), v) < std::make_pair(place(w), w); });
  for (std::size_t i = 0; i < order.size(); ++i)
    result[order[i]] = i > 0 && place(order[i - 1]) == place(order[i])
      ? result[order[i - 1]] : order[i];
  return result;
}

// Returns the face of which each face is a duplicate, or the face itself. Duplicates have the same
// three points in any order, which must be different. A closed component keeps its faces where it
// touches another one, unless all of them are duplicates of faces of the other.
inline std::vector<Index> originals_of_faces(const Surface& surface)
{
  const std::vector<Index> number = numbers_of_points(surface);
  const std::vector<char> is_closed = closed_components(surface);
  const Components& component = surface.components;
  typedef std::tuple<Corners, bool, Index, Index> Key; // the points, whether open, component, face
  std::vector<Key> faces;
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    Corners c = surface.corners[f];
    c = {number[c[0]], number[c[1]], number[c[2]]};
    std::sort(c.begin(), c.end());
    if (c[0] != c[1] && c[1] != c[2])
      faces.emplace_back(c, !is_closed[component[f]], component[f], f);
  }
  std::sort(faces.begin(), faces.end());
  std::vector<Index> result = first_indices(surface.number_of_faces());
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (std::get<0>(faces[i]) == std::get<0>(faces[i - 1]))
      result[std::get<3>(faces[i])] = result[std::get<3>(faces[i - 1])];

  std::vector<Index> original(component.number, null_index); // the component of the first face
  std::vector<char> is_copy(component.number, 1);
  for (Index f = 0; f < result.size(); ++f) {
    const Index c = component[f], o = component[result[f]];
    original[c] = original[c] == null_index ? o : original[c];
    is_copy[c] = is_copy[c] && o != c && o == original[c];
  }
  std::map<std::pair<Index, Index>, Index> first_of_component; // of faces with the same points
  for (Index f = 0; f < result.size(); ++f) {
    const Index c = component[f];
    if (is_closed[c] && !is_copy[c] && component[result[f]] != c)
      result[f] = first_of_component.emplace(std::make_pair(result[f], c), f).first->second;
  }
  return result;
}

// Returns the faces that are their own originals, connected as a soup whose coincident points of
// one group are merged. This can connect faces that duplicate faces had separated.
inline Surface distinct_faces(const Surface& surface, const std::vector<Index>& original)
{
  Surface result;
  result.points = surface.points;
  const std::vector<Index> number = numbers_of_points(surface, groups_of_vertices(surface));
  for (Index f = 0; f < original.size(); ++f)
    if (original[f] == f) {
      const Corners& c = surface.corners[f];
      result.corners.push_back({number[c[0]], number[c[1]], number[c[2]]});
      if (!surface.groups.empty())
        result.groups.push_back(surface.groups[f]);
    }
  connect_triangles(result);
  return result;
}

// Returns a representative for each vertex. Border vertices of one group that are nearer to each
// other than `width` have the same; those at a distance of a few widths may have the same.
inline std::vector<Index> welded_vertices(const Surface& surface, double width)
{
  typedef std::array<std::int64_t, 4> Cell; // the last coordinate is the group
  const std::vector<Index> group = groups_of_vertices(surface);
  std::vector<char> is_on_border(surface.points.size(), 0);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_border(h))
      is_on_border[surface.source_vertex(h)] = is_on_border[surface.target_vertex(h)] = 1;
  std::vector<std::pair<Cell, Index> > vertices;
  Disjoint_sets sets(surface.points.size()); // sets of vertices
  for (Index v = 0; v < surface.points.size(); ++v) {
    const Vector& p = surface.points[v];
    if (is_on_border[v])
      vertices.push_back({{std::llround(p.x() / width), std::llround(p.y() / width),
                           std::llround(p.z() / width), group[v]}, v});
  }
  std::sort(vertices.begin(), vertices.end());
  for (const auto& [c, v] : vertices)
    for (int i = 0; i < 14; ++i) { // half of the neighboring cells, and its own
      const Cell near = {c[0] + i / 9 - 1, c[1] + i / 3 % 3 - 1, c[2] + i % 3 - 1, c[3]};
      const auto found = std::lower_bound(vertices.begin(), vertices.end(),
                                          std::make_pair(near, Index(0)));
      if (found != vertices.end() && found->first == near)
        sets.join(v, found->second);
    }
  std::vector<Index> result;
  for (Index v = 0; v < surface.points.size(); ++v)
    result.push_back(sets.representative(v));
  return result;
}

// Connects faces whose border edges meet, such as the unwelded patches of a model, because the end
// of a patch is not the end of the surface. Points nearer than 10^-4 of the diagonal of the
// bounding box count as equal. The faces of the surface keep their order.
inline void weld_borders(Surface& surface)
{
  const Bounding_box box(surface.points);
  const double width = 1e-4 * (box.largest - box.smallest).norm();
  if (!(width > 0))
    return;
  const std::vector<Index> vertex = welded_vertices(surface, width);
  std::vector<char> is_kept(vertex.size(), 0); // otherwise a face would lose a corner
  for (const auto& [a, b, c] : surface.corners)
    if (vertex[a] == vertex[b] || vertex[b] == vertex[c] || vertex[c] == vertex[a])
      is_kept[a] = is_kept[b] = is_kept[c] = 1;
  bool is_changed = false;
  for (Corners& corners : surface.corners)
    for (Index& v : corners)
      if (!is_kept[v] && vertex[v] != v) {
        v = vertex[v];
        is_changed = true;
      }
  if (!is_changed)
    return;
  connect_triangles(surface);
  surface.components = connected_components(surface);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_WELD_BORDERS_H
