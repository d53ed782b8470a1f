// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(nystrom_embedding)

using CGAL::Spectral_segmentation::internal::Eigenpairs;
using CGAL::Spectral_segmentation::internal::Index;
using CGAL::Spectral_segmentation::internal::normalized_rows;
using CGAL::Spectral_segmentation::internal::nystrom_extrapolation;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

typedef std::mt19937 Random;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index cols, double smallest, Random& random)
{
  std::uniform_real_distribution<double> entry(smallest, 1);
  return MatrixXd::NullaryExpr(rows, cols, [&] { return entry(random); });
}

// Different elements in any order.
std::vector<Index> random_samples(Eigen::Index n, std::size_t m, Random& random)
{
  std::vector<Index> samples(static_cast<std::size_t>(n));
  std::iota(samples.begin(), samples.end(), Index(0));
  std::shuffle(samples.begin(), samples.end(), random);
  samples.resize(m);
  return samples;
}

MatrixXd rows_of(const MatrixXd& a, const std::vector<Index>& samples)
{
  MatrixXd rows(samples.size(), a.cols());
  for (std::size_t i = 0; i < samples.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = a.row(samples[i]);
  return rows;
}

// The eigenvalues of `a`, largest first, with their eigenvectors.
Eigenpairs dense_eigenpairs(const MatrixXd& a)
{
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a);
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

// Returns whether two vectors are equal up to sign.
bool are_parallel(const VectorXd& a, const VectorXd& b, double tolerance)
{ return std::min((a - b).norm(), (a + b).norm()) < tolerance; }

// Runs `test(random)` with a number of seeds.
template <class Test>
void with_seeds(unsigned number, const Test& test)
{
  for (unsigned seed = 1; seed <= number; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      test(random);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(extrapolated_vectors_reproduce_the_sampled_rows)
{
  with_seeds(50, [](Random& random) {
    const Eigen::Index m = 1 + random() % 6, n = m + random() % 40;
    const MatrixXd noise = random_matrix(n, n, -1, random);
    const MatrixXd a = noise + noise.transpose() + 4 * MatrixXd::Identity(n, n);
    const std::vector<Index> samples = random_samples(n, m, random);
    const MatrixXd rows = rows_of(a, samples);
    const Eigenpairs e = nystrom_extrapolation(rows, samples);
    const MatrixXd of_samples = rows_of(e.vectors, samples);
    const double condition = e.values.cwiseAbs().maxCoeff() / e.values.cwiseAbs().minCoeff();
    BOOST_TEST((of_samples * of_samples.transpose() - MatrixXd::Identity(m, m)).norm() <
               1e-13 * condition);
    BOOST_TEST((of_samples * e.values.asDiagonal() * e.vectors.transpose() - rows).norm() <
               1e-12 * condition);
    for (Eigen::Index i = 1; i < m; ++i)
      BOOST_TEST(e.values[i - 1] >= e.values[i]);
  });
}

BOOST_AUTO_TEST_CASE(the_result_is_exact_with_all_rows)
{
  with_seeds(20, [](Random& random) {
    const Eigen::Index n = 2 + random() % 10;
    const MatrixXd noise = random_matrix(n, n, -1, random);
    const MatrixXd a = noise * noise.transpose() + MatrixXd::Identity(n, n);
    const std::vector<Index> samples = random_samples(n, static_cast<std::size_t>(n), random);
    const MatrixXd rows = rows_of(a, samples);
    const Eigenpairs expected = dense_eigenpairs(a);
    const Eigenpairs e = nystrom_extrapolation(rows, samples);
    BOOST_TEST((e.values - expected.values).norm() < 1e-9);
    BOOST_TEST((a * e.vectors - e.vectors * expected.values.asDiagonal()).norm() < 1e-9);
    BOOST_TEST((e.vectors.transpose() * e.vectors - MatrixXd::Identity(n, n)).norm() < 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(rows_are_normalized_by_all_row_sums_of_a_matrix_of_rank_m)
{
  with_seeds(50, [](Random& random) {
    const Eigen::Index m = 1 + random() % 5, n = m + random() % 30;
    const MatrixXd root = random_matrix(n, m, 0, random);
    const MatrixXd a = root * root.transpose();
    const VectorXd scale = a.rowwise().sum().cwiseSqrt().cwiseInverse();
    const MatrixXd normalized = scale.asDiagonal() * a * scale.asDiagonal();
    const std::vector<Index> samples = random_samples(n, m, random);
    const VectorXd block = dense_eigenpairs(rows_of(a, samples)(Eigen::all, samples)).values;
    BOOST_TEST((normalized_rows(rows_of(a, samples), samples) - rows_of(normalized, samples))
                 .norm() < 1e-13 * block[0] / block[m - 1]);
  });
}

BOOST_AUTO_TEST_CASE(two_by_two_worked_by_hand)
{
  // Eigenvalues 1 + u and 1 - u with (1, 1) and (1, -1); the third element is like the mean.
  const double u = 0.5;
  const MatrixXd rows = (MatrixXd(2, 3) << 1, u, 0.75, u, 1, 0.75).finished();
  const Eigenpairs e = nystrom_extrapolation(rows, {0, 1});
  BOOST_TEST(std::abs(e.values[0] - 1.5) < 1e-15);
  BOOST_TEST(std::abs(e.values[1] - 0.5) < 1e-15);
  const double r = std::sqrt(0.5);
  BOOST_TEST(are_parallel(e.vectors.col(0), Eigen::Vector3d(r, r, r), 1e-15));
  BOOST_TEST(are_parallel(e.vectors.col(1), Eigen::Vector3d(r, -r, 0), 1e-15));
}

BOOST_AUTO_TEST_SUITE_END()
