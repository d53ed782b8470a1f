// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONCURRENCY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONCURRENCY_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

template <class ConcurrencyTag>
constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;

// Calls f(), which may use TBB: while it waits, the thread takes no task from outside of it. So a
// run does not meet tasks of its caller. Within a run waiting threads take what there is to do.
template <class Function>
void call_isolated(const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::this_task_arena::isolate(f);
#else
  f();
#endif
}

// Tasks have a context of their own: if the caller's is cancelled, none is skipped in silence.

// Calls f(0) .. f(n - 1), which do not depend on each other.
template <class ConcurrencyTag, class Function>
void for_each_index(std::size_t n, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<ConcurrencyTag>) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_for(std::size_t(0), n, f, own);
    return;
  }
#endif
  for (std::size_t i = 0; i < n; ++i)
    f(i);
}

// The sum of f(0) .. f(n - 1), which begins with a zero of its type. It is taken in blocks, so that
// its rounding does not depend on the number of threads.
template <class ConcurrencyTag, class Value, class Function>
Value sum_of(std::size_t n, const Value& zero, const Function& f)
{
  constexpr std::size_t size_of_block = 4096;
  std::vector<Value> sums((n + size_of_block - 1) / size_of_block, zero);
  for_each_index<ConcurrencyTag>(sums.size(), [&](std::size_t block) {
    Value sum = zero;
    for (std::size_t i = block * size_of_block; i < (std::min)((block + 1) * size_of_block, n); ++i)
      sum += f(i);
    sums[block] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), zero);
}

// Functions that run beside the caller, who waits for them; without threads `run()` calls them.
template <class ConcurrencyTag, bool IsParallel = is_parallel<ConcurrencyTag> >
class Task_group
{
public:
  template <class Function>
  void run(const Function& f) { f(); }
  void wait() {}
};

#ifdef CGAL_LINKED_WITH_TBB
template <class ConcurrencyTag>
class Task_group<ConcurrencyTag, true>
{
  tbb::task_group_context own_{tbb::task_group_context::isolated};
  tbb::task_group group_{own_};

public:
  template <class Function>
  void run(const Function& f) { group_.run(f); }
  void wait() { group_.wait(); }
};
#endif

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONCURRENCY_H
