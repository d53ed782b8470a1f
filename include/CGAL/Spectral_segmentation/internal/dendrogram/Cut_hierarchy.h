// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_CUT_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_CUT_HIERARCHY_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A set of faces: a root, or one side of the cut of its parent.
struct Cut_node
{
  std::size_t parent = null_node;
  std::size_t children[2] = {null_node, null_node}; // that of smaller area first
  double area = 0;
  Cut_state cut_state = Cut_state::NOT_SEARCHED;
  double salience = 0;
  Salience_factors factors;

  bool is_leaf() const { return children[0] == null_node; }
};

// The nodes of a dendrogram, with all cuts. The roots come first, by their first faces; the children
// of the i-th cut are the nodes number_of_roots + 2 i and the next one, unless nodes keep the numbers
// that they had before a change.
struct Cut_hierarchy
{
  std::size_t number_of_roots = 0;
  std::vector<Cut_node> nodes;
  std::vector<Index> leaf;           // of each face: the node without children that holds it
  std::vector<std::size_t> order;    // the nodes in the order in which the run decided on them
  bool is_ultrametric = false;       // no cut is less salient than those that follow
  bool is_complete = true;           // false: some cuts are lost, as no face was left for a side

  std::size_t number_of_segments() const
  { return number_of_roots + (nodes.size() - number_of_roots) / 2; }
};

// Makes the nodes of a dendrogram.
class Cut_hierarchy_builder
{
  const Dendrogram& d_;
  const std::size_t leaves_;
  std::vector<Cut_node> nodes_;     // the leaves, then what each merge makes
  std::vector<std::size_t> number_; // of each of these in the hierarchy
  std::size_t number_of_roots_ = 0;

  void add_nodes()
  {
    for (double area : d_.areas) {
      nodes_.emplace_back();
      nodes_.back().area = area;
      nodes_.back().cut_state =
        d_.is_ultrametric ? Cut_state::NO_CUT : Cut_state::NOT_SEARCHED;
    }
    nodes_.resize(leaves_ + d_.merges.size());
    for (std::size_t k = 0; k < d_.merges.size(); ++k) {
      const Merge& m = d_.merges[k];
      Cut_node& n = nodes_[m.is_cut() ? leaves_ + k : m.leaves[0]];
      n.cut_state = m.state;
      n.salience = m.salience;
      n.factors = m.factors;
    }
    std::vector<std::size_t> root(leaves_); // of each set of leaves
    std::iota(root.begin(), root.end(), std::size_t(0));
    const Components sets = replay(d_, root, [&](std::size_t k, std::size_t a, std::size_t b) {
      const std::size_t parent = leaves_ + k;
      // What are equal areas on paper may differ by rounding.
      if (nodes_[a].area > (1 + 1e-9) * nodes_[b].area)
        std::swap(a, b);
      nodes_[parent].area = nodes_[a].area + nodes_[b].area;
      nodes_[parent].children[0] = a;
      nodes_[parent].children[1] = b;
      nodes_[a].parent = nodes_[b].parent = parent;
      return parent;
    });
    number_of_roots_ = root.size();
    number_.assign(nodes_.size(), null_node);
    std::size_t next = 0;
    for (Index leaf : d_.leaf)
      if (std::size_t& number = number_[root[sets[leaf]]]; number == null_node)
        number = next++;
  }

  void number_nodes()
  {
    if (!d_.node_of_leaf.empty()) {
      number_ = d_.node_of_leaf;
      for (const Merge& m : d_.merges)
        number_.push_back(m.node);
      return;
    }
    std::size_t next = number_of_roots_;
    for (std::size_t k = d_.merges.size(); k-- > 0;)
      if (d_.merges[k].is_cut())
        for (std::size_t child : nodes_[leaves_ + k].children)
          number_[child] = next++;
  }

public:
  explicit Cut_hierarchy_builder(const Dendrogram& d) : d_(d), leaves_(d.number_of_leaves()) {}

  Cut_hierarchy operator()()
  {
    add_nodes();
    number_nodes();
    Cut_hierarchy result;
    result.number_of_roots = number_of_roots_;
    result.is_ultrametric = d_.is_ultrametric;
    result.is_complete = d_.is_complete;
    const auto number = [this](std::size_t i) { return i == null_node ? i : number_[i]; };
    result.nodes.resize(2 * leaves_ - number_of_roots_);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (i >= leaves_ && !d_.merges[i - leaves_].is_cut())
        continue;
      Cut_node& n = result.nodes[number(i)];
      n = nodes_[i];
      n.parent = number(n.parent);
      for (std::size_t& child : n.children)
        child = number(child);
    }
    for (std::size_t k = d_.merges.size(); k-- > 0;)
      result.order.push_back(
        number(d_.merges[k].is_cut() ? leaves_ + k : d_.merges[k].leaves[0]));
    result.leaf.reserve(d_.leaf.size());
    for (Index leaf : d_.leaf)
      result.leaf.push_back(static_cast<Index>(number(leaf)));
    return result;
  }
};

inline Cut_hierarchy cut_hierarchy(const Dendrogram& d) { return Cut_hierarchy_builder(d)(); }

// All nodes, the roots first, and parents before their children.
inline std::vector<std::size_t> parents_first(const Cut_hierarchy& hierarchy)
{
  std::vector<std::size_t> result(hierarchy.number_of_roots);
  std::iota(result.begin(), result.end(), std::size_t(0));
  result.reserve(hierarchy.nodes.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Cut_node& n = hierarchy.nodes[result[k]];
    if (!n.is_leaf())
      result.insert(result.end(), n.children, n.children + 2);
  }
  return result;
}

// The elements (faces, or leaves) of each node of a hierarchy, as ranges of one permutation of them
// all: the range of a node is that of its first child and that of its second.
class Nested_ranges
{
  std::vector<Index> elements_;
  std::vector<std::size_t> first_, end_; // of each node, in elements_

public:
  typedef Iterator_range<std::vector<Index>::const_iterator> Range;

  Nested_ranges() = default;

  // Those of a leaf ascend.
  explicit Nested_ranges(const Cut_hierarchy& hierarchy)
    : elements_(hierarchy.leaf.size()), first_(hierarchy.nodes.size(), 0),
      end_(hierarchy.nodes.size(), 0)
  {
    const std::vector<Cut_node>& nodes = hierarchy.nodes;
    std::vector<std::size_t> size(nodes.size(), 0);
    for (Index node : hierarchy.leaf)
      ++size[node];
    const std::vector<std::size_t> order = parents_first(hierarchy);
    for (std::size_t k = order.size(); k-- > hierarchy.number_of_roots;)
      size[nodes[order[k]].parent] += size[order[k]];
    std::size_t end = 0;
    for (std::size_t i : order) {
      if (i < hierarchy.number_of_roots)
        first_[i] = end;
      else if (i == nodes[nodes[i].parent].children[0])
        first_[i] = first_[nodes[i].parent];
      else
        first_[i] = end_[nodes[nodes[i].parent].children[0]];
      end_[i] = first_[i] + size[i];
      end = (std::max)(end, end_[i]);
    }
    std::vector<std::size_t> next(first_);
    for (Index e = 0; e < elements_.size(); ++e)
      elements_[next[hierarchy.leaf[e]]++] = e;
  }

  std::size_t size() const { return elements_.size(); }
  std::size_t size(std::size_t node) const { return end_[node] - first_[node]; }
  std::size_t first(std::size_t node) const { return first_[node]; } // its place in the permutation

  Range operator[](std::size_t node) const
  {
    const auto begin = elements_.begin();
    return make_range(begin + static_cast<std::ptrdiff_t>(first_[node]),
                      begin + static_cast<std::ptrdiff_t>(end_[node]));
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_CUT_HIERARCHY_H
