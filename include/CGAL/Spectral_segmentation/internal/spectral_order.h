// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SPECTRAL_ORDER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SPECTRAL_ORDER_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/sorted_indices.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The faces in the order of the ratio e2 / e1 of the eigenvectors (`spectral_embedding()`), from s
// to t, by their distances from both (Section 5.3).
//
// Both eigenvectors are linear in the affinities x and y of a face to s and t, so the ratio is a
// monotone function of x / y, that is, of the distance from s minus that from t. Sorting by this
// difference needs no kernel and does not underflow. Where it ties, as along a limb that leaves the
// way from s to t, the face nearer to s comes first.
template <class ConcurrencyTag = Sequential_tag>
std::vector<Index> spectral_order(const std::vector<double>& from_s,
                                  const std::vector<double>& from_t)
{
  std::vector<double> difference(from_s.size());
  for (std::size_t f = 0; f < difference.size(); ++f)
    difference[f] = from_s[f] - from_t[f];
  return sorted_by_distance<ConcurrencyTag>(difference, [&](Index f, Index g)
    { return from_s[f] < from_s[g] || (from_s[f] == from_s[g] && f < g); });
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SPECTRAL_ORDER_H
