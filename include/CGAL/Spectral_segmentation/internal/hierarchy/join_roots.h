// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_JOIN_ROOTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_JOIN_ROOTS_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/grid/component_distances.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the same hierarchy below a single root. Components are cut from each other first, the
// farthest gap before the others, with an infinite salience, so that they come apart at every
// threshold.
inline Cut_hierarchy join_roots(Cut_hierarchy cuts, const Surface& mesh)
{
  const std::size_t roots = cuts.number_of_roots;
  if (roots < 2)
    return cuts;
  std::vector<std::size_t> root(cuts.nodes.size()); // the root of each node
  std::iota(root.begin(), root.begin() + static_cast<std::ptrdiff_t>(roots), std::size_t(0));
  for (std::size_t i = roots; i < root.size(); ++i)
    root[i] = root[cuts.nodes[i].parent];
  std::vector<Index> root_of_face;
  for (Index leaf : cuts.leaf)
    root_of_face.push_back(static_cast<Index>(root[leaf]));
  const auto gaps = nearest_sets_of_faces(mesh, root_of_face, roots);

  // The joins of sets of roots, each of which is known by one of its roots.
  struct Join
  {
    std::size_t roots[2];
    double area[2];
  };
  std::vector<Join> joins;
  Face_components sets(roots);
  std::vector<double> area(roots);
  for (Index i = 0; i < roots; ++i) {
    sets.add(i);
    area[i] = cuts.nodes[i].area;
  }
  for (const auto& [a, b] : gaps) {
    Index first = sets.representative(a), second = sets.representative(b);
    if (area[first] > area[second])
      std::swap(first, second);
    joins.push_back({{first, second}, {area[first], area[second]}});
    sets.join(first, second);
    area[sets.representative(first)] = joins.back().area[0] + joins.back().area[1];
  }

  Cut_hierarchy result;
  result.number_of_roots = 1;
  result.is_monotonic = cuts.is_monotonic;
  result.has_all_cuts = cuts.has_all_cuts;
  result.nodes.resize(1);
  std::vector<std::size_t> node(roots, null_node); // the node of the set that a root stands for
  node[sets.representative(0)] = 0;
  result.nodes[0].area = area[sets.representative(0)];
  for (std::size_t i = joins.size(); i-- > 0;) {
    const Join& join = joins[i];
    // The set was known by one of the two roots from here on.
    const std::size_t parent =
      node[join.roots[0]] != null_node ? node[join.roots[0]] : node[join.roots[1]];
    result.cut(parent, join.area[0], join.area[1]);
    Cut_node& n = result.nodes[parent];
    n.cut_state = Cut_state::CUT;
    n.salience = std::numeric_limits<double>::infinity();
    result.cut_order.push_back(parent);
    for (int k = 0; k < 2; ++k)
      node[join.roots[k]] = n.children[k];
  }
  const std::size_t shift = result.nodes.size() - roots;
  const auto number = [&](std::size_t i)
  { return i == null_node ? null_node : i < roots ? node[i] : i + shift; };
  for (std::size_t i = 0; i < cuts.nodes.size(); ++i) {
    Cut_node n = cuts.nodes[i];
    n.parent = i < roots ? result.nodes[number(i)].parent : number(n.parent);
    for (std::size_t& child : n.children)
      child = number(child);
    if (i < roots)
      result.nodes[number(i)] = n;
    else
      result.nodes.push_back(n);
  }
  for (std::size_t turn : cuts.cut_order)
    result.cut_order.push_back(number(turn));
  for (Index leaf : cuts.leaf)
    result.leaf.push_back(static_cast<Index>(number(leaf)));
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_JOIN_ROOTS_H
