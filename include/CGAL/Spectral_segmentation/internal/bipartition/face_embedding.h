// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_FACE_EMBEDDING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_FACE_EMBEDDING_H

#include <CGAL/Spectral_segmentation/internal/bipartition/nystrom.h>
#include <CGAL/Spectral_segmentation/internal/distances/shortest_paths.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The spectral embedding of the faces of a part (Section 5). The search needs only the order of the
// embedding for two samples, which `spectral_order()` finds without it.

// Returns the combined distances of all faces from some samples, one row per sample.
inline Eigen::MatrixXd distances_from(const Surface& part, const std::vector<Index>& samples)
{
  Eigen::MatrixXd rows(samples.size(), part.number_of_faces());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::vector<double> distance =
      shortest_paths(part, &Edge_weights::combined, samples[i]);
    rows.row(static_cast<Eigen::Index>(i)) =
      Eigen::Map<const Eigen::VectorXd>(distance.data(), rows.cols());
  }
  return rows;
}

// Returns the affinities by the paper's kernel, whose width is the mean of all given distances.
// Faces of different components, at infinite distance, have the affinity 0.
inline Eigen::MatrixXd affinities(const Eigen::MatrixXd& distances)
{
  const auto is_finite = distances.array().isFinite();
  const double sum = is_finite.select(distances.array(), 0).sum();
  const double sigma = sum > 0 ? sum / static_cast<double>(is_finite.count()) : 1;
  return (-distances.array() / (sigma * sigma)).exp().matrix();
}

// Returns D^-1/2 A D^-1/2 for a whole matrix A of affinities.
inline Eigen::MatrixXd normalized(const Eigen::MatrixXd& affinities)
{
  const Eigen::VectorXd scale = affinities.rowwise().sum().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * affinities * scale.asDiagonal();
}

// Returns the eigenvectors of the normalized affinities, approximated from the distances of some
// samples (Section 5.2), or exact if all faces are samples, in ascending order.
inline Eigenpairs affinity_eigenpairs(const Eigen::MatrixXd& distances,
                                      const std::vector<Index>& samples)
{
  const Eigen::MatrixXd rows = affinities(distances);
  return rows.rows() == rows.cols() && std::is_sorted(samples.begin(), samples.end())
    ? descending_eigenpairs(normalized(rows))
    : nystrom_extrapolation(normalized_rows(rows, samples), samples);
}

inline Eigenpairs face_eigenpairs(const Surface& part, const std::vector<Index>& samples)
{ return affinity_eigenpairs(distances_from(part, samples), samples); }

// Returns the coordinate of each face on the spectral line: the ratio of the second eigenvector to
// the first (Section 5.3). The first sample does not lie above the last one.
inline Eigen::VectorXd spectral_coordinates(const Eigenpairs& e, const std::vector<Index>& samples)
{
  const Eigen::VectorXd z = e.vectors.col(1).cwiseQuotient(e.vectors.col(0));
  return z[samples.front()] <= z[samples.back()] ? z : Eigen::VectorXd(-z);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_FACE_EMBEDDING_H
