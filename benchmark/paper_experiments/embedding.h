// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EMBEDDING_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EMBEDDING_H

#include "nystrom.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace segmentation_benchmark {

// The 1-D spectral embedding of the faces of a part (Section 5.3). A run needs their order only,
// `spectral_order()`; the eigenvectors are for those who want to look at them.

struct Spectral_embedding
{
  double sigma;           // width of the kernel
  Eigen::VectorXd first;  // e1, positive
  Eigen::VectorXd second; // e2
  Eigen::VectorXd ratio;  // z = e2 / e1, smallest at the first sample
};

// The embedding from the distances of all faces from the samples s and t.
inline Spectral_embedding spectral_embedding(const std::vector<double>& from_s,
                                             const std::vector<double>& from_t, Index s, Index t)
{
  const Eigen::Index n = static_cast<Eigen::Index>(from_s.size());
  Eigen::MatrixXd distances(2, n);
  distances.row(0) = Eigen::Map<const Eigen::VectorXd>(from_s.data(), n);
  distances.row(1) = Eigen::Map<const Eigen::VectorXd>(from_t.data(), n);

  Spectral_embedding result;
  result.sigma = distances.isZero(0) ? 1 : distances.mean();
  const Eigen::MatrixXd affinities =
    (-distances.array() / (result.sigma * result.sigma)).exp().matrix();
  const std::vector<Index> samples = {s, t};
  const Eigenpairs e = nystrom_extrapolation(normalized_rows(affinities, samples), samples);
  result.first = e.vectors.col(0);
  result.second = e.vectors.col(1);
  // The signs of eigenvectors are arbitrary. All entries of the first have the same one.
  if (result.first[s] < 0)
    result.first = -result.first;
  if (result.second[s] > result.second[t])
    result.second = -result.second;
  result.ratio = result.second.cwiseQuotient(result.first);
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_EMBEDDING_H
