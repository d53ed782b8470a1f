// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>

#include "test_meshes.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using CGAL::Spectral_segmentation::internal::Eigen_decomposition;
using CGAL::Spectral_segmentation::internal::Symmetric_matrix;
using CGAL::Spectral_segmentation::internal::Vector;

BOOST_AUTO_TEST_SUITE(vector)

namespace {

Symmetric_matrix random_matrix(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random),
          normal(random), normal(random), normal(random)};
}

// Returns whether the matrix only scales a unit vector, by this value.
bool is_eigenvector(const Symmetric_matrix& m, const Vector& v, double eigenvalue)
{ return std::abs(v.norm() - 1) < 1e-12 && (m * v - eigenvalue * v).norm() < 1e-9; }

} // namespace

BOOST_AUTO_TEST_CASE(eigenvalues_and_vectors_equal_the_results_of_a_dense_solver)
{
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Symmetric_matrix m = random_matrix(random);
    Eigen::Matrix3d dense;
    dense << m.xx, m.xy, m.zx, m.xy, m.yy, m.yz, m.zx, m.yz, m.zz;
    const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(dense).eigenvalues();
    const Eigen_decomposition solver(m);
    BOOST_TEST(std::abs(solver.largest_eigenvalue() - values[2]) < 1e-12);
    for (int k = 0; k < 3; ++k)
      BOOST_TEST(std::abs(solver.eigenvalue(k) - values[k]) < 1e-12);
    Vector smallest, middle;
    solver.set_eigenvectors(smallest, middle);
    BOOST_TEST(is_eigenvector(m, smallest, values[0]));
    BOOST_TEST(is_eigenvector(m, middle, values[1]));
    BOOST_TEST(std::abs(smallest.dot(middle)) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(equal_eigenvalues_have_orthogonal_vectors)
{
  for (const Symmetric_matrix& m : {Symmetric_matrix{2, 2, 2}, Symmetric_matrix{1, 1, 3},
                                    Symmetric_matrix{3, 1, 3}, Symmetric_matrix()}) {
    Vector smallest, middle;
    Eigen_decomposition(m).set_eigenvectors(smallest, middle);
    const double least = (std::min)({m.xx, m.yy, m.zz});
    BOOST_TEST(is_eigenvector(m, smallest, least));
    BOOST_TEST(is_eigenvector(m, middle, m.xx + m.yy + m.zz - least -
                                           Eigen_decomposition(m).largest_eigenvalue()));
    BOOST_TEST(std::abs(smallest.dot(middle)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_inverse_takes_a_product_back)
{
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const Symmetric_matrix m = random_matrix(random);
    const Vector v(1, -2, 0.5);
    BOOST_TEST((m.inverse() * (m * v) - v).norm() < 1e-7);
  }
}

BOOST_AUTO_TEST_SUITE_END()
