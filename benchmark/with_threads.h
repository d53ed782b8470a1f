// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_WITH_THREADS_H
#define SEGMENTATION_BENCHMARK_WITH_THREADS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <stdexcept>

namespace segmentation_benchmark {

// f(tag) with so many threads: the tag is a CGAL::Sequential_tag for 1, else a CGAL::Parallel_tag.
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

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_WITH_THREADS_H
