// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// What each of the things that the default method is made of gains in error, and costs in time, on
/// the Princeton Segmentation Benchmark: each is left out alone.

#include "evaluation.h"
#include "for_each_mesh.h"
#include "method_variants.h"
#include "program.h"
#include "score_report.h"
#include "tree_errors.h"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::string folder, ids = "odd", json;
  std::size_t threads = 1;
};

// The errors of one method.
struct Result
{
  const char* name;
  std::vector<Tree_errors> meshes;
};

// The columns of the table.
struct Figures
{
  double best_threshold, seconds;
  std::vector<double> by_default, best_automatic, k, best_of_tree; // one per mesh
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("folder", o.folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
  app.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
  app.add_option("--json", o.json, "writes all figures, of each mesh too")->type_name("OUT");
  app.add_option("--threads", o.threads, "meshes at a time, each on one thread")
    ->check(CLI::Range(1, 1024))->capture_default_str();
}

std::vector<Result> results(const Options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  const std::vector<Tree_method> methods = ablated_methods();
  std::vector<Result> result;
  for (const Tree_method& method : methods)
    result.push_back({method.name, std::vector<Tree_errors>(ids.size())});
  Progress progress(ids.size());
  for_each_mesh(ids.size(), o.threads, [&](std::size_t i) {
    const Benchmark_mesh input = read_benchmark_mesh(o.folder, ids[i]);
    for (std::size_t m = 0; m < methods.size(); ++m)
      result[m].meshes[i] = tree_errors(input, methods[m]);
    progress.step();
  });
  return result;
}

Figures figures(const Result& result)
{
  const std::size_t best = best_threshold(mean_tree_errors(result.meshes));
  return {tried_thresholds()[best],
          median(values_of(result.meshes, [](const Tree_errors& e) { return e.time.thread; })),
          values_of(result.meshes, &Tree_errors::by_default),
          values_of(result.meshes, [best](const Tree_errors& e) { return e.automatic[best]; }),
          values_of(result.meshes, &Tree_errors::k),
          values_of(result.meshes, &Tree_errors::best)};
}

// The mean, its change from the first line, and the standard error of the change.
void print_error(const std::vector<double>& errors, const std::vector<double>& of_first)
{
  const Paired_difference change = paired_difference(errors, of_first);
  std::printf(" %7.4f %+8.4f +- %.4f", mean_of(errors), change.mean, change.standard_error);
}

void print_line(const char* name, const Figures& f, const Figures& first)
{
  std::printf("%-28s", name);
  print_error(f.by_default, first.by_default);
  print_error(f.best_automatic, first.best_automatic);
  std::printf(" %9.2f", f.best_threshold);
  print_error(f.k, first.k);
  print_error(f.best_of_tree, first.best_of_tree);
  std::printf(" %7.3f %+8.3f\n", f.seconds, f.seconds - first.seconds);
}

void print(const std::vector<Result>& results)
{
  std::printf("%-28s %7s %18s %7s %18s %9s %7s %18s %7s %18s %7s %8s\n", "Rand error", "auto",
              "change", "best", "change", "threshold", "k", "change", "tree", "change", "seconds",
              "change");
  const Figures first = figures(results.front());
  for (const Result& result : results)
    print_line(result.name, figures(result), first);
}

Json json_of(const Result& result)
{
  const Figures f = figures(result);
  Json json = {{"name", result.name},
               {"auto", mean_of(f.by_default)},
               {"best_auto", mean_of(f.best_automatic)},
               {"best_threshold", f.best_threshold},
               {"k", mean_of(f.k)},
               {"tree", mean_of(f.best_of_tree)},
               {"median_seconds", f.seconds}};
  for (const Tree_errors& mesh : result.meshes)
    json["meshes"][std::to_string(mesh.id)] = json_of(mesh);
  return json;
}

void run(const Options& o)
{
  const std::vector<Result> all = results(o);
  print(all);
  std::printf("auto: at the default threshold; best: at the one threshold that is best for these "
              "meshes\nk: people's usual number of parts is given; tree: the best number of parts"
              "\nseconds: median of one thread for a whole tree; change: from the first line, with "
              "the standard error over the meshes\n");
  std::fflush(stdout);
  Json json = {{"thresholds", tried_thresholds()}};
  for (const Result& result : all)
    json["methods"].push_back(json_of(result));
  write_json(o.json, json);
}

int main(int argc, char** argv)
{
  return run_program("segmentation_ablation",
                     "What the default method gains by each of its parts, on people's cuts.",
                     add_options, run, argc, argv);
}
