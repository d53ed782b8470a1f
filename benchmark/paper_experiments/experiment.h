// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENT_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENT_H

#include "../paper_graph.h"
#include "../princeton_benchmark.h"

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_statistics.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// The common part of all experiments.
namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Sides;

struct Part
{
  Surface graph;
  std::vector<Index> faces; // their numbers in the mesh, ascending
};

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

// Each connected component is a part.
inline std::vector<Part> components(const Surface& mesh)
{
  const CGAL::Spectral_segmentation::internal::Components of_mesh =
    connected_components(mesh);
  const std::vector<Index> component = of_mesh.face_labels(mesh.number_of_faces());
  const std::size_t number = of_mesh.number;
  std::vector<Part> parts(number);
  for (Index f = 0; f < component.size(); ++f)
    parts[component[f]].faces.push_back(f);
  std::vector<Surface> graphs = split(mesh, component, number);
  for (std::size_t i = 0; i < number; ++i)
    parts[i].graph = std::move(graphs[i]);
  return parts;
}

// The component with the most faces, which is the first part that is cut.
inline Part whole_part(const Surface& mesh)
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

// 1 less the faces that the cut takes off the person's segments, of each the smaller of two pieces,
// relative to those of the cut's smaller side: 1 where it follows the borders of segments, 0 where
// the smaller side is nowhere the larger piece of one.
inline double agreement(const Part& part, const Sides& side, const Labels& person)
{
  const Eigen::ArrayXXd faces =
    overlap(Labels(side.begin(), side.end()), labels_of_part(part, person));
  return 1 - faces.colwise().minCoeff().sum() / faces.rowwise().sum().minCoeff();
}

inline double minimum_area(const Surface& mesh)
{ return Engine_options::zhang_liu_2005().minimum_segment_size * total_area(mesh); }

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENT_H
