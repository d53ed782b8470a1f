// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Compares methods with people's cuts on the Princeton Segmentation Benchmark (Chen, Golovinskiy,
/// Funkhouser, SIGGRAPH 2009), by category and overall. The meshes may also be segmented in other
/// triangulations, which should give the same parts. Other meshes have parts that are known: files
/// with the part of each triangle, which need not form a manifold.

#include "for_each_mesh.h"
#include "program.h"
#include "score_known_parts.h"
#include "score_mesh.h"
#include "score_report.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::string folder, ids = "odd", json, cache, known_parts;
  std::vector<std::string> methods = method_names();
  std::vector<std::string> protocols = {"auto", "k", "tree"};
  std::vector<std::string> triangulations = {triangulation_names().front()};
  std::optional<double> threshold;
  std::size_t threads = 1;

  Options() { methods.push_back(people_method); }
};

void add_options(CLI::App& app, Options& o)
{
  add_benchmark_options(app, o.folder, o.ids)->required(false); // with --known-parts
  app.add_option("--method", o.methods, "rows of the tables [all]")
    ->check(CLI::IsMember(o.methods));
  app.add_option("--protocol", o.protocols,
                 "auto: nothing is given; k: people's usual number of parts is, or that of known "
                 "parts; tree: the best number of parts of the tree [all]")
    ->check(CLI::IsMember(o.protocols));
  app.add_option("--triangulation", o.triangulations,
                 "in which the meshes are segmented, several for a comparison: as_is; decimated to "
                 "1500 faces; remeshed to about 8000 like ones; or subdivided, each face in four "
                 "[as_is]")
    ->check(CLI::IsMember(triangulation_names()));
  app.add_option("--cache", o.cache,
                 "where meshes that are decimated or remeshed are kept for further runs")
    ->type_name("DIR");
  app.add_option("--threshold", o.threshold,
                 "of the protocol auto, in place of each method's default");
  app.add_option("--json", o.json, "writes the values of each mesh")->type_name("OUT");
  app.add_option("--known-parts", o.known_parts,
                 "also segments the files NAME.off of a folder, whose triangles need not form a "
                 "manifold; NAME.truth beside it has the number of the true part of each triangle")
    ->check(CLI::ExistingDirectory)->type_name("DIR");
  add_threads_option(app, o.threads);
}

std::vector<Row> selected_rows(const Options& o)
{
  std::vector<Row> rows;
  for (const std::string& method : o.methods)
    if (method == people_method)
      rows.push_back({method, Protocol::OTHERS});
    else
      for (Protocol protocol : {Protocol::AUTO, Protocol::K, Protocol::TREE})
        if (std::count(o.protocols.begin(), o.protocols.end(), name(protocol)) != 0 &&
            (protocol == Protocol::AUTO || tree_method(method)))
          for (const std::string& triangulation : o.triangulations)
            rows.push_back({method, protocol, triangulation});
  if (rows.empty())
    throw std::invalid_argument("none of the methods has such a protocol");
  return rows;
}

Json report_on_benchmark(const Options& o, const std::vector<Row>& rows)
{
  const std::vector<int> ids = parse_ids(o.ids);
  const auto meshes = results_of_meshes(ids.size(), o.threads, [&](std::size_t i) {
    return Mesh_scorer(read_benchmark_mesh(o.folder, ids[i]), o.threshold, o.cache)(rows);
  });
  const std::vector<Row_summary> summaries = row_summaries(rows, meshes);
  print_means(summaries);
  std::printf("\n");
  print_categories(summaries);
  if (o.triangulations.size() > 1) {
    std::printf("\n");
    print_triangulations(summaries, meshes);
  }
  return json_report(rows, meshes);
}

Json report_on_known_parts(const Options& o, const std::vector<Row>& rows)
{
  const std::vector<std::filesystem::path> files = off_files(o.known_parts);
  const auto meshes = results_of_meshes(files.size(), o.threads, [&](std::size_t i)
    { return Known_parts_scorer(read_known_parts(files[i]))(rows); });
  print_known_parts(rows, meshes);
  return json_of_known_parts(rows, meshes);
}

void run(const Options& o)
{
  if (o.folder.empty() && o.known_parts.empty())
    throw std::invalid_argument("there is nothing to segment: give the folder of the benchmark, "
                                "or --known-parts");
  const std::vector<Row> rows = selected_rows(o);
  Json json;
  if (!o.folder.empty())
    json["benchmark"] = report_on_benchmark(o, rows);
  if (!o.known_parts.empty())
    json["known_parts"] = report_on_known_parts(o, rows_of_known_parts(rows));
  if (!o.json.empty() && !(std::ofstream(o.json) << json.dump(1) << std::endl))
    throw std::runtime_error("cannot write " + o.json);
}

int main(int argc, char** argv)
{
  return run_program("segmentation_quality",
                     "Errors of segmentations with respect to people's on the Princeton benchmark.",
                     add_options, run, argc, argv);
}
