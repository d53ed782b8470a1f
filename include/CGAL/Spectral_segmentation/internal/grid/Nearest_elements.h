// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_NEAREST_ELEMENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_NEAREST_ELEMENTS_H

#include <CGAL/Spectral_segmentation/internal/grid/Grid.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Finds the nearest of some elements for each node of a grid. Elements are offered to nodes near
// them. A node that takes an element offers it to its neighbors; a predicate of a node and a
// squared distance says whether a node may take one (a closest point transform by propagation,
// Danielsson 1980).
template <class SquaredDistance, class Reaches>
class Nearest_elements
{
  const Grid& grid_;
  const SquaredDistance squared_distance_of_; // between an element and a point
  const Reaches reaches_;
  std::vector<Index> element_;         // one per node
  std::vector<float> squared_distance_;
  std::vector<Index> improved_;        // the nodes that took an element

public:
  Nearest_elements(const Grid& grid, const SquaredDistance& squared_distance,
                   const Reaches& reaches)
    : grid_(grid), squared_distance_of_(squared_distance), reaches_(reaches),
      element_(grid.number_of_nodes(), null_index),
      squared_distance_(grid.number_of_nodes(), (std::numeric_limits<float>::max)()) {}

  void offer(Index node, Index element)
  {
    const float d = static_cast<float>(squared_distance_of_(element, grid_.point(node)));
    if (d < squared_distance_[node] && reaches_(node, d)) {
      squared_distance_[node] = d;
      element_[node] = element;
      improved_.push_back(node);
    }
  }

  void propagate()
  {
    for (std::vector<Index> nodes; !improved_.empty();) {
      nodes.clear();
      nodes.swap(improved_);
      for (Index node : nodes) {
        const Index element = element_[node];
        grid_.for_each_neighbor(node, [&](Index neighbor) {
          if (element_[neighbor] != element)
            offer(neighbor, element);
        });
      }
    }
  }

  Index element(Index node) const { return element_[node]; } // null_index if none is near
  float squared_distance(Index node) const { return squared_distance_[node]; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_NEAREST_ELEMENTS_H
