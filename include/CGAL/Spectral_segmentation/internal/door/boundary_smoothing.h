// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_BOUNDARY_SMOOTHING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_BOUNDARY_SMOOTHING_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Smooths the boundaries between segments (Section 2, post-smoothing). A tooth, a face with two edges
// to another segment while the third leads to its own, goes to that segment, so that two edges of
// the boundary become one; then the face behind it may be a tooth. As a tooth touches its own segment
// along one edge only, no segment is emptied or disconnected. A morphological opening with the ball
// of radius two made boundaries longer, and they turned more from edge to edge.
//
// `opposite` is that of the half-edges of a surface. The faces that constraints name stay.
inline void remove_teeth(const std::vector<Index>& opposite, const Constraints& constraints,
                         std::vector<std::size_t>& labels)
{
  std::vector<char> is_fixed(labels.size(), 0);
  for (const auto& pairs : {&constraints.seams, &constraints.uncuttable})
    for (const auto& [f, g] : *pairs)
      is_fixed[f] = is_fixed[g] = 1;
  for (const auto& seed : constraints.seeds)
    is_fixed[seed.first] = 1;
  const auto label_across = [&](Index f, Index i) { return labels[opposite[3 * f + i % 3] / 3]; };
  std::vector<Index> faces(labels.size());
  std::iota(faces.begin(), faces.end(), Index(0));
  while (!faces.empty()) {
    std::vector<Index> next; // which have a neighbor that has changed
    for (Index f : faces)
      for (Index i = 0; i < 3 && !is_fixed[f]; ++i) {
        const std::size_t other = label_across(f, i + 1);
        if (opposite[3 * f + i] == 3 * f + i || label_across(f, i) != labels[f] ||
            other == labels[f] || other != label_across(f, i + 2))
          continue;
        labels[f] = other;
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          next.push_back(opposite[h] / 3);
        break;
      }
    faces.swap(next);
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_BOUNDARY_SMOOTHING_H
