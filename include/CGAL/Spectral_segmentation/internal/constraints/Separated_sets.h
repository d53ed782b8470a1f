// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SEPARATED_SETS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SEPARATED_SETS_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Sets that are merged, and pairs of them that must not be. Sets with different seeds are apart,
// too. A set is represented by the lowest of its indices.
class Separated_sets
{
  mutable std::vector<Index> merged_into_; // paths become shorter whenever they are followed
  std::vector<Index> seed_;
  std::vector<std::set<Index> > apart_; // the sets from which each representative is apart

public:
  explicit Separated_sets(std::size_t number = 0)
    : merged_into_(number), seed_(number, null_index), apart_(number)
  { std::iota(merged_into_.begin(), merged_into_.end(), Index(0)); }

  std::size_t number() const { return merged_into_.size(); }

  Index representative(Index a) const
  {
    while (merged_into_[a] != a)
      a = merged_into_[a] = merged_into_[merged_into_[a]];
    return a;
  }

  Index seed(Index a) const { return seed_[representative(a)]; }
  void set_seed(Index a, Index seed) { seed_[representative(a)] = seed; }

  // Returns the sets from which a set is apart, but for those with other seeds.
  const std::set<Index>& apart_from(Index a) const { return apart_[representative(a)]; }

  void separate(Index a, Index b)
  {
    a = representative(a);
    b = representative(b);
    apart_[a].insert(b);
    apart_[b].insert(a);
  }

  bool are_apart(Index a, Index b) const
  {
    a = representative(a);
    b = representative(b);
    return apart_[a].count(b) > 0 ||
           (seed_[a] != null_index && seed_[b] != null_index && seed_[a] != seed_[b]);
  }

  void merge(Index a, Index b)
  {
    const auto [into, from] = std::minmax({representative(a), representative(b)});
    if (into == from)
      return;
    merged_into_[from] = into;
    seed_[into] = (std::min)(seed_[into], seed_[from]);
    for (Index c : apart_[from]) {
      apart_[c].erase(from);
      apart_[c].insert(into);
      apart_[into].insert(c);
    }
    apart_[from].clear();
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SEPARATED_SETS_H
