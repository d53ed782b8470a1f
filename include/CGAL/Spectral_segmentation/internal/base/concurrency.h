// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_CONCURRENCY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_CONCURRENCY_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

enum class Execution { SEQUENTIAL, PARALLEL }; // one thread, or all threads of TBB

// All functions fall back to one thread if the program is built without TBB. Each has its own task
// context, so that a caller who cancels tasks cannot skip some of a run.

// Calls f(). A thread that waits inside f never executes tasks of the caller.
template <class Function>
void call_isolated(const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::this_task_arena::isolate(f);
#else
  f();
#endif
}

// Calls f(0) .. f(n - 1), which do not depend on each other.
template <class Function>
void for_each_index(Execution execution, std::size_t n, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (execution == Execution::PARALLEL && n > 1) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_for(std::size_t(0), n, f, own);
    return;
  }
#endif
  static_cast<void>(execution);
  for (std::size_t i = 0; i < n; ++i)
    f(i);
}

// Calls functions that do not depend on each other.
template <class... Functions>
void call_all(Execution execution, const Functions&... f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (execution == Execution::PARALLEL) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_invoke(f..., own);
    return;
  }
#endif
  static_cast<void>(execution);
  (f(), ...);
}

// Returns zero + f(0) + ... + f(n - 1). It adds in blocks, so that rounding does not depend on the
// number of threads.
template <class Value, class Function>
Value sum_of(Execution execution, std::size_t n, const Value& zero, const Function& f)
{
  constexpr std::size_t size_of_block = 4096;
  std::vector<Value> sums((n + size_of_block - 1) / size_of_block, zero);
  for_each_index(execution, sums.size(), [&](std::size_t block) {
    Value sum = zero;
    for (std::size_t i = block * size_of_block; i < (std::min)((block + 1) * size_of_block, n); ++i)
      sum += f(i);
    sums[block] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), zero);
}

// Prefetches memory that will be read soon, if the compiler supports it. Otherwise, loops that
// visit faces in a special order wait for memory half of the time.
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_CONCURRENCY_H
