// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SORTED_INDICES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SORTED_INDICES_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The indices of the keys, the smallest key first; of equal ones those first that `is_first(i, j)`
// says.
template <class ConcurrencyTag, class Integer, class IsFirst>
std::vector<Index> sorted_by_key(std::vector<std::pair<Integer, Index> >& keys,
                                 const IsFirst& is_first)
{
  typedef std::pair<Integer, Index> Key;
  // The lower and the upper half, more or less, are sorted in two threads.
  auto middle = keys.begin();
  if (is_parallel<ConcurrencyTag> && keys.size() > 10000) {
    std::vector<Integer> sample;
    for (std::size_t i = 0; i < keys.size(); i += keys.size() / 100)
      sample.push_back(keys[i].first);
    std::nth_element(sample.begin(), sample.begin() + 50, sample.end());
    middle = std::partition(keys.begin(), keys.end(),
                            [pivot = sample[50]](const Key& k) { return k.first < pivot; });
  }
  for_each_index<ConcurrencyTag>(2, [&](std::size_t half) {
    const auto end = half == 0 ? middle : keys.end();
    auto first = half == 0 ? keys.begin() : middle;
    boost::sort::spreadsort::integer_sort(
      first, end, [](const Key& k, unsigned offset) { return k.first >> offset; },
      [](const Key& a, const Key& b) { return a.first < b.first; });
    while (first != end) { // equal keys are in any order
      const auto equal = first;
      first = std::find_if(equal, end, [&](const Key& k) { return k.first != equal->first; });
      std::sort(equal, first,
                [&](const Key& a, const Key& b) { return is_first(a.second, b.second); });
    }
  });
  std::vector<Index> order(keys.size());
  for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) { order[i] = keys[i].second; });
  return order;
}

// The indices of the values, the smallest value first; equal ones keep their order. No NaN.
template <class ConcurrencyTag = Sequential_tag>
std::vector<Index> sorted_indices(const std::vector<float>& values)
{
  std::vector<std::pair<std::int32_t, Index> > keys(values.size());
  for (Index i = 0; i < keys.size(); ++i) {
    const float value = values[i] + 0.f; // no negative zero
    std::int32_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    keys[i] = {bits < 0 ? bits ^ 0x7fffffff : bits, i}; // in the order of the values
  }
  return sorted_by_key<ConcurrencyTag>(keys, std::less<Index>());
}

// The same of distances, which are on a grid, or of their differences.
template <class ConcurrencyTag = Sequential_tag, class IsFirst = std::less<Index> >
std::vector<Index> sorted_by_distance(const std::vector<double>& distances,
                                      const IsFirst& is_first = IsFirst())
{
  std::vector<std::pair<std::int64_t, Index> > keys(distances.size());
  for (Index i = 0; i < keys.size(); ++i)
    keys[i] = {static_cast<std::int64_t>(distances[i] / grid_step), i};
  return sorted_by_key<ConcurrencyTag>(keys, is_first);
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SORTED_INDICES_H
