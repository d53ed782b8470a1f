// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// What each of the things that the default method is made of gains in error, and costs in time, on
/// the Princeton Segmentation Benchmark: each is left out alone.

#include "Method_trees.h"
#include "evaluation.h"
#include "for_each_mesh.h"
#include "method_variants.h"
#include "program.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::string folder, ids = "odd";
  std::size_t threads = 1;
};

// The errors of one method.
struct Result
{
  const char* name;
  std::vector<Tree_errors> meshes;
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("folder", o.folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
  app.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
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

// Prints the mean, its change from the first line, and the standard error of the change.
void print_error(const Result& result, const Result& first, double Tree_errors::*error)
{
  const std::vector<double> errors = values_of(result.meshes, error);
  const Paired_difference change = paired_difference(errors, values_of(first.meshes, error));
  std::printf(" %7.4f %+8.4f +- %.4f", mean_of(errors), change.mean, change.standard_error);
}

void run(const Options& o)
{
  const std::vector<Result> all = results(o);
  const auto seconds = [](const Result& result)
  { return median(values_of(result.meshes, &Tree_errors::seconds)); };
  std::printf("%-28s %7s %18s %7s %18s %7s %18s %7s %8s\n", "Rand error", "auto", "change", "k",
              "change", "tree", "change", "seconds", "change");
  for (const Result& result : all) {
    std::printf("%-28s", result.name);
    for (double Tree_errors::*error :
         {&Tree_errors::by_default, &Tree_errors::k, &Tree_errors::best})
      print_error(result, all.front(), error);
    std::printf(" %7.3f %+8.3f\n", seconds(result), seconds(result) - seconds(all.front()));
  }
  std::printf("auto: at the default threshold; k: people's usual number of parts is given; tree: "
              "the best number\nof parts; seconds: median of one thread for a whole tree; change: "
              "from the first line, with the\nstandard error over the meshes\n");
}

int main(int argc, char** argv)
{
  return run_program("segmentation_ablation",
                     "What the default method gains by each of its parts, on people's cuts.",
                     add_options, run, argc, argv);
}
