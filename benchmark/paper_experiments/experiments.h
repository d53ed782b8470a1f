// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENTS_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENTS_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace segmentation_benchmark {

struct Experiment_options
{
  std::string folder, ids = "odd";
  std::string pictures; // a folder for pictures of the first mesh, and plots; empty for none
  std::uint64_t seed = 1;
};

// Figure 1.
struct Placement_options : Experiment_options
{
  std::size_t pairs = 10; // pairs of samples, per kind and mesh
};

void run_placement_of_samples(const Placement_options& o);

// Figure 3 and Section 4.
void run_comparison_of_samplings(const Experiment_options& o);

// Figure 4 and Section 7.1.
struct Clustering_options : Experiment_options
{
  std::size_t samples = 100; // rows of the affinity matrix
  std::size_t faces = 0;     // meshes are decimated to so many, if not 0
};

void run_comparison_with_clustering(const Clustering_options& o);

// Section 7.2. The pictures are plots.
struct Number_of_samples_options : Experiment_options
{
  std::size_t faces = 1000; // meshes are decimated to so many
};

void run_number_of_samples(const Number_of_samples_options& o);

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EXPERIMENTS_H
