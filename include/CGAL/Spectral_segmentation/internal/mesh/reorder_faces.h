// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_REORDER_FACES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_REORDER_FACES_H

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/utility/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Sorts three faces without branches, which nobody could predict.
inline Neighbors ascending(Neighbors faces)
{
  for (int i : {0, 1, 0})
    std::tie(faces[i], faces[i + 1]) = std::minmax({faces[i], faces[i + 1]});
  return faces;
}

// Returns the faces in an order in which faces near on the surface are near in memory. The order
// consists of blocks, each found by a breadth-first search that begins at a face next to an earlier
// block, or at the first face that is left. It does not depend on the data structure.
inline std::vector<Index> locality_order(const std::vector<Neighbors>& neighbors)
{
  constexpr std::size_t size_of_block = 1024; // any size of which the cache holds several
  std::vector<Index> order, outside; // outside: faces next to the blocks so far
  order.reserve(neighbors.size());
  std::vector<char> is_in_order(neighbors.size(), 0);
  const auto add = [&](Index f, std::size_t end_of_block) {
    if (is_in_order[f])
      return;
    if (order.size() == end_of_block) {
      outside.push_back(f);
      return;
    }
    is_in_order[f] = 1;
    order.push_back(f);
    prefetch(&neighbors[f]);
  };
  for (Index first = 0; first < neighbors.size(); ++first)
    for (outside.push_back(first); !outside.empty();) {
      const Index seed = outside.back();
      outside.pop_back();
      std::size_t next = order.size();
      const std::size_t end_of_block = next + size_of_block;
      for (add(seed, end_of_block); next < order.size(); ++next)
        for (Index f : ascending(neighbors[order[next]]))
          add(f, end_of_block);
    }
  return order;
}

// Numbers the vertices in the order in which faces use them, so that the vertices of faces near in
// order are near in memory. Removes vertices without a face.
inline void number_vertices_by_faces(Triangles& triangles)
{
  std::vector<Vector> points;
  points.reserve(triangles.points.size());
  std::vector<Index> number(triangles.points.size(), null_index);
  for (Corners& corners : triangles.corners)
    for (Index& v : corners) {
      if (number[v] == null_index) {
        number[v] = static_cast<Index>(points.size());
        points.push_back(triangles.points[v]);
      }
      v = number[v];
    }
  triangles.points = std::move(points);
}

// Returns the triangles with their faces in an order, renumbered, and vertices numbered by faces.
inline Triangles in_order(Triangles triangles, const std::vector<Index>& order)
{
  std::vector<Index> number(order.size());
  for (Index i = 0; i < order.size(); ++i)
    number[order[i]] = i;
  std::vector<Corners> corners;
  std::vector<Neighbors> neighbors;
  corners.reserve(order.size());
  neighbors.reserve(order.size());
  for (Index f : order) {
    corners.push_back(triangles.corners[f]);
    const Neighbors& across = triangles.neighbors[f];
    neighbors.push_back({number[across[0]], number[across[1]], number[across[2]]});
  }
  triangles.corners = std::move(corners);
  triangles.neighbors = std::move(neighbors);
  number_vertices_by_faces(triangles);
  return triangles;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_REORDER_FACES_H
