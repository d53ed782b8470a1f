// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_EDITING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_EDITING_H

#include <CGAL/Spectral_segmentation/internal/dendrogram/Cut_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The merges of a hierarchy, whose nodes keep their numbers when they are changed.
inline Dendrogram dendrogram_of(const Cut_hierarchy& h, std::vector<Index>& leaf_in_node)
{
  Dendrogram d;
  d.is_ultrametric = h.is_ultrametric;
  d.is_complete = h.is_complete;
  leaf_in_node.assign(h.nodes.size(), null_index);
  for (std::size_t i = 0; i < h.nodes.size(); ++i)
    if (h.nodes[i].is_leaf()) {
      leaf_in_node[i] = static_cast<Index>(d.number_of_leaves());
      d.areas.push_back(h.nodes[i].area);
      d.node_of_leaf.push_back(i);
    }
  const std::vector<std::size_t> order = parents_first(h);
  for (std::size_t k = order.size(); k-- > 0;)
    if (const Cut_node& n = h.nodes[order[k]]; !n.is_leaf())
      leaf_in_node[order[k]] = leaf_in_node[n.children[0]];
  for (std::size_t k = h.order.size(); k-- > 0;) {
    const std::size_t i = h.order[k];
    const Cut_node& n = h.nodes[i];
    const std::size_t a = n.is_leaf() ? i : n.children[0], b = n.is_leaf() ? i : n.children[1];
    d.merges.push_back({{leaf_in_node[a], leaf_in_node[b]}, n.salience, n.factors, i, n.cut_state});
  }
  for (Index leaf : h.leaf)
    d.leaf.push_back(leaf_in_node[leaf]);
  return d;
}

// Lowers each salience to that of the merge that contains it, and brings the merges in the order of
// their saliences.
inline void lower_saliences(Dendrogram& d)
{
  const std::vector<std::size_t> above = parents(d);
  for (std::size_t k = d.merges.size(); k-- > 0;)
    if (const std::size_t i = above[d.number_of_leaves() + k]; i != null_node)
      d.merges[k].salience = (std::min)(d.merges[k].salience,
                                        d.merges[i - d.number_of_leaves()].salience);
  std::stable_sort(d.merges.begin(), d.merges.end(),
                   [](const Merge& a, const Merge& b) { return a.salience < b.salience; });
}

// Changes a hierarchy by hand.
class Hierarchy_editor
{
  typedef std::vector<Merge>::iterator Iterator;

  const Cut_hierarchy& h_;
  std::vector<Index> leaf_in_; // of each node: one of its leaves
  Dendrogram d_;

  // Of each node, whether it is below another one, or that.
  std::vector<char> are_within(std::size_t node) const
  {
    std::vector<char> result(h_.nodes.size(), 0);
    for (std::size_t i : parents_first(h_))
      result[i] = i == node || (h_.nodes[i].parent != null_node && result[h_.nodes[i].parent]);
    return result;
  }

  Iterator merge_of(std::size_t node)
  {
    return std::find_if(d_.merges.begin(), d_.merges.end(),
                        [node](const Merge& m) { return m.node == node; });
  }

  // Takes away the merge that contains node b, whose sibling takes the place of both; brings the
  // merges within b before the one to whose place they come. Returns the node that is free now.
  std::size_t detach(std::size_t b, const std::vector<char>& is_in_b, std::size_t parent_of_a)
  {
    const std::size_t parent = h_.nodes[b].parent;
    const std::size_t (&children)[2] = h_.nodes[parent].children;
    const std::size_t sibling = children[children[0] == b ? 1 : 0];
    d_.merges.erase(merge_of(parent));
    for (Merge& m : d_.merges)
      for (Index& leaf : m.leaves)
        if (!is_in_b[m.node] && is_in_b[d_.node_of_leaf[leaf]])
          leaf = leaf_in_[sibling];
    const Iterator place = merge_of(parent_of_a);
    const double salience = place->salience;
    const Iterator end = std::stable_partition(place, d_.merges.end(),
                                               [&](const Merge& m) { return is_in_b[m.node] != 0; });
    if (d_.is_ultrametric)
      for (Iterator m = place; m != end; ++m)
        m->salience = (std::min)(m->salience, salience);
    if (!are_within(sibling)[parent_of_a])
      return parent;
    merge_of(sibling)->node = parent; // which has all of its faces, as before
    return sibling;
  }

  // Lets a merge of two nodes come as early as it can, and so its cut as late as it can.
  void insert(Merge m, const std::vector<char>& is_in_a, const std::vector<char>& is_in_b)
  {
    m.salience = 0;
    for (const Merge& other : d_.merges)
      m.salience = (std::min)(m.salience, other.is_cut() ? other.salience : 0);
    Iterator place = d_.merges.begin();
    for (Iterator other = place; other != d_.merges.end(); ++other)
      if (other->is_cut() && (is_in_a[other->node] || is_in_b[other->node])) {
        m.salience = (std::max)(m.salience, other->salience);
        place = other + 1;
      }
    d_.merges.insert(place, m);
  }

public:
  explicit Hierarchy_editor(const Cut_hierarchy& h) : h_(h), d_(dendrogram_of(h, leaf_in_)) {}

  // Makes two nodes the children of one, by moving b to the place of a, and returns it.
  std::size_t merge(std::size_t a, std::size_t b)
  {
    const std::vector<char> is_in_a = are_within(a), is_in_b = are_within(b);
    if (is_in_a[b] || is_in_b[a])
      throw std::invalid_argument("Segmentation_hierarchy: a node cannot be merged with one that "
                                  "contains it");
    const auto root = [this](std::size_t i) {
      while (h_.nodes[i].parent != null_node)
        i = h_.nodes[i].parent;
      return i;
    };
    if (root(a) != root(b))
      throw std::invalid_argument("Segmentation_hierarchy: nodes of different roots cannot be "
                                  "merged");
    const std::size_t parent = h_.nodes[a].parent;
    Merge m{{leaf_in_[a], leaf_in_[b]}, 0, {}, parent};
    if (parent == h_.nodes[b].parent) {
      m.factors = merge_of(parent)->factors;
      d_.merges.erase(merge_of(parent));
    }
    else
      m.node = detach(b, is_in_b, parent);
    insert(m, is_in_a, is_in_b);
    return m.node;
  }

  // Cuts a leaf as another hierarchy cuts its only root, whose i-th face is `faces[i]`.
  template <class FaceRange>
  void graft(std::size_t leaf, const FaceRange& faces, const Cut_hierarchy& part)
  {
    std::vector<Index> unused;
    const Dendrogram of_part = dendrogram_of(part, unused);
    const Index first = leaf_in_[leaf], next = static_cast<Index>(d_.number_of_leaves());
    const auto leaf_of = [=](Index i) { return i == 0 ? first : next + i - 1; };
    const auto node_of = [&](std::size_t i) { return i == 0 ? leaf : h_.nodes.size() + i - 1; };
    d_.areas.insert(d_.areas.end(), of_part.areas.begin() + 1, of_part.areas.end());
    d_.areas[first] = of_part.areas[0];
    for (std::size_t i = 0; i < of_part.number_of_leaves(); ++i) {
      d_.node_of_leaf.resize(d_.number_of_leaves());
      d_.node_of_leaf[leaf_of(static_cast<Index>(i))] = node_of(of_part.node_of_leaf[i]);
    }
    auto f = faces.begin();
    for (Index i : of_part.leaf)
      d_.leaf[*f++] = leaf_of(i);
    std::vector<Merge> merges = of_part.merges;
    for (Merge& m : merges) {
      m.node = node_of(m.node);
      for (Index& i : m.leaves)
        i = leaf_of(i);
    }
    std::remove_copy_if(d_.merges.begin(), d_.merges.end(), std::back_inserter(merges),
                        [=](const Merge& m) { return m.node == leaf; });
    d_.merges = std::move(merges);
    d_.is_complete = d_.is_complete && part.is_complete;
    if (d_.is_ultrametric)
      lower_saliences(d_);
  }

  Cut_hierarchy hierarchy() const { return cut_hierarchy(d_); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_EDITING_H
