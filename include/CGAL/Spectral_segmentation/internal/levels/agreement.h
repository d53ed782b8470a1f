// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_AGREEMENT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_AGREEMENT_H

#include <CGAL/Spectral_segmentation/internal/levels/Band_cells.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the segment of each face of a surface, given the segments of the faces of a coarser one
// and the coarse vertex that each vertex became: the segment of most faces around the corners.
inline std::vector<Index> segments_of_finer_faces(const Surface& finer, const Surface& coarse,
                                                  const std::vector<Index>& segments,
                                                  const std::vector<Index>& coarse_vertex)
{
  const Leaf_fractions around = vertex_fractions(coarse, segments);
  Leaf_fractions of_faces;
  std::vector<Index> result;
  for (const Corners& corners : finer.corners) {
    of_faces.add_element();
    for (Index v : corners)
      if (coarse_vertex[v] != null_index)
        for (const auto& [segment, fraction] : around[coarse_vertex[v]])
          of_faces.add(segment, fraction);
    float largest = 0;
    Index best = null_index; // ties, up to rounding, go to the first segment
    for (const auto& [segment, fraction] : of_faces[result.size()])
      if (fraction > largest * (segment < best ? 0.99999f : 1.00001f)) {
        largest = fraction;
        best = segment;
      }
    result.push_back(best);
  }
  return result;
}

// Returns the panoptic quality of two partitions of faces (Kirillov et al. 2019): the intersections
// over unions of segments that exceed 1/2, summed, over the mean number of segments.
inline double panoptic_quality(const std::vector<Index>& first, const std::vector<Index>& second,
                               const std::vector<double>& areas)
{
  std::map<Index, double> of_first, of_second;
  std::map<std::pair<Index, Index>, double> common;
  for (std::size_t f = 0; f < areas.size(); ++f)
    if (areas[f] > 0) {
      of_first[first[f]] += areas[f];
      of_second[second[f]] += areas[f];
      common[{first[f], second[f]}] += areas[f];
    }
  double sum = 0;
  for (const auto& [segments, both] : common) {
    const double any = of_first[segments.first] + of_second[segments.second] - both;
    sum += 2 * both > any ? both / any : 0;
  }
  return of_first.empty() ? 1 : 2 * sum / static_cast<double>(of_first.size() + of_second.size());
}

// Returns the first partition with the largest sum of panoptic qualities with the others.
inline std::size_t most_agreed(const std::vector<std::vector<Index> >& partitions,
                               const std::vector<double>& areas)
{
  std::vector<double> sums(partitions.size(), 0);
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double quality = quantized(panoptic_quality(partitions[i], partitions[j], areas));
      sums[i] += quality;
      sums[j] += quality;
    }
  return static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_AGREEMENT_H
