// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_MERGING_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Region_graph.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges regions that satisfy constraints, in the order in which the cuts of the old hierarchy are
// undone, the least salient first. If a region on one side of an old cut can be merged with a
// region on the other side, they are merged with the salience of the cut. Unconstrained regions are
// merged as before. Regions that a constraint keeps apart are not merged. The regions that remain
// at the end are the roots.
class Constrained_merging
{
  const Cut_hierarchy& old_;
  Region_graph& regions_;
  const std::vector<Index>& region_of_face_;
  std::vector<std::set<Index> > below_; // one per node of the old hierarchy: its regions
  Dendrogram result_;                   // its leaves are regions

  void merge(Index a, Index b, std::size_t old_node)
  {
    const Cut_node& old = old_.nodes[old_node];
    result_.merges.push_back({{a, b}, old.salience, old.factors});
    regions_.merge(a, b);
  }

  // Merges the two sides of a cut if each is one region, otherwise the regions that touch.
  void merge_below(std::size_t node)
  {
    std::set<Index>& all = below_[node];
    if (!old_.nodes[node].is_leaf()) {
      const std::size_t (&children)[2] = old_.nodes[node].children;
      const std::set<Index> first = regions_.representatives(below_[children[0]]);
      const std::set<Index> second = regions_.representatives(below_[children[1]]);
      if (first.size() == 1 && second.size() == 1 && *first.begin() != *second.begin() &&
          !regions_.are_apart(*first.begin(), *second.begin()))
        merge(*first.begin(), *second.begin(), node);
      all = first;
      all.insert(second.begin(), second.end());
    }
    all = regions_.representatives(all);
    for (Face_pair pair = regions_.longest_boundary(all); pair[0] != null_index;
         pair = regions_.longest_boundary(all)) {
      merge(pair[0], pair[1], node);
      all = regions_.representatives(all);
    }
  }

  // Merges the regions that constraints made of one leaf for good, as far as the constraints allow.
  // What is left are the leaves of the result.
  void merge_in_leaves()
  {
    for (std::size_t i = 0; i < old_.nodes.size(); ++i)
      if (old_.nodes[i].is_leaf())
        merge_below(i);
    result_.merges.clear();
    for (Index r : region_of_face_)
      result_.leaf.push_back(regions_.representative(r));
    for (Index r = 0; r < regions_.number(); ++r)
      result_.areas.push_back(regions_.area(regions_.representative(r)));
  }

public:
  // `leaves` holds for each region the leaves of the old hierarchy from which it was made. The call
  // of the object merges `regions`.
  Constrained_merging(const Cut_hierarchy& old, Region_graph& regions,
                      const std::vector<Index>& region_of_face,
                      const std::vector<std::set<std::size_t> >& leaves)
    : old_(old), regions_(regions), region_of_face_(region_of_face), below_(old.nodes.size())
  {
    // A region that lost its only face to a group is no leaf.
    for (Index r : std::set<Index>(region_of_face.begin(), region_of_face.end()))
      for (std::size_t leaf : leaves[r])
        below_[leaf].insert(r);
  }

  Cut_hierarchy operator()()
  {
    merge_in_leaves();
    for (std::size_t i = old_.cut_order.size(); i-- > 0;)
      if (!old_.nodes[old_.cut_order[i]].is_leaf())
        merge_below(old_.cut_order[i]);
    result_.has_all_cuts = old_.has_all_cuts;
    return hierarchy_of(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_MERGING_H
