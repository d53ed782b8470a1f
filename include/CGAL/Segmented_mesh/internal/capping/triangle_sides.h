// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_SIDES_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_SIDES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// A side of a triangle, from its smaller to its larger vertex.
struct Triangle_side
{
  std::pair<Index, Index> vertices;
  bool is_forward;               // whether the triangle runs along it from first to second
  std::array<Index, 2> corners;  // the triangle's corners at its vertices, from 0 to 3 n - 1

  Index triangle() const { return corners[0] / 3; }
  Index apex() const { return 3 - corners[0] % 3 - corners[1] % 3; } // the opposite corner

  bool operator<(const Triangle_side& s) const
  { return std::tie(vertices, corners) < std::tie(s.vertices, s.corners); }
};

// Returns the sides sorted by edge, and the sides at an edge in the order of the triangles.
inline std::vector<Triangle_side> sorted_sides(const std::vector<Corners>& triangles)
{
  std::vector<Triangle_side> result;
  result.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      Index v = triangles[t][i], w = triangles[t][j];
      Index a = static_cast<Index>(3 * t + i), b = static_cast<Index>(3 * t + j);
      const bool is_forward = v < w;
      if (!is_forward) {
        std::swap(v, w);
        std::swap(a, b);
      }
      result.push_back({{v, w}, is_forward, {{a, b}}});
    }
  std::sort(result.begin(), result.end());
  return result;
}

// Calls f with the index of the first side and the number of sides at each edge.
template <class Function>
void for_each_edge(const std::vector<Triangle_side>& sides, const Function& f)
{
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].vertices == sides[begin].vertices)
      ++end;
    f(begin, end - begin);
  }
}

// Returns whether two sides of triangles pass an edge in opposite directions.
inline bool are_opposite(const Triangle_side& s, const Triangle_side& t)
{ return s.is_forward != t.is_forward && s.vertices.first != s.vertices.second; }

// Returns whether each edge has two triangles that pass it in opposite directions.
inline bool is_closed(const std::vector<Triangle_side>& sides)
{
  bool result = true;
  for_each_edge(sides, [&](std::size_t i, std::size_t n)
    { result = result && n == 2 && are_opposite(sides[i], sides[i + 1]); });
  return result;
}

// Returns whether triangles form an oriented manifold, with or without a border. Then an edge has
// at most two triangles, and there are as many fans (sets of corners that edges connect) as
// vertices.
inline bool is_manifold(const std::vector<Corners>& triangles,
                        const std::vector<Triangle_side>& sides)
{
  const std::size_t n = sides.size();
  Disjoint_sets fans(n); // sets of corners
  bool has_manifold_edges = true;
  for_each_edge(sides, [&](std::size_t i, std::size_t number) {
    if (number == 2 && are_opposite(sides[i], sides[i + 1]))
      for (int k : {0, 1})
        fans.join(sides[i].corners[k], sides[i + 1].corners[k]);
    else if (number > 1 || sides[i].vertices.first == sides[i].vertices.second)
      has_manifold_edges = false;
  });
  if (!has_manifold_edges)
    return false;
  std::vector<Index> vertices;
  for (const Corners& t : triangles)
    vertices.insert(vertices.end(), t.begin(), t.end());
  std::sort(vertices.begin(), vertices.end());
  const auto end = std::unique(vertices.begin(), vertices.end());
  return fans.number() == static_cast<std::size_t>(end - vertices.begin());
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_SIDES_H
