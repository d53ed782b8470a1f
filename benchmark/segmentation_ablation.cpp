// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Measures how much each element of the default method reduces the error, and how much time it
/// takes, on the Princeton Segmentation Benchmark: each is left out alone.

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

void add_options(CLI::App& app, Options& o)
{
  add_benchmark_options(app, o.folder, o.ids);
  add_threads_option(app, o.threads);
}

typedef std::vector<Tree_errors> Errors_of_methods;

std::vector<double> values(const std::vector<Errors_of_methods>& meshes, std::size_t method,
                           double Tree_errors::*value)
{ return values_of(meshes, [=](const Errors_of_methods& e) { return e[method].*value; }); }

// Prints the mean, its change from the first method, and the standard error of the change.
void print_error(const std::vector<double>& errors, const std::vector<double>& of_first)
{
  const Paired_difference change = paired_difference(errors, of_first);
  std::printf(" %7.4f %+8.4f +- %.4f", mean_of(errors), change.mean, change.standard_error);
}

void run(const Options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  const std::vector<Tree_method> methods = ablated_methods();
  const auto meshes = results_of_meshes(ids.size(), o.threads, [&](std::size_t i) {
    const Benchmark_mesh input = read_benchmark_mesh(o.folder, ids[i]);
    Errors_of_methods result;
    for (const Tree_method& method : methods)
      result.push_back(tree_errors(input, method));
    return result;
  });
  const auto seconds = [&](std::size_t method)
  { return median(values(meshes, method, &Tree_errors::seconds)); };
  std::printf("%-28s %7s %18s %7s %18s %7s %18s %7s %8s\n", "Rand error", "auto", "change", "k",
              "change", "tree", "change", "seconds", "change");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::printf("%-28s", methods[m].name);
    for (double Tree_errors::*error :
         {&Tree_errors::by_default, &Tree_errors::k, &Tree_errors::best})
      print_error(values(meshes, m, error), values(meshes, 0, error));
    std::printf(" %7.3f %+8.3f\n", seconds(m), seconds(m) - seconds(0));
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
