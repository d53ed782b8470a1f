// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H

#include <CGAL/Spectral_segmentation/internal/grid/set_contacts.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Merge.h>
#include <CGAL/Spectral_segmentation/internal/salience/salience_in_component.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges the components of an object that somebody put together. The smallest joins the neighbor
// with which it has the most contact, and so on. The larger it is, the more salient is its
// boundary. What touches nothing comes last, with an infinite salience, unless it is tiny beside
// the largest component.
class Component_merging
{
  // A set of components, beside another one.
  struct Neighbor
  {
    std::size_t contact = 0;
    double squared_gap = std::numeric_limits<double>::infinity();
    Index leaves[2] = {null_index, null_index}; // of both sets, those with the most contact
    std::size_t contact_of_leaves = 0;
    double squared_gap_of_leaves = std::numeric_limits<double>::infinity();

    void add(const Neighbor& other)
    {
      contact += other.contact;
      squared_gap = (std::min)(squared_gap, other.squared_gap);
      if (std::make_pair(other.contact_of_leaves, -other.squared_gap_of_leaves) >
          std::make_pair(contact_of_leaves, -squared_gap_of_leaves)) {
        std::copy(other.leaves, other.leaves + 2, leaves);
        contact_of_leaves = other.contact_of_leaves;
        squared_gap_of_leaves = other.squared_gap_of_leaves;
      }
    }
  };

  typedef std::map<Index, Neighbor> Neighbors;

  const Cut_hierarchy& cuts_;
  const Surface& mesh_;
  std::vector<Index> number_of_leaf_;    // one per node
  std::vector<Index> leaf_;              // one per face
  std::vector<double> area_of_leaf_;
  std::vector<std::size_t> root_;        // one per node
  double area_ = 0;
  std::vector<Merge> merges_;

  void number_leaves()
  {
    number_of_leaf_.assign(cuts_.nodes.size(), null_index);
    root_.resize(cuts_.nodes.size());
    for (std::size_t i : parents_first(cuts_)) {
      const Cut_node& n = cuts_.nodes[i];
      root_[i] = n.parent == null_node ? i : root_[n.parent];
      if (n.is_leaf()) {
        number_of_leaf_[i] = static_cast<Index>(area_of_leaf_.size());
        area_of_leaf_.push_back(n.area);
      }
    }
    for (Index leaf : cuts_.leaf)
      leaf_.push_back(number_of_leaf_[leaf]);
    for (std::size_t i = 0; i < cuts_.number_of_roots; ++i)
      area_ += cuts_.nodes[i].area;
    if (!(area_ > 0))
      area_ = 1; // all areas are 0
  }

  Index any_leaf(std::size_t node) const
  {
    while (!cuts_.nodes[node].is_leaf())
      node = cuts_.nodes[node].children[1];
    return number_of_leaf_[node];
  }

  // Adds the cuts of the components as merges.
  void add_cuts()
  {
    for (std::size_t i = 0; i < cuts_.nodes.size(); ++i) {
      const Cut_node& n = cuts_.nodes[i];
      if (!n.is_leaf())
        merges_.push_back({{any_leaf(n.children[0]), any_leaf(n.children[1])},
                           salience_in_component(n.salience, cuts_.nodes[root_[i]].area / area_),
                           n.factors});
    }
  }

  std::vector<Neighbors> neighbors() const
  {
    std::vector<Index> root_of_leaf(area_of_leaf_.size());
    for (std::size_t i = 0; i < cuts_.nodes.size(); ++i)
      if (cuts_.nodes[i].is_leaf())
        root_of_leaf[number_of_leaf_[i]] = static_cast<Index>(root_[i]);
    std::vector<Neighbors> result(cuts_.number_of_roots);
    for (const Set_contact& c : set_contacts(mesh_, leaf_)) {
      const auto [a, b] = c.sets;
      if (root_of_leaf[a] == root_of_leaf[b])
        continue;
      result[root_of_leaf[a]][root_of_leaf[b]].add({c.area, c.squared_gap, {a, b}, c.area,
                                                    c.squared_gap});
      result[root_of_leaf[b]][root_of_leaf[a]].add({c.area, c.squared_gap, {b, a}, c.area,
                                                    c.squared_gap});
    }
    return result;
  }

  // Adds the merges of the components.
  void add_merges()
  {
    typedef std::pair<double, Index> Sized; // an area, and the set that has it
    std::vector<Neighbors> neighbors = this->neighbors();
    std::vector<double> area;
    std::set<Sized> sets, apart;
    for (Index i = 0; i < cuts_.number_of_roots; ++i) {
      area.push_back(cuts_.nodes[i].area);
      sets.insert({quantized(area[i]), i});
    }
    const auto join = [&](Index a, Index b, double salience) {
      const Neighbor& seam = neighbors[a].at(b);
      merges_.push_back({{seam.leaves[0], seam.leaves[1]}, salience, {}});
      sets.erase({quantized(area[b]), b});
      apart.erase({quantized(area[b]), b});
      for (const auto& [c, neighbor] : neighbors[a]) {
        if (c != b) {
          neighbors[b][c].add(neighbor);
          neighbors[c][b].add(neighbors[c][a]);
        }
        neighbors[c].erase(a);
      }
      neighbors[a].clear();
      area[b] += area[a];
      sets.insert({quantized(area[b]), b});
    };
    const auto is_better = [](const auto& x, const auto& y) { // contact, then the gap
      return std::make_pair(x.second.contact, -x.second.squared_gap) <
             std::make_pair(y.second.contact, -y.second.squared_gap);
    };
    const double tiny = share_at_threshold * *std::max_element(area.begin(), area.end());
    while (sets.size() + apart.size() > 1) {
      const bool are_all_apart = sets.empty();
      std::set<Sized>& from = are_all_apart ? apart : sets;
      const Index a = from.begin()->second;
      from.erase(from.begin());
      const auto best = std::max_element(neighbors[a].begin(), neighbors[a].end(), is_better);
      if (are_all_apart)
        join(a, best->first, std::numeric_limits<double>::infinity());
      else if (best->second.contact > 0 || area[a] < tiny)
        join(a, best->first, salience_of_component(area[a] / area_));
      else
        apart.insert({quantized(area[a]), a});
    }
  }

public:
  // Takes the cuts of the components, one root for each, and the mesh, whose faces have areas.
  Component_merging(const Cut_hierarchy& cuts, const Surface& mesh) : cuts_(cuts), mesh_(mesh) {}

  // Returns the hierarchy of the whole mesh.
  Cut_hierarchy operator()()
  {
    number_leaves();
    add_cuts();
    add_merges();
    std::stable_sort(merges_.begin(), merges_.end(), [](const Merge& a, const Merge& b)
      { return quantized(a.salience) < quantized(b.salience); });
    Cut_hierarchy result = hierarchy_of_merges(leaf_, area_of_leaf_, merges_);
    result.has_all_cuts = cuts_.has_all_cuts;
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H
