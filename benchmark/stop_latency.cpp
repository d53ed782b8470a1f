// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// How soon a run of a large mesh ends that is to stop, at 5 %, 10 % ... 95 % of its processor
/// time: until `go_further()` is asked next and says no, and from then until the function returns.
/// Where nothing is asked any more, all counts as the second.

#include "princeton_benchmark.h"
#include "program.h"
#include "segmentation_metrics.h"
#include "sized_mesh.h"
#include "with_threads.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/vector_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::Stage;
namespace params = CGAL::Spectral_segmentation::parameters;

struct Options
{
  std::string mesh_file = std::string(SPECTRAL_SEGMENTATION_MESHES_DIR) + "/armadillo.off";
  std::size_t faces = 2000000;
  std::vector<std::size_t> threads = {1, 2};
};

const char* name_of(Stage stage)
{
  switch (stage) {
  case Stage::INITIALIZATION:
    return "initialization";
  case Stage::SAMPLING:
    return "sampling";
  case Stage::EMBEDDING:
    return "embedding";
  case Stage::LINE_SEARCH:
    return "line search";
  case Stage::MERGING:
    return "merging";
  case Stage::PROJECTION:
    return "projection";
  default:
    return "boundary smoothing";
  }
}

typedef std::chrono::steady_clock Clock;

double milliseconds(Clock::time_point from, Clock::time_point to)
{
  return std::chrono::duration<double, std::milli>(to - from).count();
}

// Processor time of all threads, which other work on the machine does not change.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Acts like a person's hand: another thread constraints to stop after so many processor seconds.
class Stopper : public CGAL::Spectral_segmentation::Segmentation_visitor
{
  std::atomic<bool> is_constrained_{false}, is_over_{false};
  Clock::time_point constraint_, no_;
  std::atomic<const char*> where_{"reading"};
  const char* where_of_constraint_ = nullptr;
  std::thread hand_;

public:
  explicit Stopper(double seconds)
    : hand_([this, end = processor_seconds() + seconds] {
        while (!is_over_ && processor_seconds() < end)
          std::this_thread::sleep_for(std::chrono::microseconds(200));
        constraint_ = no_ = Clock::now();
        where_of_constraint_ = where_;
        is_constrained_ = true;
      })
  {
  }

  ~Stopper()
  {
    is_over_ = true;
    hand_.join();
  }

  bool is_due() const { return is_constrained_; }
  const char* where() const { return where_of_constraint_; }
  Clock::time_point constraint() const { return constraint_; }
  // Returns when it was said, or when the run should stop if nothing was asked after that.
  Clock::time_point no() const { return no_; }

  void before_stage(Stage stage, std::size_t) { where_ = name_of(stage); }

  bool go_further()
  {
    if (!is_constrained_)
      return true;
    no_ = Clock::now();
    return false;
  }
};

template <class NamedParameters>
void segment(const Mesh& mesh, std::size_t threads, const NamedParameters& np)
{
  with_threads(threads, [&](auto tag) {
    return CGAL::segment_spectral_recursive<decltype(tag)>(
      mesh, boost::vector_property_map<std::size_t>(mesh.number_of_faces()), np);
  });
}

void print_latencies(const char* what, const std::vector<double>& milliseconds)
{
  std::printf("  %-28s median %7.1f ms, largest %7.1f ms\n", what, median(milliseconds),
              *std::max_element(milliseconds.begin(), milliseconds.end()));
}

void measure(const Mesh& mesh, std::size_t threads)
{
  double whole = 0; // the longest of three runs, so that the last stages are met
  for (int i = 0; i < 3; ++i) {
    const double start = processor_seconds();
    segment(mesh, threads, params::default_values());
    whole = (std::max)(whole, processor_seconds() - start);
  }
  std::printf("%zu faces, %zu threads: %.2f s of the processor\n"
              "  constraint   asked after  returns after  stage\n",
              static_cast<std::size_t>(mesh.number_of_faces()), threads, whole);
  std::vector<double> until_asked, until_return, sums;
  for (int percent = 5; percent < 100; percent += 5) {
    Stopper stopper(whole * percent / 100);
    segment(mesh, threads, params::visitor(std::ref(stopper)));
    const bool is_due = stopper.is_due();
    const Clock::time_point end = Clock::now();
    if (!is_due) // this run took less
      continue;
    until_asked.push_back(milliseconds(stopper.constraint(), stopper.no()));
    until_return.push_back(milliseconds(stopper.no(), end));
    sums.push_back(until_asked.back() + until_return.back());
    std::printf("  %3d %% %9.1f ms %11.1f ms  %s\n", percent, until_asked.back(),
                until_return.back(), stopper.where());
  }
  print_latencies("from the constraint to the no:", until_asked);
  print_latencies("from the no to the return:", until_return);
  print_latencies("from the constraint to the return:", sums);
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("--mesh", o.mesh_file, "mesh whose shape is taken [armadillo of libcgal-demo]")
    ->check(CLI::ExistingFile);
  app.add_option("--faces", o.faces, "to which it is subdivided")->capture_default_str();
  app.add_option("--threads", o.threads, "several numbers")
    ->check(CLI::Range(1, 1024))
    ->capture_default_str();
}

void run(const Options& o)
{
  const Mesh mesh = with_size(read_mesh(o.mesh_file), o.faces);
  for (std::size_t threads : o.threads)
    measure(mesh, threads);
}

int main(int argc, char** argv)
{
  return run_program("stop_latency", "How soon a run ends that is to stop.", add_options, run, argc,
                     argv);
}
