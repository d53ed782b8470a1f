// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_LAPLACIAN_SMOOTHING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_LAPLACIAN_SMOOTHING_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the points after some steps of uniform Laplacian smoothing (Section 2). Each step moves a
// point half the way to the mean of its neighbors; vertices on the border of the mesh stay. Ends
// early if `go_further()`, asked before each step, is false.
template <class GoFurther>
std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations,
                                    const GoFurther& go_further)
{
  std::vector<Vector> points = graph.points;
  if (iterations == 0)
    return points;
  std::vector<char> is_fixed(points.size(), 0);
  for (Index h = 0; h < graph.opposite.size(); ++h)
    if (graph.is_border(h))
      is_fixed[graph.source_vertex(h)] = is_fixed[graph.target_vertex(h)] = 1;

  std::vector<Vector> sum(points.size());
  std::vector<unsigned> degree(points.size());
  for (; iterations > 0 && go_further(); --iterations) {
    std::fill(sum.begin(), sum.end(), Vector());
    std::fill(degree.begin(), degree.end(), 0u);
    // One halfedge of each edge starts at an inner vertex. Therefore the mean is unweighted.
    for (Index h = 0; h < graph.opposite.size(); ++h) {
      sum[graph.source_vertex(h)] += points[graph.target_vertex(h)];
      ++degree[graph.source_vertex(h)];
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!is_fixed[v] && degree[v] > 0)
        points[v] = (points[v] + sum[v] / degree[v]) / 2;
  }
  return points;
}

inline std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations)
{ return smoothed_points(graph, iterations, [] { return true; }); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_LAPLACIAN_SMOOTHING_H
