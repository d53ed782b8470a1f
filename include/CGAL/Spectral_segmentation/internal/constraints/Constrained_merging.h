// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_MERGING_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes a tree that satisfies the constraints from one that does not.
//
// First it cuts leaves into regions until no region, and no regions that a set of groups joins,
// hold separated sets. Then it merges the regions of each set. Then it undoes the cuts of the
// tree, the least salient first: if a region on one side of a cut can be merged with a region
// on the other side, they are merged with the salience of the cut. The regions that remain at the
// end are the roots.
class Constrained_merging
{
  // A region that joins two sets that must be separate, or two sets on a path between such sets.
  struct Conflict
  {
    Index region = null_index, sets[2] = {null_index, null_index};
  };

  const Surface& mesh_;
  const Constraint_groups& groups_;
  const double minimum_area_;
  Run_monitor& monitor_;
  const Merge_tree tree_;

  std::vector<Index> region_;         // one per face
  std::vector<Index> leaf_of_region_;
  std::map<Index, std::set<Index> > regions_of_, sets_in_; // one per set, and one per region

  Separated_sets regions_;
  std::vector<double> areas_;
  std::vector<std::map<Index, double> > lengths_; // the boundary with each neighbor
  Merge_tree result_;                             // its leaves are regions
  std::vector<Index> leaf_;                       // one per region that is not merged

  // Divides leaves into connected regions between forced boundaries.
  void split_at_seams()
  {
    std::vector<char> is_cut(tree_.leaves.size(), 0);
    for (Index f : groups_.faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (groups_.is_seam[h] && tree_.leaf[f] == tree_.leaf[mesh_.neighbor(h)])
          is_cut[tree_.leaf[f]] = 1;
    Disjoint_sets pieces(region_.size());
    for (Index f = 0; f < region_.size(); ++f)
      if (is_cut[region_[f]])
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (!groups_.is_seam[h] && region_[mesh_.neighbor(h)] == region_[f])
            pieces.join(f, mesh_.neighbor(h));
    std::map<Index, Index> region_of_piece;
    for (Index f = 0; f < region_.size(); ++f)
      if (is_cut[tree_.leaf[f]]) {
        const auto [piece, is_new] = region_of_piece.emplace(
          pieces.representative(f), static_cast<Index>(leaf_of_region_.size()));
        if (is_new)
          leaf_of_region_.push_back(tree_.leaf[f]);
        region_[f] = piece->second;
      }
  }

  // Returns a region to cut on the shortest path over regions and sets from one set to another.
  Conflict conflict_between(Index from, Index to) const
  {
    std::map<Index, Conflict> previous = {{from, {}}};
    std::vector<Index> reached(1, from);
    for (std::size_t i = 0; !previous.count(to); ++i)
      for (Index region : regions_of_.at(reached[i]))
        for (Index set : sets_in_.at(region))
          if (previous.emplace(set, Conflict{region, {reached[i], set}}).second)
            reached.push_back(set);
    return previous.at(to);
  }

  // Returns a conflict; its region is null_index if there is none.
  Conflict find_conflict()
  {
    regions_of_.clear();
    sets_in_.clear();
    for (Index f : groups_.faces) {
      regions_of_[groups_.set(f)].insert(region_[f]);
      sets_in_[region_[f]].insert(groups_.set(f));
    }
    Separated_sets joined(groups_.sets.number()); // the sets that regions join
    for (const auto& in_region : sets_in_)
      for (Index set : in_region.second)
        joined.merge(*in_region.second.begin(), set);
    std::map<Index, Index> seeded; // a set with a seed for sets that are joined
    for (const auto& entry : regions_of_) {
      const Index a = entry.first, root = joined.representative(a);
      for (Index b : groups_.sets.separated_from(a))
        if (joined.representative(b) == root)
          return conflict_between(a, b);
      if (groups_.sets.seed(a) != null_index)
        if (const Index b = seeded.emplace(root, a).first->second; b != a)
          return conflict_between(a, b);
    }
    return {};
  }

  // Cuts a region between two sets. Each face joins the set that is fewer faces away. Unless both
  // sets have seeds, this ends where one of them reaches another region, with which it can be
  // merged; then the rest stays with the other set. Other sets in the region are not cut.
  void cut(const Conflict& conflict)
  {
    constexpr Index stays = null_index;
    const Index region = conflict.region, new_region = static_cast<Index>(leaf_of_region_.size());
    const Index labels[2] = {new_region, new_region + 1}; // while the region is cut
    std::map<Index, std::vector<Index> > faces_of_set;    // within the region
    for (Index f : groups_.faces)
      if (region_[f] == region)
        faces_of_set[groups_.set(f)].push_back(f);
    std::vector<Index> reached;
    const auto reach = [&](Index f, Index label) {
      if (region_[f] != region)
        return;
      const std::vector<Index> all =
        groups_.group[f] == null_index ? std::vector<Index>(1, f) : faces_of_set.at(groups_.set(f));
      for (Index g : all)
        region_[g] = label;
      reached.insert(reached.end(), all.begin(), all.end());
    };
    bool are_seeds = true;
    for (int i : {0, 1}) {
      are_seeds = are_seeds && groups_.sets.seed(conflict.sets[i]) != null_index;
      reach(faces_of_set.at(conflict.sets[i]).front(), labels[i]);
    }
    Index label = labels[0]; // the label of the faces that are cut off
    bool is_at_end = false;
    for (std::size_t i = 0; i < reached.size() && !is_at_end; ++i) {
      const Index f = reached[i];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (groups_.is_seam[h])
          continue;
        const Index r = region_[mesh_.neighbor(h)];
        reach(mesh_.neighbor(h), region_[f]);
        is_at_end |= !are_seeds && r != region && r != labels[0] && r != labels[1];
      }
      label = is_at_end ? region_[f] : label;
    }

    for (Index f : std::exchange(reached, {}))
      if (region_[f] != label)
        region_[f] = region;
    reach(faces_of_set.at(conflict.sets[label == labels[0] ? 1 : 0]).front(), stays);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
        reach(mesh_.neighbor(h), stays);
    for (Index& r : region_)
      r = r == stays ? region : r == region || r == label ? new_region : r;
    leaf_of_region_.push_back(Index(leaf_of_region_[region]));
  }

  void merge_regions(Index a, Index b)
  {
    const auto [into, from] =
      std::minmax({regions_.representative(a), regions_.representative(b)});
    if (into == from)
      return;
    regions_.merge(into, from);
    areas_[into] += areas_[from];
    for (const auto& [c, length] : std::exchange(lengths_[from], {})) {
      lengths_[c].erase(from);
      if (c != into) {
        lengths_[c][into] += length;
        lengths_[into][c] += length;
      }
    }
  }

  // Sets the data of regions, and merges the regions of each set.
  void set_regions()
  {
    regions_ = Separated_sets(leaf_of_region_.size());
    areas_.assign(leaf_of_region_.size(), 0);
    lengths_.resize(leaf_of_region_.size());
    for (Index f = 0; f < region_.size(); ++f) {
      areas_[region_[f]] += mesh_.areas[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (const Index b = region_[mesh_.neighbor(h)]; b != region_[f])
          lengths_[region_[f]][b] += groups_.is_seam[h] ? 0 : mesh_.length(h);
    }
    for (const auto& [set, regions] : regions_of_)
      for (Index region : regions)
        merge_regions(*regions.begin(), region);
    for (const auto& [set, regions] : regions_of_) {
      if (groups_.sets.seed(set) != null_index)
        regions_.set_seed(*regions.begin(), groups_.sets.seed(set));
      for (Index other : groups_.sets.separated_from(set))
        regions_.separate(*regions.begin(), *regions_of_.at(other).begin());
    }
  }

  // Returns the neighbor with which a region can be merged along the longest boundary, and its
  // length; null_index if there is none. If `among` is given, the neighbor is one of these.
  std::pair<Index, double> longest_neighbor(Index a, const std::set<Index>* among = nullptr) const
  {
    std::pair<Index, double> result(null_index, -1);
    for (const auto& [b, length] : lengths_[a])
      if (quantized(length) > result.second && (!among || among->count(b)) &&
          !regions_.are_separated(a, b))
        result = {b, quantized(length)};
    return result;
  }

  // Merges each region beside a forced boundary that is small, or a strip along another boundary,
  // with its neighbor, because the forced boundary is meant to be the boundary.
  void merge_small_regions()
  {
    constexpr double area_of_strip = 0.1; // relative to the square of the length of the boundary
    for (Index a = 0; a < lengths_.size(); ++a)
      if (!lengths_[a].empty() && !regions_.separated_from(a).empty())
        if (const auto [b, length] = longest_neighbor(a);
            b != null_index &&
            areas_[a] < (std::max)(minimum_area_, area_of_strip * length * length))
          merge_regions(a, b);
  }

  std::set<Index> representatives(const std::set<Index>& regions) const
  {
    std::set<Index> result;
    for (Index a : regions)
      result.insert(regions_.representative(a));
    return result;
  }

  // Makes the remaining regions the leaves of the result.
  void set_leaves()
  {
    leaf_.assign(leaf_of_region_.size(), null_index);
    std::vector<char> has_face(leaf_.size(), 0);
    for (Index& r : region_) {
      r = regions_.representative(r);
      has_face[r] = 1;
    }
    for (Index r = 0; r < leaf_.size(); ++r)
      if (has_face[r]) {
        leaf_[r] = static_cast<Index>(result_.leaves.size());
        result_.leaves.push_back({areas_[r]});
      }
    for (Index r : region_)
      result_.leaf.push_back(leaf_[r]);
  }

  // Merges regions by `merge(a, b)` until no two that touch can be merged, first along the longest
  // boundary.
  template <class Merge>
  void merge_all(std::set<Index>& regions, const Merge& merge) const
  {
    regions = representatives(regions);
    while (regions.size() > 1) {
      std::pair<double, std::pair<Index, Index> > best(-1, {null_index, null_index});
      for (Index a : regions)
        if (const auto [b, length] = longest_neighbor(a, &regions); length > best.first)
          best = {length, {a, b}};
      if (best.first < 0)
        return;
      merge(best.second.first, best.second.second);
      regions = representatives(regions);
    }
  }

  // Merges the regions on the two sides of a cut if each side has one region, otherwise adjacent
  // regions. All regions of different components count as adjacent. Returns the remaining regions.
  std::set<Index> undo(const Merge& cut, const std::vector<Index>& component,
                       const std::set<Index>& one, const std::set<Index>& other)
  {
    const std::set<Index> first = representatives(one), second = representatives(other);
    const bool are_single = first.size() == 1 && second.size() == 1;
    if (are_single || component[*first.begin()] != component[*second.begin()])
      for (Index a : first)
        for (Index b : second)
          if (a != b)
            lengths_[b][a] = lengths_[a][b];
    std::set<Index> all = first;
    all.insert(second.begin(), second.end());
    merge_all(all, [&](Index a, Index b) {
      result_.merges.push_back({{leaf_[a], leaf_[b]}, cut.salience, cut.factors});
      merge_regions(a, b);
    });
    return all;
  }

public:
  // Takes cuts whose leaves, like the groups of each set, are connected in each component.
  Constrained_merging(Merge_tree tree, const Surface& mesh, const Constraint_groups& groups,
                      double minimum_segment_size, Run_monitor& monitor)
    : mesh_(mesh), groups_(groups), minimum_area_(minimum_segment_size * total_area(mesh)),
      monitor_(monitor), tree_(std::move(tree)), region_(tree_.leaf)
  {
    for (Index i = 0; i < tree_.leaves.size(); ++i)
      leaf_of_region_.push_back(i);
  }

  Merge_tree operator()()
  {
    split_at_seams();
    for (Conflict c = find_conflict(); c.region != null_index; c = find_conflict()) {
      monitor_.go_further(); // may throw
      cut(c);
    }
    set_regions();
    merge_small_regions();
    std::vector<Index> component(leaf_of_region_.size(), null_index); // one per region
    std::vector<std::set<Index> > below(tree_.leaves.size()); // the regions in each set of leaves
    for (Index f = 0; f < region_.size(); ++f)
      if (Index& entry = component[region_[f]]; entry == null_index) {
        entry = mesh_.components[f];
        below[leaf_of_region_[region_[f]]].insert(region_[f]);
      }
    for (std::set<Index>& regions : below)
      merge_all(regions, [this](Index a, Index b) { merge_regions(a, b); });
    set_leaves();
    const Merged_sets sets(tree_);
    for (std::size_t i = 0; i < tree_.merges.size(); ++i) {
      const Index a = sets.sides[i][0].leaf, b = sets.sides[i][1].leaf;
      below[a] = undo(tree_.merges[i], component, below[a], below[b]);
    }
    result_.is_monotonic = true;
    result_.has_all_cuts = tree_.has_all_cuts;
    return std::move(result_);
  }
};

// Changes the tree so that it satisfies the constraints. Joins the groups of each set by faces.
inline Merge_tree enforce_constraints(Merge_tree tree, Constraint_groups& groups,
                                      const Level& mesh, const Run_data& d)
{
  if (groups.faces.empty())
    return tree;
  const std::size_t number_of_roots = tree.number_of_roots();
  groups = Group_connection(mesh.surface, tree.leaf, tree.leaves.size(), groups)(mesh.parent_face);
  tree = Constrained_merging(std::move(tree), mesh.surface, groups,
                             d.options.minimum_segment_size, d.monitor)();
  const std::size_t number = tree.number_of_roots(), maximum = maximum_number(d.options);
  if (number > number_of_roots && number > maximum)
    throw std::invalid_argument(
      "segment_spectral_recursive: the constrained edges and seeds need " +
      std::to_string(number) + " segments, but " + std::to_string(maximum) + " are allowed");
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_MERGING_H
