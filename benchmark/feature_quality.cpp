// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Segments the Princeton Segmentation Benchmark with made features of known worth, and prints the
/// Rand errors to the person from whose parts the features are made.

#include "evaluation.h"
#include "for_each_mesh.h"
#include "k_means.h"
#include "made_features.h"
#include "princeton_benchmark.h"
#include "program.h"
#include "run_engine.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::string folder, ids = "odd";
  double weight = Engine_options().feature_weight;
  std::size_t threads = 1;
};

void add_options(CLI::App& app, Options& o)
{
  add_benchmark_options(app, o.folder, o.ids);
  app.add_option("--weight", o.weight, "the feature_weight of all runs")
    ->check(CLI::Range(0., 1.))->capture_default_str();
  add_threads_option(app, o.threads);
}

// The noise with which k-means on the features of all faces has a mean Rand error of .20, or .10.
constexpr double noise_for_error_20 = 0.40, noise_for_error_10 = 0.28;

struct Kind
{
  const char* name;
  Feature_matrix (*make)(const Mesh&, const Labels&, Feature_random&);
};

const std::array<Kind, 7> kinds = {{
  {"none", [](const Mesh&, const Labels&, Feature_random&) { return Feature_matrix(); }},
  {"parts, k-means .20", [](const Mesh& mesh, const Labels& person, Feature_random& random)
    { return noisy_parts(mesh, person, noise_for_error_20, random); }},
  {"parts, k-means .10", [](const Mesh& mesh, const Labels& person, Feature_random& random)
    { return noisy_parts(mesh, person, noise_for_error_10, random); }},
  {"labels, 1/5 wrong", [](const Mesh& mesh, const Labels& person, Feature_random& random)
    { return indicators(noisy_labels(mesh, person, 0.2, random)); }},
  {"labels", [](const Mesh&, const Labels& person, Feature_random&) { return indicators(person); }},
  {"smooth field", [](const Mesh& mesh, const Labels&, Feature_random& random)
    { return smooth_features(mesh, 8, random); }},
  {"noise", [](const Mesh&, const Labels& person, Feature_random& random)
    { return normal_noise(person.size(), 8, random); }}}};

// The results on a mesh with one kind of features.
struct Outcome
{
  double error = undefined, error_of_k_means = undefined;
};

typedef std::array<Outcome, kinds.size()> Outcomes;

Outcomes outcomes(const Options& o, int id)
{
  const Benchmark_mesh input = read_benchmark_mesh(o.folder, id);
  Feature_random random(id);
  const Labels& person = input.people[random() % input.people.size()];
  Outcomes result;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    random.seed(static_cast<unsigned>(100 * id) + static_cast<unsigned>(k));
    const Feature_matrix features = kinds[k].make(input.mesh, person, random);
    Feature_source source;
    source.dimension = static_cast<std::size_t>(features.cols());
    source.read = [&](CGAL::Spectral_segmentation::internal::Index f, double* vector)
      { std::copy_n(features.row(f).data(), features.cols(), vector); };
    Engine_options options;
    options.feature_weight = o.weight;
    result[k].error = rand_error(
      labels_of_run(run_engine(input.mesh, options, Execution::SEQUENTIAL, Run_control(), source)),
      person);
    if (features.cols() > 0) {
      Random_engine random_centers(id);
      result[k].error_of_k_means =
        rand_error(k_means(features, number_of_segments(person), random_centers), person);
    }
  }
  return result;
}

void print_errors(const std::vector<Outcomes>& meshes)
{
  std::printf("%-20s %8s %8s    change +- standard error\n", "features", "error", "k-means");
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto error = [k](const Outcomes& m) { return m[k].error; };
    const auto without = [](const Outcomes& m) { return m[0].error; };
    const auto of_k_means = [k](const Outcomes& m) { return m[k].error_of_k_means; };
    const Paired_difference d =
      paired_difference(values_of(meshes, error), values_of(meshes, without));
    std::printf("%-20s %8.4f %8.4f   %+.4f +- %.4f\n", kinds[k].name,
                mean_of(values_of(meshes, error)), mean_of(values_of(meshes, of_k_means)), d.mean,
                d.standard_error);
  }
}

void run(const Options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  print_errors(results_of_meshes(ids.size(), o.threads, [&](std::size_t i)
    { return outcomes(o, ids[i]); }));
}

int main(int argc, char** argv)
{
  return run_program("feature_quality",
                     "Segments the Princeton benchmark with made features of known worth.",
                     add_options, run, argc, argv);
}
