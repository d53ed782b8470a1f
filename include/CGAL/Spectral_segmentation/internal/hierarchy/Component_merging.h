// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/grid/set_contacts.h>
#include <CGAL/Spectral_segmentation/internal/features/Set_features.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/salience/component_salience.h>
#include <CGAL/Spectral_segmentation/internal/surface/model_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges the components of a model. The smallest joins the neighbor with which it has the most
// contact, and so on. The larger it is, the more salient is its boundary. A component that touches
// nothing comes last, with an infinite salience, unless it is tiny beside the largest component. A
// sheet touches nothing. A component keeps all of its cuts, or none, by the evidence of all its
// cuts together.
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

  const Surface& mesh_;
  const Component_shares& shares_;
  Run_monitor& monitor_;
  Dendrogram result_;
  std::vector<Index> component_of_leaf_;
  Set_features features_; // of the components
  double feature_weight_;

  std::vector<Neighbors> neighbors() const
  {
    std::vector<Neighbors> result(shares_.share.size());
    const auto count_steps = [&](std::size_t number) { monitor_.count_steps(number); };
    for (const Set_contact& c : set_contacts(mesh_, result_.leaf, count_steps)) {
      count_steps(1000); // of a map
      const auto [a, b] = c.sets;
      const Index i = component_of_leaf_[a], j = component_of_leaf_[b];
      if (i == j)
        continue;
      const std::size_t contact = i == shares_.sheet || j == shares_.sheet ? 0 : c.area;
      result[i][j].add({contact, c.squared_gap, {a, b}, contact, c.squared_gap});
      result[j][i].add({contact, c.squared_gap, {b, a}, contact, c.squared_gap});
    }
    return result;
  }

  // Adds the merges of the components. Of equal sets, that with the fewest neighbors is merged
  // first, so that thousands at one place are merged in nearly linear time.
  void add_merges(std::vector<Neighbors> neighbors)
  {
    typedef std::tuple<double, std::size_t, Index> Key; // area, number of neighbors, and the set
    std::vector<double> area = shares_.share;
    std::vector<Key> key(area.size());
    std::set<Key> sets, apart;
    const auto insert = [&](std::set<Key>& into, Index i) {
      key[i] = {quantized(area[i]), neighbors[i].size(), i};
      into.insert(key[i]);
    };
    double tiny = 0;
    for (Index i = 0; i < area.size(); ++i) {
      insert(sets, i);
      if (i != shares_.sheet)
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
                               : salience_of_component(area[a], logit_of_features(a, b)));
      insert(from, b);
    }
  }

  // Returns whether each component has too little evidence to be cut. Saliences that are no
  // probabilities are no evidence for or against anything.
  std::vector<char> are_uncut(std::size_t number_of_cuts) const
  {
    const std::size_t n = shares_.share.size();
    std::vector<double> evidence(n, 0);
    std::vector<char> are_probabilities(n, 1), result;
    for (std::size_t i = 0; i < number_of_cuts; ++i) {
      const Merge& m = result_.merges[i];
      const Index component = component_of_leaf_[m.leaves[0]];
      if (m.salience >= 0 && m.salience <= 1)
        evidence[component] += evidence_of_cut(m.salience);
      else
        are_probabilities[component] = 0;
    }
    const double fading = features_.empty() ? 0 : Feature_logit::fading(feature_weight_);
    const double required = (1 - fading) * required_evidence(shares_.effective_number());
    for (std::size_t i = 0; i < n; ++i)
      result.push_back(are_probabilities[i] && evidence[i] < required);
    return result;
  }

  // Shifts the logits of the first merges, which are the cuts of components, in each component that
  // stays uncut: the highest comes to lie below all later merges, and below the default threshold.
  void lower_cuts(std::size_t number_of_cuts)
  {
    const std::vector<char> is_uncut = are_uncut(number_of_cuts);
    double least = default_probability_threshold;
    for (std::size_t i = number_of_cuts; i < result_.merges.size(); ++i)
      least = (std::min)(least, result_.merges[i].salience);
    std::vector<double> highest(is_uncut.size(), 0);
    for (std::size_t i = 0; i < number_of_cuts; ++i) {
      double& of_component = highest[component_of_leaf_[result_.merges[i].leaves[0]]];
      of_component = (std::max)(of_component, result_.merges[i].salience);
    }
    for (std::size_t i = 0; i < number_of_cuts; ++i) {
      Merge& m = result_.merges[i];
      const Index component = component_of_leaf_[m.leaves[0]];
      if (is_uncut[component] && highest[component] >= least) {
        const double shift = clamped_logit(highest[component]) - clamped_logit(least / 2);
        m.salience = (std::min)(1 / (1 + std::exp(shift - clamped_logit(m.salience))), least / 2);
      }
    }
  }

public:
  // Takes the merges within the components, each of which they make one set, the mesh, whose faces
  // have areas, the shares of the components in it, and their features.
  Component_merging(Dendrogram merges, const Surface& mesh, const Component_shares& shares,
                    Set_features features, double feature_weight, Run_monitor& monitor)
    : mesh_(mesh), shares_(shares), monitor_(monitor), result_(std::move(merges)),
      component_of_leaf_(result_.areas.size()), features_(std::move(features)),
      feature_weight_(feature_weight)
  {
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      component_of_leaf_[result_.leaf[f]] = mesh.components[f];
  }

  // Returns the hierarchy of the whole mesh.
  Cut_hierarchy operator()()
  {
    const std::size_t number_of_cuts = result_.merges.size();
    if (shares_.share.size() > 1)
      add_merges(neighbors());
    lower_cuts(number_of_cuts);
    sort_merges(result_.merges);
    return hierarchy_of(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_COMPONENT_MERGING_H
