// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Fits the numbers of `Calibrated_part_salience` to people's cuts on the Princeton Segmentation
/// Benchmark, and reports the Rand errors of runs with them; also with each category judged by
/// numbers that are fitted to the others, and with numbers that are fitted without single factors.
///
/// Cuts of each mesh in several triangulations count, so that the numbers fit all of them; the Rand
/// errors are those of the meshes as they are.
///
/// The cuts are those that a run with the numbers in the source evaluates; in further passes those
/// of runs with the numbers of the pass before.

#include "evaluation.h"
#include "evaluated_cuts.h"
#include "for_each_mesh.h"
#include "method_variants.h"
#include "part_salience_fit.h"
#include "program.h"
#include "tree_errors.h"
#include "triangulations.h"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace segmentation_benchmark;

typedef nlohmann::ordered_json Json;
typedef std::map<std::size_t, Calibrated_part_salience> Saliences; // indexed by category

struct Options
{
  std::string folder, ids = "odd", json, cache;
  std::vector<std::string> triangulations = triangulation_names();
  std::size_t threads = 1, rounds = 3, passes = 1;
  std::size_t coarse_faces =
    CGAL::Spectral_segmentation::Options().number_of_coarse_faces;
  bool leaves_one_category_out = false, leaves_factors_out = false;
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("folder", o.folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
  app.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
  app.add_option("--rounds", o.rounds,
                 "of fitting again, each with more weight on the cuts that the last one prefers")
    ->capture_default_str();
  app.add_option("--passes", o.passes, "of runs, each with the numbers fitted to those before")
    ->check(CLI::Range(1, 100))->capture_default_str();
  app.add_option("--triangulation", o.triangulations, "in which the cuts are made")
    ->capture_default_str()->check(CLI::IsMember(triangulation_names()));
  app.add_option("--cache", o.cache, "folder that keeps the triangulations for other runs");
  app.add_option("--coarse-faces", o.coarse_faces,
                 "the number_of_coarse_faces of all runs; 0: the meshes themselves")
    ->capture_default_str();
  app.add_flag("--leave-one-category-out", o.leaves_one_category_out,
               "also judges each category by a fit to the others");
  app.add_flag("--leave-factors-out", o.leaves_factors_out,
               "also fits without each factor, and without related ones together");
  app.add_option("--json", o.json, "writes all figures, of each mesh too")->type_name("OUT");
  app.add_option("--threads", o.threads,
                 "meshes at a time, each on one thread; with 1, a mesh may use all threads")
    ->check(CLI::Range(1, 1024))->capture_default_str();
}

// f(mesh) of each mesh of the benchmark.
template <class Function>
auto of_each_mesh(const Options& o, const Function& f)
{
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<decltype(f(Benchmark_mesh()))> results(ids.size());
  Progress progress(ids.size());
  for_each_mesh(ids.size(), o.threads, [&](std::size_t i) {
    results[i] = f(read_benchmark_mesh(o.folder, ids[i]));
    progress.step();
  });
  return results;
}

Engine_options options_with(const Calibrated_part_salience& salience, std::size_t coarse_faces)
{
  Engine_options result = CGAL::Spectral_segmentation::Options();
  result.part_salience = salience;
  result.number_of_coarse_faces = coarse_faces;
  return result;
}

// The mesh in another triangulation, with people's segmentations of it.
Benchmark_mesh triangulated_as(const std::string& triangulation, const Benchmark_mesh& original,
                               const std::filesystem::path& cache)
{
  if (is_as_is(triangulation))
    return original;
  Mesh mesh =
    retriangulated(triangulation, original.mesh, cache, std::to_string(original.id)).mesh;
  const Retriangulated_mesh back{original.mesh, nearest_faces(mesh, original.mesh)};
  Benchmark_mesh result{original.id, std::move(mesh), {}};
  for (const Labels& person : original.people)
    result.people.push_back(carried_back(back, person));
  return result;
}

// The cuts of each mesh in each triangulation.
std::vector<Mesh_cuts> evaluated_cuts(const Options& o, const Calibrated_part_salience& salience)
{
  const std::vector<std::vector<Mesh_cuts> > of_meshes =
    of_each_mesh(o, [&](const Benchmark_mesh& mesh) {
      std::vector<Mesh_cuts> cuts;
      for (const std::string& triangulation : o.triangulations)
        cuts.push_back(evaluated_cuts(triangulated_as(triangulation, mesh, o.cache),
                                      options_with(salience, o.coarse_faces)));
      return cuts;
    });
  std::vector<Mesh_cuts> result;
  for (const std::vector<Mesh_cuts>& cuts : of_meshes)
    result.insert(result.end(), cuts.begin(), cuts.end());
  return result;
}

Tree_method method_with(const Calibrated_part_salience& salience, std::size_t coarse_faces)
{ return method_with("fitted", options_with(salience, coarse_faces), Execution::PARALLEL); }

std::vector<Tree_errors> errors_with(const Options& o, const Saliences& saliences)
{
  return of_each_mesh(o, [&](const Benchmark_mesh& mesh)
    { return tree_errors(mesh, method_with(saliences.at(category(mesh.id)), o.coarse_faces)); });
}

// For each category the fit to all others.
Saliences fits_to_others(const std::vector<Mesh_cuts>& meshes, std::size_t rounds)
{
  Saliences result;
  for (const Mesh_cuts& mesh : meshes) {
    const std::size_t left_out = category(mesh.id);
    if (result.count(left_out) != 0)
      continue;
    std::vector<Mesh_cuts> others;
    for (const Mesh_cuts& other : meshes)
      if (category(other.id) != left_out)
        others.push_back(other);
    if (others.empty())
      throw std::invalid_argument("one category cannot be left out of one");
    result[left_out] = fit_part_salience(others, rounds).salience;
  }
  return result;
}

std::vector<Tree_errors> errors_with(const Options& o, const Calibrated_part_salience& salience)
{
  return of_each_mesh(o, [&](const Benchmark_mesh& mesh)
    { return tree_errors(mesh, method_with(salience, o.coarse_faces)); });
}

// Factors that are left out together.
struct Factor_set
{
  std::string name;
  Left_out_factors factors;
};

// Each factor alone, and those that are computed from the same data.
std::vector<Factor_set> factor_sets()
{
  const auto set_of = [](const std::vector<std::string>& names) {
    Factor_set set;
    for (std::size_t i = 0; i < fitted_factors.size(); ++i)
      set.factors[i] = std::count(names.begin(), names.end(), fitted_factors[i].name) > 0;
    return set;
  };
  std::vector<Factor_set> result;
  for (const Fitted_factor& f : fitted_factors) {
    result.push_back(set_of({f.name}));
    result.back().name = f.name;
  }
  result.push_back(set_of({"convexity_gain", "relative_convexity_gain"}));
  result.back().name = "convexity, both";
  return result;
}

// Prints the gain of each set of factors: the errors without it against the errors with all
// factors.
void print_factors(const Options& o, const std::vector<Mesh_cuts>& cuts,
                   const std::vector<Tree_errors>& with_all, Json& json)
{
  const std::size_t best_with_all = best_threshold(mean_tree_errors(with_all));
  std::printf("\nLeft out; change of\nRand error%18s%21s%21s%21s\n", "default", "best threshold",
              "k", "tree");
  for (const Factor_set& set : factor_sets()) {
    const std::vector<Tree_errors> without =
      errors_with(o, fit_part_salience(cuts, o.rounds, set.factors).salience);
    const std::size_t best = best_threshold(mean_tree_errors(without));
    const auto change = [&](const auto& of_without, const auto& of_all) {
      const Paired_difference d =
        paired_difference(values_of(without, of_without), values_of(with_all, of_all));
      std::printf("   %+.4f +- %.4f", d.mean, d.standard_error);
    };
    std::printf("%-24s", set.name.c_str());
    change(&Tree_errors::by_default, &Tree_errors::by_default);
    change([=](const Tree_errors& e) { return e.automatic[best]; },
           [=](const Tree_errors& e) { return e.automatic[best_with_all]; });
    change(&Tree_errors::k, &Tree_errors::k);
    change(&Tree_errors::best, &Tree_errors::best);
    std::printf("\n");
    std::fflush(stdout);
    json[set.name] = json_of(mean_tree_errors(without));
  }
}

void print(const Part_salience_fit& fit)
{
  std::printf("  double constant = %.3f;\n", fit.salience.constant);
  for (const Fitted_factor& f : fitted_factors)
    std::printf("  double %s = %.3f;\n", f.name, fit.salience.*f.coefficient);
}

std::map<std::size_t, std::vector<Tree_errors> >
by_category(const std::vector<Tree_errors>& meshes)
{
  std::map<std::size_t, std::vector<Tree_errors> > result;
  for (const Tree_errors& mesh : meshes)
    result[category(mesh.id)].push_back(mesh);
  return result;
}

void print_line(const char* name, const std::vector<Tree_errors>& meshes, std::size_t threshold)
{
  const Tree_errors mean = mean_tree_errors(meshes);
  std::printf("%-10s %6zu %8.4f %8.4f %8.4f %8.4f\n", name, meshes.size(), mean.people,
              mean.automatic[threshold], mean.k, mean.best);
}

void print(const char* title, const std::vector<Tree_errors>& meshes)
{
  const Tree_errors mean = mean_tree_errors(meshes);
  const std::size_t best = best_threshold(mean);
  std::printf("\n%s\nthreshold     auto\n", title);
  for (std::size_t t = 0; t < mean.automatic.size(); ++t)
    std::printf("%9.2f %8.4f%s\n", tried_thresholds()[t], mean.automatic[t],
                t == best ? "  least" : "");
  std::printf("  default %8.4f\n", mean.by_default);
  std::printf("\nRand error meshes   people  auto%.2f       k     tree\n",
              tried_thresholds()[best]);
  for (const auto& [category, of_category] : by_category(meshes))
    print_line(category_names[category], of_category, best);
  print_line("all meshes", meshes, best);
  std::fflush(stdout);
}

Json json_of(const Calibrated_part_salience& salience)
{
  Json json = {{"constant", salience.constant}};
  for (const Fitted_factor& f : fitted_factors)
    json[f.name] = salience.*f.coefficient;
  return json;
}

Json json_of(const std::vector<Tree_errors>& meshes)
{
  const Tree_errors mean = mean_tree_errors(meshes);
  Json json = json_of(mean);
  json["best_threshold"] = tried_thresholds()[best_threshold(mean)];
  for (const Tree_errors& mesh : meshes)
    json["meshes"][std::to_string(mesh.id)] = json_of(mesh);
  return json;
}

void run(const Options& o)
{
  std::vector<Mesh_cuts> cuts;
  Part_salience_fit fit;
  for (std::size_t pass = 0; pass < o.passes; ++pass) {
    cuts = evaluated_cuts(o, fit.salience);
    fit = fit_part_salience(cuts, o.rounds);
    std::printf("pass %zu:", pass + 1);
    for (const Fitted_factor& f : fitted_factors)
      std::printf(" %.3f", fit.salience.*f.coefficient);
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("%zu cuts of %zu triangulations, loss %.5f\n\n", number_of_cuts(cuts), cuts.size(),
              fit.loss);
  print(fit);
  Saliences saliences;
  for (const Mesh_cuts& mesh : cuts)
    saliences[category(mesh.id)] = fit.salience;
  const std::vector<Tree_errors> errors = errors_with(o, saliences);
  print("Fitted to all meshes", errors);

  Json json = {{"cuts", number_of_cuts(cuts)},
               {"loss", fit.loss},
               {"salience", json_of(fit.salience)},
               {"thresholds", tried_thresholds()},
               {"fitted_to_all", json_of(errors)}};
  if (o.leaves_one_category_out) {
    saliences = fits_to_others(cuts, o.rounds);
    const std::vector<Tree_errors> of_left_out = errors_with(o, saliences);
    print("Each category by a fit to the others", of_left_out);
    Json& left_out = json["fitted_to_others"] = json_of(of_left_out);
    for (const auto& [category, salience] : saliences)
      left_out["salience"][category_names[category]] = json_of(salience);
  }
  if (o.leaves_factors_out)
    print_factors(o, cuts, errors, json["without_factors"]);
  write_json(o.json, json);
}

int main(int argc, char** argv)
{
  return run_program("fit_part_salience",
                     "Fits the calibrated salience to people's cuts on the Princeton benchmark.",
                     add_options, run, argc, argv);
}
