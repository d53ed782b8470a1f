// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_REORDER_FACES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_REORDER_FACES_H

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the Morton code (Morton 1966) of a point in a box.
inline std::uint64_t morton_code(const Vector& p, const Bounding_box& box)
{
  constexpr int bits = 20; // per dimension
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double scale = extent > 0 ? ((1 << bits) - 1) / extent : 0;
  const Vector q = scale * (p - box.smallest);
  std::uint64_t result = 0;
  for (int bit = bits; bit-- > 0;)
    for (int i = 0; i < 3; ++i)
      result = 2 * result + (static_cast<std::uint64_t>(q[i]) >> bit & 1);
  return result;
}

// Numbers the vertices in the order in which the faces use them. Then the points of faces that are
// near in memory are near in memory, and a pass over a mesh of 2 million faces takes half the time.
inline void reorder_vertices(Surface& surface)
{
  std::vector<Index> number(surface.points.size(), null_index);
  std::vector<Vector> points;
  points.reserve(surface.points.size());
  for (Corners& c : surface.corners)
    for (Index& v : c) {
      if (number[v] == null_index) {
        number[v] = static_cast<Index>(points.size());
        points.push_back(surface.points[v]);
      }
      v = number[v];
    }
  for (Index v = 0; v < number.size(); ++v)
    if (number[v] == null_index) // no face uses it
      points.push_back(surface.points[v]);
  surface.points = std::move(points);
}

// Rotates each face to start at its smallest point, and returns the faces in Morton order, which
// depends only on their points and puts faces near in space near in memory. Faces with equal points
// keep their order.
inline std::vector<Index> geometric_order(Surface& surface)
{
  start_at_smallest_vertices(surface, [&](Index v, Index w)
    { return surface.points[v] < surface.points[w]; });
  const Bounding_box box(surface.points);
  std::vector<std::uint64_t> code;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    code.push_back(morton_code(surface.centroid(f), box));
  const auto point = [&](Index f, int i) { return surface.points[surface.corners[f][i]]; };
  std::vector<Index> result = first_indices(surface.number_of_faces());
  std::sort(result.begin(), result.end(), [&](Index f, Index g) {
    if (code[f] != code[g])
      return code[f] < code[g];
    return std::make_tuple(point(f, 0), point(f, 1), point(f, 2), f) <
           std::make_tuple(point(g, 0), point(g, 1), point(g, 2), g);
  });
  return result;
}

// Returns the faces across the edges of a face in ascending order. It sorts without branches, which
// would be unpredictable.
inline std::array<Index, 3> ascending_neighbors(const Surface& surface, Index f)
{
  std::array<Index, 3> faces = {surface.neighbor(3 * f), surface.neighbor(3 * f + 1),
                                surface.neighbor(3 * f + 2)};
  for (int i : {0, 1, 0})
    std::tie(faces[i], faces[i + 1]) = std::minmax({faces[i], faces[i + 1]});
  return faces;
}

// Returns the faces in an order in which faces near on the surface are near in memory. The order
// consists of blocks, each found by a breadth-first search that begins at a face next to an earlier
// block, or at the first face that is left. Therefore each component is a range, and components
// keep their order. The order does not depend on the data structure.
inline std::vector<Index> locality_order(const Surface& surface)
{
  constexpr std::size_t size_of_block = 1024; // the cache holds several blocks
  const std::size_t n = surface.number_of_faces();
  std::vector<Index> order, outside; // outside: faces next to the blocks so far
  order.reserve(n);
  std::vector<char> is_in_order(n, 0);
  const auto add = [&](Index f, std::size_t end_of_block) {
    if (is_in_order[f])
      return;
    if (order.size() == end_of_block) {
      outside.push_back(f);
      return;
    }
    is_in_order[f] = 1;
    order.push_back(f);
    prefetch(&surface.opposite[3 * f]);
  };
  for (Index first = 0; first < n; ++first)
    for (outside.push_back(first); !outside.empty();) {
      const Index seed = outside.back();
      outside.pop_back();
      std::size_t next = order.size();
      const std::size_t end_of_block = next + size_of_block;
      for (add(seed, end_of_block); next < order.size(); ++next)
        for (Index f : ascending_neighbors(surface, order[next]))
          add(f, end_of_block);
    }
  return order;
}

// Puts the faces in the given order. Numbers the vertices in the order in which faces use them, so
// that the vertices of faces near in order are near in memory. Removes vertices without a face.
// Returns the new index of each vertex, or null_index.
inline std::vector<Index> reorder_faces(Surface& surface, const std::vector<Index>& order)
{
  std::vector<Index> face(order.size()), vertex(surface.points.size(), null_index);
  for (Index i = 0; i < order.size(); ++i)
    face[order[i]] = i;
  renumber_halfedges(surface, [&](Index h) { return 3 * face[h / 3] + h % 3; });
  std::vector<Corners> corners;
  std::vector<Vector> points;
  std::vector<double> areas;
  std::vector<Index> component;
  corners.reserve(order.size());
  points.reserve(surface.points.size());
  for (Index f : order) {
    corners.push_back(surface.corners[f]);
    for (Index& v : corners.back()) {
      if (vertex[v] == null_index) {
        vertex[v] = static_cast<Index>(points.size());
        points.push_back(surface.points[v]);
      }
      v = vertex[v];
    }
    if (!surface.areas.empty())
      areas.push_back(surface.areas[f]);
    if (surface.components.number > 1)
      component.push_back(surface.components[f]);
  }
  surface.corners = std::move(corners);
  surface.points = std::move(points);
  surface.areas = std::move(areas);
  surface.components.labels = std::move(component);
  number_by_first_faces(surface.components);
  return vertex;
}

// Copies vertices so that each part has its own. `part_of_face` maps each face to its part.
template <class PartOfFace>
void separate_vertices(Surface& surface, const PartOfFace& part_of_face)
{
  start_at_smallest_vertices(surface); // so that copies get the same indices in soups and meshes
  std::vector<Index> part(surface.points.size(), null_index); // the part that keeps the vertex
  std::map<std::pair<Index, Index>, Index> copies;            // the copy for another part
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index& v : surface.corners[f]) {
      const Index p = part_of_face[f];
      if (part[v] == null_index)
        part[v] = p;
      if (part[v] == p)
        continue;
      const auto [copy, is_new] =
        copies.emplace(std::make_pair(v, p), static_cast<Index>(surface.points.size()));
      if (is_new)
        surface.points.push_back(Vector(surface.points[v]));
      v = copy->second;
    }
  start_at_smallest_vertices(surface);
}

// Gives each fan of faces around a vertex, which are neighbors one after the other, a vertex of its
// own, so that surfaces that meet at a point are apart however the point is numbered. Takes faces
// that start at their smallest vertices, and keeps them so.
inline void separate_fans(Surface& surface)
{
  const std::size_t number_of_points = surface.points.size();
  std::vector<char> is_done(surface.number_of_halfedges(), 0), is_taken(number_of_points, 0);
  for (Index h = 0; h < is_done.size(); ++h) {
    if (is_done[h])
      continue;
    Index v = surface.source_vertex(h);
    if (std::exchange(is_taken[v], char(1))) {
      surface.points.push_back(Vector(surface.points[v]));
      v = static_cast<Index>(surface.points.size() - 1);
    }
    const auto set_vertex = [&](Index g) {
      surface.corners[g / 3][g % 3] = v;
      is_done[g] = 1;
    };
    set_vertex(h);
    for (Index g = h; !surface.is_border(Surface::previous(g));) {
      g = surface.opposite[Surface::previous(g)];
      if (is_done[g])
        break;
      set_vertex(g);
    }
    for (Index g = h; !surface.is_border(g);) {
      g = Surface::next(surface.opposite[g]);
      if (is_done[g])
        break;
      set_vertex(g);
    }
  }
  if (surface.points.size() > number_of_points)
    start_at_smallest_vertices(surface);
}

// Separates the groups of faces: each gets its own vertices, and edges between groups become
// borders.
inline void separate_groups(Surface& surface)
{
  if (surface.groups.empty())
    return;
  separate_vertices(surface, surface.groups);
  for (Index h = 0; h < surface.opposite.size(); ++h)
    if (const Index o = surface.opposite[h]; surface.groups[h / 3] != surface.groups[o / 3]) {
      surface.opposite[h] = h;
      surface.opposite[o] = o;
    }
  separate_fans(surface);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_REORDER_FACES_H
