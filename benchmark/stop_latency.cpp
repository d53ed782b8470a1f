// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// How soon a run of a large mesh ends that its visitor wants to stop, at 5 %, 10 % ... 95 % of its
/// time: until `go_further()` is asked next, and from then until the function returns.

#include "princeton_benchmark.h"
#include "program.h"
#include "segmentation_metrics.h"
#include "sized_mesh.h"
#include "with_threads.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/vector_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
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
    case Stage::INITIALIZATION: return "initialization";
    case Stage::SAMPLING: return "sampling";
    case Stage::EMBEDDING: return "embedding";
    case Stage::LINE_SEARCH: return "line search";
    case Stage::MERGING: return "merging";
    case Stage::PROJECTION: return "projection";
    default: return "boundary smoothing";
  }
}

// Wants the run to stop some time after it began.
class Stopper : public CGAL::Spectral_segmentation::Segmentation_visitor
{
  typedef std::chrono::steady_clock Clock;

  Clock::time_point start_ = Clock::now();
  double time_;           // of the wish, in seconds
  double time_of_no_ = 0; // 0: not yet
  std::string where_ = "reading";
  std::string where_of_no_;

public:
  explicit Stopper(double time) : time_(time) {}

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool has_stopped() const { return time_of_no_ > 0; }
  double time_of_no() const { return time_of_no_; }
  const std::string& where() const { return where_of_no_; }

  void start_stage(Stage stage, std::size_t) { where_ = name_of(stage); }

  bool go_further()
  {
    const double now = seconds();
    if (now < time_)
      return true;
    time_of_no_ = now;
    where_of_no_ = where_;
    return false;
  }
};

// Of a whole run, which ends when the visitor wants it.
double seconds_of_run(const Mesh& mesh, std::size_t threads, Stopper& stopper)
{
  return with_threads(threads, [&](auto tag) {
    CGAL::segment_spectral_recursive<decltype(tag)>(
      mesh, boost::vector_property_map<std::size_t>(mesh.number_of_faces()),
      params::visitor(std::ref(stopper)));
    return stopper.seconds();
  });
}

void print_latencies(const char* what, const std::vector<double>& seconds)
{
  std::printf("  %-28s median %7.1f ms, largest %7.1f ms\n", what, 1000 * median(seconds),
              1000 * *std::max_element(seconds.begin(), seconds.end()));
}

void measure(const Mesh& mesh, std::size_t threads)
{
  Stopper never((std::numeric_limits<double>::infinity)());
  const double whole = seconds_of_run(mesh, threads, never);
  std::printf("%zu faces, %zu threads: %.2f s\n  wish   asked after  returns after  stage\n",
              static_cast<std::size_t>(mesh.number_of_faces()), threads, whole);
  std::vector<double> until_asked, until_return;
  for (int percent = 5; percent < 100; percent += 5) {
    const double wish = whole * percent / 100;
    Stopper stopper(wish);
    const double end = seconds_of_run(mesh, threads, stopper);
    if (!stopper.has_stopped()) // this run was faster
      continue;
    until_asked.push_back(stopper.time_of_no() - wish);
    until_return.push_back(end - stopper.time_of_no());
    std::printf("  %3d %% %9.1f ms %11.1f ms  %s\n", percent, 1000 * until_asked.back(),
                1000 * until_return.back(), stopper.where().c_str());
  }
  print_latencies("from the wish to the question:", until_asked);
  print_latencies("from the no to the return:", until_return);
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("--mesh", o.mesh_file, "mesh whose shape is taken [armadillo of libcgal-demo]")
    ->check(CLI::ExistingFile);
  app.add_option("--faces", o.faces, "to which it is subdivided")->capture_default_str();
  app.add_option("--threads", o.threads, "several numbers")
    ->check(CLI::Range(1, 1024))->capture_default_str();
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
