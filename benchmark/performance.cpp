// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Time and peak memory against the size of the mesh: whole runs and their stages, beside CGAL's
/// SDF segmentation; another number of segments of a finished tree; a shortest path tree; and the
/// coarsening to as many faces as are searched, beside CGAL's edge collapse, with its default
/// strategy and with its cheapest.
///
/// A row is RUN/threads:N/FACES or WHAT/FACES. Runs have counters: the milliseconds of each stage,
/// summed over the parts, and the bytes a face at the peak, beyond the mesh.
/// `calibrated_unsimplified` searches the mesh itself; `paper` makes 5 parts.
///
/// All sizes, on a machine with nothing else to do, and the picture:
///
///     performance --largest 10000000 --benchmark_out=performance.json
///     scripts/plot_performance.py performance.json

#include "Peak_memory.h"
#include "paper_graph.h"
#include "program.h"
#include "run_engine.h"
#include "segment_by_sdf.h"
#include "sized_mesh.h"
#include "with_threads.h"

#include "../bindings/command_line/Run_watch.h"

#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/boost/graph/helpers.h>

#include <benchmark/benchmark.h>

#include <boost/property_map/vector_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Stage;
namespace internal = CGAL::Spectral_segmentation::internal;
namespace params = CGAL::Spectral_segmentation::parameters;

const std::size_t sizes[] = {1000, 3000, 12500, 20000, 50000, 75000, 200000, 350000, 800000,
                             2000000, 3200000, 10000000};

const std::pair<Stage, const char*> stages[] = {
  {Stage::INITIALIZATION, "initialization"}, {Stage::SAMPLING, "sampling"},
  {Stage::EMBEDDING, "embedding"},           {Stage::LINE_SEARCH, "line_search"},
  {Stage::MERGING, "merging"},               {Stage::PROJECTION, "projection"}};

constexpr std::size_t unlimited = CGAL::Spectral_segmentation::unlimited;
constexpr double any_salience = -std::numeric_limits<double>::infinity();

struct Run
{
  const char* name;
  std::size_t largest; // the number of faces up to which its time is bearable
  bool uses_paper_method;
  std::size_t number_of_coarse_faces;
  std::size_t maximum_number_of_segments;
  double salience_threshold;
};

const std::size_t coarse_faces = CGAL::Spectral_segmentation::Options().number_of_coarse_faces;
constexpr double threshold = CGAL::Spectral_segmentation::default_probability_threshold;

const Run calibrated = {"calibrated", unlimited, false, coarse_faces, unlimited, threshold};
const Run unsimplified = {"calibrated_unsimplified", 75000, false, 0, unlimited, threshold};
const Run paper = {"paper", unlimited, true, 0, 5, any_salience};

constexpr std::size_t largest_for_sdf = 350000;

struct Options
{
  std::string mesh_file = std::string(SPECTRAL_SEGMENTATION_MESHES_DIR) + "/armadillo.off";
  std::size_t largest = 200000;
  std::set<std::size_t> threads = {1, (std::max)(1u, std::thread::hardware_concurrency())};
};

std::size_t segment(const Mesh& mesh, const Run& run, std::size_t threads,
                    segment_mesh::Run_watch& watch, Segmentation_hierarchy& tree)
{
  return with_threads(threads, [&](auto tag) {
    const auto segment_with = [&](const auto& np) {
      return CGAL::segment_spectral_recursive<decltype(tag)>(
        mesh, boost::vector_property_map<std::size_t>(mesh.number_of_faces()), np);
    };
    const auto np = params::number_of_coarse_faces(run.number_of_coarse_faces)
                      .maximum_number_of_segments(run.maximum_number_of_segments)
                      .salience_threshold(run.salience_threshold)
                      .hierarchy(tree)
                      .visitor(std::ref(watch));
    return run.uses_paper_method ? segment_with(np.zhang_liu_2005()) : segment_with(np);
  });
}

// The data that the rows of a size share, made when they are asked for.
class Input
{
  Mesh mesh_;
  std::optional<Segmentation_hierarchy> tree_;
  std::optional<Surface> graph_;

public:
  Input(const Mesh& original, std::size_t size) : mesh_(with_size(original, size)) {}

  const Mesh& mesh() const { return mesh_; }

  const Segmentation_hierarchy& tree()
  {
    if (!tree_) {
      segment_mesh::Run_watch watch(false);
      segment(mesh_, calibrated, 1, watch, tree_.emplace());
    }
    return *tree_;
  }

  // With the distances of the paper.
  const Surface& graph()
  {
    if (!graph_)
      graph_ = paper_graph(mesh_);
    return *graph_;
  }
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

void measure_run(benchmark::State& state, Input& input, const Run& run, std::size_t threads)
{
  std::size_t number_of_segments = 0;
  std::map<Stage, double> seconds;
  const Peak_memory memory;
  for (auto _ : state) {
    segment_mesh::Run_watch watch(false);
    Segmentation_hierarchy tree;
    number_of_segments = segment(input.mesh(), run, threads, watch, tree);
    for (const auto& stage : stages)
      seconds[stage.first] += watch.seconds(stage.first);
  }
  count(state, input.mesh(), number_of_segments, memory);
  for (const auto& [stage, name] : stages)
    if (seconds[stage] > 0)
      state.counters[name] =
        benchmark::Counter(1000 * seconds[stage], benchmark::Counter::kAvgIterations);
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
  const Segmentation_hierarchy& tree = input.tree();
  std::size_t number = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(labels_of_tree(tree, any_salience, number));
    number = 1 + number % tree.number_of_segments();
  }
}

void measure_shortest_path_tree(benchmark::State& state, Input& input)
{
  const Surface& graph = input.graph();
  for (auto _ : state)
    benchmark::DoNotOptimize(internal::shortest_paths(graph, &Edge_weights::combined, 0));
}

void measure_coarsening(benchmark::State& state, Input& input)
{
  const Surface& graph = input.graph();
  for (auto _ : state) {
    Run_control control;
    internal::Run_monitor monitor(control);
    benchmark::DoNotOptimize(
      internal::coarsened(Execution::SEQUENTIAL, graph, coarse_faces, monitor));
  }
}

// A copy of the mesh each time, which takes a percent of it.
template <class... Strategies>
void measure_coarsening_of_cgal(benchmark::State& state, Input& input, const Strategies&... np)
{
  for (auto _ : state) {
    Mesh mesh = input.mesh();
    collapse_edges(mesh, coarse_faces, np...);
    benchmark::DoNotOptimize(mesh);
  }
}

void measure_cheapest_coarsening_of_cgal(benchmark::State& state, Input& input)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  measure_coarsening_of_cgal(state, input,
                             CGAL::parameters::get_cost(SMS::Edge_length_cost<Mesh>())
                               .get_placement(SMS::Midpoint_placement<Mesh>()));
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
    if (size_ <= run.largest)
      add(run.name + ("/threads:" + std::to_string(threads)),
          [=, &run](benchmark::State& state, Input& input)
          { measure_run(state, input, run, threads); });
  }

  // The runs come first, while the mesh is alone in memory.
  void add_all(const std::set<std::size_t>& threads) const
  {
    for (const Run* run : {&calibrated, &unsimplified, &paper})
      for (std::size_t n : threads)
        add_run(*run, n);
    if (size_ <= largest_for_sdf)
      add("sdf/threads:1", measure_sdf);
    add("another_number_of_segments", measure_another_number);
    add("shortest_path_tree", measure_shortest_path_tree);
    if (size_ > coarse_faces) {
      add("coarsening/ours", measure_coarsening);
      add("coarsening/cgal", measure_coarsening_of_cgal<>);
      add("coarsening/cgal_edge_length", measure_cheapest_coarsening_of_cgal);
    }
  }
};

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
      Rows(inputs, size).add_all(o.threads);
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
