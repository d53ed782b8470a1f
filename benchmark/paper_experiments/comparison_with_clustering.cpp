// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../evaluation.h"
#include "../Peak_memory.h"
#include "../for_each_mesh.h"
#include "../princeton_benchmark.h"
#include "../timed.h"
#include "cut_between_samples.h"
#include "experiment.h"
#include "experiments.h"
#include "face_samples.h"
#include "pictures.h"
#include "recursive_cuts.h"
#include "simplified.h"
#include "spectral_clusters.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <tuple>
#include <utility>
#include <vector>

// Figure 4 and Section 7.1: spectral clustering by k-means, and line search.
namespace segmentation_benchmark {
namespace {

struct Clusterer
{
  const char* name;
  Labels (*segment)(const Surface&, std::size_t k, std::size_t samples, Random_engine&);
};

Labels by_line_search(const Surface& mesh, std::size_t k, std::size_t,
                      Random_engine& random)
{
  return recursive_cuts(mesh, k, [&](const Part& part) {
    return cut_between_samples(sampling_schemes[shape_context_scheme], part.graph,
                               minimum_area(mesh), random);
  });
}

enum { K_WAY, TWO_MEANS, LINE_SEARCH, NUMBER_OF_CLUSTERERS };

constexpr std::array<Clusterer, NUMBER_OF_CLUSTERERS> clusterers = {{
  {"k-way k-means", k_way_clusters},
  {"recursive 2-means", recursive_two_means},
  {"line search", by_line_search},
}};

struct Result
{
  Labels labels;
  double rand_error, seconds, megabytes;
};

typedef std::array<Result, NUMBER_OF_CLUSTERERS> Results;

// With the face distances given.
Results results(const Benchmark_mesh& input, const Clustering_options& o)
{
  const Surface graph = paper_graph(input.mesh);
  const std::size_t k = usual_number_of_segments(input.people);
  Random_engine random = random_engine(o.seed, input.id);
  Results all;
  for (std::size_t i = 0; i < clusterers.size(); ++i) {
    const Peak_memory memory;
    auto [labels, time] =
      timed([&] { return clusterers[i].segment(graph, k, o.samples, random); });
    const double megabytes = static_cast<double>(memory.bytes()) / 1e6;
    const double rand_error = mean_rand_error(labels, input.people);
    all[i] = {std::move(labels), rand_error, time.thread, megabytes};
  }
  return all;
}

std::vector<double> values(const std::vector<Results>& meshes, std::size_t clusterer,
                           double Result::*member)
{ return values_of(meshes, [=](const Results& all) { return all[clusterer].*member; }); }

void print(const std::vector<Results>& meshes)
{
  std::printf("%-18s %10s %8s %8s\n", "method", "Rand error", "seconds", "MB");
  for (std::size_t i = 0; i < clusterers.size(); ++i) {
    std::printf("%-18s", clusterers[i].name);
    for (const auto& [width, digits, member] : {std::make_tuple(10, 4, &Result::rand_error),
                                                std::make_tuple(8, 3, &Result::seconds),
                                                std::make_tuple(8, 1, &Result::megabytes)})
      std::printf(" %*.*f", width, digits, mean_of(values(meshes, i, member)));
    std::printf("\n");
  }
  std::printf("means; seconds of the processor and peak memory of the segmentation, the face "
              "distances given\n");
}

void print_claim(const std::vector<Results>& meshes)
{
  const auto excess = [&](std::size_t clusterer) {
    return paired_difference(values(meshes, clusterer, &Result::rand_error),
                             values(meshes, LINE_SEARCH, &Result::rand_error));
  };
  const Paired_difference k_way = excess(K_WAY), two_means = excess(TWO_MEANS);
  std::printf("Section 7.1, that line search is better than k-means: %s against k-way k-means, "
              "whose error is larger by %+.3f +- %.3f, %s against recursive 2-means, by %+.3f +- "
              "%.3f.\n",
              verdict(k_way.is_positive()), k_way.mean, k_way.standard_error,
              verdict(two_means.is_positive()), two_means.mean, two_means.standard_error);
}

void write_pictures(const Mesh& mesh, const Results& results, const Pictures& pictures)
{
  for (std::size_t i = 0; i < clusterers.size(); ++i)
    pictures.write_mesh(clusterers[i].name, mesh, segment_colors(mesh, results[i].labels));
}

} // namespace

void run_comparison_with_clustering(const Clustering_options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<Results> meshes;
  Progress progress(ids.size());
  for (int id : ids) {
    Benchmark_mesh input = read_benchmark_mesh(o.folder, id);
    if (o.faces > 0)
      input = simplified(input, o.faces);
    meshes.push_back(results(input, o));
    if (meshes.size() == 1 && !o.pictures.empty())
      write_pictures(input.mesh, meshes.front(), Pictures(o.pictures));
    progress.step();
  }
  print(meshes);
  print_claim(meshes);
}

} // namespace segmentation_benchmark
