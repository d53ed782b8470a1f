// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CUT_EDITOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CUT_EDITOR_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {

// Edits a hierarchy by hand. Nodes keep their indices.
class Cut_editor
{
  Cut_hierarchy& cuts_;
  std::vector<Cut_node>& nodes_;
  std::vector<std::size_t> position_; // one per node; `null_node` if not searched

  std::size_t& place_of(std::size_t i) // returns the entry in its parent
  {
    std::size_t (&children)[2] = nodes_[nodes_[i].parent].children;
    return children[children[0] == i ? 0 : 1];
  }

  void set_children(std::size_t parent, std::size_t first, std::size_t second)
  {
    if (nodes_[first].area > nodes_[second].area)
      std::swap(first, second);
    nodes_[parent].children[0] = first;
    nodes_[parent].children[1] = second;
    nodes_[first].parent = nodes_[second].parent = parent;
  }

  void update_areas(std::size_t from, std::size_t below)
  {
    for (std::size_t i = from; i != below; i = nodes_[i].parent) {
      const std::size_t (&children)[2] = nodes_[i].children;
      nodes_[i].area = nodes_[children[0]].area + nodes_[children[1]].area;
      set_children(i, children[0], children[1]);
    }
    set_children(below, nodes_[below].children[0], nodes_[below].children[1]);
  }

  void find_positions()
  {
    position_.assign(nodes_.size(), null_node);
    for (std::size_t k = 0; k < cuts_.cut_order.size(); ++k)
      position_[cuts_.cut_order[k]] = k;
  }

  // Sets the salience and the position of a cut into two nodes, which comes as late as possible.
  void move_last(std::size_t i)
  {
    Cut_node& n = nodes_[i];
    n.salience = 0;
    for (std::size_t node : cuts_.cut_order)
      n.salience = (std::min)(n.salience, nodes_[node].salience);
    position_[i] = cuts_.cut_order.size();
    for (std::size_t child : n.children)
      if (!nodes_[child].is_leaf()) {
        n.salience = (std::max)(n.salience, nodes_[child].salience);
        position_[i] = (std::min)(position_[i], position_[child]);
      }
  }

  // Orders the nodes by their former positions, but parents before their children. In a monotonic
  // hierarchy, lowers saliences that exceed the parent's, and orders by salience first.
  void update_order()
  {
    typedef std::tuple<double, std::size_t, std::size_t> Key; // salience, position, node
    std::priority_queue<Key, std::vector<Key>, std::greater<Key> > queue;
    const auto enqueue = [&](std::size_t i) {
      if (position_[i] != null_node)
        queue.push({cuts_.is_monotonic ? -nodes_[i].salience : 0, position_[i], i});
    };
    cuts_.cut_order.clear();
    for (std::size_t i = 0; i < cuts_.number_of_roots; ++i)
      enqueue(i);
    while (!queue.empty()) {
      const std::size_t i = std::get<2>(queue.top());
      queue.pop();
      cuts_.cut_order.push_back(i);
      if (nodes_[i].is_leaf())
        continue;
      for (std::size_t child : nodes_[i].children) {
        if (cuts_.is_monotonic && position_[child] != null_node)
          nodes_[child].salience = (std::min)(nodes_[child].salience, nodes_[i].salience);
        enqueue(child);
      }
    }
  }

  // Returns the smallest node that contains both; `null_node` if they have different roots.
  std::size_t common_node(std::size_t a, std::size_t b) const
  {
    std::vector<char> is_above(nodes_.size(), 0);
    for (; a != null_node; a = nodes_[a].parent)
      is_above[a] = 1;
    while (b != null_node && !is_above[b])
      b = nodes_[b].parent;
    return b;
  }

  // Moves node b next to node a, and returns their new parent. It is the node whose cut separated
  // b; the sibling of b takes the place of that node.
  std::size_t moved_to(std::size_t a, std::size_t b, std::size_t common)
  {
    const std::size_t parent = nodes_[b].parent;
    const std::size_t (&children)[2] = nodes_[parent].children;
    const std::size_t sibling = children[children[0] == b ? 1 : 0];
    std::size_t result = parent;
    if (parent == common) { // the sibling contains a, and will have all faces of the parent
      const Cut_node s = nodes_[sibling];
      Cut_node& n = nodes_[parent];
      n.cut_state = s.cut_state;
      n.salience = s.salience;
      n.factors = s.factors;
      position_[parent] = position_[sibling];
      set_children(parent, s.children[0], s.children[1]);
      result = sibling;
    }
    else {
      place_of(parent) = sibling;
      nodes_[sibling].parent = nodes_[parent].parent;
      update_areas(nodes_[sibling].parent, common);
    }
    place_of(a) = result;
    Cut_node& n = nodes_[result];
    n.parent = nodes_[a].parent;
    n.cut_state = Cut_state::CUT;
    n.factors = Salience_factors();
    n.area = nodes_[a].area + nodes_[b].area;
    set_children(result, a, b);
    update_areas(n.parent, common);
    return result;
  }

public:
  explicit Cut_editor(Cut_hierarchy& cuts) : cuts_(cuts), nodes_(cuts.nodes) { find_positions(); }

  // Makes two nodes the children of one node, by moving b next to a, and returns that node.
  std::size_t merge(std::size_t a, std::size_t b)
  {
    const std::size_t common = common_node(a, b);
    if (common == null_node)
      throw std::invalid_argument("Segmentation_hierarchy: nodes of different roots cannot be "
                                  "merged");
    if (common == a || common == b)
      throw std::invalid_argument("Segmentation_hierarchy: a node cannot be merged with one that "
                                  "contains it");
    const std::size_t parent = nodes_[b].parent;
    const std::size_t result =
      nodes_[a].parent == parent ? parent : moved_to(a, b, common);
    move_last(result);
    update_order();
    return result;
  }

  // Cuts a leaf like another hierarchy cuts its only root, whose i-th face is `faces[i]`.
  template <class FaceRange>
  void graft(std::size_t leaf, const FaceRange& faces, const Cut_hierarchy& part)
  {
    if (part.nodes[0].is_leaf())
      return;
    const std::size_t shift = nodes_.size() - 1;
    const auto number = [=](std::size_t i) { return i == 0 || i == null_node ? i : i + shift; };
    const auto node_of = [=](std::size_t i) { return i == 0 ? leaf : number(i); };
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      Cut_node n = part.nodes[i];
      for (std::size_t& child : n.children)
        child = number(child);
      n.parent = i == 0 ? nodes_[leaf].parent : node_of(n.parent);
      if (i == 0) {
        n.area = nodes_[leaf].area;
        nodes_[leaf] = n;
      }
      else
        nodes_.push_back(n);
    }
    auto f = faces.begin();
    for (Index leaf_of_part : part.leaf)
      cuts_.leaf[*f++] = static_cast<Index>(node_of(leaf_of_part));
    cuts_.cut_order.erase(std::remove(cuts_.cut_order.begin(), cuts_.cut_order.end(), leaf),
                          cuts_.cut_order.end());
    for (std::size_t i : part.cut_order)
      cuts_.cut_order.push_back(node_of(i));
    cuts_.has_all_cuts = cuts_.has_all_cuts && part.has_all_cuts;
    if (cuts_.is_monotonic && nodes_[leaf].parent != null_node)
      nodes_[leaf].salience = (std::min)(nodes_[leaf].salience,
                                         nodes_[nodes_[leaf].parent].salience);
    find_positions();
    update_order();
  }
};

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CUT_EDITOR_H
