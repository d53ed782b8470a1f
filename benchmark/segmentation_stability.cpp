// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Rand distance between the result on a mesh and on the same mesh after a change that leaves its
/// shape as it is, or nearly so.

#include "for_each_mesh.h"
#include "mesh_changes.h"
#include "program.h"
#include "segmentation_methods.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::vector<std::string> inputs;
  std::string ids = "odd";
  std::vector<std::string> methods = {tree_methods().front().name};
  unsigned int seed = 0;
  std::size_t threads = 1;
};

// The distances of one method under one change.
struct Distances
{
  Mean mean, identical;
  double largest = 0;
  std::string worst;

  void add(double distance, const std::string& name)
  {
    mean.add(distance);
    identical.add(distance == 0);
    if (distance > largest) {
      largest = distance;
      worst = name;
    }
  }
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("inputs", o.inputs, "folder of the Princeton benchmark, or mesh files")
    ->required()->check(CLI::ExistingPath);
  app.add_option("--ids", o.ids, "of the benchmark: odd, even, all, or a list as 1-20,33")
    ->capture_default_str();
  app.add_option("--method", o.methods, "what is compared with itself [" +
                                          std::string(tree_methods().front().name) + "]")
    ->check(CLI::IsMember(method_names()));
  app.add_option("--seed", o.seed, "of the random changes of each mesh")->capture_default_str();
  app.add_option("--threads", o.threads,
                 "meshes at a time, each on one thread; with 1, a mesh may use all threads")
    ->check(CLI::Range(1, 1024))->capture_default_str();
}

std::vector<std::filesystem::path> mesh_files(const Options& o)
{
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path input : o.inputs)
    if (std::filesystem::is_directory(input))
      for (int id : parse_ids(o.ids))
        files.push_back(input / "off" / (std::to_string(id) + ".off"));
    else
      files.push_back(input);
  return files;
}

double distance(const std::string& method, const Labels& original, const Changed_mesh& changed)
{
  Labels expected;
  for (std::size_t f : changed.original_faces)
    expected.push_back(original[f]);
  return rand_error(contiguous(expected), default_labels(method, changed.mesh));
}

void print(const std::string& change, const Distances& d)
{
  std::printf("  %-14s %8.4f %8.4f  %7.0f %%  %s\n", change.c_str(), d.mean(), d.largest,
              100 * d.identical(), d.worst.c_str());
}

// One for each change.
std::vector<double> distances(const std::string& method, const Mesh& mesh, unsigned int seed)
{
  const Labels original = default_labels(method, mesh);
  CGAL::Random random(seed);
  std::vector<double> result;
  for (const Mesh_change& change : mesh_changes())
    result.push_back(distance(method, original, change.apply(mesh, random)));
  return result;
}

void compare(const Options& o, const std::string& method)
{
  const std::vector<std::filesystem::path> files = mesh_files(o);
  std::vector<std::vector<double> > of_mesh(files.size());
  {
    Progress progress(files.size());
    for_each_mesh(files.size(), o.threads, [&](std::size_t i) {
      of_mesh[i] = distances(method, read_mesh(files[i]), o.seed);
      progress.step();
    });
  }
  std::printf("%s\n  %-14s %8s %8s  %9s  %s\n", method.c_str(), "Rand distance", "mean",
              "largest", "identical", "of mesh");
  for (std::size_t change = 0; change < mesh_changes().size(); ++change) {
    Distances all;
    for (std::size_t i = 0; i < files.size(); ++i)
      all.add(of_mesh[i][change], files[i].stem().string());
    print(mesh_changes()[change].name, all);
  }
}

void run(const Options& o)
{
  for (const std::string& method : o.methods)
    compare(o, method);
}

int main(int argc, char** argv)
{
  return run_program("segmentation_stability",
                     "How much a segmentation changes with the mesh when the shape does not.",
                     add_options, run, argc, argv);
}
