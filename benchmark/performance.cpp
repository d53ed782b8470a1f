// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Time and memory of the stages and of whole runs against the size of the mesh, beside CGAL's SDF
/// segmentation and other searches for shortest paths. `scripts/plot_performance.py` draws what
/// `--benchmark_out=FILE` writes.
///
/// A row is METHOD/WHAT/threads:N/FACES, without threads where there is one only. A stage is that
/// of the first cut, for which the mesh is one part; the paper's whole run makes 5 parts.

#include "Peak_memory.h"
#include "program.h"
#include "segment_by_sdf.h"
#include "segment_with_threads.h"
#include "sized_mesh.h"

#include "../examples/segment_mesh/Run_watch.h"

#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/helpers.h>

#include <benchmark/benchmark.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
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
#include <utility>
#include <vector>

using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::Method;
using CGAL::Spectral_segmentation::Segment_tree;
using CGAL::Spectral_segmentation::Stage;
namespace params = CGAL::Spectral_segmentation::parameters;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Face_dual_graph;
using internal::Index;
using internal::Weighting;

typedef boost::vector_property_map<std::size_t> Segment_ids;

const std::size_t sizes[] = {1000, 3000, 12500, 20000, 50000, 75000, 200000, 350000, 800000,
                             2000000, 3200000, 10000000};

struct Options
{
  std::string mesh_file = std::string(SPECTRAL_SEGMENTATION_MESHES_DIR) + "/armadillo.off";
  std::size_t largest = 200000;
  std::set<std::size_t> threads = {1, (std::max)(1u, std::thread::hardware_concurrency())};
};

// Arguments of the run that are given for both methods, so that they have one type.
struct Run
{
  const char* name;
  Method method;
  std::size_t maximum_number_of_segments;
  double salience_threshold;
  std::size_t number_of_refined_candidates;
};

const Run runs[] = {
  {"calibrated", Method::CALIBRATED, (std::numeric_limits<std::size_t>::max)(),
   CGAL::Spectral_segmentation::default_probability_threshold, 4},
  {"paper", Method::ZHANG_LIU_2005, 5, -std::numeric_limits<double>::infinity(), 0}};

// Ends the run after the first stage of one kind, if asked to, whose time alone then counts.
class Stage_watch : public segment_mesh::Run_watch
{
  std::optional<Stage> last_;
  benchmark::State* state_ = nullptr;
  std::optional<std::size_t> part_; // that is timed

public:
  explicit Stage_watch(std::optional<Stage> last = std::nullopt, benchmark::State* state = nullptr)
    : Run_watch(false), last_(last), state_(state) {}

  void start_stage(Stage stage, std::size_t part)
  {
    Run_watch::start_stage(stage, part);
    if (state_ && stage == last_ && !part_) {
      part_ = part;
      state_->ResumeTiming();
    }
  }

  void end_stage(Stage stage, std::size_t part)
  {
    if (state_ && stage == last_ && part == part_)
      state_->PauseTiming();
    Run_watch::end_stage(stage, part);
  }

  bool go_further() { return !last_ || seconds(*last_) == 0; }
};

std::size_t segment(const Mesh& mesh, const Run& run, std::size_t threads, Stage_watch& watch,
                    Segment_tree& tree)
{
  return segment_with_threads(
    threads, mesh, Segment_ids(mesh.number_of_faces()),
    params::method(run.method).maximum_number_of_segments(run.maximum_number_of_segments)
      .salience_threshold(run.salience_threshold)
      .number_of_refined_candidates(run.number_of_refined_candidates)
      .segment_tree(tree).visitor(std::ref(watch)));
}

// What the rows of a size share, made when it is asked for.
class Input
{
  Mesh mesh_;
  std::optional<Segment_tree> tree_;
  std::optional<Face_dual_graph> graph_;

public:
  Input(const Mesh& original, std::size_t size) : mesh_(with_size(original, size)) {}

  const Mesh& mesh() const { return mesh_; }

  const Segment_tree& tree()
  {
    if (!tree_) {
      Stage_watch watch;
      segment(mesh_, runs[0], 1, watch, tree_.emplace());
    }
    return *tree_;
  }

  const Face_dual_graph& graph()
  {
    if (!graph_)
      graph_ = internal::initialize<CGAL::Sequential_tag>(
        mesh_, std::vector<Mesh::Face_index>(mesh_.faces().begin(), mesh_.faces().end()),
        mesh_.points(), CGAL::Exact_predicates_inexact_constructions_kernel(),
        internal::Options(), [] { return true; });
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

void count(benchmark::State& state, const Mesh& mesh, std::size_t number_of_segments)
{
  state.counters["faces"] = static_cast<double>(mesh.number_of_faces());
  if (number_of_segments > 0)
    state.counters["segments"] = static_cast<double>(number_of_segments);
}

void count(benchmark::State& state, const Mesh& mesh, std::size_t number_of_segments,
           const Peak_memory& memory)
{
  count(state, mesh, number_of_segments);
  state.counters["bytes_per_face"] =
    static_cast<double>(memory.bytes()) / static_cast<double>(mesh.number_of_faces());
}

// Stages are counted in seconds of the last run, summed over its parts.
void measure_whole_run(benchmark::State& state, Input& input, const Run& run, std::size_t threads)
{
  const Mesh& mesh = input.mesh();
  std::size_t number_of_segments = 0;
  const Peak_memory memory;
  for (auto _ : state) {
    Stage_watch watch;
    Segment_tree tree;
    number_of_segments = segment(mesh, run, threads, watch, tree);
    state.counters["initialization"] = watch.seconds(Stage::INITIALIZATION);
    state.counters["sampling"] = watch.seconds(Stage::SAMPLING);
    state.counters["embedding"] = watch.seconds(Stage::EMBEDDING);
    state.counters["line_search"] = watch.seconds(Stage::LINE_SEARCH);
  }
  count(state, mesh, number_of_segments, memory);
}

void measure_stage(benchmark::State& state, Input& input, const Run& run, std::size_t threads,
                   Stage stage)
{
  const Mesh& mesh = input.mesh();
  for (auto _ : state) {
    state.PauseTiming();
    Stage_watch watch(stage, &state);
    Segment_tree tree;
    segment(mesh, run, threads, watch, tree);
    state.ResumeTiming();
  }
  count(state, mesh, 0);
}

double seconds_of_line_search(const Mesh& mesh, const Run& run, std::size_t threads)
{
  Stage_watch watch(Stage::LINE_SEARCH);
  Segment_tree tree;
  segment(mesh, run, threads, watch, tree);
  return watch.seconds(Stage::LINE_SEARCH);
}

// By which the line search is longer than without.
void measure_refinement(benchmark::State& state, Input& input, const Run& run, std::size_t threads)
{
  const Mesh& mesh = input.mesh();
  Run without = run;
  without.number_of_refined_candidates = 0;
  for (auto _ : state)
    state.SetIterationTime((std::max)(0., seconds_of_line_search(mesh, run, threads) -
                                            seconds_of_line_search(mesh, without, threads)));
  count(state, mesh, 0);
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
  count(state, input.mesh(), 0);
}

void measure_sdf(benchmark::State& state, Input& input)
{
  std::size_t number = 0;
  const Peak_memory memory;
  for (auto _ : state)
    number = number_of_segments(segment_by_sdf(input.mesh()));
  count(state, input.mesh(), number, memory);
}

// Touches the graph and no more: the numbers of steps from the source.
struct Breadth_first_search
{
  std::vector<Index> operator()(const Face_dual_graph& graph, Index source, Weighting) const
  {
    std::vector<Index> steps(graph.number_of_faces(), internal::null_index);
    std::vector<Index> reached = {source};
    reached.reserve(steps.size());
    steps[source] = 0;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
        const Index g = graph.halfedges[h].neighbor;
        if (steps[g] == internal::null_index) {
          steps[g] = steps[reached[i]] + 1;
          reached.push_back(g);
        }
      }
    return steps;
  }
};

template <class Search>
void measure_tree(benchmark::State& state, Input& input)
{
  const Face_dual_graph& graph = input.graph();
  for (auto _ : state)
    benchmark::DoNotOptimize(Search()(graph, 0, &Face_dual_graph::Halfedge::combined));
  count(state, input.mesh(), 0);
}

// The distances of `graph` by the edges of the mesh, of which none is on a border.
std::vector<double> weights_of_edges(const Mesh& mesh, const Face_dual_graph& graph)
{
  std::vector<double> weights;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Index f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    Index h = 3 * f;
    while (graph.halfedges[h].neighbor != g)
      ++h;
    weights.push_back(graph.halfedges[h].combined);
  }
  return weights;
}

void measure_tree_on_cgal_dual(benchmark::State& state, Input& input)
{
  const Mesh& mesh = input.mesh();
  if (!CGAL::is_closed(mesh)) {
    state.SkipWithError("CGAL::Dual takes closed meshes only");
    return;
  }
  const std::vector<double> weights = weights_of_edges(mesh, input.graph());
  const CGAL::Dual<Mesh> dual(mesh);
  const auto weight = [&weights](Mesh::Edge_index e) { return weights[e]; };
  const auto index = get(CGAL::face_index, mesh);
  for (auto _ : state) {
    std::vector<double> distance(mesh.number_of_faces());
    boost::dijkstra_shortest_paths(
      dual, Mesh::Face_index(0),
      boost::weight_map(boost::make_function_property_map<Mesh::Edge_index, double>(weight))
        .distance_map(boost::make_iterator_property_map(distance.begin(), index))
        .vertex_index_map(index));
    benchmark::DoNotOptimize(distance);
  }
  count(state, mesh, 0);
}

// The rows of a size.
class Rows
{
  Inputs& inputs_;
  std::size_t size_;

public:
  Rows(Inputs& inputs, std::size_t size) : inputs_(inputs), size_(size) {}

  template <class Function>
  benchmark::internal::Benchmark* add(const std::string& name, const Function& measure) const
  {
    const auto of_size = [measure, &inputs = inputs_, size = size_](benchmark::State& state)
      { measure(state, inputs(size)); };
    return benchmark::RegisterBenchmark((name + "/" + std::to_string(size_)).c_str(), of_size)
      ->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
  }
};

void add_runs(const Rows& rows, const Run& run, std::size_t threads)
{
  const auto name = [&](const std::string& what)
    { return run.name + ("/" + what) + "/threads:" + std::to_string(threads); };
  rows.add(name("whole"), [&run, threads](benchmark::State& state, Input& input)
    { measure_whole_run(state, input, run, threads); })->UseRealTime();
  for (const auto& [stage_name, stage] : {std::make_pair("initialization", Stage::INITIALIZATION),
                                          std::make_pair("sampling", Stage::SAMPLING),
                                          std::make_pair("embedding", Stage::EMBEDDING),
                                          std::make_pair("line_search", Stage::LINE_SEARCH)})
    rows.add(name(stage_name), [&run, threads, s = stage](benchmark::State& state, Input& input)
      { measure_stage(state, input, run, threads, s); })->UseRealTime();
  if (run.number_of_refined_candidates > 0)
    rows.add(name("refinement"), [&run, threads](benchmark::State& state, Input& input)
      { measure_refinement(state, input, run, threads); })->UseManualTime();
}

void add_rows(const Rows& rows, const std::set<std::size_t>& threads)
{
  for (const Run& run : runs)
    for (std::size_t n : threads)
      add_runs(rows, run, n);
  rows.add("sdf/whole", measure_sdf)->UseRealTime();
  rows.add("calibrated/another_number", measure_another_number);
  rows.add("shortest_path_tree/stock_bgl_on_cgal_dual", measure_tree_on_cgal_dual);
  rows.add("shortest_path_tree/bgl", measure_tree<internal::Dijkstra_search>);
  rows.add("shortest_path_tree/buckets", measure_tree<internal::Bucket_search>);
  rows.add("shortest_path_tree/breadth_first", measure_tree<Breadth_first_search>);
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("--mesh", o.mesh_file, "whose shape all meshes have [armadillo of libcgal-demo]")
    ->check(CLI::ExistingFile);
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
