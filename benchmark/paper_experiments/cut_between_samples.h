// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_CUT_BETWEEN_SAMPLES_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_CUT_BETWEEN_SAMPLES_H

#include "experiment.h"
#include "face_samples.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>

#include <optional>
#include <vector>

namespace segmentation_benchmark {

// BESTCUT of the paper (Figure 2), with the two samples of any scheme.
inline std::optional<Sides> cut_between_samples(const Sampling_scheme& scheme,
                                                const Surface& part, double minimum_area,
                                                Random_engine& random)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  if (part.number_of_faces() < 2)
    return std::nullopt;
  const std::vector<Index> samples = scheme.take(part, 2, random);
  const std::optional<internal::Cut> cut = internal::line_search(
    Execution::SEQUENTIAL, part,
    internal::face_order(Execution::SEQUENTIAL, part, {samples[0], samples[1]}),
    CGAL::Spectral_segmentation::Weighted_part_salience(), minimum_area);
  return cut ? std::optional<Sides>(cut->side) : std::nullopt;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_CUT_BETWEEN_SAMPLES_H
