// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_MERGE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_MERGE_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A merge of two sets of leaves. Each set is given by one of its leaves.
struct Merge
{
  Index leaves[2];
  double salience;          // of the boundary that vanishes
  Salience_factors factors; // of this boundary
};

// Returns the hierarchy whose cuts are the merges in reverse. Takes the leaf of each face, the area
// of each leaf, and the merges, the least salient first. Sets that are not merged are the roots.
inline Cut_hierarchy hierarchy_of_merges(const std::vector<Index>& leaf,
                                         const std::vector<double>& area_of_leaf,
                                         const std::vector<Merge>& merges)
{
  struct Join
  {
    Index sets[2]; // of smaller area first
    double areas[2];
  };
  std::vector<Join> joins;
  joins.reserve(merges.size());
  std::vector<double> area = area_of_leaf; // of the set that each representative stands for
  Face_components sets(area.size());
  for (Index i = 0; i < area.size(); ++i)
    sets.add(i);
  for (const Merge& m : merges) {
    Index a = sets.representative(m.leaves[0]), b = sets.representative(m.leaves[1]);
    CGAL_precondition(a != b);
    if (quantized(area[a]) > quantized(area[b]))
      std::swap(a, b);
    joins.push_back({{a, b}, {(std::min)(area[a], area[b]), (std::max)(area[a], area[b])}});
    sets.join(a, b);
    area[sets.representative(a)] = joins.back().areas[0] + joins.back().areas[1];
  }

  Cut_hierarchy result;
  result.is_monotonic = true;
  std::vector<std::size_t> node(area.size(), null_node); // of the set of each representative
  for (Index l : leaf) {
    const Index set = sets.representative(l);
    if (node[set] == null_node) {
      node[set] = result.nodes.size();
      result.nodes.emplace_back();
      result.nodes.back().area = area[set];
    }
  }
  result.number_of_roots = result.nodes.size();
  for (std::size_t i = joins.size(); i-- > 0;) {
    const auto& [a, b] = joins[i].sets; // one of them represented both from here on
    const std::size_t parent = node[a] != null_node ? node[a] : node[b];
    result.cut(parent, joins[i].areas[0], joins[i].areas[1]);
    Cut_node& n = result.nodes[parent];
    n.cut_state = Cut_state::CUT;
    n.salience = merges[i].salience;
    n.factors = merges[i].factors;
    result.cut_order.push_back(parent);
    node[a] = n.children[0];
    node[b] = n.children[1];
  }
  for (Cut_node& n : result.nodes)
    if (n.is_leaf())
      n.cut_state = Cut_state::NO_CUT;
  result.leaf.reserve(leaf.size());
  for (Index l : leaf)
    result.leaf.push_back(static_cast<Index>(node[l]));
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_MERGE_H
