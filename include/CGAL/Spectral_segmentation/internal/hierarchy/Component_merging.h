// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/grid/set_contacts.h>
#include <CGAL/Spectral_segmentation/internal/features/Set_features.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/salience/salience_in_component.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <algorithm>
#include <array>
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
// the largest component. A sheet under the object, such as the water under a ship, touches nothing
// and counts for nothing.
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
  Run_monitor& monitor_;
  const Nested_ranges leaves_;                  // the leaves of each node
  const std::vector<std::size_t> root_of_leaf_; // one per place among the leaves
  Dendrogram result_;
  const Index sheet_;  // the root that is a sheet under all others, or null_index
  double area_ = 0;    // without the sheet
  Set_features features_; // of the roots
  double feature_weight_;

  // Returns the largest component if it is flat, and at least twice as long as all others together.
  Index largest_sheet() const
  {
    std::vector<Moments> moments(cuts_.number_of_roots);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      moments[root_of_leaf_[result_.leaf[f]]].add(mesh_, f);
    Index largest = 0;
    for (Index i = 0; i < moments.size(); ++i)
      if (moments[i].area > moments[largest].area)
        largest = i;
    Moments others;
    for (Index i = 0; i < moments.size(); ++i)
      if (i != largest)
        others += moments[i];
    if (!(others.area > 0))
      return null_index;
    const std::array<double, 3> extents = moments[largest].deviations();
    const bool is_sheet = extents[0] <= 0.02 * extents[1] &&
                          extents[2] >= 2 * others.deviations()[2];
    return is_sheet ? largest : null_index;
  }

  // Returns the share of a component in the area of all but the sheet, or of the sheet in all.
  double share(std::size_t root) const
  {
    const double area = cuts_.nodes[root].area;
    return area / (root == sheet_ ? area_ + area : area_);
  }

  // Sets the saliences of the cuts of components.
  void set_saliences()
  {
    for (Merge& m : result_.merges)
      m.salience =
        salience_in_component(m.salience, share(root_of_leaf_[m.leaves[0]]), m.factors);
  }

  std::vector<Neighbors> neighbors() const
  {
    std::vector<Neighbors> result(cuts_.number_of_roots);
    const auto count_steps = [&](std::size_t number) { monitor_.count_steps(number); };
    for (const Set_contact& c : set_contacts(mesh_, result_.leaf, count_steps)) {
      count_steps(1000); // of a map
      const auto [a, b] = c.sets;
      const Index root_a = static_cast<Index>(root_of_leaf_[a]),
                  root_b = static_cast<Index>(root_of_leaf_[b]);
      if (root_a == root_b)
        continue;
      const std::size_t contact = root_a == sheet_ || root_b == sheet_ ? 0 : c.area;
      result[root_a][root_b].add({contact, c.squared_gap, {a, b}, contact, c.squared_gap});
      result[root_b][root_a].add({contact, c.squared_gap, {b, a}, contact, c.squared_gap});
    }
    return result;
  }

  // Adds the merges of the components. Of equal sets, that with the fewest neighbors is merged
  // first, so that thousands at one place are merged in nearly linear time.
  void add_merges(std::vector<Neighbors> neighbors)
  {
    typedef std::tuple<double, std::size_t, Index> Key; // area, number of neighbors, and the set
    std::vector<double> area;
    std::vector<Key> key;
    std::set<Key> sets, apart;
    const auto insert = [&](std::set<Key>& into, Index i) {
      key[i] = {quantized(area[i]), neighbors[i].size(), i};
      into.insert(key[i]);
    };
    double tiny = 0;
    for (Index i = 0; i < cuts_.number_of_roots; ++i) {
      area.push_back(cuts_.nodes[i].area);
      key.emplace_back();
      insert(sets, i);
      if (i != sheet_)
        tiny = (std::max)(tiny, share_at_threshold * area[i]);
    }
    const auto join = [&](Index a, Index b, double salience) {
      monitor_.count_steps(100 * neighbors[a].size());
      const Neighbor& seam = neighbors[a].at(b);
      result_.merges.push_back({{seam.leaves[0], seam.leaves[1]}, quantized(salience), {}});
      sets.erase(key[b]);
      apart.erase(key[b]);
      for (const auto& [c, neighbor] : neighbors[a]) {
        if (c != b) {
          neighbors[b][c].add(neighbor);
          neighbors[c][b].add(neighbors[c][a]);
        }
        neighbors[c].erase(a);
      }
      neighbors[a].clear();
      area[b] += area[a];
      features_.join(a, b);
    };
    const double explained_variance = features_.explained_variance();
    const auto logit_of_features = [&](Index a, Index b) {
      return features_.empty() ? 0
        : Feature_logit().of_components(features_.distance(a, b), explained_variance,
                                        feature_weight_);
    };
    const auto is_better = [](const auto& x, const auto& y) { // contact, then the gap
      return std::make_pair(x.second.contact, -x.second.squared_gap) <
             std::make_pair(y.second.contact, -y.second.squared_gap);
    };
    while (sets.size() + apart.size() > 1) {
      const bool are_all_apart = sets.empty(); // and stay apart when they are joined
      std::set<Key>& from = are_all_apart ? apart : sets;
      const Index a = std::get<2>(*from.begin());
      from.erase(from.begin());
      const auto best = std::max_element(neighbors[a].begin(), neighbors[a].end(), is_better);
      const Index b = best->first;
      if (!are_all_apart && best->second.contact == 0 && !(area[a] < tiny)) {
        insert(apart, a);
        continue;
      }
      join(a, b, are_all_apart ? std::numeric_limits<double>::infinity()
                               : salience_of_component(area[a] / area_,
                                                       logit_of_features(a, b)));
      insert(from, b);
    }
  }

public:
  // Takes the cuts of the components, one root for each, the mesh, whose faces have areas, and the
  // features of the roots.
  Component_merging(const Cut_hierarchy& cuts, const Surface& mesh, Set_features features,
                    double feature_weight, Run_monitor& monitor)
    : cuts_(cuts), mesh_(mesh), monitor_(monitor), leaves_(ranges_of_leaves(cuts)),
      root_of_leaf_(roots_of_leaves(cuts, leaves_)), result_(dendrogram_of(cuts, leaves_)),
      sheet_(largest_sheet()), features_(std::move(features)), feature_weight_(feature_weight)
  {
    for (std::size_t i = 0; i < cuts.number_of_roots; ++i)
      if (i != sheet_)
        area_ += cuts.nodes[i].area;
    if (!(area_ > 0))
      area_ = 1; // all areas are 0
  }

  // Returns the hierarchy of the whole mesh.
  Cut_hierarchy operator()()
  {
    set_saliences();
    add_merges(neighbors());
    sort_merges(result_.merges);
    return hierarchy_of(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H
