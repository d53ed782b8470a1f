// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_GRAPH_H
#define SEGMENTATION_BENCHMARK_PAPER_GRAPH_H

#include "princeton_benchmark.h"
#include "run_engine.h"

#include <CGAL/spectral_embedding.h>

namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Surface;
using CGAL::Spectral_segmentation::internal::Index;

// The faces of a mesh, by their own numbers, with the distances of the paper (Section 3).
inline Surface paper_graph(const Mesh& mesh)
{
  return CGAL::Spectral_segmentation::internal::weighted_face_graph(
    triangles_of(mesh), Engine_options::zhang_liu_2005());
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_GRAPH_H
