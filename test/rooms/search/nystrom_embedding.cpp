// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(nystrom_embedding)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Eigenpairs;
using CGAL::Spectral_segmentation::internal::Index;
using CGAL::Spectral_segmentation::internal::normalized_rows;
using CGAL::Spectral_segmentation::internal::nystrom_extrapolation;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::shortest_paths;
using CGAL::Spectral_segmentation::internal::spectral_order;

namespace {

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

// The embedding for two samples s and t.
struct Embedding
{
  Eigen::VectorXd first, ratio;

  Embedding(const std::vector<double>& from_s, const std::vector<double>& from_t, Index s, Index t)
  {
    namespace internal = CGAL::Spectral_segmentation::internal;
    const Eigen::Index n = static_cast<Eigen::Index>(from_s.size());
    Eigen::MatrixXd distances(2, n);
    distances.row(0) = Eigen::Map<const Eigen::VectorXd>(from_s.data(), n);
    distances.row(1) = Eigen::Map<const Eigen::VectorXd>(from_t.data(), n);
    const internal::Eigenpairs e = internal::affinity_eigenpairs(distances, {s, t});
    first = e.vectors.col(0);
    ratio = internal::spectral_coordinates(e, {s, t});
  }
};

// Distances of all faces of a random mesh from two of them.
struct Two_samples
{
  Index s, t;
  std::vector<double> from_s, from_t;

  explicit Two_samples(Random& random)
  {
    const std::vector<Soup> shapes = {plate(5, 4), sphere(1), torus(2, 0.7, 6, 5), dumbbell(5, 4)};
    const Surface graph =
      graph_with_distances(displaced(shapes[random() % shapes.size()], 0.2, random));
    const Index n = num_vertices(graph);
    s = Index(random() % n);
    t = Index((s + 1 + random() % (n - 1)) % n);
    from_s = shortest_paths(graph, &Edge_weights::combined, s);
    from_t = shortest_paths(graph, &Edge_weights::combined, t);
  }

  double difference(Index f) const { return from_s[f] - from_t[f]; }
};

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

BOOST_AUTO_TEST_CASE(a_path_of_three_faces_worked_by_hand)
{
  // With the samples at its ends, sigma is 1 and the affinities are 1, q, q^2 with q = 1 / e.
  const Embedding e({0, 1, 2}, {2, 1, 0}, 0, 2);
  const double q = std::exp(-1.), r = std::sqrt(0.5);
  BOOST_TEST(std::abs(e.first[0]) == r, tt::tolerance(1e-12));
  BOOST_TEST(std::abs(e.first[1]) == std::sqrt(q / (1 + q * q)), tt::tolerance(1e-12));
  BOOST_TEST(std::abs(e.first[2]) == r, tt::tolerance(1e-12));
  BOOST_TEST(e.ratio[0] == -1, tt::tolerance(1e-12));
  BOOST_TEST(std::abs(e.ratio[1]) < 1e-12);
  BOOST_TEST(e.ratio[2] == 1, tt::tolerance(1e-12));
  BOOST_TEST(spectral_order({0, 1, 2}, {2, 1, 0}) == std::vector<Index>({0, 1, 2}),
             tt::per_element());
  BOOST_TEST(spectral_order({2, 1, 0}, {0, 1, 2}) == std::vector<Index>({2, 1, 0}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(the_first_eigenvector_has_one_sign)
{
  for (unsigned seed = 1; seed <= 200; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Two_samples samples(random);
      const Embedding e(samples.from_s, samples.from_t, samples.s, samples.t);
      BOOST_TEST(e.first.minCoeff() * e.first.maxCoeff() > 0);
    }
  }
}

// The claim on which the order rests: no kernel and no eigenvector is needed for it.
BOOST_AUTO_TEST_CASE(the_ratio_of_the_eigenvectors_grows_with_the_difference_of_the_distances)
{
  for (unsigned seed = 1; seed <= 200; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Two_samples samples(random);
      const Embedding e(samples.from_s, samples.from_t, samples.s, samples.t);
      const std::vector<Index> order = spectral_order(samples.from_s, samples.from_t);
      const double rounding = 1e-10 * e.ratio.cwiseAbs().maxCoeff();
      for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const Index f = order[i], g = order[i + 1];
        if (samples.difference(g) - samples.difference(f) > 1e-5)
          BOOST_TEST(e.ratio[f] < e.ratio[g]);
        else
          BOOST_TEST(e.ratio[f] < e.ratio[g] + rounding);
      }
      BOOST_TEST(e.ratio[samples.s] <= e.ratio.minCoeff() + rounding);
      BOOST_TEST(e.ratio[samples.t] >= e.ratio.maxCoeff() - rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE(ties_go_to_the_face_nearer_to_s_and_then_to_the_smaller_number)
{
  for (unsigned seed = 1; seed <= 100; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Index n = static_cast<Index>(1 + random() % 100);
      std::vector<double> from_s(n), from_t(n);
      for (Index f = 0; f < n; ++f) {
        from_s[f] = random() % 5;
        from_t[f] = random() % 5;
      }
      const auto precedes = [&](Index f, Index g) {
        const double difference = (from_s[f] - from_t[f]) - (from_s[g] - from_t[g]);
        if (difference != 0)
          return difference < 0;
        return from_s[f] != from_s[g] ? from_s[f] < from_s[g] : f < g;
      };
      const std::vector<Index> order = spectral_order(from_s, from_t);
      BOOST_REQUIRE(order.size() == n);
      // The place of a face is the number of faces that precede it.
      for (Index place = 0; place < n; ++place) {
        Index predecessors = 0;
        for (Index f = 0; f < n; ++f)
          predecessors += precedes(f, order[place]);
        BOOST_TEST(predecessors == place);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
