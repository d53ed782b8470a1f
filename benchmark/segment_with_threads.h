// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SEGMENT_WITH_THREADS_H
#define SEGMENTATION_BENCHMARK_SEGMENT_WITH_THREADS_H

#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <stdexcept>

namespace segmentation_benchmark {

// segment_spectral_recursive() with so many threads, and the sequential one with 1.
template <class TriangleMesh, class SegmentIdMap, class NamedParameters>
std::size_t segment_with_threads(std::size_t threads, const TriangleMesh& mesh,
                                 SegmentIdMap segment_ids, const NamedParameters& np)
{
  if (threads == 1)
    return CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(mesh, segment_ids, np);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads)); // also more threads than cores
  return arena.execute([&]
    { return CGAL::segment_spectral_recursive<CGAL::Parallel_tag>(mesh, segment_ids, np); });
#else
  throw std::runtime_error("this build has no threads, as it is without TBB");
#endif
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SEGMENT_WITH_THREADS_H
