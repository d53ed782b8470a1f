// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_GRAPH_H
#define SEGMENTATION_BENCHMARK_PAPER_GRAPH_H

#include "princeton_benchmark.h"
#include "run_engine.h"

#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>

#include <utility>

namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Face_graph;
using CGAL::Spectral_segmentation::internal::Index;

// The faces of a mesh, by their own numbers, with the distances of the paper (Section 3).
inline Face_graph paper_graph(const Mesh& mesh)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  internal::Triangles triangles = triangles_of(mesh);
  internal::normalize(triangles.points);
  Face_graph graph = internal::face_graph(Execution::SEQUENTIAL, std::move(triangles));
  const Engine_options options = CGAL::Spectral_segmentation::Options::zhang_liu_2005();
  internal::set_face_distances(
    Execution::SEQUENTIAL, graph, graph.points,
    internal::face_normals(Execution::SEQUENTIAL, graph, graph.points),
    {options.geodesic_weight, options.concave_angle_weight, options.convex_angle_weight});
  return graph;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_GRAPH_H
