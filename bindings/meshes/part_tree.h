// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PART_TREE_H
#define SEGMENT_MESH_PART_TREE_H

#include "../files/Segmented_soup.h"

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace segment_mesh {

using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using mesh_file::Index;

// Returns the median of the labels of the faces of a leaf: that of most faces, because only
// smoothing of boundaries moves faces between leaves.
inline Index label_of_leaf(const Segmentation_hierarchy& tree, std::size_t leaf,
                           const std::vector<Index>& labels)
{
  std::vector<Index> labels_of_faces;
  for (std::size_t f : tree.faces(leaf))
    labels_of_faces.push_back(labels[f]);
  const auto middle =
    labels_of_faces.begin() + static_cast<std::ptrdiff_t>(labels_of_faces.size() / 2);
  std::nth_element(labels_of_faces.begin(), middle, labels_of_faces.end());
  return *middle;
}

// Returns the tree of cuts between the labels of a run, each part before its own parts. A part has
// the number of its node in the hierarchy. Returns nothing if some segment is no node.
inline std::vector<mesh_file::Part> part_tree(const Segmentation_hierarchy& tree,
                                              const std::vector<Index>& labels,
                                              std::size_t number_of_segments)
{
  using mesh_file::null_index;
  std::vector<Index> segment(tree.number_of_nodes()); // one per node; null_index if it has many
  for (std::size_t i = tree.number_of_nodes(); i-- > 0;) { // parents come before their children
    const auto& children = tree.node(i).children;
    if (tree.node(i).is_leaf())
      segment[i] = label_of_leaf(tree, i, labels);
    else
      segment[i] = segment[children[0]] == segment[children[1]] ? segment[children[0]] : null_index;
  }

  std::vector<std::pair<std::size_t, Index> > stack; // nodes with the places of their parents
  for (std::size_t i = tree.number_of_roots(); i-- > 0;)
    stack.emplace_back(i, null_index);
  std::vector<mesh_file::Part> parts;
  std::vector<char> is_found(number_of_segments, 0);
  std::size_t number_found = 0;
  while (!stack.empty()) {
    const auto [node, parent] = stack.back();
    stack.pop_back();
    const Index place = static_cast<Index>(parts.size());
    parts.push_back({parent, segment[node], static_cast<Index>(node)});
    if (segment[node] == null_index) {
      const auto& children = tree.node(node).children;
      stack.emplace_back(children[1], place);
      stack.emplace_back(children[0], place);
    }
    else if (is_found[segment[node]]++)
      return {};
    else
      ++number_found;
  }
  return number_found == number_of_segments ? parts : std::vector<mesh_file::Part>();
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PART_TREE_H
