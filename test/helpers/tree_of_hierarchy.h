// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TREE_OF_HIERARCHY_H
#define TREE_OF_HIERARCHY_H

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <cstddef>
#include <map>
#include <vector>

// Returns the tree of the cuts of a hierarchy, without the decisions of the search on leaves. The
// leaves are numbered by their nodes.
inline CGAL::Spectral_segmentation::internal::Merge_tree
tree_of(const CGAL::Spectral_segmentation::internal::Cut_hierarchy& hierarchy)
{
  using CGAL::Spectral_segmentation::internal::Index;
  CGAL::Spectral_segmentation::internal::Merge_tree result;
  std::map<std::size_t, Index> leaf_in; // a leaf in each node
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i)
    if (hierarchy.nodes[i].is_leaf()) {
      leaf_in[i] = Index(result.leaves.size());
      result.leaves.emplace_back();
      result.leaves.back().area = hierarchy.nodes[i].area;
    }
  for (Index node : hierarchy.leaf)
    result.leaf.push_back(leaf_in.at(node));
  for (auto i = hierarchy.cut_order.rbegin(); i != hierarchy.cut_order.rend(); ++i) {
    const auto& n = hierarchy.nodes[*i];
    if (n.is_leaf())
      continue;
    const Index a = leaf_in.at(n.children[0]), b = leaf_in.at(n.children[1]);
    result.merges.push_back({{a, b}, n.salience, n.factors});
    leaf_in[*i] = a;
  }
  return result;
}

// Returns a hierarchy whose nodes are the components of a surface.
inline CGAL::Spectral_segmentation::internal::Cut_hierarchy
uncut_hierarchy(const CGAL::Spectral_segmentation::internal::Surface& surface)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  return internal::hierarchy_of(internal::uncut_tree(surface, internal::Cut_state::NOT_SEARCHED));
}

#endif // TREE_OF_HIERARCHY_H
