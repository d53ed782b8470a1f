// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WALL_LABELS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WALL_LABELS_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes the faces of walls in each node of a hierarchy connected, from the roots on. Pieces that
// come off a side of a cut go to the other side.
class Wall_labels
{
  typedef std::vector<Index> Faces;

  const Surface& walls_;           // each component is a wall
  const Cut_hierarchy& cuts_;      // of the outer walls
  const Nested_ranges leaves_;     // of each node
  Faces& leaf_;                    // one per face
  std::vector<std::size_t> node_;  // one per face: a child of the current node
  std::vector<std::pair<std::size_t, Faces> > connected_; // faces to divide further, and their node

  // Returns the connected pieces of the faces of a node.
  std::vector<Faces> pieces(const Faces& faces, std::size_t node)
  {
    std::vector<Faces> result;
    for (Index first : faces)
      if (node_[first] == node) {
        Faces piece(1, first);
        node_[first] = null_node;
        for (std::size_t i = 0; i < piece.size(); ++i)
          for (Index h = 3 * piece[i]; h < 3 * piece[i] + 3; ++h)
            if (const Index g = walls_.neighbor(h); node_[g] == node) {
              node_[g] = null_node;
              piece.push_back(g);
            }
        result.push_back(std::move(piece));
      }
    for (const Faces& piece : result)
      for (Index f : piece)
        node_[f] = node;
    return result;
  }

  double area(const Faces& faces) const
  {
    double result = 0;
    for (Index f : faces)
      result += walls_.areas[f];
    return quantized(result);
  }

  // Moves a piece to the face of another node beside which it has the longest boundary.
  void move(const Faces& piece)
  {
    const std::size_t node = node_[piece.front()];
    std::map<Index, std::pair<double, Index> > boundary; // its length, and a face, for each leaf
    for (Index f : piece)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (const Index g = walls_.neighbor(h); node_[g] != node && node_[g] != null_node) {
          boundary[leaf_[g]].first += walls_.length(h);
          boundary[leaf_[g]].second = g;
        }
    const Index g =
      std::max_element(boundary.begin(), boundary.end(), [](const auto& a, const auto& b)
        { return quantized(a.second.first) < quantized(b.second.first); })->second.second;
    for (Index f : piece) {
      node_[f] = node_[g];
      leaf_[f] = leaf_[g];
    }
  }

  // Divides connected faces among nodes. Moves all pieces of a node, but for the largest.
  void divide(const Faces& faces, const std::vector<std::size_t>& nodes)
  {
    for (std::size_t node : nodes)
      for (Index f : faces)
        if (leaves_.first(leaf_[f]) - leaves_.first(node) < leaves_.size(node))
          node_[f] = node;
    for (std::size_t node : nodes) {
      const std::vector<Faces> all = pieces(faces, node);
      const auto largest = std::max_element(all.begin(), all.end(),
        [&](const Faces& a, const Faces& b) { return area(a) < area(b); });
      for (auto piece = all.begin(); piece != all.end(); ++piece)
        if (piece != largest)
          move(*piece);
    }
    for (std::size_t node : nodes)
      if (std::vector<Faces> all = pieces(faces, node); !all.empty())
        connected_.emplace_back(node, std::move(all.front()));
    for (Index f : faces)
      node_[f] = null_node;
  }

public:
  // Takes the leaf of the nearest face of an outer wall for each face, which it changes.
  Wall_labels(const Surface& walls, const Cut_hierarchy& cuts, std::vector<Index>& leaf)
    : walls_(walls), cuts_(cuts), leaves_(ranges_of_leaves(cuts)), leaf_(leaf),
      node_(leaf.size(), null_node) {}

  void operator()()
  {
    std::vector<Faces> walls(walls_.components.number);
    for (Index f = 0; f < leaf_.size(); ++f)
      walls[walls_.components[f]].push_back(f);
    std::vector<std::size_t> roots(cuts_.number_of_roots);
    std::iota(roots.begin(), roots.end(), std::size_t(0));
    for (const Faces& wall : walls)
      divide(wall, roots);
    while (!connected_.empty()) {
      const auto [node, faces] = std::move(connected_.back());
      connected_.pop_back();
      if (!cuts_.nodes[node].is_leaf())
        divide(faces, {cuts_.nodes[node].children[0], cuts_.nodes[node].children[1]});
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WALL_LABELS_H
