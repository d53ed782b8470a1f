// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_DENDROGRAM_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_DENDROGRAM_H

#include <CGAL/Spectral_segmentation/internal/search/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A merge of two sets of leaves. Each set is given by one of its leaves.
struct Merge
{
  Index leaves[2];
  double salience;          // the salience of the boundary that vanishes
  Salience_factors factors; // its factors
};

// Regions of faces, and how they are merged. In reverse, the merges are the cuts of a hierarchy.
struct Dendrogram
{
  std::vector<Index> leaf;    // one per face
  std::vector<double> areas;  // one per leaf
  std::vector<Merge> merges;  // the least salient first
  bool has_all_cuts = true;
};

// Orders the merges by their saliences. Merges of equal salience keep their order.
inline void sort_merges(std::vector<Merge>& merges)
{
  std::stable_sort(merges.begin(), merges.end(), [](const Merge& a, const Merge& b)
    { return a.salience < b.salience; });
}

// Returns the cuts of a hierarchy as merges, the last cut first. The leaves of the result are the
// positions of the hierarchy's leaves in `leaves`.
inline Dendrogram dendrogram_of(const Cut_hierarchy& cuts, const Nested_ranges& leaves)
{
  const auto place = [&](std::size_t node) { return static_cast<Index>(leaves.first(node)); };
  Dendrogram result;
  result.has_all_cuts = cuts.has_all_cuts;
  for (Index node : cuts.leaf)
    result.leaf.push_back(place(node));
  result.areas.resize(leaves.size());
  for (std::size_t i = 0; i < cuts.nodes.size(); ++i)
    if (cuts.nodes[i].is_leaf())
      result.areas[place(i)] = cuts.nodes[i].area;
  for (auto i = cuts.cut_order.rbegin(); i != cuts.cut_order.rend(); ++i) {
    const Cut_node& n = cuts.nodes[*i];
    if (!n.is_leaf())
      result.merges.push_back({{place(n.children[0]), place(n.children[1])}, n.salience,
                               n.factors});
  }
  return result;
}

// Appends the merges of a hierarchy of some faces, which are given by their indices in the mesh of
// a dendrogram.
inline void append(Dendrogram& all, const Cut_hierarchy& cuts, const std::vector<Index>& faces)
{
  const Dendrogram d = dendrogram_of(cuts, ranges_of_leaves(cuts));
  const Index first = static_cast<Index>(all.areas.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    all.leaf[faces[i]] = first + d.leaf[i];
  all.areas.insert(all.areas.end(), d.areas.begin(), d.areas.end());
  for (const Merge& m : d.merges)
    all.merges.push_back({{first + m.leaves[0], first + m.leaves[1]}, m.salience, m.factors});
  all.has_all_cuts = all.has_all_cuts && d.has_all_cuts;
}

// Returns the hierarchy of a dendrogram. Sets that are not merged are the roots.
inline Cut_hierarchy hierarchy_of(const Dendrogram& d)
{
  struct Join
  {
    Index sets[2]; // the smaller area first
    double areas[2];
  };
  std::vector<Join> joins;
  joins.reserve(d.merges.size());
  std::vector<double> area = d.areas; // the area of the set of each representative
  Face_components sets(area.size());
  for (Index i = 0; i < area.size(); ++i)
    sets.add(i);
  for (const Merge& m : d.merges) {
    Index a = sets.representative(m.leaves[0]), b = sets.representative(m.leaves[1]);
    CGAL_precondition(a != b);
    if (area[a] > (1 + 1e-9) * area[b]) // areas that are equal up to noise do not decide
      std::swap(a, b);
    joins.push_back({{a, b}, {(std::min)(area[a], area[b]), (std::max)(area[a], area[b])}});
    sets.join(a, b);
    area[sets.representative(a)] = joins.back().areas[0] + joins.back().areas[1];
  }

  Cut_hierarchy result;
  result.is_monotonic = true;
  result.has_all_cuts = d.has_all_cuts;
  std::vector<std::size_t> node(area.size(), null_node); // one per representative
  for (Index l : d.leaf) {
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
    n.salience = d.merges[i].salience;
    n.factors = d.merges[i].factors;
    result.cut_order.push_back(parent);
    node[a] = n.children[0];
    node[b] = n.children[1];
  }
  for (Cut_node& n : result.nodes)
    if (n.is_leaf())
      n.cut_state = Cut_state::NO_CUT;
  result.leaf.reserve(d.leaf.size());
  for (Index l : d.leaf)
    result.leaf.push_back(static_cast<Index>(node[l]));
  return result;
}

// Applies the cuts of a hierarchy from the top down: the part with the most salient cut comes next.
// A cut that is more salient than the cut above it gets the salience of the latter.
inline Cut_hierarchy applied_from_top_down(Cut_hierarchy cuts)
{
  typedef std::pair<double, std::size_t> Key; // minus the salience of a node's cut, and the node
  std::set<Key> queue;
  const auto enqueue = [&](std::size_t node) {
    if (!cuts.nodes[node].is_leaf())
      queue.insert({-quantized(cuts.nodes[node].salience), node});
  };
  for (std::size_t root = 0; root < cuts.number_of_roots; ++root)
    enqueue(root);
  cuts.cut_order.clear();
  double least = std::numeric_limits<double>::infinity();
  while (!queue.empty()) {
    const std::size_t node = queue.begin()->second;
    queue.erase(queue.begin());
    Cut_node& n = cuts.nodes[node];
    n.salience = least = (std::min)(least, n.salience);
    cuts.cut_order.push_back(node);
    enqueue(n.children[0]);
    enqueue(n.children[1]);
  }
  return hierarchy_of(dendrogram_of(cuts, ranges_of_leaves(cuts)));
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_DENDROGRAM_H
