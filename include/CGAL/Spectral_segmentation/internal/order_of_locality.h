// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ORDER_OF_LOCALITY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ORDER_OF_LOCALITY_H

#include <CGAL/Spectral_segmentation/internal/Triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The faces in an order in which what is near on the surface is near in memory: blocks, each found
// by a breadth-first search that begins at a face next to an earlier block, or at the first face
// that is left. It does not depend on the data structure.
inline std::vector<Index> order_of_locality(const std::vector<Neighbors>& neighbors)
{
  constexpr std::size_t size_of_block = 1024; // any that fits into the cache together with others
  std::vector<Index> order, outside; // of the blocks so far, but next to them
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
  };
  for (Index first = 0; first < neighbors.size(); ++first)
    for (outside.push_back(first); !outside.empty();) {
      const Index seed = outside.back();
      outside.pop_back();
      std::size_t next = order.size();
      const std::size_t end_of_block = next + size_of_block;
      for (add(seed, end_of_block); next < order.size(); ++next) {
        Neighbors ascending = neighbors[order[next]];
        std::sort(ascending.begin(), ascending.end());
        for (Index f : ascending)
          add(f, end_of_block);
      }
    }
  return order;
}

// The same triangles with their faces in an order, and numbered so. Vertices are numbered as faces
// come to them, so that those of faces near in order are near in memory; those without a face go.
inline Triangles in_order(const Triangles& triangles, const std::vector<Index>& order)
{
  std::vector<Index> new_face(order.size()), new_vertex(triangles.points.size(), null_index);
  for (Index i = 0; i < order.size(); ++i)
    new_face[order[i]] = i;
  Triangles result;
  result.unit = triangles.unit;
  result.corners.reserve(order.size());
  result.neighbors.reserve(order.size());
  result.points.reserve(triangles.points.size());
  for (Index f : order) {
    std::array<Index, 3> corners = triangles.corners[f];
    for (Index& v : corners) {
      if (new_vertex[v] == null_index) {
        new_vertex[v] = static_cast<Index>(result.points.size());
        result.points.push_back(triangles.points[v]);
      }
      v = new_vertex[v];
    }
    result.corners.push_back(corners);
    const Neighbors& n = triangles.neighbors[f];
    result.neighbors.push_back({new_face[n[0]], new_face[n[1]], new_face[n[2]]});
  }
  return result;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ORDER_OF_LOCALITY_H
