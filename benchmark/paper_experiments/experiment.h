// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENT_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENT_H

#include "../princeton_benchmark.h"

#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/Options.h>
#include <CGAL/Spectral_segmentation/internal/mesh/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/door/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// What all experiments share.
namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Face_graph;
using CGAL::Spectral_segmentation::internal::Index;
using CGAL::Spectral_segmentation::internal::Part;
using CGAL::Spectral_segmentation::internal::Sides;

// The same numbers on every platform, as long as no distribution of the standard library is used.
typedef std::mt19937_64 Random_engine;

inline Random_engine random_engine(std::uint64_t seed, int id)
{
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      static_cast<std::uint32_t>(id)};
  return Random_engine(seeds);
}

inline Index random_face(std::size_t number_of_faces, Random_engine& random)
{ return static_cast<Index>(random() % number_of_faces); }

// The dual graph with the distances of the paper.
inline Face_graph paper_graph(const Mesh& mesh)
{
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  namespace internal = CGAL::Spectral_segmentation::internal;
  return internal::initialize<CGAL::Sequential_tag>(
    internal::read_triangles(mesh, faces, mesh.points(),
                             CGAL::Exact_predicates_inexact_constructions_kernel()),
    internal::Options(), [] { return true; }).graph;
}

// Each connected component is a part.
inline std::vector<Part> components(const Face_graph& mesh)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  std::size_t number;
  const std::vector<Index> component = internal::connected_components(mesh, number);
  std::vector<Part> parts(number);
  for (Index f = 0; f < component.size(); ++f)
    parts[component[f]].faces.push_back(f);
  std::vector<Face_graph> graphs = internal::split(mesh, component, number);
  for (std::size_t i = 0; i < number; ++i) {
    parts[i].graph = std::move(graphs[i]);
    parts[i].node = i;
  }
  return parts;
}

// The component with the most faces, which is the first part that is cut.
inline Part whole_part(const Face_graph& mesh)
{
  std::vector<Part> parts = components(mesh);
  return std::move(*std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b)
                                     { return a.faces.size() < b.faces.size(); }));
}

inline Labels labels_of_part(const Part& part, const Labels& labels)
{
  Labels result;
  for (Index f : part.faces)
    result.push_back(labels[f]);
  return contiguous(result);
}

inline double minimum_area(const Face_graph& mesh)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  return internal::Options().minimum_segment_size * internal::total_area(mesh);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENT_H
