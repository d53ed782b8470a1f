// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Table 1 of Zhang and Liu 2005 with its own rows beside ours, for meshes of libcgal-demo of the
/// same size and about the same kind, by the paper's method into the same number of parts.

#include "princeton_benchmark.h"
#include "program.h"
#include "segmentation_metrics.h"
#include "sized_mesh.h"

#include "../bindings/command_line/Run_watch.h"

#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <boost/property_map/vector_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::Stage;
namespace params = CGAL::Spectral_segmentation::parameters;

constexpr std::array<const char*, 5> columns = {"initialization", "sampling", "embedding",
                                                "line search", "total"};

typedef std::array<double, columns.size()> Seconds;

struct Row
{
  const char* model;
  std::size_t faces;
  Seconds seconds;
  std::size_t parts;
  const char* our_mesh;
};

const Row rows[] = {
  {"Heart", 1600, {0.04, 0.03, 0.01, 0.09, 0.17}, 5, "blobby"},
  {"Dolphin", 2000, {0.03, 0.14, 0.03, 0.25, 0.45}, 8, "cow"},
  {"Bird", 3000, {0.07, 0.15, 0.02, 0.24, 0.48}, 5, "triceratops"},
  {"Dino-pet", 4000, {0.08, 0.45, 0.15, 0.79, 1.47}, 29, "dino"},
  {"Snake", 12000, {0.24, 0.40, 0.12, 0.61, 1.37}, 4, "diplodocus"},
  {"Bowl", 13000, {0.25, 0.30, 0.07, 0.32, 0.94}, 3, "mushroom"},
  {"Machine part", 20000, {0.46, 1.82, 0.47, 2.1, 4.85}, 6, "fandisk_large"},
  {"Horse", 40000, {0.54, 5.3, 1.79, 5.13, 12.76}, 19, "camel"},
  {"Bunny", 70000, {1.02, 7.2, 1.86, 7.29, 17.37}, 14, "bunny00"},
  {"Isis", 200000, {2.92, 19.7, 4.54, 13.48, 40.64}, 5, "armadillo"}};

struct Options
{
  std::string folder = SPECTRAL_SEGMENTATION_MESHES_DIR;
  std::size_t runs = 5;
};

// Medians of the runs.
struct Result
{
  std::size_t faces;
  std::size_t parts;
  Seconds seconds; // with one thread
};

void add_options(CLI::App& app, Options& o)
{
  app.add_option("--meshes", o.folder, "folder with the meshes of libcgal-demo")
    ->check(CLI::ExistingDirectory)->capture_default_str();
  app.add_option("--runs", o.runs, "of which the median is printed")
    ->check(CLI::Range(1, 1000))->capture_default_str();
}

std::size_t segment(const Mesh& mesh, std::size_t parts, segment_mesh::Run_watch& watch)
{
  return CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
    mesh, boost::vector_property_map<std::size_t>(mesh.number_of_faces()),
    params::zhang_liu_2005().maximum_number_of_segments(parts)
      .salience_threshold(-std::numeric_limits<double>::infinity()).visitor(std::ref(watch)));
}

Result result(const Row& row, const Options& o)
{
  const std::filesystem::path folder = o.folder;
  const Mesh mesh = with_size(read_mesh(folder / (row.our_mesh + std::string(".off"))), row.faces);
  Result r;
  r.faces = mesh.number_of_faces();
  std::array<std::vector<double>, columns.size()> seconds;
  for (std::size_t i = 0; i < o.runs; ++i) {
    segment_mesh::Run_watch one(false);
    r.parts = segment(mesh, row.parts, one);
    seconds.back().push_back(one.seconds());
    for (Stage stage : {Stage::INITIALIZATION, Stage::SAMPLING, Stage::EMBEDDING,
                        Stage::LINE_SEARCH})
      seconds[static_cast<std::size_t>(stage)].push_back(one.seconds(stage));
  }
  std::transform(seconds.begin(), seconds.end(), r.seconds.begin(), median);
  return r;
}

void print_line(const std::string& name, std::size_t faces, std::size_t parts)
{ std::printf("%-18s %7zu %5zu", name.c_str(), faces, parts); }

void print(const Row& row, const Result& r)
{
  print_line(row.model, row.faces, row.parts);
  for (double s : row.seconds)
    std::printf(" %14.2f", s);
  std::printf("\n");
  print_line("  " + std::string(row.our_mesh), r.faces, r.parts);
  for (double s : r.seconds)
    std::printf(" %14.4f", s);
  std::printf("\n%-32s", "  times as fast");
  for (std::size_t c = 0; c < columns.size(); ++c)
    std::printf(" %14.1f", row.seconds[c] / r.seconds[c]);
  std::printf("\n");
}

void run(const Options& o)
{
  std::printf("%-18s %7s %5s", "seconds", "faces", "parts");
  for (const char* column : columns)
    std::printf(" %14s", column);
  std::printf("\n");
  for (const Row& row : rows)
    print(row, result(row, o));
  std::printf("A model of the paper, on a Xeon at 2.2 GHz; then a mesh of the same size here, "
              "median of %zu runs.\n", o.runs);
}

int main(int argc, char** argv)
{
  return run_program("table_1", "The times of Table 1 in Zhang and Liu 2005 beside those here.",
                     add_options, run, argc, argv);
}
