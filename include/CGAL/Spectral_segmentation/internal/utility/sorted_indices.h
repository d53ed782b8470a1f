// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_UTILITY_SORTED_INDICES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_UTILITY_SORTED_INDICES_H

#include <CGAL/Spectral_segmentation/internal/utility/Index.h>
#include <CGAL/Spectral_segmentation/internal/utility/concurrency.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The indices of the values, the smallest value first; of equal ones those first that
// `is_first(i, j)` says. No NaN.
template <class Value, class IsFirst = std::less<Index> >
std::vector<Index> sorted_indices(Execution execution, const std::vector<Value>& values,
                                  const IsFirst& is_first = IsFirst())
{
  struct Entry // a value beside its index is in the cache
  {
    Value value;
    Index index;
  };
  std::vector<Entry> entries(values.size());
  for (Index i = 0; i < entries.size(); ++i)
    entries[i] = {values[i], i};
  sort(execution, entries.begin(), entries.end(), [&](const Entry& a, const Entry& b)
    { return a.value < b.value || (a.value == b.value && is_first(a.index, b.index)); });
  std::vector<Index> result(entries.size());
  for (Index i = 0; i < entries.size(); ++i)
    result[i] = entries[i].index;
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_UTILITY_SORTED_INDICES_H
