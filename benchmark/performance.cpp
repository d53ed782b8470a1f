// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Time and memory of whole runs and of the stages of the first cut against the size of the mesh,
/// beside CGAL's SDF segmentation and other searches for shortest paths.
/// `scripts/plot_performance.py` draws what `--benchmark_out=FILE` writes.
///
/// A row is METHOD/WHAT/threads:N/FACES, without threads where there is one only. The paper's whole
/// run makes 5 parts.

#include "First_cut.h"
#include "Peak_memory.h"
#include "other_searches.h"
#include "program.h"
#include "segment_by_sdf.h"
#include "sized_mesh.h"
#include "with_threads.h"

#include "../examples/segment_mesh/Run_watch.h"

#include <CGAL/boost/graph/helpers.h>

#include <benchmark/benchmark.h>

#include <boost/property_map/vector_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::Segment_tree;
using CGAL::Spectral_segmentation::Stage;
namespace params = CGAL::Spectral_segmentation::parameters;

typedef boost::vector_property_map<std::size_t> Segment_ids;

const std::size_t sizes[] = {1000, 3000, 12500, 20000, 50000, 75000, 200000, 350000, 800000,
                             2000000, 3200000, 10000000};

struct Options
{
  std::string mesh_file = std::string(SPECTRAL_SEGMENTATION_MESHES_DIR) + "/armadillo.off";
  std::size_t largest = 200000;
  std::set<std::size_t> threads = {1, (std::max)(1u, std::thread::hardware_concurrency())};
};

struct Run
{
  const char* name;
  Method method;
  std::size_t maximum_number_of_segments;
  double salience_threshold;
};

const Run runs[] = {
  {"calibrated", Method::CALIBRATED, (std::numeric_limits<std::size_t>::max)(),
   CGAL::Spectral_segmentation::default_probability_threshold},
  {"paper", Method::ZHANG_LIU_2005, 5, -std::numeric_limits<double>::infinity()}};

std::size_t segment(const Mesh& mesh, const Run& run, std::size_t threads,
                    segment_mesh::Run_watch& watch, Segment_tree& tree)
{
  return with_threads(threads, [&](auto tag) {
    return CGAL::segment_spectral_recursive<decltype(tag)>(
      mesh, Segment_ids(mesh.number_of_faces()),
      params::method(run.method).maximum_number_of_segments(run.maximum_number_of_segments)
        .salience_threshold(run.salience_threshold).segment_tree(tree).visitor(std::ref(watch)));
  });
}

// What the rows of a size share, made when it is asked for.
class Input
{
  Mesh mesh_;
  std::optional<Segment_tree> tree_;
  std::optional<First_cut> first_cut_;

public:
  Input(const Mesh& original, std::size_t size) : mesh_(with_size(original, size)) {}

  const Mesh& mesh() const { return mesh_; }

  const Segment_tree& tree()
  {
    if (!tree_) {
      segment_mesh::Run_watch watch(false);
      segment(mesh_, runs[0], 1, watch, tree_.emplace());
    }
    return *tree_;
  }

  First_cut& first_cut(Method method)
  {
    if (!first_cut_ || first_cut_->method() != method)
      first_cut_.emplace(mesh_, method);
    return *first_cut_;
  }

  const Face_dual_graph& graph() { return first_cut(Method::CALIBRATED).graph(); }
};

// Keeps the input of one size only, as rows come in the order of their sizes.
class Inputs
{
  Mesh original_;
  std::size_t size_ = 0;
  std::optional<Input> input_;

public:
  explicit Inputs(const std::string& mesh_file) : original_(read_mesh(mesh_file)) {}

  Input& operator()(std::size_t size)
  {
    if (size != size_) {
      input_.reset();
      input_.emplace(original_, size);
      size_ = size;
    }
    return *input_;
  }
};

void count(benchmark::State& state, const Mesh& mesh, std::size_t number_of_segments,
           const Peak_memory& memory)
{
  state.counters["segments"] = static_cast<double>(number_of_segments);
  state.counters["bytes_per_face"] =
    static_cast<double>(memory.bytes()) / static_cast<double>(mesh.number_of_faces());
}

// The stages are counted in seconds, of the last run and summed over its parts.
void measure_whole_run(benchmark::State& state, Input& input, const Run& run, std::size_t threads)
{
  std::size_t number_of_segments = 0;
  const Peak_memory memory;
  for (auto _ : state) {
    segment_mesh::Run_watch watch(false);
    Segment_tree tree;
    number_of_segments = segment(input.mesh(), run, threads, watch, tree);
    state.counters["initialization"] = watch.seconds(Stage::INITIALIZATION);
    state.counters["sampling"] = watch.seconds(Stage::SAMPLING);
    state.counters["embedding"] = watch.seconds(Stage::EMBEDDING);
    state.counters["line_search"] = watch.seconds(Stage::LINE_SEARCH);
  }
  count(state, input.mesh(), number_of_segments, memory);
}

void measure_sdf(benchmark::State& state, Input& input)
{
  std::size_t number = 0;
  const Peak_memory memory;
  for (auto _ : state)
    number = number_of_segments(segment_by_sdf(input.mesh()));
  count(state, input.mesh(), number, memory);
}

void measure_another_number(benchmark::State& state, Input& input)
{
  const Segment_tree& tree = input.tree();
  const Segment_ids ids(input.mesh().number_of_faces());
  std::size_t number = 1;
  for (auto _ : state) {
    tree.segment_by_number(input.mesh(), ids, number);
    number = 1 + number % tree.number_of_segments();
  }
}

template <class Search>
void measure_search(benchmark::State& state, Input& input)
{
  const Face_dual_graph& graph = input.graph();
  for (auto _ : state)
    benchmark::DoNotOptimize(Search()(graph, 0, &Face_dual_graph::Halfedge::combined));
}

void measure_breadth_first_search(benchmark::State& state, Input& input)
{
  const Face_dual_graph& graph = input.graph();
  for (auto _ : state)
    benchmark::DoNotOptimize(breadth_first_search(graph, 0));
}

void measure_dijkstra_on_dual(benchmark::State& state, Input& input)
{
  if (!CGAL::is_closed(input.mesh())) {
    state.SkipWithError("CGAL::Dual takes closed meshes only");
    return;
  }
  const std::vector<double> weights = weights_of_edges(input.mesh(), input.graph());
  for (auto _ : state)
    benchmark::DoNotOptimize(dijkstra_on_dual(input.mesh(), weights, Mesh::Face_index(0)));
}

// The rows of a size.
class Rows
{
  Inputs& inputs_;
  std::size_t size_;

public:
  Rows(Inputs& inputs, std::size_t size) : inputs_(inputs), size_(size) {}

  template <class Function>
  void add(const std::string& name, const Function& measure) const
  {
    const auto of_size = [measure, &inputs = inputs_, size = size_](benchmark::State& state) {
      Input& input = inputs(size);
      measure(state, input);
      state.counters["faces"] = static_cast<double>(input.mesh().number_of_faces());
    };
    benchmark::RegisterBenchmark((name + "/" + std::to_string(size_)).c_str(), of_size)
      ->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
  }

  void add_run(const Run& run, std::size_t threads) const
  {
    add(name(run, "whole", threads), [=, &run](benchmark::State& state, Input& input)
      { measure_whole_run(state, input, run, threads); });
  }

  // `stage(first cut, tag)` is its work.
  template <class Function>
  void add_stage(const Run& run, const char* stage_name, std::size_t threads,
                 const Function& stage) const
  {
    add(name(run, stage_name, threads), [=, &run](benchmark::State& state, Input& input) {
      First_cut& first_cut = input.first_cut(run.method);
      for (auto _ : state)
        with_threads(threads, [&](auto tag) { stage(first_cut, tag); });
    });
  }

  static std::string name(const Run& run, const std::string& what, std::size_t threads)
  { return run.name + ("/" + what) + "/threads:" + std::to_string(threads); }
};

void add_stages(const Rows& rows, const Run& run, std::size_t threads)
{
  rows.add_stage(run, "initialization", threads, [](auto& cut, auto tag) { cut.initialize(tag); });
  rows.add_stage(run, "sampling", threads, [](auto& cut, auto tag) { cut.sample(tag); });
  rows.add_stage(run, "embedding", threads, [](auto& cut, auto tag) { cut.order(tag); });
  rows.add_stage(run, "line_search", threads, [](auto& cut, auto tag) { cut.search_lines(tag); });
  if (run.method == Method::CALIBRATED)
    rows.add_stage(run, "refinement", threads, [](auto& cut, auto tag) { cut.refine(tag); });
}

// The whole runs come first, while no stage has left anything in memory.
void add_rows(const Rows& rows, const std::set<std::size_t>& threads)
{
  for (const Run& run : runs)
    for (std::size_t n : threads)
      rows.add_run(run, n);
  rows.add("sdf/whole", measure_sdf);
  rows.add("calibrated/another_number", measure_another_number);
  for (const Run& run : runs)
    for (std::size_t n : threads)
      add_stages(rows, run, n);
  rows.add("shortest_path_tree/stock_bgl_on_cgal_dual", measure_dijkstra_on_dual);
  rows.add("shortest_path_tree/bgl", measure_search<internal::Dijkstra_search>);
  rows.add("shortest_path_tree/buckets", measure_search<internal::Bucket_search>);
  rows.add("shortest_path_tree/breadth_first", measure_breadth_first_search);
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("--mesh", o.mesh_file, "connected mesh whose shape all meshes have [armadillo of "
                                        "libcgal-demo]")->check(CLI::ExistingFile);
  app.add_option("--largest", o.largest, "number of faces up to which there are rows, of 10000000")
    ->capture_default_str();
  app.add_option("--threads", o.threads, "of the runs, several numbers [1 and all cores]")
    ->check(CLI::Range(1, 1024));
}

void run(const Options& o)
{
  Inputs inputs(o.mesh_file);
  benchmark::AddCustomContext("mesh", o.mesh_file);
  for (std::size_t size : sizes)
    if (size <= o.largest)
      add_rows(Rows(inputs, size), o.threads);
  benchmark::RunSpecifiedBenchmarks();
}

void print_help()
{
  Options options;
  CLI::App app("", "performance");
  add_options(app, options);
  std::cout << app.help() << "\n";
  benchmark::PrintDefaultHelp();
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv, print_help);
  return run_program("performance", "Time and memory against the size of the mesh.", add_options,
                     run, argc, argv);
}
