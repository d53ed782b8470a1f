// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SORTED_INDICES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SORTED_INDICES_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The indices of the values, the smallest value first; equal ones keep their order.
template <class Value>
std::vector<Index> sorted_indices(const std::vector<Value>& values)
{
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return values[a] < values[b]; });
  return order;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SORTED_INDICES_H
