// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_NYSTROM_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_NYSTROM_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

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
// `rows` is the m x n block of these rows; row i is that of element `samples[i]`.

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

// f(eigenvalue), or 0 for an eigenvalue that is 0 but for rounding: the pseudo-inverse.
template <class Function>
Eigen::VectorXd on_nonzero(const Eigen::VectorXd& values, Function f)
{
  const double smallest = 1e-12 * values.cwiseAbs().maxCoeff();
  return values.unaryExpr([&](double v) { return std::abs(v) > smallest ? f(v) : 0.; });
}

// The normalized rows D^-1/2 A D^-1/2, with the row sums D of elements that are not samples taken
// from the approximation of A.
inline Eigen::MatrixXd normalized_rows(const Eigen::MatrixXd& rows,
                                       const std::vector<Index>& samples)
{
  const Eigenpairs block = descending_eigenpairs(sampled_block(rows, samples));
  const Eigen::MatrixXd inverse = block.vectors *
    on_nonzero(block.values, [](double v) { return 1 / v; }).asDiagonal() *
    block.vectors.transpose();
  const Eigen::VectorXd row_sums = rows.transpose() * (inverse * rows.rowwise().sum());
  // An approximated sum may come out negative; any positive value serves, as it cancels out in the
  // ratio of two eigenvectors.
  const Eigen::VectorXd scale = row_sums.unaryExpr(
    [](double sum) { return 1 / std::sqrt((std::max)(std::abs(sum), 1e-300)); });
  Eigen::VectorXd scale_of_samples(rows.rows());
  for (std::size_t i = 0; i < samples.size(); ++i)
    scale_of_samples[static_cast<Eigen::Index>(i)] = scale[samples[i]];
  return scale_of_samples.asDiagonal() * rows * scale.asDiagonal();
}

// Eigenvectors of the sampled block, extrapolated to all elements: [U; Y^T U Lambda^-1], as in
// Section 5.2. They reproduce the sampled rows, and are not orthogonal.
inline Eigenpairs nystrom_extrapolation(const Eigen::MatrixXd& rows,
                                        const std::vector<Index>& samples)
{
  const Eigenpairs block = descending_eigenpairs(sampled_block(rows, samples));
  return {block.values, rows.transpose() * block.vectors *
    on_nonzero(block.values, [](double v) { return 1 / v; }).asDiagonal()};
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_NYSTROM_H
