// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/base/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/weights/searched_features.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

// Features on the mesh that is searched.
BOOST_AUTO_TEST_SUITE(searched_features)

using namespace test_meshes;
using namespace CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Salience_factors;
namespace tt = boost::test_tools;

namespace {

double random_value(Random& random) { return double(random()) / double(Random::max()) - 0.5; }

Feature_source source_of(const Eigen::MatrixXd& rows)
{
  return {std::size_t(rows.cols()), [&rows](Index f, double* vector) {
    for (Eigen::Index i = 0; i < rows.cols(); ++i)
      vector[i] = rows(f, i);
  }};
}

Eigen::MatrixXd random_rows(std::size_t rows, std::size_t columns, Random& random)
{
  return Eigen::MatrixXd::NullaryExpr(Eigen::Index(rows), Eigen::Index(columns),
                                      [&] { return random_value(random); });
}

std::vector<Index> numbers(std::size_t n)
{
  std::vector<Index> result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(principal_subspace_against_eigenvectors)
{
  Random random(1);
  const std::size_t rows = 400, columns = 60, dimension = 5;
  Eigen::MatrixXd m = random_rows(rows, columns, random);
  m.leftCols(dimension) *= 10;
  m = (m * random_rows(columns, columns, random).householderQr().householderQ()).eval();
  m.rowwise() -= m.colwise().mean().eval();
  Row_matrix a(rows, columns);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      a[i][j] = m(i, j);

  const Row_matrix found = principal_subspace(a, dimension);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(m.transpose() * m);
  const Eigen::MatrixXd expected = solver.eigenvectors().rightCols(dimension);
  Eigen::MatrixXd q(columns, dimension);
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t j = 0; j < dimension; ++j)
      q(i, j) = found[i][j];
  BOOST_TEST((q.transpose() * q - Eigen::MatrixXd::Identity(dimension, dimension)).norm() < 1e-12);
  BOOST_TEST((q * q.transpose() - expected * expected.transpose()).norm() < 1e-3);
}

BOOST_AUTO_TEST_CASE(columns_that_depend_on_others_become_zero)
{
  Row_matrix m(3, 3);
  m.values = {1, 2, 0, 1, 2, 0, 0, 0, 2};
  orthonormalize(m);
  BOOST_TEST(m[0][0] == std::sqrt(0.5), tt::tolerance(1e-15));
  BOOST_TEST(m[0][1] == 0);
  BOOST_TEST(m[2][2] == 1);
}

BOOST_AUTO_TEST_CASE(means_at_vertices_by_brute_force)
{
  Random random(2);
  const Surface surface = surface_of(displaced(sphere(2), 0.1, random));
  const std::size_t n = surface.points.size();
  const Eigen::MatrixXd rows = random_rows(surface.number_of_faces(), 11, random);
  const std::vector<Index> faces = numbers(surface.number_of_faces()), vertices = numbers(n);
  const Vertex_features means =
    Feature_means(source_of(rows), surface, faces, vertices, n)();
  for (Index v = 0; v < n; ++v) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rows.cols());
    double area = 0;
    for (Index f = 0; f < faces.size(); ++f)
      for (Index w : surface.corners[f])
        if (w == v) {
          sum += surface.areas[f] / 3 * (rows.row(f) - rows.row(0));
          area += surface.areas[f] / 3;
        }
    BOOST_TEST(means.areas[v] == area, tt::tolerance(1e-12));
    for (Eigen::Index i = 0; i < rows.cols(); ++i)
      BOOST_TEST(std::abs(means.means[v][i] - sum[i] / area) < 1e-12);
  }
}

// Only some of many faces at one vertex are read, but each vertex gets features.
BOOST_AUTO_TEST_CASE(each_vertex_has_features_of_many_faces)
{
  Random random(3);
  const Surface surface = surface_of(sphere(4));
  const std::size_t n = 4;
  std::vector<Index> vertices(surface.points.size());
  for (Index v = 0; v < vertices.size(); ++v)
    vertices[v] = v == 17 ? 3 : v % 3;
  Eigen::MatrixXd rows(surface.number_of_faces(), 1);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    rows(f, 0) = f == 0 ? 0 : 1;
  std::size_t number_of_reads = 0;
  const Feature_source source{1, [&](Index f, double* x) { ++number_of_reads; *x = rows(f, 0); }};
  const std::vector<Index> faces = numbers(surface.number_of_faces());
  const Vertex_features means = Feature_means(source, surface, faces, vertices, n)();
  BOOST_TEST(number_of_reads < surface.number_of_faces() / 8);
  for (std::size_t v = 0; v < n; ++v) {
    BOOST_TEST(means.areas[v] > 0);
    BOOST_TEST(means.means[v][0] > 0.9);
  }
}

BOOST_AUTO_TEST_CASE(features_have_variance_1)
{
  Random random(4);
  const Surface surface = surface_of(displaced(sphere(2), 0.1, random));
  for (std::size_t columns : {1, 3, 16, 40}) {
    const Eigen::MatrixXd rows = random_rows(surface.number_of_faces(), columns, random);
    const std::vector<Index> faces = numbers(surface.number_of_faces()),
                             vertices = numbers(surface.points.size());
    const Face_features features = CGAL::Spectral_segmentation::internal::searched_features(
      surface, Feature_means(source_of(rows), surface, faces, vertices, vertices.size())());
    BOOST_TEST(features.dimension == (std::min)(columns, std::size_t(16)));
    Feature_variance variance(features);
    double squares = 0;
    std::vector<double> sum(features.dimension, 0);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < features.dimension; ++i) {
        squares += surface.areas[f] * features[f][i] * features[f][i];
        sum[i] += surface.areas[f] * features[f][i];
      }
    BOOST_TEST(squares == total_area(surface), tt::tolerance(1e-5));
    for (double s : sum)
      BOOST_TEST(std::abs(s) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(explained_variance_by_hand)
{
  const Face_features features{1, {0, 2, 4, 10}};
  Feature_variance variance(features);
  variance.add(0, 1, 0);
  variance.add(1, 1, 0);
  variance.add(2, 2, 1);
  variance.add(3, 1, 1);
  // The means are 1 and 6, and 4 of all; the squares 116 + 36 - 5 * 4^2.
  BOOST_TEST(variance.squared_step() == 25);
  BOOST_TEST(variance.explained() == 2 * 9 + 3 * 4);
  BOOST_TEST(variance.explained_fraction() == 30. / (4 + 32 + 100 - 80), tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(sets_of_faces_by_hand)
{
  const Face_features features{2, {0, 0, 3, 4, 6, 8, 0, 0}};
  Set_features sets(features, {1, 1, 1, 2}, {0, 1, 1, 2}, 4);
  BOOST_TEST(sets.distance(0, 1) == 7.5); // from (0, 0) to (4.5, 6)
  BOOST_TEST(sets.distance(0, 2) == 0);
  BOOST_TEST(sets.distance(0, 3) == 0, "an empty set");
  BOOST_TEST(sets.explained_variance() == 2 * 7.5 * 7.5 / 5);
  sets.join(1, 2);
  BOOST_TEST(sets.distance(0, 2) == 3.75);
  BOOST_TEST(Set_features().empty());
  BOOST_TEST(Set_features().explained_variance() == 0);
}

BOOST_AUTO_TEST_CASE(order_along_the_largest_variance)
{
  Random random(5);
  Face_features features{3, {}};
  std::vector<double> position;
  for (std::size_t f = 0; f < 100; ++f) {
    position.push_back(random_value(random));
    for (double direction : {0.6, 0., -0.8})
      features.values.push_back(float(direction * position.back() + 1e-3 * random_value(random)));
  }
  std::vector<Index> order = feature_order(features, std::vector<double>(50, 1),
                                           [] { auto n = numbers(100); n.resize(50); return n; }());
  if (position[order.front()] > position[order.back()])
    std::reverse(order.begin(), order.end());
  BOOST_TEST(order.size() == 50);
  for (std::size_t i = 1; i < order.size(); ++i)
    BOOST_TEST(position[order[i]] > position[order[i - 1]] - 0.01);
}

BOOST_AUTO_TEST_CASE(only_steps_beyond_the_usual_count_as_concave)
{
  Surface surface = surface_of(plate(20, 20));
  surface.weights.assign(surface.number_of_halfedges(), Edge_weights());
  Face_features ramp{1, {}}, step{1, {}};
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    const double x = surface.centroid(f).x();
    ramp.values.push_back(float(x));
    step.values.push_back(x > 0 ? 0.5f : -0.5f);
  }
  Surface smooth = surface;
  add_feature_steps(ramp, 1, 0.5, smooth);
  add_feature_steps(step, 3, 0.5, surface);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    BOOST_TEST(smooth.weights[h].concavity < 0.05);
    const bool is_at_step = step.values[h / 3] != step.values[surface.neighbor(h)];
    BOOST_TEST(surface.weights[h].concavity == (is_at_step ? 0.75 : 0), tt::tolerance(1e-4));
  }
}

BOOST_AUTO_TEST_SUITE_END()
