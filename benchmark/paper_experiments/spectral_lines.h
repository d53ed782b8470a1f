// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SPECTRAL_LINES_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SPECTRAL_LINES_H

#include "parts.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

// Line search along the ratio of the first two eigenvectors, for any number of samples.
namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Eigenpairs;

// Returns the distance between two vectors after scaling to unit length and choice of the sign:
// from 0, for the same direction, to the square root of 2.
inline double direction_error(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  const Eigen::VectorXd u = a.normalized(), v = b.normalized();
  return (std::min)((u - v).norm(), (u + v).norm());
}

// Returns the faces in the order of the ratio of the second eigenvector to the first. Where it ties
// but for rounding, those near the first sample on the line come first.
inline std::vector<Index> spectral_line(const Surface& part, const Eigenpairs& e,
                                        const std::vector<Index>& samples, bool is_reversed)
{
  Eigen::ArrayXd z =
    CGAL::Spectral_segmentation::internal::spectral_coordinates(e, samples).array();
  if (is_reversed)
    z = -z;
  const double step = 1e-9 * (z.maxCoeff() - z.minCoeff());
  if (step > 0)
    z = (z / step).round();
  const Index first = *std::min_element(samples.begin(), samples.end(),
                                        [&z](Index f, Index g) { return z[f] < z[g]; });
  const std::vector<double> distance = CGAL::Spectral_segmentation::internal::shortest_paths(
    part, &Edge_weights::combined, first);
  std::vector<Index> line = all_faces(part);
  std::sort(line.begin(), line.end(), [&](Index f, Index g) {
    return std::make_tuple(z[f], distance[f], f) < std::make_tuple(z[g], distance[g], g);
  });
  return line;
}

// Returns the most salient cut along the line, searched from both its ends.
inline std::optional<Cut> cut_by_eigenvectors(const Surface& part, const Eigenpairs& e,
                                              const std::vector<Index>& samples,
                                              double minimum_area)
{
  std::optional<Cut> best;
  for (bool is_reversed : {false, true}) {
    std::optional<Cut> cut =
      CGAL::Spectral_segmentation::internal::line_search(
        Execution::SEQUENTIAL, part, spectral_line(part, e, samples, is_reversed),
        CGAL::Spectral_segmentation::Weighted_part_salience(), minimum_area);
    if (cut && (!best || cut->salience > best->salience))
      best = std::move(cut);
  }
  return best;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SPECTRAL_LINES_H
