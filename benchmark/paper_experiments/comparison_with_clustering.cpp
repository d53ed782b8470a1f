// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Peak_memory.h"
#include "../evaluation.h"
#include "../timed.h"
#include "experiments.h"
#include "face_samples.h"
#include "spectral_clusters.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

// Figure 4 and Section 7.1: spectral clustering by k-means, and line search.
namespace segmentation_benchmark {
namespace {

struct Clusterer
{
  const char* name;
  Labels (*segment)(const Surface&, std::size_t k, std::size_t samples, Random_engine&);
};

Labels by_line_search(const Surface& mesh, std::size_t k, std::size_t, Random_engine& random)
{ return recursive_cuts_by_samples(sampling_schemes[shape_context_scheme], mesh, k, random); }

// The methods, of which line search is the last.
constexpr std::array<Clusterer, 3> clusterers = {{
  {"k-way k-means", k_way_clusters},
  {"recursive 2-means", recursive_two_means},
  {"line search", by_line_search},
}};

struct Result
{
  double rand_error, seconds, megabytes;
};

typedef std::array<Result, clusterers.size()> Results;

// Returns the result of each method, without the time and memory for the distances of faces.
Results results(const Benchmark_mesh& input, std::size_t samples)
{
  const Surface graph = paper_graph(input.mesh);
  const std::size_t k = usual_number_of_segments(input.people);
  Random_engine random = random_engine(input.id);
  Results all;
  for (std::size_t i = 0; i < clusterers.size(); ++i) {
    const Peak_memory memory;
    const auto [labels, time] =
      timed([&] { return clusterers[i].segment(graph, k, samples, random); });
    const double megabytes = static_cast<double>(memory.bytes()) / 1e6;
    all[i] = {mean_rand_error(labels, input.people), time.thread, megabytes};
  }
  return all;
}

} // namespace

void compare_with_clusterings(const Experiment_options& o)
{
  const std::vector<Results> meshes = measure_meshes(
    o, [&](const Benchmark_mesh& input) { return results(input, o.samples); });
  std::printf("%-18s %10s %21s %8s %8s\n", "method", "Rand error", "more than line search",
              "seconds", "MB");
  for (std::size_t i = 0; i < clusterers.size(); ++i) {
    const auto values = [&](std::size_t clusterer, double Result::*member)
    { return values_of(meshes, [=](const Results& all) { return all[clusterer].*member; }); };
    const Paired_difference more = paired_difference(
      values(i, &Result::rand_error), values(clusterers.size() - 1, &Result::rand_error));
    std::printf("%-18s %10.4f %+12.3f +- %.3f %8.3f %8.1f\n", clusterers[i].name,
                mean_of(values(i, &Result::rand_error)), more.mean, more.standard_error,
                mean_of(values(i, &Result::seconds)), mean_of(values(i, &Result::megabytes)));
  }
  std::printf("means; seconds of the processor and peak memory of the segmentation, the face "
              "distances given\n");
}

} // namespace segmentation_benchmark
