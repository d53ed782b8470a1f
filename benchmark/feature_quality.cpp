// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Segments the Princeton Segmentation Benchmark with made features of known worth, and prints the
/// Rand errors to the person from whose parts the features are made; also fits what features say
/// about boundaries to people's parts.

#include "Logistic_regression.h"
#include "evaluated_cuts.h"
#include "evaluation.h"
#include "for_each_mesh.h"
#include "made_features.h"
#include "program.h"

#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

using namespace segmentation_benchmark;
using spectral::Salience_factors;
using spectral::internal::Feature_logit;

struct Options
{
  std::string folder, ids = "odd";
  double weight = Engine_options().feature_weight;
  std::size_t threads = 1;
  bool fits = false;
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("folder", o.folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
  app.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
  app.add_option("--weight", o.weight, "the feature_weight of all runs")
    ->check(CLI::Range(0., 1.))->capture_default_str();
  app.add_flag("--fit", o.fits, "also fits the numbers of Feature_logit to the boundaries");
  app.add_option("--threads", o.threads, "meshes at a time, each on one thread")
    ->check(CLI::Range(1, 1024))->capture_default_str();
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

// What is known of a mesh with one kind of features.
struct Outcome
{
  double error = undefined, error_of_k_means = undefined;
  Mesh_cuts cuts;
};

typedef std::array<Outcome, kinds.size()> Outcomes;

Outcomes outcomes(const Options& o, int id)
{
  Benchmark_mesh input = read_benchmark_mesh(o.folder, id);
  Feature_random random(id);
  const Labels person = input.people[random() % input.people.size()];
  input.people = {person};
  Outcomes result;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    random.seed(static_cast<unsigned>(100 * id) + static_cast<unsigned>(k));
    const Feature_matrix features = kinds[k].make(input.mesh, person, random);
    Feature_source source;
    source.dimension = static_cast<std::size_t>(features.cols());
    source.read = [&](spectral::internal::Index f, double* vector)
      { std::copy_n(features.row(f).data(), features.cols(), vector); };
    Engine_options options;
    options.feature_weight = o.weight;
    result[k].cuts.id = id;
    result[k].error = rand_error(
      labels_of_run(run_engine(input.mesh, options, Execution::SEQUENTIAL,
                               Cut_collector(input.people, result[k].cuts), source)), person);
    if (features.cols() > 0)
      result[k].error_of_k_means =
        rand_error(k_means(features, number_of_segments(person), random), person);
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

// Fits the logit of boundaries. A mesh counts as much as any other, with each kind of features.
void print_fit(const std::vector<Outcomes>& meshes)
{
  constexpr std::array<const char*, 7> names = {
    "logit of shape", "constant", "explained_variance_near_cut", "feature_step",
    "explained_variance", "explained_variance_of_mesh", "logit of shape, reliable"};
  std::vector<std::array<double, names.size()> > rows;
  std::vector<double> targets, weights;
  for (const Outcomes& mesh : meshes)
    for (std::size_t k = 1; k < kinds.size(); ++k) {
      const std::size_t first = rows.size();
      double sum = 0;
      for (const Cut_group& group : mesh[k].cuts.groups) {
        const Cut_sample& cut = group.cuts.front();
        const Salience_factors& f = cut.factors;
        if (group.kind != Evaluated_cut::BOUNDARY || !(f.feature_reliability > 0))
          continue;
        const Feature_logit logit;
        const double g = Feature_logit::ramp(f.feature_reliability, logit.first_reliability,
                                             logit.last_reliability);
        const double shape = spectral::Calibrated_part_salience().boundary_network.logit(f);
        rows.push_back({shape, g, g * std::sqrt(f.explained_variance_near_cut),
                        g * f.feature_step, g * std::sqrt(f.explained_variance),
                        g * std::sqrt(f.explained_variance_of_mesh), g * shape});
        targets.push_back(cut.agreement);
        weights.push_back(std::exp(f.log_relative_part_area / 2));
        sum += weights.back();
      }
      for (std::size_t i = first; i < weights.size(); ++i)
        weights[i] /= sum;
    }
  Eigen::MatrixXd factors(rows.size(), names.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < names.size(); ++j)
      factors(i, j) = rows[i][j];
  const Logistic_model model = Logistic_regression(
    factors, Eigen::Map<Eigen::VectorXd>(targets.data(), targets.size()))(
    Eigen::Map<Eigen::VectorXd>(weights.data(), weights.size()));
  std::printf("\n%zu boundaries, loss %.4f, constant %.2f without features\n", rows.size(),
              model.loss, model.constant);
  for (std::size_t j = 0; j < names.size(); ++j)
    std::printf("%-28s %+.2f\n", names[j], model.coefficients[j]);
}

void run(const Options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<Outcomes> meshes(ids.size());
  Progress progress(ids.size());
  for_each_mesh(ids.size(), o.threads, [&](std::size_t i) {
    meshes[i] = outcomes(o, ids[i]);
    progress.step();
  });
  print_errors(meshes);
  if (o.fits)
    print_fit(meshes);
}

int main(int argc, char** argv)
{
  return run_program("feature_quality",
                     "Segments the Princeton benchmark with made features of known worth.",
                     add_options, run, argc, argv);
}
