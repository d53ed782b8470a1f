// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_RUN_ENGINE_H
#define SEGMENTATION_BENCHMARK_RUN_ENGINE_H

#include "princeton_benchmark.h"

#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/spectral_embedding.h>

#include <cstddef>
#include <utility>
#include <vector>

// Runs with constants of a method changed, and with a look at what the engine does.
namespace segmentation_benchmark {

// The options of a run and the constants of its method, which ablations change.
struct Engine_options : CGAL::Spectral_segmentation::Options,
                        CGAL::Spectral_segmentation::internal::Method_constants
{
  Engine_options(const CGAL::Spectral_segmentation::Options& o = Options())
    : Options(o), Method_constants(CGAL::Spectral_segmentation::internal::constants_of(o.method))
  {}
};

using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Execution;
using CGAL::Spectral_segmentation::internal::Feature_source;
using CGAL::Spectral_segmentation::internal::Index;
using CGAL::Spectral_segmentation::internal::Run_control;
using CGAL::Spectral_segmentation::internal::Surface;

inline Surface triangles_of(const Mesh& mesh)
{
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  return CGAL::Spectral_segmentation::internal::read_triangle_mesh(
    mesh, faces, mesh.points(), CGAL::Exact_predicates_inexact_constructions_kernel());
}

// Returns the faces of a mesh, by their own numbers, with the distances of the paper (Section 3).
inline Surface paper_graph(const Mesh& mesh)
{
  return CGAL::Spectral_segmentation::internal::weighted_face_graph(
    triangles_of(mesh), Engine_options::zhang_liu_2005());
}

inline CGAL::Spectral_segmentation::Segmentation_hierarchy
run_engine(const Mesh& mesh, const Engine_options& options, Execution execution,
           Run_control&& control = Run_control(), const Feature_source& features = Feature_source())
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  return internal::with_selection(internal::segment(triangles_of(mesh), options, options, execution,
                                                    control, internal::Constraints(), features),
                                  options);
}

// Returns the labels that a run assigned.
inline Labels labels_of_run(const CGAL::Spectral_segmentation::Segmentation_hierarchy& tree)
{ return tree.labels(tree.nodes()); }

// Returns the labels for at most `n` segments, by the cuts of at least this salience.
inline Labels labels_of_tree(const CGAL::Spectral_segmentation::Segmentation_hierarchy& tree,
                             double salience_threshold,
                             std::size_t n = CGAL::Spectral_segmentation::unlimited)
{ return tree.labels(tree.nodes_above(salience_threshold, n)); }

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_RUN_ENGINE_H
