// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SIMPLIFIED_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SIMPLIFIED_H

#include "../mesh_changes.h"
#include "../princeton_benchmark.h"

#include <cstddef>
#include <utility>

namespace segmentation_benchmark {

// With about so many faces, that the whole matrix fits, and the labels of the nearest original
// faces.
inline Benchmark_mesh simplified(const Benchmark_mesh& input, std::size_t faces)
{
  Changed_mesh changed = decimated(input.mesh, 3 * faces / 2);
  Benchmark_mesh result{input.id, std::move(changed.mesh), {}};
  for (const Labels& person : input.people) {
    Labels labels;
    for (std::size_t f : changed.original_faces)
      labels.push_back(person[f]);
    result.people.push_back(contiguous(labels));
  }
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SIMPLIFIED_H
