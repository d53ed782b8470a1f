// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_FOR_EACH_MESH_H
#define SEGMENTATION_BENCHMARK_FOR_EACH_MESH_H

#include "../bindings/command_line/is_terminal.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace segmentation_benchmark {

// Calls f(0) .. f(n - 1).
template <class Function>
void for_each_mesh(std::size_t n, std::size_t threads, const Function& f)
{
  if (threads > 1) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::parallel_for(std::size_t(0), n, [&f](std::size_t i) {
      tbb::task_arena alone(1);
      alone.execute([&f, i] { f(i); });
    }, tbb::simple_partitioner());
    return;
#else
    throw std::runtime_error("this build has no threads, as it is without TBB");
#endif
  }
  for (std::size_t i = 0; i < n; ++i)
    f(i);
}

// A line on standard error, if that is a terminal.
class Progress
{
  std::mutex mutex_;
  std::size_t all_, done_ = 0;
  bool is_shown_ = segment_mesh::standard_error_is_terminal();

public:
  explicit Progress(std::size_t all) : all_(all) {}

  ~Progress()
  {
    if (is_shown_)
      std::cerr << "\r\33[K" << std::flush;
  }

  void step()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (is_shown_)
      std::cerr << "\r" << done_ << " of " << all_ << " meshes" << std::flush;
  }
};

// Returns f(0) .. f(n - 1), and shows how many are done.
template <class Function>
auto results_of_meshes(std::size_t n, std::size_t threads, const Function& f)
{
  std::vector<decltype(f(std::size_t()))> results(n);
  Progress progress(n);
  for_each_mesh(n, threads, [&](std::size_t i) {
    results[i] = f(i);
    progress.step();
  });
  return results;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_FOR_EACH_MESH_H
