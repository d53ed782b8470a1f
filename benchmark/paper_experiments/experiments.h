// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENTS_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENTS_H

#include "../for_each_mesh.h"
#include "../mesh_changes.h"
#include "../princeton_benchmark.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

struct Experiment_options
{
  std::string folder, ids = "odd";
  std::size_t faces = 0;     // meshes are decimated to so many, if not 0
  std::size_t samples = 100; // rows of the affinity matrix of clusterings
};

// Compares line search between samples in the same part and in different parts (Figure 1).
void compare_placements(const Experiment_options& o);

// Compares how often samples by several schemes lie in different parts (Figure 3 and Section 4).
void compare_samplings(const Experiment_options& o);

// Compares line search with spectral clustering by k-means (Figure 4 and Section 7.1).
void compare_with_clusterings(const Experiment_options& o);

// Compares more samples with two (Section 7.2).
void compare_numbers_of_samples(const Experiment_options& o);

// Returns a mesh with about so many faces, which have the labels of the nearest original faces.
inline Benchmark_mesh simplified(const Benchmark_mesh& input, std::size_t faces)
{
  Changed_mesh changed = decimated(input.mesh, 3 * faces / 2);
  Benchmark_mesh result{input.id, std::move(changed.mesh), {}};
  for (const Labels& person : input.people) {
    Labels labels;
    for (std::size_t f : changed.original_faces)
      labels.push_back(person[f]);
    result.people.push_back(contiguous(labels));
  }
  return result;
}

// Returns what a function measures on each mesh.
template <class Function>
auto measure_meshes(const Experiment_options& o, const Function& measure)
{
  const std::vector<int> ids = parse_ids(o.ids);
  return results_of_meshes(ids.size(), 1, [&](std::size_t i) {
    const Benchmark_mesh input = read_benchmark_mesh(o.folder, ids[i]);
    return measure(o.faces > 0 ? simplified(input, o.faces) : input);
  });
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENTS_H
