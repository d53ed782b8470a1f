// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constrained_regions.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Replays the merges of a dendrogram with regions that fulfill constraints in place of the leaves.
// Where a merge has a region on one side that can be merged with one on the other, they are merged
// with its salience, so what no constraint concerns is merged as before. Regions that must be apart
// stay so.
class Constrained_merging
{
  typedef std::set<Index> Regions;

  const Dendrogram& old_;
  Region_graph& regions_;
  Dendrogram result_;

  // Two regions, each known by itself; `k` is the merge of the old dendrogram.
  void merge(Index a, Index b, std::size_t k)
  {
    if (k < old_.merges.size()) {
      if (quantized(regions_.area(b)) < quantized(regions_.area(a)))
        std::swap(a, b);
      Merge m = old_.merges[k];
      m.leaves[0] = a;
      m.leaves[1] = b;
      result_.merges.push_back(m);
    }
    regions_.merge(a, b);
  }

  Regions merged(const Regions& regions)
  {
    Regions result;
    for (Index a : regions)
      result.insert(regions_[a]);
    return result;
  }

  // Merges regions that touch as long as some can be.
  Regions merge_all(Regions regions, std::size_t k)
  {
    while (const auto pair = regions_.longest_boundary(regions)) {
      merge(pair->first, pair->second, k);
      regions = merged(regions);
    }
    return regions;
  }

public:
  Constrained_merging(const Dendrogram& old, Region_graph& regions)
    : old_(old), regions_(regions) {}

  // `region` is that of each face; `leaves` has the old leaves of which each region was made.
  Dendrogram operator()(const Surface& surface, const std::vector<Index>& region,
                        const std::vector<std::set<Index> >& leaves)
  {
    std::vector<Regions> below(old_.number_of_leaves());
    for (Index r = 0; r < leaves.size(); ++r)
      for (Index leaf : leaves[r])
        below[leaf].insert(r);
    // Undoes cuts inside a leaf that no constraint needs, for good.
    for (Regions& of_leaf : below)
      of_leaf = merge_all(merged(of_leaf), old_.merges.size());
    result_ = Dendrogram();
    result_.is_ultrametric = old_.is_ultrametric;
    result_.is_complete = old_.is_complete;
    for (Index r : region)
      result_.leaf.push_back(regions_[r]);
    replay(old_, below, [&](std::size_t k, const Regions& a, const Regions& b) {
      Regions both = merged(a);
      const Regions other = merged(b);
      // They need not touch.
      if (both.size() == 1 && other.size() == 1 && both != other &&
          !regions_.are_apart(*both.begin(), *other.begin()))
        merge(*both.begin(), *other.begin(), k);
      both.insert(other.begin(), other.end());
      return merge_all(merged(both), k);
    });
    result_.areas.resize(leaves.size());
    set_areas(surface, result_);
    number_leaves_by_first_faces(result_);
    return std::move(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_H
