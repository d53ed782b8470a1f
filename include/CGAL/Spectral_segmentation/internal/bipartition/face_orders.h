// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_FACE_ORDERS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_FACE_ORDERS_H

#include <CGAL/Spectral_segmentation/internal/bipartition/shape_context_sampling.h>
#include <CGAL/Spectral_segmentation/internal/distances/shortest_paths.h>
#include <CGAL/Spectral_segmentation/internal/base/sorted_indices.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The faces of a part in an order along which cuts are searched: a cut is between the faces up to
// one of them and the rest.
typedef std::vector<Index> Face_order;

// The order of the 1-D spectral embedding, from s to t, by the distances from both (Section 5.3).
//
// The embedding of a face is the ratio e2 / e1 of the eigenvectors that Nystrom's method gives for
// two samples. Both are linear in the affinities x and y of a face to s and t, so the ratio is a
// monotone function of x / y, that is, of the distance from s minus that from t. Sorting by this
// difference needs no kernel and does not underflow. Where it ties, as along a limb that leaves the
// way from s to t, the face nearer to s comes first.
inline Face_order spectral_order(Execution execution, const std::vector<double>& from_s,
                                 const std::vector<double>& from_t)
{
  std::vector<double> difference(from_s.size());
  for (std::size_t f = 0; f < difference.size(); ++f)
    difference[f] = from_s[f] - from_t[f];
  return sorted_indices(execution, difference, [&](Index f, Index g)
    { return from_s[f] < from_s[g] || (from_s[f] == from_s[g] && f < g); });
}

// The orders of the calibrated method: the spectral order from both ends; then, if they are asked
// for, the orders by distance from each sample and each reference face, which grow a single limb
// where the pair sees several at once.
inline std::vector<Face_order> face_orders(Execution execution, const Surface& part,
                                           const std::vector<Index>& references,
                                           const Sample_faces& samples, bool from_single_sources)
{
  std::vector<Index> sources = {samples.s, samples.t};
  if (from_single_sources)
    for (Index reference : references)
      if (reference != samples.s && reference != samples.t)
        sources.push_back(reference);
  std::vector<std::vector<double> > distances(sources.size());
  for_each_index(execution, sources.size(), [&](std::size_t i)
    { distances[i] = shortest_paths(part, &Edge_weights::combined, sources[i]); });

  std::vector<Face_order> orders = {spectral_order(execution, distances[0], distances[1]),
                                    spectral_order(execution, distances[1], distances[0])};
  if (from_single_sources)
    for (const std::vector<double>& distance : distances)
      orders.push_back(sorted_indices(execution, distance));
  return orders;
}

// The order of the paper.
inline Face_order face_order(Execution execution, const Surface& part,
                             const Sample_faces& samples)
{
  std::vector<double> from_s, from_t;
  call_all(execution,
    [&] { from_s = shortest_paths(part, &Edge_weights::combined, samples.s); },
    [&] { from_t = shortest_paths(part, &Edge_weights::combined, samples.t); });
  return spectral_order(execution, from_s, from_t);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_FACE_ORDERS_H
