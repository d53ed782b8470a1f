// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Rand distance and agreement between the result on a mesh and on the same mesh after a change
/// that leaves its shape as it is, or nearly so.

#include "for_each_mesh.h"
#include "mesh_changes.h"
#include "program.h"
#include "segmentation_methods.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::string folder, ids = "odd";
  std::size_t threads = 1;
};

// The effect of one change on one mesh.
struct Effect
{
  double rand_distance, agreement;
};

// The effects of one change on all meshes.
struct Effects
{
  Mean rand_distance, agreement, is_identical;
  double least_agreement = 1;
  std::string worst;

  void add(const Effect& e, const std::string& name)
  {
    rand_distance.add(e.rand_distance);
    agreement.add(e.agreement);
    is_identical.add(e.agreement == 1);
    if (e.agreement < least_agreement) {
      least_agreement = e.agreement;
      worst = name;
    }
  }
};

// Returns the fraction of faces with the same label, after the labels were matched, those with most
// faces in common first.
double agreement(const Labels& a, const Labels& b)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> common;
  for (std::size_t f = 0; f < a.size(); ++f)
    ++common[{a[f], b[f]}];
  std::vector<std::pair<std::size_t, std::pair<std::size_t, std::size_t> > > pairs;
  for (const auto& [labels, number] : common)
    pairs.push_back({number, labels});
  std::sort(pairs.rbegin(), pairs.rend());
  std::set<std::size_t> matched[2];
  std::size_t result = 0;
  for (const auto& [number, labels] : pairs)
    if (matched[0].count(labels.first) == 0 && matched[1].count(labels.second) == 0) {
      matched[0].insert(labels.first);
      matched[1].insert(labels.second);
      result += number;
    }
  return static_cast<double>(result) / static_cast<double>(a.size());
}

void add_options(CLI::App& app, Options& o)
{
  add_benchmark_options(app, o.folder, o.ids);
  add_threads_option(app, o.threads);
}

Labels segment(const Mesh& mesh) { return default_labels("calibrated", mesh); }

Effect effect(const Labels& original, const Changed_mesh& changed)
{
  Labels expected;
  for (std::size_t f : changed.original_faces)
    expected.push_back(original[f]);
  const Labels labels = segment(changed.mesh);
  return {rand_error(contiguous(expected), labels), agreement(expected, labels)};
}

void print(const std::string& change, const Effects& e)
{
  std::printf("%-14s %8.4f  %8.2f %% %6.1f %%  %7.0f %%  %s\n", change.c_str(),
              e.rand_distance(), 100 * e.agreement(), 100 * e.least_agreement,
              100 * e.is_identical(), e.worst.c_str());
}

// Returns the effect of each change on a mesh.
std::vector<Effect> effects(const Mesh& mesh)
{
  const Labels original = segment(mesh);
  CGAL::Random random(0);
  std::vector<Effect> result;
  for (const Mesh_change& change : mesh_changes())
    result.push_back(effect(original, change.apply(mesh, random)));
  return result;
}

void run(const Options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  const auto of_mesh = results_of_meshes(ids.size(), o.threads, [&](std::size_t i)
    { return effects(read_benchmark_mesh(o.folder, ids[i]).mesh); });
  std::printf("%-14s %8s  %10s %8s  %9s  %s\n", "change", "Rand", "agreement", "least",
              "identical", "of mesh");
  for (std::size_t change = 0; change < mesh_changes().size(); ++change) {
    Effects all;
    for (std::size_t i = 0; i < ids.size(); ++i)
      all.add(of_mesh[i][change], std::to_string(ids[i]));
    print(mesh_changes()[change].name, all);
  }
}

int main(int argc, char** argv)
{
  return run_program("segmentation_stability",
                     "How much a segmentation changes with the mesh when the shape does not.",
                     add_options, run, argc, argv);
}
