// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_PACKED_GRAPH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_PACKED_GRAPH_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// An immutable directed graph that keeps the arcs that leave a node side by side. BGL's
// compressed_sparse_row_graph takes four times the memory for an arc, and a second to compile.
struct Packed_graph
{
  typedef std::pair<Index, Index> Ends; // the source and the target of an arc

  std::vector<Index> first_arc; // one per node, then the number of arcs
  std::vector<Index> targets;   // one per arc

  // Packs the arcs; the arcs of a node keep their order. `place` becomes the index of each arc.
  Packed_graph(std::size_t number_of_nodes, const std::vector<Ends>& arcs,
               std::vector<Index>& place)
    : first_arc(number_of_nodes + 1, 0), targets(arcs.size())
  {
    place.resize(arcs.size());
    for (const Ends& ends : arcs)
      ++first_arc[ends.first + 1];
    std::partial_sum(first_arc.begin(), first_arc.end(), first_arc.begin());
    std::vector<Index> next = first_arc;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      place[i] = next[arcs[i].first]++;
      targets[place[i]] = arcs[i].second;
    }
  }

  Index number_of_nodes() const { return static_cast<Index>(first_arc.size() - 1); }
  Index number_of_arcs() const { return static_cast<Index>(targets.size()); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_PACKED_GRAPH_H
