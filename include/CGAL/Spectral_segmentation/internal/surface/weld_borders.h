// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_WELD_BORDERS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_WELD_BORDERS_H

#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>
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
}

// Finds duplicate faces, which have the same three points in any order, by a hash table. A face
// with coincident points is not a duplicate. A random key guards the hash against points that were
// chosen to collide; the result does not depend on it.
class Duplicate_faces
{
  const Surface& surface_;
  std::vector<std::uint64_t> hash_; // one per vertex

  const std::uint64_t key_ = std::uint64_t(std::random_device()()) << 32 | std::random_device()();

  std::uint64_t hash(const Vector& p) const
  {
    std::uint64_t h = key_;
    for (int i = 0; i < 3; ++i) {
      const double coordinate = p[i] + 0.; // no negative zero
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof bits);
      h = (h ^ bits) * 0x9e3779b97f4a7c15;
      h ^= h >> 29;
    }
    return h;
  }

  std::array<Vector, 3> sorted_points(Index f) const
  {
    const Corners& c = surface_.corners[f];
    std::array<Vector, 3> result = {surface_.points[c[0]], surface_.points[c[1]],
                                    surface_.points[c[2]]};
    std::sort(result.begin(), result.end(), [](const Vector& p, const Vector& q)
      { return std::make_tuple(p.x(), p.y(), p.z()) < std::make_tuple(q.x(), q.y(), q.z()); });
    return result;
  }

public:
  explicit Duplicate_faces(const Surface& surface) : surface_(surface)
  {
    hash_.reserve(surface.points.size());
    for (const Vector& p : surface.points)
      hash_.push_back(hash(p));
  }

  // Returns the first face with the same points for each face, which may be the face itself.
  std::vector<Index> operator()() const
  {
    const std::size_t n = surface_.corners.size();
    std::size_t size = 1;
    while (size < 2 * n)
      size *= 2;
    std::vector<Index> table(size, null_index), result;
    result.reserve(n);
    const auto face_hash = [&](Index f) {
      const Corners& c = surface_.corners[f];
      const std::uint64_t h = (hash_[c[0]] + hash_[c[1]] + hash_[c[2]]) * 0xbf58476d1ce4e5b9;
      return static_cast<std::size_t>(h ^ (h >> 31));
    };
    for (Index f = 0; f < n; ++f) {
      const std::array<Vector, 3> points = sorted_points(f);
      if (points[0] == points[1] || points[1] == points[2]) {
        result.push_back(f);
        continue;
      }
      std::size_t slot = face_hash(f) & (size - 1);
      while (table[slot] != null_index && !(sorted_points(table[slot]) == points))
        slot = (slot + 1) & (size - 1);
      if (table[slot] == null_index)
        table[slot] = f;
      result.push_back(table[slot]);
    }
    return result;
  }
};

// Returns the faces that `first_duplicate` maps to themselves, connected as a soup whose coincident
// points of one group are merged. This can connect faces that duplicate faces had separated.
inline Surface distinct_faces(const Surface& surface, const std::vector<Index>& first_duplicate)
{
  Surface result;
  result.points = surface.points;
  const std::vector<Index> group = groups_of_vertices(surface);
  const auto coordinates = [&](Index v) {
    const Vector& p = surface.points[v];
    return std::make_tuple(p.x(), p.y(), p.z(), group[v]);
  };
  std::vector<Index> order(surface.points.size()), number(order.size());
  for (Index v = 0; v < order.size(); ++v)
    order[v] = v;
  std::sort(order.begin(), order.end(), [&](Index v, Index w)
    { return std::make_pair(coordinates(v), v) < std::make_pair(coordinates(w), w); });
  for (std::size_t i = 0; i < order.size(); ++i)
    number[order[i]] = i > 0 && coordinates(order[i - 1]) == coordinates(order[i])
      ? number[order[i - 1]] : order[i];
  for (Index f = 0; f < first_duplicate.size(); ++f)
    if (first_duplicate[f] == f) {
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
  Face_components sets(surface.points.size()); // sets of vertices
  for (Index v = 0; v < surface.points.size(); ++v) {
    sets.add(v);
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_WELD_BORDERS_H
