// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Compares methods with people's cuts on the Princeton Segmentation Benchmark (Chen, Golovinskiy,
/// Funkhouser, SIGGRAPH 2009): all metrics of the benchmark, by category and overall, and the
/// distance from the least Rand error that one segmentation can have with respect to all people,
/// of which an upper bound is computed. The meshes may also be segmented in other triangulations,
/// or put together from many closed components, which should give the same parts. Other meshes
/// have parts that are known: unions of primitives, which stand for mechanical parts, and files
/// with the part of each triangle, which need not form a manifold.

#include "Contact_sheet.h"
#include "assembled_meshes.h"
#include "for_each_mesh.h"
#include "primitive_unions.h"
#include "program.h"
#include "score_known_parts.h"
#include "score_mesh.h"
#include "score_report.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using namespace segmentation_benchmark;

struct Options
{
  std::string folder, ids = "odd", json, sheet, cache, sheet_of_unions, known_parts;
  std::vector<std::string> methods = method_names();
  std::vector<std::string> protocols = {"auto", "k", "tree"};
  std::vector<std::string> triangulations = {triangulation_names().front()};
  std::optional<double> threshold;
  std::size_t threads = 1, unions = 0;

  Options() { methods.push_back(people_method); }
};

std::vector<std::string> names_of_triangulations()
{
  std::vector<std::string> names = triangulation_names();
  names.insert(names.end(), assembly_names().begin(), assembly_names().end());
  return names;
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("folder", o.folder,
                 "holds off/N.off and seg/Benchmark/N/*.seg; may be left out with "
                 "--primitive-unions or --known-parts")
    ->check(CLI::ExistingDirectory);
  app.add_option("--ids", o.ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
  app.add_option("--method", o.methods, "rows of the tables [all]")
    ->check(CLI::IsMember(o.methods));
  app.add_option("--protocol", o.protocols,
                 "auto: nothing is given; k: people's usual number of parts is, or that of known "
                 "parts; tree: the best number of parts of the tree [all]")
    ->check(CLI::IsMember(o.protocols));
  app.add_option("--triangulation", o.triangulations,
                 "in which the meshes are segmented, several for a comparison: as_is; decimated to "
                 "1500 faces; remeshed to about 8000 like ones; subdivided, each face in four; or "
                 "put together from closed components with gaps or intersecting, which are the "
                 "first person's parts cut by random cells [as_is]")
    ->check(CLI::IsMember(names_of_triangulations()));
  app.add_option("--cache", o.cache,
                 "where meshes that are decimated or remeshed are kept for further runs")
    ->type_name("DIR");
  app.add_option("--threshold", o.threshold,
                 "of the protocol auto, in place of each method's default");
  app.add_option("--json", o.json, "writes all figures, of each mesh too")->type_name("OUT");
  app.add_option("--sheet", o.sheet, "writes a picture of all meshes as the first row cuts them")
    ->type_name("OUT.png");
  app.add_option("--primitive-unions", o.unions,
                 "also segments so many mechanical parts, made by the seeds from 1 on")
    ->check(CLI::Range(1, 1000000));
  app.add_option("--unions-sheet", o.sheet_of_unions,
                 "writes a picture of each with its true parts, and as the first row cuts it")
    ->type_name("OUT.png");
  app.add_option("--known-parts", o.known_parts,
                 "also segments the files NAME.off of a folder, whose triangles need not form a "
                 "manifold; NAME.truth beside it has the number of the true part of each triangle")
    ->check(CLI::ExistingDirectory)->type_name("DIR");
  app.add_option("--threads", o.threads,
                 "meshes at a time, each on one thread; with 1, a mesh may use all threads")
    ->check(CLI::Range(1, 1024))->capture_default_str();
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
            (protocol == Protocol::AUTO || is_tree_method(method)))
          for (const std::string& triangulation : o.triangulations)
            rows.push_back({method, protocol, triangulation});
  if (rows.empty())
    throw std::invalid_argument("none of the methods has such a protocol");
  return rows;
}

std::string caption(int id, const Score& score)
{
  char text[40];
  std::snprintf(text, sizeof text, "%03d %s %.3f", id, category_names[category(id)],
                score.errors[RAND_ERROR]);
  return text;
}

std::vector<Scored_mesh> score_meshes(const Options& o, const std::vector<Row>& rows,
                                      Contact_sheet* sheet)
{
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<Scored_mesh> meshes(ids.size());
  Progress progress(ids.size());
  for_each_mesh(ids.size(), o.threads, [&](std::size_t i) {
    const Benchmark_mesh input = read_benchmark_mesh(o.folder, ids[i]);
    meshes[i] = Mesh_scorer(input, o.threshold, o.cache)(rows);
    const Score& first = meshes[i].scores.front();
    if (sheet)
      sheet->add(caption(ids[i], first), input.mesh, first.labels);
    for (Score& score : meshes[i].scores)
      Labels().swap(score.labels);
    progress.step();
  });
  return meshes;
}

void report_on_benchmark(const Options& o, const std::vector<Row>& rows, Json& json)
{
  std::optional<Contact_sheet> sheet;
  if (!o.sheet.empty())
    sheet.emplace();
  const std::vector<Scored_mesh> meshes = score_meshes(o, rows, sheet ? &*sheet : nullptr);

  const std::vector<Row_summary> summaries = row_summaries(rows, meshes);
  print_metrics(summaries);
  std::printf("\n");
  print_categories(summaries);
  if (o.triangulations.size() > 1) {
    std::printf("\n");
    print_triangulations(summaries, meshes);
  }
  std::fflush(stdout);
  json = json_report(summaries, meshes);
  if (sheet)
    sheet->write(o.sheet);
}

void add_to_sheet(Contact_sheet& sheet, const Known_parts& input, const Known_parts_score& score)
{
  char text[40];
  std::snprintf(text, sizeof text, "%03d", std::stoi(input.name));
  sheet.add(text + std::string(" known"), *input.mesh, input.truth);
  std::snprintf(text, sizeof text, "%03d result %.3f", std::stoi(input.name), score.by_area);
  sheet.add(text, *input.mesh, score.labels);
}

// Scores n meshes, make_mesh(0) .. make_mesh(n - 1), and prints the means.
template <class MakeMesh>
Json report_on_known_parts(const Options& o, const std::string& kind, const std::vector<Row>& rows,
                           std::size_t n, const MakeMesh& make_mesh, Contact_sheet* sheet)
{
  std::vector<Scored_known_parts> meshes(n);
  {
    Progress progress(n);
    for_each_mesh(n, o.threads, [&](std::size_t i) {
      const Known_parts input = make_mesh(i);
      meshes[i] = Known_parts_scorer(input)(rows);
      if (sheet)
        add_to_sheet(*sheet, input, meshes[i].scores.front());
      for (Known_parts_score& score : meshes[i].scores)
        Labels().swap(score.labels);
      progress.step();
    });
  }
  print_known_parts(kind, rows, meshes);
  std::fflush(stdout);
  return json_of_known_parts(rows, meshes);
}

Json report_on_unions(const Options& o, const std::vector<Row>& rows)
{
  std::optional<Contact_sheet> sheet;
  if (!o.sheet_of_unions.empty())
    sheet.emplace();
  Json json = report_on_known_parts(
    o, "unions of primitives", rows_of_known_parts(rows, true), o.unions,
    [](std::size_t i) { return primitive_union(i + 1); }, sheet ? &*sheet : nullptr);
  if (sheet)
    sheet->write(o.sheet_of_unions);
  return json;
}

Json report_on_files(const Options& o, const std::vector<Row>& rows)
{
  const std::vector<std::filesystem::path> files = off_files(o.known_parts);
  Json json = report_on_known_parts(
    o, "files with known parts", rows_of_known_parts(rows, false), files.size(),
    [&](std::size_t i) { return read_known_parts(files[i]); }, nullptr);
  for (const Label_method& method : label_methods())
    if (!is_reference(method.name) && std::count(o.methods.begin(), o.methods.end(), method.name))
      std::printf("%s is left out: it needs a manifold mesh\n", method.name);
  return json;
}

void run(const Options& o)
{
  if (o.folder.empty() && o.unions == 0 && o.known_parts.empty())
    throw std::invalid_argument("there is nothing to segment: give the folder of the benchmark, "
                                "--primitive-unions or --known-parts");
  const std::vector<Row> rows = selected_rows(o);
  Json json;
  if (!o.folder.empty())
    report_on_benchmark(o, rows, json);
  if (o.unions > 0) {
    if (!json.empty())
      std::printf("\n");
    json["primitive_unions"] = report_on_unions(o, rows);
  }
  if (!o.known_parts.empty()) {
    if (!json.empty())
      std::printf("\n");
    json["known_parts"] = report_on_files(o, rows);
  }
  write_json(o.json, json);
}

int main(int argc, char** argv)
{
  return run_program("segmentation_quality",
                     "Errors of segmentations with respect to people's on the Princeton benchmark.",
                     add_options, run, argc, argv);
}
