// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_INITIALIZATION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_INITIALIZATION_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/laplacian_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/simplification.h>
#include <CGAL/Spectral_segmentation/internal/thickness.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// All that a run needs to know of a mesh.
struct Initial_mesh
{
  Face_dual_graph graph;
  // If the graph has more faces than shall be searched: the first simplifies the graph, the next
  // that one, and so on.
  std::vector<Simplified_mesh> simplified;

  // The one on which cuts are searched, which has face distances.
  Face_dual_graph& searched() { return simplified.empty() ? graph : simplified.back().graph; }
};

inline Distance_weights distance_weights(const Options& options)
{
  return {options.geodesic_weight, options.concave_angle_weight, options.convex_angle_weight,
          options.concavity_radius};
}

template <class ConcurrencyTag>
void measure(Face_dual_graph& graph, const std::vector<Vector>& points, const Options& options)
{
  const std::vector<Vector> normals = face_normals<ConcurrencyTag>(graph, points);
  for_each_index<ConcurrencyTag>(options.needs_thickness() ? 2 : 1, [&](std::size_t task) {
    if (task == 0)
      set_face_distances<ConcurrencyTag>(graph, points, normals, distance_weights(options));
    else
      graph.thickness = thickness<ConcurrencyTag>(graph, points, normals, thickness_radius);
  });
}

// Smoothing ends early if `go_further()` is false.
template <class ConcurrencyTag, class GoFurther>
Initial_mesh initialize(Triangles triangles, const Options& options, const GoFurther& go_further)
{
  Initial_mesh result{dual_graph<ConcurrencyTag>(std::move(triangles)), {}};
  Face_dual_graph& graph = result.graph;
  std::vector<Vector> points =
    smoothed_points(graph, options.number_of_smoothing_iterations, go_further);
  const std::size_t number_of_faces = options.faces_to_search(graph.number_of_faces());
  if (number_of_faces == graph.number_of_faces()) {
    measure<ConcurrencyTag>(graph, points, options);
    return result;
  }
  graph.points = std::move(points);
  result.simplified = simplify_in_steps<ConcurrencyTag>(graph, number_of_faces);
  measure<ConcurrencyTag>(result.searched(), result.searched().points, options);
  return result;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_INITIALIZATION_H
