// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINED_BOUNDARIES_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINED_BOUNDARIES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_curves.h>
#include <CGAL/Segmented_mesh/internal/refinement/Refinement.h>
#include <CGAL/Segmented_mesh/internal/refinement/Segment_keeper.h>
#include <CGAL/Segmented_mesh/internal/refinement/Segment_shares.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns the splits of faces along the curves.
inline Refinement refinement(const Surface& graph, const std::vector<Index>& labels,
                             const Boundary_band& band, const Boundary_curves& curves)
{
  Refinement result;
  std::vector<Index> point(graph.number_of_halfedges(), null_index);
  for (Index f : band.faces) {
    Refinement::Split_face split{f, {}, curves.apex_edge(f), {}};
    bool has_point = false;
    for (Index i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      if (curves.is_crossed(h) && point[h] == null_index) {
        point[h] = static_cast<Index>(result.points.size());
        if (!graph.is_border(h))
          point[graph.opposite[h]] = point[h];
        result.points.push_back({h, curves.position(h)});
      }
      has_point |= point[h] != null_index;
      split.points[i] = point[h];
      split.labels[2 * i] = curves.label(h, 0);
      split.labels[2 * i + 1] = curves.label(h, 1);
    }
    if (has_point)
      result.split_faces.push_back(split);
    else if (split.labels[0] != labels[f])
      result.other_labels.emplace_back(f, split.labels[0]);
  }
  return result;
}

// Refines the boundaries between segments. The share of each segment in the angle at a vertex is
// smoothed by diffusion in a band around them, and each vertex takes the label of its largest
// share. If the ends of an edge have two labels, the boundary crosses it where both shares are
// equal. Then the boundaries become taut.
//
// The labels of the faces must be less than `number_of_segments`, and each must have a face. The
// points of the surface are normalized, and its areas are set.
inline Refinement refined_boundaries(Surface& graph, const std::vector<Index>& labels,
                                     std::size_t number_of_segments,
                                     std::size_t number_of_iterations)
{
  normalize(graph.points);
  set_areas(Execution::SEQUENTIAL, graph);
  constexpr int number_of_rounds = 2, number_of_steps = 10;
  const Boundary_band band(graph, labels);
  if (band.faces.empty())
    return Refinement();
  Boundary_curves curves(graph, labels, band,
                         Segment_shares(graph, labels, band, number_of_iterations));
  const Segment_keeper keep_segments(graph, labels, number_of_segments, band);
  for (int round = 0; round < number_of_rounds; ++round) {
    curves.snap();
    for (int step = 0; step < number_of_steps; ++step)
      curves.tighten();
    keep_segments(curves);
  }
  return refinement(graph, labels, band, curves);
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINED_BOUNDARIES_H
