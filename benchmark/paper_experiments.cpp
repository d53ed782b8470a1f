// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// The experiments of Zhang and Liu 2005 on the Princeton Segmentation Benchmark. A claim of the
/// paper is reproduced if a difference has the claimed sign and more than twice its standard error.

#include "paper_experiments/experiments.h"
#include "program.h"

#include <CLI/CLI.hpp>

using namespace segmentation_benchmark;

struct Options
{
  Experiment_options values;
  void (*experiment)(const Experiment_options&) = nullptr;
};

CLI::App& add_experiment(CLI::App& app, Options& o, const char* name, const char* description,
                         void (*experiment)(const Experiment_options&))
{
  CLI::App& command = *app.add_subcommand(name, description);
  add_benchmark_options(command, o.values.folder, o.values.ids);
  command.callback([&o, experiment] { o.experiment = experiment; });
  return command;
}

// Compares the numbers of samples on meshes with few faces, which exact eigenvectors need.
void compare_on_small_meshes(const Experiment_options& o)
{
  Experiment_options small = o;
  small.faces = 1000;
  compare_numbers_of_samples(small);
}

void add_options(CLI::App& app, Options& o)
{
  app.require_subcommand(1);
  add_experiment(app, o, "placement", "Figure 1: line search between samples in the same part, and "
                 "in different parts", compare_placements);
  add_experiment(app, o, "sampling", "Section 4: how often the two samples lie in different parts, "
                 "by sampling scheme", compare_samplings);
  CLI::App& clustering = add_experiment(
    app, o, "clustering", "Section 7.1: k-way and recursive k-means on spectral embeddings, and "
    "line search", compare_with_clusterings);
  clustering.add_option("--samples", o.values.samples,
                        "rows of the affinity matrix; it is whole in parts with no more faces")
    ->check(CLI::Range(2, 20000))->capture_default_str();
  clustering.add_option("--faces", o.values.faces,
                        "to which the meshes are decimated, so that the matrix can be whole")
    ->check(CLI::Range(200, 20000));
  add_experiment(app, o, "nystrom", "Section 7.2: eigenvectors and segmentations by two samples "
                 "and by more, on meshes decimated to 1000 faces", compare_on_small_meshes);
}

void run(const Options& o) { o.experiment(o.values); }

int main(int argc, char** argv)
{
  return run_program("paper_experiments",
                     "The experiments of Zhang and Liu 2005 on the Princeton benchmark.",
                     add_options, run, argc, argv);
}
