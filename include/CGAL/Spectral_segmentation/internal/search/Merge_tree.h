// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MERGE_TREE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MERGE_TREE_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A set of faces that no cut divides. If the search decided not to cut it, there are the number of
// cuts that were made before, and a cut that was rejected.
struct Leaf
{
  double area = 0;
  Cut_state cut_state = Cut_state::NO_CUT;
  std::size_t number_of_earlier_cuts = null_node; // null_node: the search did not decide on it
  double salience = 0;
  Salience_factors factors = {};
};

// A merge of two sets of leaves, which in reverse is a cut. Each set is given by one of its leaves.
struct Merge
{
  Index leaves[2];
  double salience;          // the salience of the boundary that vanishes
  Salience_factors factors; // its factors
};

// The result of a run up to its last step. Sets that are not merged are the roots.
struct Merge_tree
{
  std::vector<Index> leaf;    // one per face of a surface
  std::vector<Leaf> leaves;   // each has a face
  std::vector<Merge> merges;  // the last cut first
  bool is_monotonic = false;  // no cut is less salient than any later cut
  bool has_all_cuts = true;   // false if cuts are lost because a side became too small

  std::size_t number_of_roots() const { return leaves.size() - merges.size(); }
};

// Returns a tree without merges, whose leaves are the components of a surface.
inline Merge_tree uncut_tree(const Surface& surface, Cut_state state)
{
  Merge_tree result;
  result.leaf = surface.components.face_labels(surface.number_of_faces());
  for (double area : component_areas(surface, surface.components))
    result.leaves.push_back({area, state});
  return result;
}

// Sets the areas of the leaves to the sums of the areas of their faces.
inline void set_areas_of_leaves(Merge_tree& tree, const Surface& surface)
{
  for (Leaf& leaf : tree.leaves)
    leaf.area = 0;
  for (Index f = 0; f < tree.leaf.size(); ++f)
    tree.leaves[tree.leaf[f]].area += surface.areas[f];
}

// Appends the merges of a tree of some faces, which are given by their indices in the surface of
// all. The decisions of the search on leaves are left out.
inline void append(Merge_tree& all, const Merge_tree& tree, const std::vector<Index>& faces)
{
  const Index first = static_cast<Index>(all.leaves.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    all.leaf[faces[i]] = first + tree.leaf[i];
  all.leaves.resize(all.leaves.size() + tree.leaves.size());
  for (const Merge& m : tree.merges)
    all.merges.push_back({{first + m.leaves[0], first + m.leaves[1]}, m.salience, m.factors});
  all.has_all_cuts = all.has_all_cuts && tree.has_all_cuts;
}

// A set of leaves that a tree merges, as a range of an order of the leaves in which each such set
// is a range.
struct Merged_set
{
  Index first, end;
  Index leaf;  // one of its leaves
  Index merge; // the merge that made it; null_index for a single leaf
  double area;

  Index size() const { return end - first; }
  bool contains(Index position) const { return position >= first && position < end; }
};

// The sets that the merges of a tree join. The range of the union begins with the range of its
// first side, which has the smaller area.
struct Merged_sets
{
  std::vector<std::array<Merged_set, 2> > sides; // one pair per merge
  std::vector<Merged_set> roots;                 // by their first faces
  std::vector<Index> position;                   // one per leaf, in the order

  explicit Merged_sets(const Merge_tree& tree)
    : position(tree.leaves.size())
  {
    const Index n = static_cast<Index>(tree.leaves.size());
    Disjoint_sets sets(n);
    std::vector<Merged_set> set(n); // one per representative
    for (Index i = 0; i < n; ++i)
      set[i] = {0, 1, i, null_index, tree.leaves[i].area};
    for (Index i = 0; i < tree.merges.size(); ++i) {
      Index a = sets.representative(tree.merges[i].leaves[0]);
      Index b = sets.representative(tree.merges[i].leaves[1]);
      CGAL_precondition(a != b);
      if (set[a].area > (1 + 1e-9) * set[b].area) // areas that are equal up to noise do not decide
        std::swap(a, b);
      sides.push_back({set[a], set[b]});
      sets.join(a, b);
      set[sets.representative(a)] = {0, set[a].size() + set[b].size(), set[a].leaf, i,
                                     set[a].area + set[b].area};
    }
    std::vector<char> is_root(n, 0);
    for (Index leaf : tree.leaf)
      if (const Index root = sets.representative(leaf); !is_root[root]) {
        is_root[root] = 1;
        roots.push_back(set[root]);
      }
    set_ranges();
  }

  Merged_set union_of(std::size_t merge) const
  {
    const auto& [a, b] = sides[merge];
    return {a.first, b.end, a.leaf, static_cast<Index>(merge), a.area + b.area};
  }

private:
  void set_ranges()
  {
    std::vector<Index> first(sides.size()); // one per merge
    const auto move_to = [&](Merged_set& set, Index i) {
      set = {i, i + set.size(), set.leaf, set.merge, set.area};
      (set.merge == null_index ? position[set.leaf] : first[set.merge]) = i;
    };
    Index next = 0;
    for (Merged_set& root : roots) {
      move_to(root, next);
      next = root.end;
    }
    for (std::size_t i = sides.size(); i-- > 0;) {
      move_to(sides[i][0], first[i]);
      move_to(sides[i][1], sides[i][0].end);
    }
  }
};

// Returns the hierarchy of a tree.
inline Cut_hierarchy hierarchy_of(const Merge_tree& tree)
{
  const Merged_sets sets(tree);
  Cut_hierarchy result;
  result.is_monotonic = tree.is_monotonic;
  result.has_all_cuts = tree.has_all_cuts;
  result.number_of_roots = sets.roots.size();
  std::vector<std::size_t> node_of_leaf(tree.leaves.size()), node_of_cut(sets.sides.size());
  const auto add_node = [&](const Merged_set& set, std::size_t node) {
    (set.merge == null_index ? node_of_leaf[set.leaf] : node_of_cut[set.merge]) = node;
  };
  for (const Merged_set& root : sets.roots) {
    add_node(root, result.nodes.size());
    result.nodes.emplace_back();
    result.nodes.back().area = root.area;
  }
  std::vector<Index> decided; // leaves
  for (Index i = 0; i < tree.leaves.size(); ++i)
    if (tree.leaves[i].number_of_earlier_cuts != null_node)
      decided.push_back(i);
  std::stable_sort(decided.begin(), decided.end(), [&](Index a, Index b) {
    return tree.leaves[a].number_of_earlier_cuts < tree.leaves[b].number_of_earlier_cuts;
  });
  auto next = decided.begin();
  for (std::size_t number_of_cuts = 0;; ++number_of_cuts) {
    for (; next != decided.end() && tree.leaves[*next].number_of_earlier_cuts <= number_of_cuts;
         ++next)
      result.cut_order.push_back(node_of_leaf[*next]);
    if (number_of_cuts == tree.merges.size())
      break;
    const std::size_t i = tree.merges.size() - 1 - number_of_cuts, node = node_of_cut[i];
    const auto& [a, b] = sets.sides[i];
    result.cut(node, (std::min)(a.area, b.area), (std::max)(a.area, b.area));
    Cut_node& n = result.nodes[node];
    n.cut_state = Cut_state::CUT;
    n.salience = tree.merges[i].salience;
    n.factors = tree.merges[i].factors;
    result.cut_order.push_back(node);
    add_node(a, n.children[0]);
    add_node(b, n.children[1]);
  }
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    Cut_node& n = result.nodes[node_of_leaf[i]];
    n.cut_state = tree.leaves[i].cut_state;
    n.salience = tree.leaves[i].salience;
    n.factors = tree.leaves[i].factors;
  }
  result.leaf.reserve(tree.leaf.size());
  for (Index leaf : tree.leaf)
    result.leaf.push_back(static_cast<Index>(node_of_leaf[leaf]));
  return result;
}

// Returns the segment of each face, one of its leaves, if the cuts of a monotonic tree are made
// that are at least as salient as the threshold.
inline std::vector<Index> segments_above(const Merge_tree& tree, double threshold)
{
  std::vector<Index> segment = first_indices(tree.leaves.size());
  Disjoint_sets sets(segment.size());
  for (auto m = tree.merges.begin(); m != tree.merges.end() && m->salience < threshold; ++m)
    sets.join(m->leaves[0], m->leaves[1]);
  for (Index& leaf : segment)
    leaf = sets.representative(leaf);
  return composed(tree.leaf, segment);
}

// Numbers the leaves in the order in which the cuts make them. Later steps break ties by leaves.
inline void number_leaves(Merge_tree& tree)
{
  const Merged_sets sets(tree);
  std::vector<Index> number(tree.leaves.size());
  std::vector<Leaf> leaves;
  const auto add = [&](const Merged_set& set) {
    if (set.merge != null_index)
      return;
    number[set.leaf] = static_cast<Index>(leaves.size());
    leaves.push_back(tree.leaves[set.leaf]);
  };
  std::for_each(sets.roots.begin(), sets.roots.end(), add);
  for (auto sides = sets.sides.rbegin(); sides != sets.sides.rend(); ++sides)
    std::for_each(sides->begin(), sides->end(), add);
  tree.leaves = std::move(leaves);
  for (Index& leaf : tree.leaf)
    leaf = number[leaf];
  for (Merge& m : tree.merges)
    for (Index& leaf : m.leaves)
      leaf = number[leaf];
}

// Applies the cuts of a tree from the top down: the part with the most salient cut comes next. A
// cut that is more salient than the cut above it gets the salience of the latter.
inline Merge_tree apply_from_top_down(Merge_tree tree)
{
  // Minus the salience of a cut, a number that grows from cut to cut, and the merge.
  typedef std::tuple<double, std::size_t, Index> Key;
  const Merged_sets sets(tree);
  std::set<Key> queue;
  const auto enqueue = [&](const Merged_set& set, std::size_t number) {
    if (set.merge != null_index)
      queue.insert({-quantized(tree.merges[set.merge].salience), number, set.merge});
  };
  for (std::size_t i = 0; i < sets.roots.size(); ++i)
    enqueue(sets.roots[i], i);
  std::vector<Merge> cuts;
  double least = std::numeric_limits<double>::infinity();
  while (!queue.empty()) {
    const Index i = std::get<2>(*queue.begin());
    queue.erase(queue.begin());
    cuts.push_back(tree.merges[i]);
    cuts.back().salience = least = (std::min)(least, tree.merges[i].salience);
    for (std::size_t k = 0; k < 2; ++k)
      enqueue(sets.sides[i][k], sets.roots.size() + 2 * (tree.merges.size() - i) + k);
  }
  tree.merges.assign(cuts.rbegin(), cuts.rend());
  tree.is_monotonic = true;
  number_leaves(tree);
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MERGE_TREE_H
