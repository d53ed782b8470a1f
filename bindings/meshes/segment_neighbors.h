// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_SEGMENT_NEIGHBORS_H
#define SEGMENT_MESH_SEGMENT_NEIGHBORS_H

#include "read_input.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace segment_mesh {

// Returns, for each segment, the segments that it touches. Some may be missing that touch it only
// beside a third one.
inline std::vector<std::vector<std::size_t> >
segment_neighbors(const Input& input, const std::vector<Index>& segment_of_triangle,
                  std::size_t number_of_segments)
{
  std::vector<std::vector<std::size_t> > neighbors(number_of_segments);
  std::vector<Index> first_segment(input.soup.points.size(), mesh_file::null_index); // at a point
  for (std::size_t t = 0; t < input.triangles.size(); ++t)
    for (Index v : input.triangles[t]) {
      const Index b = segment_of_triangle[t];
      if (first_segment[v] == mesh_file::null_index)
        first_segment[v] = b;
      const Index a = first_segment[v];
      if (a != b) {
        neighbors[a].push_back(b);
        neighbors[b].push_back(a);
      }
    }
  for (std::vector<std::size_t>& list : neighbors) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbors;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_SEGMENT_NEIGHBORS_H
