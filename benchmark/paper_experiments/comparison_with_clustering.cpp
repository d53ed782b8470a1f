// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Peak_memory.h"
#include "../for_each_mesh.h"
#include "../princeton_benchmark.h"
#include "../timed.h"
#include "evaluation.h"
#include "experiment.h"
#include "experiments.h"
#include "pictures.h"
#include "recursive_cuts.h"
#include "simplified.h"
#include "spectral_clusters.h"

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/Cut_judge.h>
#include <CGAL/Spectral_segmentation/internal/Monitor.h>
#include <CGAL/Spectral_segmentation/internal/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/options.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

// Figure 4 and Section 7.1: spectral clustering by k-means, and line search.
namespace segmentation_benchmark {
namespace {

struct Clusterer
{
  const char* name;
  Labels (*segment)(const Face_dual_graph&, std::size_t k, std::size_t samples, Random_engine&);
};

Labels by_line_search(const Face_dual_graph& mesh, std::size_t k, std::size_t,
                      Random_engine&)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  CGAL::Spectral_segmentation::Segmentation_visitor visitor;
  internal::Monitor<CGAL::Spectral_segmentation::Segmentation_visitor> monitor(visitor);
  const internal::Options options;
  const internal::Judged_mesh judged = internal::judged_mesh(mesh, options);
  return recursive_cuts(mesh, k, [&](const Part& part) {
    const auto cut = internal::best_cut<CGAL::Sequential_tag>(part, judged, options, monitor);
    return cut ? std::optional<Sides>(cut->side) : std::nullopt;
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
  double rand_error = undefined, seconds, megabytes;
};

typedef std::array<Result, NUMBER_OF_CLUSTERERS> Results;

// With the face distances given.
Results results(const Face_dual_graph& graph, std::size_t k, const Clustering_options& o,
                Random_engine random)
{
  Results all;
  for (std::size_t i = 0; i < clusterers.size(); ++i) {
    const Peak_memory memory;
    auto [labels, time] =
      timed([&] { return clusterers[i].segment(graph, k, o.samples, random); });
    all[i] = {std::move(labels), undefined, time.thread,
              static_cast<double>(memory.bytes()) / 1e6};
  }
  return all;
}

Results results(const Benchmark_mesh& input, const Clustering_options& o)
{
  Results all = results(paper_graph(input.mesh), usual_number_of_segments(input.people), o,
                        random_engine(o.seed, input.id));
  for (Result& result : all)
    result.rand_error = mean_rand_error(std::exchange(result.labels, {}), input.people);
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

// One mesh in some parts, by each method.
void run_on_mesh(const Clustering_options& o)
{
  const Mesh mesh = read_mesh(o.mesh);
  const Results all = results(paper_graph(mesh), o.parts, o, random_engine(o.seed, 0));
  if (!o.pictures.empty())
    for (std::size_t i = 0; i < clusterers.size(); ++i)
      Pictures(o.pictures).write_mesh(clusterers[i].name, mesh,
                                      segment_colors(mesh, all[i].labels));
  print({all});
}

} // namespace

void run_comparison_with_clustering(const Clustering_options& o)
{
  if (!o.mesh.empty()) {
    run_on_mesh(o);
    return;
  }
  if (o.folder.empty())
    throw std::invalid_argument("clustering needs a benchmark folder or a mesh");
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<Results> meshes;
  Progress progress(ids.size());
  for (int id : ids) {
    const Benchmark_mesh input = read_benchmark_mesh(o.folder, id);
    meshes.push_back(results(o.faces > 0 ? simplified(input, o.faces) : input, o));
    progress.step();
  }
  print(meshes);
  print_claim(meshes);
}

} // namespace segmentation_benchmark
