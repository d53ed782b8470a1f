// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_BOUNDARY_SMOOTHING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_BOUNDARY_SMOOTHING_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the segment into which the face sticks as a tooth, with two of its edges, while the third
// leads to its own segment. Returns the face's own segment if it is no tooth.
inline std::size_t segment_around_tooth(const std::vector<Index>& neighbors,
                                        const std::vector<std::size_t>& labels, Index f)
{
  for (Index i = 0; i < 3; ++i) {
    const Index own = neighbors[3 * f + i];
    const std::size_t a = labels[neighbors[3 * f + (i + 1) % 3]];
    const std::size_t b = labels[neighbors[3 * f + (i + 2) % 3]];
    if (own != f && labels[own] == labels[f] && a == b)
      return a;
  }
  return labels[f];
}

// Smooths the boundaries between segments (Section 2, post-smoothing). A tooth goes to the segment
// into which it sticks, so that two edges of the boundary become one; then the face behind it may
// be a tooth. No segment is emptied or disconnected, because a tooth touches its own segment along
// one edge only. A morphological opening with the ball of radius two made boundaries longer, and
// they turned more from edge to edge. A duplicate face, whose neighbors are three times its
// original, keeps the label of that face.
inline void remove_teeth(const std::vector<Index>& neighbors, std::vector<std::size_t>& labels)
{
  std::vector<Index> faces = first_indices(labels.size());
  std::vector<Index> duplicates; // and other faces with one neighbor, which are no teeth
  for (Index f : faces)
    if (neighbors[3 * f + 1] == neighbors[3 * f] && neighbors[3 * f + 2] == neighbors[3 * f] &&
        labels[f] == labels[neighbors[3 * f]])
      duplicates.push_back(f);
  while (!faces.empty()) {
    std::vector<Index> next; // faces with a neighbor that has changed
    for (Index f : faces) {
      const std::size_t label = segment_around_tooth(neighbors, labels, f);
      if (label == labels[f])
        continue;
      labels[f] = label;
      next.insert(next.end(), neighbors.begin() + 3 * f, neighbors.begin() + 3 * f + 3);
    }
    faces.swap(next);
  }
  for (Index f : duplicates)
    labels[f] = labels[neighbors[3 * f]];
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_BOUNDARY_SMOOTHING_H
