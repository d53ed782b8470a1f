// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_REGION_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_REGION_MERGING_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges the regions of an over-segmentation. It joins the two neighbors with the least salient
// common boundary until each component of the mesh is one region. This also undoes cuts that were
// needed only to reach other cuts. The merges in reverse are a hierarchy of cuts. A cut may be more
// salient than the cut above it.
class Region_merging
{
  typedef std::pair<Index, Index> Pair; // two regions, the lower index first

  const Execution execution_;
  const Surface& mesh_;
  const Evaluation_context& context_;
  const Part_salience part_salience_; // gives the order in which boundaries are merged
  const Part_salience& salience_of_cuts_;
  Run_monitor& monitor_;

  std::vector<std::vector<Index> > faces_; // one list per region, ascending
  std::vector<Index> region_;              // one per face
  double feature_reliability_ = 0;
  std::vector<Merge> merges_;              // possible merges of neighbors, the lower index first

  // Sets the factors of the boundary of two regions, which cuts their union, but for the numbers of
  // neighbors.
  void evaluate(Merge& merge) const
  {
    const std::vector<Index>& first = faces_[merge.leaves[0]];
    const std::vector<Index>& second = faces_[merge.leaves[1]];
    std::vector<Index> faces;
    std::merge(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(faces));
    Sides side;
    double area[2] = {0, 0};
    for (Index f : faces) {
      side.push_back(region_[f] == merge.leaves[0] ? 0 : 1);
      area[int(side.back())] += mesh_.areas[f];
    }
    normalize_sides(side, area);
    const Surface both = Part_extractor(mesh_)(faces);
    merge.factors = Cut_evaluator(both, faces, context_)(side, true);
    merge.factors.feature_reliability = feature_reliability_;
  }

  // Counts the neighbors of all pairs. Sets the saliences of the pairs whose numbers change, and of
  // all from the pair `first_new` on.
  void count_neighbors(std::size_t first_new)
  {
    std::vector<std::set<Index> > neighbors(faces_.size());
    for (const Merge& m : merges_) {
      neighbors[m.leaves[0]].insert(m.leaves[1]);
      neighbors[m.leaves[1]].insert(m.leaves[0]);
    }
    for (std::size_t i = 0; i < merges_.size(); ++i) {
      Merge& m = merges_[i];
      const std::set<Index> &first = neighbors[m.leaves[0]], &second = neighbors[m.leaves[1]];
      const auto common = static_cast<double>(std::count_if(
        first.begin(), first.end(), [&](Index region) { return second.count(region) > 0; }));
      const auto other = static_cast<double>((std::min)(first.size(), second.size()) - 1);
      if (i < first_new && m.factors.number_of_common_neighbors == common &&
          m.factors.number_of_other_neighbors == other)
        continue;
      m.factors.number_of_common_neighbors = common;
      m.factors.number_of_other_neighbors = other;
      m.salience = salience_of(part_salience_, m.factors);
    }
  }

  // Compares saliences. Ties go to the pair with the lower indices.
  static bool is_less_salient(const Merge& a, const Merge& b)
  {
    return std::make_tuple(quantized(a.salience), a.leaves[0], a.leaves[1]) <
           std::make_tuple(quantized(b.salience), b.leaves[0], b.leaves[1]);
  }

  // Sets the reliability of the features: the root of the mean, over all boundaries of the
  // over-segmentation, of the squared step times the fraction of the variance that the boundary
  // explains. Boundaries are weighted by the root of the area of their two sides.
  void set_feature_reliability()
  {
    if (context_.features.empty())
      return;
    double sum = 0, weights = 0;
    for (const Merge& m : merges_) {
      const double weight = std::exp(m.factors.log_relative_part_area / 2);
      weights += weight;
      sum += weight * m.factors.feature_step * m.factors.feature_step *
             m.factors.explained_variance;
    }
    feature_reliability_ = weights > 0 ? std::sqrt(sum / weights) : 0;
    for (Merge& m : merges_) {
      m.factors.feature_reliability = feature_reliability_;
      m.salience = salience_of(part_salience_, m.factors);
    }
  }

  // Evaluates the boundaries of a region with its neighbors, or of all regions.
  void evaluate_boundaries(const std::vector<Index>& faces)
  {
    std::set<Pair> neighbors;
    for (Index f : faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const auto [a, b] = std::minmax({region_[f], region_[mesh_.neighbor(h)]});
        if (a != b)
          neighbors.insert({a, b});
      }
    const std::size_t first = merges_.size();
    for (const auto& [a, b] : neighbors)
      merges_.push_back({{a, b}, 0, {}});
    for_each_index(execution_, neighbors.size(), [&](std::size_t i) {
      monitor_.go_further(); // may throw
      evaluate(merges_[first + i]);
    });
    count_neighbors(first);
  }

  void merge(Index into, Index from)
  {
    const auto touches = [into, from](const Merge& m) {
      const auto [first, second] = m.leaves;
      return first == into || second == into || first == from || second == from;
    };
    merges_.erase(std::remove_if(merges_.begin(), merges_.end(), touches), merges_.end());
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(faces_[into].size());
    faces_[into].insert(faces_[into].end(), faces_[from].begin(), faces_[from].end());
    std::inplace_merge(faces_[into].begin(), faces_[into].begin() + size, faces_[into].end());
    for (Index f : faces_[from])
      region_[f] = into;
    faces_[from].clear();
    evaluate_boundaries(faces_[into]);
  }

  // Merges until no regions are adjacent.
  std::vector<Merge> merge_all()
  {
    evaluate_boundaries(first_indices(mesh_.number_of_faces()));
    set_feature_reliability();
    std::vector<Merge> merges;
    while (!merges_.empty()) {
      merges.push_back(*std::min_element(merges_.begin(), merges_.end(), is_less_salient));
      merge(merges.back().leaves[0], merges.back().leaves[1]);
      monitor_.approach(1. / static_cast<double>(faces_.size()));
    }
    return merges;
  }

  // Returns the salience in whose order boundaries are merged: the salience of cuts, unless that is
  // the calibrated one.
  static Part_salience in_merging(const Part_salience& salience)
  {
    const auto* calibrated = salience.target<Calibrated_part_salience>();
    if (calibrated == nullptr)
      return salience;
    return [c = *calibrated](const Salience_factors& f) { return c.in_merging(f); };
  }

public:
  Region_merging(Execution execution, const Surface& mesh, const Evaluation_context& context,
                 const Part_salience& part_salience, Run_monitor& monitor)
    : execution_(execution), mesh_(mesh), context_(context),
      part_salience_(in_merging(part_salience)), salience_of_cuts_(part_salience),
      monitor_(monitor) {}

  // Returns the tree of all merges. Its leaves are the regions of an over-segmentation, numbered by
  // their first faces. `region` holds one region per face.
  Merge_tree operator()(const std::vector<Index>& region)
  {
    std::map<Index, Index> number;
    Merge_tree result;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const auto [entry, is_new] = number.emplace(region[f], static_cast<Index>(faces_.size()));
      if (is_new)
        faces_.emplace_back();
      region_.push_back(entry->second);
      faces_[entry->second].push_back(f);
    }
    result.leaf = region_;
    result.leaves.resize(faces_.size());
    set_areas_of_leaves(result, mesh_);
    result.merges = merge_all();
    for (Merge& m : result.merges)
      m.salience = salience_of(salience_of_cuts_, m.factors);
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_REGION_MERGING_H
