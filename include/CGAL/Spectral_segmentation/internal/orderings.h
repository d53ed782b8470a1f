// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ORDERINGS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ORDERINGS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/sampling.h>
#include <CGAL/Spectral_segmentation/internal/shortest_paths.h>
#include <CGAL/Spectral_segmentation/internal/sorted_indices.h>
#include <CGAL/Spectral_segmentation/internal/spectral_order.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The faces of a part in an order along which cuts are searched.
typedef std::vector<Index> Line;

// The spectral order of the two samples. From both its ends if candidates are taken, for these are
// on the first part of a line. Then, as the options ask for them, the orders by distance from each
// sample and each reference face, which grow a single limb where the pair sees several at once, and
// the orders from the thinnest face and from the thickest.
template <class ConcurrencyTag>
std::vector<Line> orderings(const Face_dual_graph& part, const std::vector<Index>& references,
                            const Sample_faces& samples, const Options& options)
{
  std::vector<Index> sources = {samples.s, samples.t};
  if (options.single_source_orderings)
    for (Index reference : references)
      if (reference != samples.s && reference != samples.t)
        sources.push_back(reference);
  std::vector<std::vector<double> > distances(sources.size());
  for_each_index<ConcurrencyTag>(sources.size(), [&](std::size_t i) {
    distances[i] = shortest_paths(part, sources[i], &Face_dual_graph::Halfedge::combined);
  });

  std::vector<Line> lines = {spectral_order<ConcurrencyTag>(distances[0], distances[1])};
  if (options.number_of_candidates > 0)
    lines.push_back(spectral_order<ConcurrencyTag>(distances[1], distances[0]));
  if (options.single_source_orderings)
    for (const std::vector<double>& distance : distances)
      lines.push_back(sorted_by_distance(distance));
  if (options.thickness_orderings) {
    lines.push_back(sorted_indices(part.thickness));
    lines.emplace_back(lines.back().rbegin(), lines.back().rend());
  }
  return lines;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ORDERINGS_H
