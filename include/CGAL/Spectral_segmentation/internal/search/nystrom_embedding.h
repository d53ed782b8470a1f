// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_NYSTROM_EMBEDDING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_NYSTROM_EMBEDDING_H

#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The Nystrom approximation of the eigenvectors of a symmetric n x n matrix of affinities, of which
// only the m rows of some samples are known (Section 5.2; Fowlkes et al., PAMI 26(2), 2004).
//
// `rows` is the m x n block of these rows; row i belongs to element `samples[i]`.

struct Eigenpairs
{
  Eigen::VectorXd values;  // descending
  Eigen::MatrixXd vectors; // n x m, one a column
};

inline Eigen::MatrixXd sampled_block(const Eigen::MatrixXd& rows, const std::vector<Index>& samples)
{
  Eigen::MatrixXd block(rows.rows(), rows.rows());
  for (std::size_t j = 0; j < samples.size(); ++j)
    block.col(static_cast<Eigen::Index>(j)) = rows.col(samples[j]);
  return block;
}

inline Eigenpairs descending_eigenpairs(const Eigen::MatrixXd& symmetric)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

// Returns f(eigenvalue), or 0 if the eigenvalue is 0 up to rounding, like a pseudo-inverse.
template <class Function>
Eigen::VectorXd on_nonzero(const Eigen::VectorXd& values, Function f)
{
  const double smallest = 1e-12 * values.cwiseAbs().maxCoeff();
  return values.unaryExpr([&](double v) { return std::abs(v) > smallest ? f(v) : 0.; });
}

// Returns the normalized rows D^-1/2 A D^-1/2. The row sums D of elements that are not samples come
// from the approximation of A.
inline Eigen::MatrixXd normalized_rows(const Eigen::MatrixXd& rows,
                                       const std::vector<Index>& samples)
{
  const Eigenpairs block = descending_eigenpairs(sampled_block(rows, samples));
  const Eigen::MatrixXd inverse = block.vectors *
    on_nonzero(block.values, [](double v) { return 1 / v; }).asDiagonal() *
    block.vectors.transpose();
  const Eigen::VectorXd row_sums = rows.transpose() * (inverse * rows.rowwise().sum());
  // An approximated sum may be negative. Any positive value serves, because it cancels out in the
  // ratio of two eigenvectors.
  const Eigen::VectorXd scale = row_sums.unaryExpr(
    [](double sum) { return 1 / std::sqrt((std::max)(std::abs(sum), 1e-300)); });
  Eigen::VectorXd scale_of_samples(rows.rows());
  for (std::size_t i = 0; i < samples.size(); ++i)
    scale_of_samples[static_cast<Eigen::Index>(i)] = scale[samples[i]];
  return scale_of_samples.asDiagonal() * rows * scale.asDiagonal();
}

// Returns the eigenvectors of the sampled block, extrapolated to all elements (Section 5.2):
// [U; Y^T U Lambda^-1]. They reproduce the sampled rows, but are not orthogonal.
inline Eigenpairs nystrom_extrapolation(const Eigen::MatrixXd& rows,
                                        const std::vector<Index>& samples)
{
  const Eigenpairs block = descending_eigenpairs(sampled_block(rows, samples));
  return {block.values, rows.transpose() * block.vectors *
    on_nonzero(block.values, [](double v) { return 1 / v; }).asDiagonal()};
}

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

// Returns D^-1/2 A D^-1/2 for a complete matrix A of affinities.
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_NYSTROM_EMBEDDING_H
