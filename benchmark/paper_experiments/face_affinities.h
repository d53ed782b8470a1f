// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_AFFINITIES_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_AFFINITIES_H

#include "experiment.h"
#include "nystrom.h"

#include <CGAL/Spectral_segmentation/internal/distances/shortest_paths.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

// Affinities of faces and the eigenvectors of their matrix, whole or approximated (Section 5).
namespace segmentation_benchmark {

inline std::vector<Index> all_faces(const Face_graph& part)
{
  std::vector<Index> faces(part.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  return faces;
}

// Combined distances, one row a sample.
inline Eigen::MatrixXd distances_from(const Face_graph& part,
                                      const std::vector<Index>& samples)
{
  Eigen::MatrixXd rows(samples.size(), part.number_of_faces());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::vector<double> distance = CGAL::Spectral_segmentation::internal::shortest_paths(
      part, &Edge_weights::combined, samples[i]);
    rows.row(static_cast<Eigen::Index>(i)) =
      Eigen::Map<const Eigen::VectorXd>(distance.data(), rows.cols());
  }
  return rows;
}

// The kernel of the paper, as wide as the mean of all distances that are given. Faces of different
// components, at infinite distance, have none.
inline Eigen::MatrixXd affinities(const Eigen::MatrixXd& distances)
{
  const auto is_finite = distances.array().isFinite();
  const double sum = is_finite.select(distances.array(), 0).sum();
  const double sigma = sum > 0 ? sum / static_cast<double>(is_finite.count()) : 1;
  return (-distances.array() / (sigma * sigma)).exp().matrix();
}

// D^-1/2 A D^-1/2 of a whole matrix.
inline Eigen::MatrixXd normalized(const Eigen::MatrixXd& affinities)
{
  const Eigen::VectorXd scale = affinities.rowwise().sum().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * affinities * scale.asDiagonal();
}

// The eigenvectors of a part, approximated from the rows of some samples as in Section 5.2, or
// exact if all faces are samples.
inline Eigenpairs face_eigenpairs(const Face_graph& part, const std::vector<Index>& samples)
{
  const Eigen::MatrixXd rows = affinities(distances_from(part, samples));
  return samples.size() == part.number_of_faces()
    ? descending_eigenpairs(normalized(rows))
    : nystrom_extrapolation(normalized_rows(rows, samples), samples);
}

// The distance between two vectors after scaling to unit length and choice of the sign: from 0, for
// the same direction, to the square root of 2.
inline double direction_error(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  const Eigen::VectorXd u = a.normalized(), v = b.normalized();
  return (std::min)((u - v).norm(), (u + v).norm());
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_AFFINITIES_H
