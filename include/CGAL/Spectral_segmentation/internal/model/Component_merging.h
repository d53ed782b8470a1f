// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_COMPONENT_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_COMPONENT_MERGING_H

#include <CGAL/Spectral_segmentation/internal/base/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/model/set_contacts.h>
#include <CGAL/Spectral_segmentation/internal/model/surrounding_components.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

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

// The fraction of the area from which a component is a part by default.
constexpr double fraction_at_threshold = 0.01;

// Returns the salience of the boundary of a component with a fraction of the area. It rises from 0
// to 1, through the default threshold. `logit` is added to its logit.
inline double salience_of_component(double fraction, double logit)
{
  const double odds =
    default_probability_threshold / (1 - default_probability_threshold) * std::exp(logit);
  return odds * fraction / (odds * fraction + fraction_at_threshold);
}

// Returns the logit of a probability, which is kept away from 0 and 1.
inline double clamped_logit(double probability)
{
  const double p = std::clamp(probability, 1e-6, 1 - 1e-6);
  return std::log(p / (1 - p));
}

// Returns the evidence of a cut for parts in its component: the excess of its logit over the logit
// of the default threshold.
inline double evidence_of_cut(double salience)
{ return (std::max)(clamped_logit(salience) - clamped_logit(default_probability_threshold), 0.); }

// Returns the total evidence of its cuts that a component needs to be cut, in a model with this
// effective number of components. In an assembled model the modeler has already separated most
// parts. A body has many likely cuts, a board has one or two barely likely cuts. The constants were
// chosen on furniture, and on animals beside other objects.
inline double required_evidence(double effective_number_of_components)
{ return (std::min)(2.5 * (effective_number_of_components - 1), 12.); }

// Merges the components of a model: repeatedly joins the smallest one to the neighbor with which it
// has the most contact. The larger it is, the more salient is its boundary. A component without
// contact comes last, with an infinite salience, unless it is tiny beside the largest component.
// Surroundings have no contacts, and come last. A component keeps all of its cuts or none,
// depending on their total evidence.
class Component_merging
{
  static constexpr double infinite_gap = std::numeric_limits<double>::infinity(),
                          largest_gap = (std::numeric_limits<double>::max)();

  // A set of components next to another set.
  struct Neighbor
  {
    std::size_t contact = 0;
    double squared_gap = infinite_gap;
    Index leaves[2] = {null_index, null_index}; // the leaves of both sets with the most contact
    std::size_t contact_of_leaves = 0;
    double squared_gap_of_leaves = infinite_gap;

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
  const Component_fractions& fractions_;
  Run_monitor& monitor_;
  Merge_tree result_;
  std::vector<Index> component_of_leaf_;
  Set_features features_; // one set per component
  double feature_weight_;

  std::vector<Neighbors> neighbors() const
  {
    std::vector<Neighbors> result(fractions_.fraction.size());
    const auto add = [&](const Neighbor& n) {
      const auto [a, b] = n.leaves;
      const Index i = component_of_leaf_[a], j = component_of_leaf_[b];
      if (i == j)
        return;
      result[i][j].add(n);
      result[j][i].add({n.contact, n.squared_gap, {b, a}, n.contact, n.squared_gap});
    };
    std::vector<Index> set = result_.leaf; // of each face; none for surroundings
    Index inside = null_index;             // a leaf that is not in the surroundings
    for (Index& leaf : set)
      if (fractions_.is_surrounding[component_of_leaf_[leaf]])
        leaf = null_index;
      else
        inside = leaf;
    const auto count_steps = [&](std::size_t number) { monitor_.count_steps(number); };
    for (const Set_contact& c : set_contacts(mesh_, set, count_steps)) {
      count_steps(1000); // the cost of a map
      const auto [a, b] = c.sets;
      add({c.area, c.squared_gap, {a, b}, c.area, c.squared_gap});
    }
    for (Index leaf = 0; leaf < component_of_leaf_.size(); ++leaf)
      if (fractions_.is_surrounding[component_of_leaf_[leaf]])
        add({0, largest_gap, {leaf, inside}, 0, largest_gap});
    return result;
  }

  // Adds the merges of the components. Ties go to the set with the fewest neighbors, so that
  // thousands at one place are merged in nearly linear time.
  void add_merges(std::vector<Neighbors> neighbors)
  {
    typedef std::tuple<double, std::size_t, Index> Key; // area, number of neighbors, and the set
    std::vector<double> area = fractions_.fraction;
    std::vector<Key> key(area.size());
    std::set<Key> sets, isolated;
    const auto insert = [&](std::set<Key>& into, Index i) {
      key[i] = {quantized(area[i]), neighbors[i].size(), i};
      into.insert(key[i]);
    };
    double tiny = 0;
    for (Index i = 0; i < area.size(); ++i) {
      insert(sets, i);
      if (!fractions_.is_surrounding[i])
        tiny = (std::max)(tiny, fraction_at_threshold * area[i]);
    }
    const auto join = [&](Index a, Index b, double salience) {
      monitor_.count_steps(100 * neighbors[a].size());
      const Neighbor& seam = neighbors[a].at(b);
      result_.merges.push_back({{seam.leaves[0], seam.leaves[1]}, quantized(salience), {}});
      sets.erase(key[b]);
      isolated.erase(key[b]);
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
        : Feature_logit().component_term(features_.distance(a, b), explained_variance,
                                         feature_weight_);
    };
    const auto is_better = [](const auto& x, const auto& y) { // contact, then the gap
      return std::make_pair(x.second.contact, -x.second.squared_gap) <
             std::make_pair(y.second.contact, -y.second.squared_gap);
    };
    while (sets.size() + isolated.size() > 1) {
      const bool are_all_isolated = sets.empty(); // and stay isolated when they are joined
      std::set<Key>& from = are_all_isolated ? isolated : sets;
      const Index a = std::get<2>(*from.begin());
      from.erase(from.begin());
      const auto best = std::max_element(neighbors[a].begin(), neighbors[a].end(), is_better);
      const Index b = best->first;
      if (!are_all_isolated && best->second.contact == 0 && !(area[a] < tiny)) {
        insert(isolated, a);
        continue;
      }
      join(a, b, are_all_isolated ? std::numeric_limits<double>::infinity()
                                  : salience_of_component(area[a], logit_of_features(a, b)));
      insert(from, b);
    }
  }

  // Returns whether each component has too little evidence to be cut; false if its saliences are
  // not probabilities.
  std::vector<char> are_uncut(std::size_t number_of_cuts) const
  {
    const std::size_t n = fractions_.fraction.size();
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
    const double discount = features_.empty() ? 0 : Feature_logit::shape_discount(feature_weight_);
    const double required = (1 - discount) * required_evidence(fractions_.effective_number());
    for (std::size_t i = 0; i < n; ++i)
      result.push_back(are_probabilities[i] && evidence[i] < required);
    return result;
  }

  // Shifts the logits of the first merges, which are the cuts of components, in each component that
  // stays uncut, so that the highest lies below all later merges and below the default threshold.
  void lower_cuts(std::size_t number_of_cuts)
  {
    const std::vector<char> is_uncut = are_uncut(number_of_cuts);
    double least = default_probability_threshold;
    for (std::size_t i = number_of_cuts; i < result_.merges.size(); ++i)
      least = (std::min)(least, result_.merges[i].salience);
    std::vector<double> highest(is_uncut.size(), 0);
    for (std::size_t i = 0; i < number_of_cuts; ++i) {
      double& maximum = highest[component_of_leaf_[result_.merges[i].leaves[0]]];
      maximum = (std::max)(maximum, result_.merges[i].salience);
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
  // Takes the tree that makes each component one set, the mesh, whose faces have areas, the
  // fractions of its area that the components have, and their features.
  Component_merging(Merge_tree tree, const Surface& mesh, const Component_fractions& fractions,
                    Set_features features, double feature_weight, Run_monitor& monitor)
    : mesh_(mesh), fractions_(fractions), monitor_(monitor), result_(std::move(tree)),
      component_of_leaf_(result_.leaves.size()), features_(std::move(features)),
      feature_weight_(feature_weight)
  {
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      component_of_leaf_[result_.leaf[f]] = mesh.components[f];
  }

  // Returns the tree of the entire mesh.
  Merge_tree operator()()
  {
    const std::size_t number_of_cuts = result_.merges.size();
    if (fractions_.fraction.size() > 1)
      add_merges(neighbors());
    lower_cuts(number_of_cuts);
    std::stable_sort(result_.merges.begin(), result_.merges.end(),
                     [](const Merge& a, const Merge& b) { return a.salience < b.salience; });
    number_leaves(result_);
    result_.is_monotonic = true;
    return std::move(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_COMPONENT_MERGING_H
