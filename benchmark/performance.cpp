// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Time and peak memory against the size of the mesh: whole runs and their stages, beside CGAL's
/// SDF segmentation and the simplification of the same mesh to 4,000 faces by meshoptimizer; and
/// another number of segments of a finished tree.
///
/// A row is RUN/threads:N/FACES or another_number_of_segments/FACES. Runs have counters: the
/// milliseconds of each stage, summed over the parts, and the bytes a face at the peak, beyond the
/// mesh. The run `paper` makes 5 parts.
///
/// All sizes, on a machine with nothing else to do, and the picture:
///
///     performance --largest 10000000 --benchmark_out=performance.json
///     scripts/plot_performance.py performance.json

#include "Peak_memory.h"
#include "program.h"
#include "segmentation_methods.h"
#include "sized_mesh.h"

#include "../bindings/command_line/Run_watch.h"

#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#include <boost/property_map/vector_property_map.hpp>

#include <CLI/CLI.hpp>

#ifdef SPECTRAL_SEGMENTATION_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::Stage;

const std::size_t sizes[] = {500, 1000, 3000, 12500, 20000, 50000, 75000, 200000, 350000, 800000,
                             2000000, 3200000, 10000000};

const std::pair<Stage, const char*> stages[] = {
  {Stage::INITIALIZATION, "initialization"}, {Stage::SAMPLING, "sampling"},
  {Stage::EMBEDDING, "embedding"},           {Stage::LINE_SEARCH, "line_search"},
  {Stage::MERGING, "merging"},               {Stage::PROJECTION, "projection"}};

constexpr std::size_t largest_for_sdf = 350000; // up to which its time is bearable
constexpr std::size_t simplified_faces = 4000;  // that meshoptimizer leaves of a mesh

struct Options
{
  std::string mesh_file = std::string(SPECTRAL_SEGMENTATION_MESHES_DIR) + "/armadillo.off";
  std::size_t largest = 200000;
  std::set<std::size_t> threads = {1, (std::max)(1u, std::thread::hardware_concurrency())};
};

// Calls f(tag) with so many threads; the tag is a CGAL::Sequential_tag for 1, else a
// CGAL::Parallel_tag.
template <class Function>
auto with_threads(std::size_t threads, const Function& f)
{
  if (threads == 1)
    return f(CGAL::Sequential_tag());
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads)); // also more threads than cores
  return arena.execute([&] { return f(CGAL::Parallel_tag()); });
#else
  throw std::runtime_error("this build has no threads, as it is without TBB");
#endif
}

enum class Run { CALIBRATED, PAPER };

std::size_t segment(const Mesh& mesh, Run run, std::size_t threads, segment_mesh::Run_watch& watch,
                    Segmentation_hierarchy& tree)
{
  return with_threads(threads, [&](auto tag) {
    const auto segment_with = [&](const auto& np) {
      return CGAL::segment_spectral_recursive<decltype(tag)>(
        mesh, boost::vector_property_map<std::size_t>(mesh.number_of_faces()),
        np.hierarchy(tree).visitor(std::ref(watch)));
    };
    return run == Run::CALIBRATED
      ? segment_with(params::default_values())
      : segment_with(params::zhang_liu_2005().maximum_number_of_segments(5)
                       .salience_threshold(any_salience));
  });
}

// The data that the rows of one size have in common, made when they are requested.
class Input
{
  Mesh mesh_;
  std::optional<Segmentation_hierarchy> tree_;

public:
  Input(const Mesh& original, std::size_t size) : mesh_(with_size(original, size)) {}

  const Mesh& mesh() const { return mesh_; }

  const Segmentation_hierarchy& tree()
  {
    if (!tree_) {
      segment_mesh::Run_watch watch(false);
      segment(mesh_, Run::CALIBRATED, 1, watch, tree_.emplace());
    }
    return *tree_;
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

void measure_run(benchmark::State& state, Input& input, Run run, std::size_t threads)
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

#ifdef SPECTRAL_SEGMENTATION_WITH_MESHOPTIMIZER
void measure_simplification(benchmark::State& state, Input& input)
{
  std::vector<float> coordinates;
  for (auto v : vertices(input.mesh()))
    for (int i = 0; i < 3; ++i)
      coordinates.push_back(static_cast<float>(input.mesh().point(v)[i]));
  std::vector<unsigned> corners;
  for (auto f : faces(input.mesh()))
    for (auto v : vertices_around_face(halfedge(f, input.mesh()), input.mesh()))
      corners.push_back(v);
  std::vector<unsigned> result(corners.size());
  for (auto _ : state)
    benchmark::DoNotOptimize(meshopt_simplify(
      result.data(), corners.data(), corners.size(), coordinates.data(), coordinates.size() / 3,
      3 * sizeof(float), 3 * simplified_faces, 1));
}
#endif

void measure_another_number(benchmark::State& state, Input& input)
{
  const Segmentation_hierarchy& tree = input.tree();
  std::size_t number = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(labels_of_tree(tree, any_salience, number));
    number = 1 + number % tree.number_of_segments();
  }
}

// The rows for a size.
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

  void add_run(const std::string& name, Run run, std::size_t threads) const
  {
    add(name + "/threads:" + std::to_string(threads), [=](benchmark::State& state, Input& input)
        { measure_run(state, input, run, threads); });
  }

  // Adds all rows, those of runs first, while the mesh is alone in memory.
  void add_all(const std::set<std::size_t>& threads) const
  {
    for (std::size_t n : threads)
      add_run("calibrated", Run::CALIBRATED, n);
    for (std::size_t n : threads)
      add_run("paper", Run::PAPER, n);
    if (size_ <= largest_for_sdf)
      add("sdf/threads:1", measure_sdf);
#ifdef SPECTRAL_SEGMENTATION_WITH_MESHOPTIMIZER
    if (size_ > simplified_faces)
      add("simplification/threads:1", measure_simplification);
#endif
    add("another_number_of_segments", measure_another_number);
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
