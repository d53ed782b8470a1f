// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPLETE_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPLETE_HIERARCHY_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

inline void require_in_file(bool is_right, const char* error)
{
  if (!is_right)
    throw std::runtime_error(std::string("read_hierarchy: ") + error);
}

// Sets the parents of the nodes of a hierarchy that was read. Checks all that the functions of a
// hierarchy rely on, and throws `std::runtime_error`.
inline void complete_hierarchy(Cut_hierarchy& cuts)
{
  std::vector<Cut_node>& nodes = cuts.nodes;
  const std::size_t n = nodes.size();
  require_in_file(cuts.number_of_roots <= n, "there are more roots than nodes");
  for (std::size_t i = 0; i < n; ++i) {
    const Cut_node& node = nodes[i];
    require_in_file(node.area >= 0, "an area is negative or not a number");
    require_in_file(!std::isnan(node.salience), "a salience is not a number");
    require_in_file((node.cut_state == Cut_state::CUT) != node.is_leaf(),
                    "a node has children if and only if it is cut");
    if (node.is_leaf())
      continue;
    for (std::size_t child : node.children) {
      require_in_file(child >= cuts.number_of_roots && child < n &&
                        nodes[child].parent == null_node,
                      "a node is the child of two nodes, a root, or does not exist");
      nodes[child].parent = i;
    }
    require_in_file(nodes[node.children[0]].area <= nodes[node.children[1]].area,
                    "the first of two children is the larger");
  }
  require_in_file(parents_first(cuts).size() == n, "a node is not below a root");

  std::vector<char> is_ordered(n, 0), has_faces(n, 0);
  for (std::size_t i : cuts.cut_order) {
    require_in_file(i < n && !is_ordered[i] &&
                      (nodes[i].parent == null_node || is_ordered[nodes[i].parent]),
                    "a node comes twice, or before its parent, in the order of cuts");
    is_ordered[i] = 1;
  }
  require_in_file(cuts.leaf.size() < null_index / 3, "there are too many faces");
  for (Index leaf : cuts.leaf) {
    require_in_file(leaf < n && nodes[leaf].is_leaf(), "a face is in no leaf");
    has_faces[leaf] = 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    require_in_file(nodes[i].is_leaf() || is_ordered[i], "a cut is missing in the order of cuts");
    require_in_file(!nodes[i].is_leaf() || has_faces[i], "a leaf has no face");
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPLETE_HIERARCHY_H
