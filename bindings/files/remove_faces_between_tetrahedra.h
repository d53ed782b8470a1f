// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_REMOVE_FACES_BETWEEN_TETRAHEDRA_H
#define SEGMENT_MESH_MESH_FILE_REMOVE_FACES_BETWEEN_TETRAHEDRA_H

#include "Polygon_soup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace mesh_file {

// The triangles of a file, searched for tetrahedra with four of them as faces.
class Tetrahedron_search
{
  typedef std::array<Index, 3> Triangle;
  typedef std::pair<std::array<Index, 2>, Index> Edge_and_apex;

  const std::vector<Point>& points_;
  std::vector<Triangle> sorted_;      // the triangles, with ascending corners
  std::vector<Edge_and_apex> apexes_; // of the first edge of each triangle

  static Triangle ascending(Index a, Index b, Index c)
  {
    Triangle result = {a, b, c};
    std::sort(result.begin(), result.end());
    return result;
  }

  bool has_triangle(Index a, Index b, Index c) const
  { return std::binary_search(sorted_.begin(), sorted_.end(), ascending(a, b, c)); }

  // Returns the volume of a tetrahedron, times six and with a sign.
  double volume(const Triangle& t, Index apex) const
  {
    double d[3][3];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        d[i][k] = points_[t[i]][k] - points_[apex][k];
    return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
           d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  }

public:
  Tetrahedron_search(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : points_(points)
  {
    for (const Triangle& t : triangles)
      sorted_.push_back(ascending(t[0], t[1], t[2]));
    std::sort(sorted_.begin(), sorted_.end());
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
    for (const auto& [a, b, c] : sorted_) {
      apexes_.push_back({{a, b}, c});
      apexes_.push_back({{b, c}, a});
      apexes_.push_back({{a, c}, b});
    }
    std::sort(apexes_.begin(), apexes_.end());
  }

  // Returns on which sides of a triangle there are tetrahedra with this face.
  std::array<bool, 2> sides(const Triangle& triangle) const
  {
    const Triangle t = ascending(triangle[0], triangle[1], triangle[2]);
    std::array<bool, 2> result = {false, false};
    const Edge_and_apex first = {{t[0], t[1]}, 0};
    for (auto i = std::lower_bound(apexes_.begin(), apexes_.end(), first);
         i != apexes_.end() && i->first == first.first; ++i)
      if (const Index d = i->second; d != t[2] && has_triangle(t[1], t[2], d) &&
                                     has_triangle(t[0], t[2], d))
        if (const double v = volume(t, d); v != 0)
          result[v > 0] = true;
    return result;
  }
};

// Removes the triangles between two tetrahedra, with a warning, if nearly all triangles are faces
// of tetrahedra: a file of a volume mesh may have the faces of its cells, of which only those
// outside bound the shape. `polygon_of_triangle` has the polygon of each triangle. Returns whether
// triangles were removed.
inline bool remove_faces_between_tetrahedra(Polygon_soup& soup,
                                            std::vector<std::array<Index, 3> >& triangles,
                                            std::vector<Index>& polygon_of_triangle)
{
  constexpr std::size_t least_number = 100; // fewer can be faces of tetrahedra by chance
  std::vector<char> is_used(soup.points.size(), 0);
  std::size_t number_of_vertices = 0;
  for (const auto& t : triangles)
    for (Index v : t)
      number_of_vertices += !std::exchange(is_used[v], char(1));
  if (triangles.size() < least_number ||
      triangles.size() < 9 * number_of_vertices / 4) // most surfaces have two faces for a vertex
    return false;
  const Tetrahedron_search search(soup.points, triangles);
  std::vector<std::size_t> kept;
  std::size_t number_of_faces = 0; // of tetrahedra
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [is_behind, is_in_front] = search.sides(triangles[i]);
    number_of_faces += is_behind || is_in_front;
    if (!is_behind || !is_in_front)
      kept.push_back(i);
  }
  if (10 * number_of_faces < 9 * triangles.size() || kept.size() == triangles.size() ||
      kept.empty())
    return false;
  soup.warnings.push_back("the triangles are faces of tetrahedra; those between two of them are "
                          "left out: " + std::to_string(triangles.size() - kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    triangles[i] = triangles[kept[i]];
    polygon_of_triangle[i] = polygon_of_triangle[kept[i]];
  }
  triangles.resize(kept.size());
  polygon_of_triangle.resize(kept.size());
  return true;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_REMOVE_FACES_BETWEEN_TETRAHEDRA_H
