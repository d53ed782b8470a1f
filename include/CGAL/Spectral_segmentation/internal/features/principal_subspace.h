// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_PRINCIPAL_SUBSPACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_PRINCIPAL_SUBSPACE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A matrix whose rows follow each other. Its products are plain loops, because sums of Eigen depend
// on its version and on the processor, and labels must not.
struct Row_matrix
{
  std::size_t number_of_columns = 0;
  std::vector<double> values;

  Row_matrix(std::size_t rows, std::size_t columns)
    : number_of_columns(columns), values(rows * columns, 0) {}

  std::size_t number_of_rows() const
  { return number_of_columns == 0 ? 0 : values.size() / number_of_columns; }
  double* operator[](std::size_t row) { return &values[row * number_of_columns]; }
  const double* operator[](std::size_t row) const { return &values[row * number_of_columns]; }
};

// Returns a * b.
inline Row_matrix product(const Row_matrix& a, const Row_matrix& b)
{
  Row_matrix result(a.number_of_rows(), b.number_of_columns);
  for (std::size_t i = 0; i < a.number_of_rows(); ++i)
    for (std::size_t k = 0; k < a.number_of_columns; ++k)
      for (std::size_t j = 0; j < b.number_of_columns; ++j)
        result[i][j] += a[i][k] * b[k][j];
  return result;
}

// Returns transposed(a) * diagonal(weights) * b.
inline Row_matrix weighted_transposed_product(const Row_matrix& a,
                                              const std::vector<double>& weights,
                                              const Row_matrix& b)
{
  Row_matrix result(a.number_of_columns, b.number_of_columns);
  for (std::size_t i = 0; i < a.number_of_rows(); ++i)
    for (std::size_t k = 0; k < a.number_of_columns; ++k) {
      const double factor = weights[i] * a[i][k];
      for (std::size_t j = 0; j < b.number_of_columns; ++j)
        result[k][j] += factor * b[i][j];
    }
  return result;
}

// Makes the columns orthonormal, the first first. Columns that depend on earlier ones become 0.
inline void orthonormalize(Row_matrix& m)
{
  const std::size_t rows = m.number_of_rows();
  const auto dot = [&](std::size_t a, std::size_t b) {
    double sum = 0;
    for (std::size_t i = 0; i < rows; ++i)
      sum += m[i][a] * m[i][b];
    return sum;
  };
  for (std::size_t j = 0; j < m.number_of_columns; ++j) {
    const double norm_before = std::sqrt(dot(j, j));
    for (int pass = 0; pass < 2; ++pass) // the second removes what rounding left
      for (std::size_t k = 0; k < j; ++k) {
        const double c = dot(j, k);
        for (std::size_t i = 0; i < rows; ++i)
          m[i][j] -= c * m[i][k];
      }
    const double norm = std::sqrt(dot(j, j));
    const double factor = norm > 1e-10 * norm_before ? 1 / norm : 0;
    for (std::size_t i = 0; i < rows; ++i)
      m[i][j] *= factor;
  }
}

// Returns orthonormal columns that span the directions in which rows of mean 0 differ the most, by
// orthogonal iteration. The directions themselves are not separated. About 500 rows, evenly spaced,
// stand for all, which takes a fraction of the time of reading 200,000 faces.
inline Row_matrix principal_subspace(const Row_matrix& all_rows, std::size_t dimension)
{
  const std::size_t step = all_rows.number_of_rows() / 500 + 1;
  Row_matrix rows((all_rows.number_of_rows() + step - 1) / step, all_rows.number_of_columns);
  for (std::size_t i = 0; i < rows.number_of_rows(); ++i)
    std::copy_n(all_rows[i * step], rows.number_of_columns, rows[i]);

  Row_matrix result(rows.number_of_columns, dimension);
  std::uint32_t state = 1;
  for (double& value : result.values) {
    state = 1664525 * state + 1013904223; // of Numerical Recipes
    value = (state >> 31) != 0 ? 1 : -1;
  }
  const std::vector<double> equal_weights(rows.number_of_rows(), 1);
  constexpr int number_of_iterations = 4;
  for (int i = 0; i < number_of_iterations; ++i) {
    orthonormalize(result);
    result = weighted_transposed_product(rows, equal_weights, product(rows, result));
  }
  orthonormalize(result);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_PRINCIPAL_SUBSPACE_H
