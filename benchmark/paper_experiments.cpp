// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// The experiments of Zhang and Liu 2005 on the Princeton Segmentation Benchmark, each with a
/// sentence whether the claim of the paper was reproduced. With --pictures they leave meshes for
/// scripts/render.py and plots for scripts/plot_lines.py.

#include "paper_experiments/experiments.h"
#include "program.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>

using namespace segmentation_benchmark;

struct Options
{
  std::function<void()> experiment;
};

void add_benchmark_options(CLI::App& command, Experiment_options& o)
{
  command.add_option("folder", o.folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
  command.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")
    ->capture_default_str();
  command.add_option("--pictures", o.pictures,
                     "writes what the first mesh looks like (PLY), and plots (JSON)")
    ->type_name("FOLDER");
  command.add_option("--seed", o.seed, "of all random choices")->capture_default_str();
}

// The options of a sub-command live as long as its callback.
template <class Experiment>
CLI::App& add_experiment(CLI::App& app, Options& o, const char* name, const char* description,
                         void (*run)(const Experiment&), std::shared_ptr<Experiment> options)
{
  CLI::App& command = *app.add_subcommand(name, description);
  add_benchmark_options(command, *options);
  command.callback([&o, run, options] { o.experiment = [run, options] { run(*options); }; });
  return command;
}

void add_options(CLI::App& app, Options& o)
{
  app.require_subcommand(1);

  const auto placement = std::make_shared<Placement_options>();
  add_experiment(app, o, "placement", "Figure 1: line search between samples in the same part, and "
                 "in different parts", run_placement_of_samples, placement)
    .add_option("--pairs", placement->pairs, "of samples, of each kind on each mesh")
    ->check(CLI::Range(1, 1000))->capture_default_str();

  add_experiment(app, o, "sampling", "Section 4: how often the two samples lie in different parts, "
                 "by sampling scheme", run_comparison_of_samplings,
                 std::make_shared<Experiment_options>());

  const auto clustering = std::make_shared<Clustering_options>();
  CLI::App& clusters = add_experiment(
    app, o, "clustering", "Section 7.1: k-way and recursive k-means on spectral embeddings, and "
    "line search", run_comparison_with_clustering, clustering);
  clusters.add_option("--samples", clustering->samples,
                      "rows of the affinity matrix; it is whole in parts with no more faces")
    ->check(CLI::Range(2, 20000))->capture_default_str();
  clusters.add_option("--faces", clustering->faces,
                      "to which the meshes are decimated, so that the matrix can be whole")
    ->check(CLI::Range(200, 20000));

  const auto numbers = std::make_shared<Number_of_samples_options>();
  add_experiment(app, o, "nystrom",
                 "Section 7.2: eigenvectors and segmentations by two samples and by more",
                 run_number_of_samples, numbers)
    .add_option("--faces", numbers->faces, "to which the meshes are decimated")
    ->check(CLI::Range(200, 5000))->capture_default_str();
}

void run(const Options& o) { o.experiment(); }

int main(int argc, char** argv)
{
  return run_program("paper_experiments",
                     "The experiments of Zhang and Liu 2005 on the Princeton benchmark.",
                     add_options, run, argc, argv);
}
