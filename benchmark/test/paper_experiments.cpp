// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include "../evaluation.h"
#include "../k_means.h"
#include "../paper_experiments/face_samples.h"
#include "../paper_experiments/parts.h"
#include "../paper_experiments/spectral_clusters.h"
#include "../paper_experiments/spectral_lines.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/segment_spectral_recursive.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(paper_experiments)

namespace internal = CGAL::Spectral_segmentation::internal;
namespace tt = boost::test_tools;
using namespace segmentation_benchmark;
using CGAL::Spectral_segmentation::internal::affinities;
using CGAL::Spectral_segmentation::internal::descending_eigenpairs;
using CGAL::Spectral_segmentation::internal::distances_from;
using CGAL::Spectral_segmentation::internal::normalized;
using CGAL::Spectral_segmentation::internal::normalized_rows;
using CGAL::Spectral_segmentation::internal::nystrom_extrapolation;
using test_meshes::graph_with_distances;

namespace {

constexpr double tolerance = 1e-12;

Surface irregular_dumbbell()
{
  test_meshes::Random random(1);
  return graph_with_distances(
    test_meshes::displaced(test_meshes::dumbbell(12, 6), 0.01, random));
}

// On which side of the neck of the dumbbell each face is.
Labels spheres(const Surface& dumbbell)
{
  Labels labels;
  for (Index f = 0; f < dumbbell.number_of_faces(); ++f)
    labels.push_back(dumbbell.centroid(f).z() > 0);
  return contiguous(labels);
}

} // namespace

BOOST_AUTO_TEST_CASE(k_means_recovers_separated_clusters)
{
  const Eigen::Index cluster_size = 40;
  Eigen::MatrixXd centers(4, 2);
  centers << 0, 0, 10, 0, 0, 10, 10, 10;
  for (std::uint32_t seed = 1; seed <= 10; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random_engine random = random_engine(0, seed);
      Eigen::MatrixXd points(4 * cluster_size, 2);
      Labels expected;
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        expected.push_back(static_cast<std::size_t>(i % 4));
        for (int j = 0; j < 2; ++j)
          points(i, j) = centers(i % 4, j) + static_cast<double>(random() % 1000) / 1000;
      }
      BOOST_TEST(k_means(points, 4, random) == expected, tt::per_element());
    }
}

BOOST_AUTO_TEST_CASE(k_means_of_fewer_places_than_clusters)
{
  Eigen::MatrixXd points(6, 1);
  points << 1, 2, 1, 2, 1, 2;
  Random_engine random = random_engine(0);
  BOOST_TEST(k_means(points, 3, random) == (Labels{0, 1, 0, 1, 0, 1}), tt::per_element());
}

// The mean distance of 0, d, d, 0 is d / 2.
BOOST_AUTO_TEST_CASE(kernel_is_as_wide_as_the_mean_distance)
{
  const double d = 3, infinity = std::numeric_limits<double>::infinity();
  Eigen::MatrixXd distances(2, 2);
  distances << 0, d, d, 0;
  const Eigen::MatrixXd a = affinities(distances);
  BOOST_TEST(a(0, 0) == 1);
  BOOST_TEST(a(0, 1) == std::exp(-d / (d * d / 4)), tt::tolerance(tolerance));

  Eigen::MatrixXd with_infinity(2, 3);
  with_infinity << 0, d, infinity, d, 0, infinity;
  BOOST_TEST((affinities(with_infinity).leftCols(2) == a));
  BOOST_TEST(affinities(with_infinity).col(2).maxCoeff() < 1e-300);
  BOOST_TEST((affinities(Eigen::MatrixXd::Zero(2, 2)) == Eigen::MatrixXd::Ones(2, 2)));
}

// Four elements in a circle, 1 with themselves and a with neighbors: a circulant matrix.
BOOST_AUTO_TEST_CASE(eigenvalues_of_a_normalized_circle)
{
  const double a = 0.3;
  Eigen::MatrixXd circle = Eigen::MatrixXd::Identity(4, 4);
  for (int i = 0; i < 4; ++i)
    circle(i, (i + 1) % 4) = circle((i + 1) % 4, i) = a;
  const Eigen::VectorXd values = descending_eigenpairs(normalized(circle)).values;
  const double sum = 1 + 2 * a;
  const std::array<double, 4> expected = {1, 1 / sum, 1 / sum, (1 - 2 * a) / sum};
  for (int i = 0; i < 4; ++i)
    BOOST_TEST(values[i] == expected[static_cast<std::size_t>(i)], tt::tolerance(tolerance));
}

// The first eigenvector of D^-1/2 A D^-1/2 is the root of the row sums, of eigenvalue 1.
BOOST_AUTO_TEST_CASE(first_eigenvector_of_a_normalized_matrix)
{
  Eigen::MatrixXd a(3, 3);
  a << 1, 0.5, 0.1, 0.5, 1, 0.2, 0.1, 0.2, 1;
  const Eigenpairs e = descending_eigenpairs(normalized(a));
  BOOST_TEST(e.values[0] == 1, tt::tolerance(tolerance));
  BOOST_TEST(direction_error(e.vectors.col(0), a.rowwise().sum().cwiseSqrt()) < 1e-7);
}

BOOST_AUTO_TEST_CASE(direction_error_of_vectors)
{
  const Eigen::Vector3d v(1, 2, 2);
  BOOST_TEST(direction_error(v, -3 * v) == 0, tt::tolerance(tolerance));
  BOOST_TEST(direction_error(v, Eigen::Vector3d(0, 1, -1)) == std::sqrt(2.),
             tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(no_error_if_all_faces_are_samples)
{
  const Surface graph = irregular_dumbbell();
  std::vector<Index> samples = all_faces(graph);
  std::reverse(samples.begin(), samples.end());
  const Eigen::MatrixXd rows = affinities(distances_from(graph, samples));
  const Eigenpairs approximate =
    nystrom_extrapolation(normalized_rows(rows, samples), samples);
  const Eigenpairs exact = face_eigenpairs(graph, all_faces(graph));
  for (int e : {0, 1})
    BOOST_TEST(direction_error(approximate.vectors.col(e), exact.vectors.col(e)) < 1e-6);
}

// The order of the two-sample embedding equals the order by the difference of the distances.
BOOST_AUTO_TEST_CASE(line_of_two_samples)
{
  const Surface graph = irregular_dumbbell();
  Random_engine random = random_engine(0);
  const std::vector<Index> samples = samples_by_contexts(graph, 2, random);
  const Eigenpairs e = face_eigenpairs(graph, samples);
  const auto from = [&](Index f)
  { return internal::shortest_paths(graph, &Edge_weights::combined, f); };
  const std::vector<double> from_s = from(samples[0]), from_t = from(samples[1]);
  std::vector<double> differences;
  for (Index f : spectral_line(graph, e, samples, false))
    differences.push_back(from_s[f] - from_t[f]);
  if (differences.front() > differences.back())
    std::reverse(differences.begin(), differences.end());
  for (std::size_t i = 1; i < differences.size(); ++i)
    BOOST_TEST(differences[i - 1] <= differences[i] + 1e-5);
}

// The cut of the package, along the line from one sample or from the other.
BOOST_AUTO_TEST_CASE(cut_by_two_samples)
{
  const Surface graph = irregular_dumbbell();
  Random_engine random = random_engine(0);
  const std::vector<Index> samples = samples_by_contexts(graph, 2, random);
  const auto from = [&](Index f)
  { return internal::shortest_paths(graph, &Edge_weights::combined, f); };
  const std::vector<double> from_s = from(samples[0]), from_t = from(samples[1]);
  const CGAL::Spectral_segmentation::Weighted_part_salience part_salience;
  const auto salience = [&](const std::vector<Index>& line) {
    return internal::line_search(Execution::SEQUENTIAL, graph, line, part_salience, 0)->salience;
  };
  const auto order = [&](const std::vector<double>& from, const std::vector<double>& to)
  { return internal::spectral_order(from, to); };
  const double expected =
    std::max(salience(order(from_s, from_t)), salience(order(from_t, from_s)));
  const auto cut = cut_by_eigenvectors(graph, face_eigenpairs(graph, samples), samples, 0);
  BOOST_TEST_REQUIRE(cut.has_value());
  BOOST_TEST(cut->salience == expected, tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(a_dumbbell_is_cut_at_its_neck_by_exact_eigenvectors)
{
  const Surface graph = irregular_dumbbell();
  const std::vector<Index> samples = all_faces(graph);
  const auto cut = cut_by_eigenvectors(graph, face_eigenpairs(graph, samples), samples, 0);
  BOOST_TEST_REQUIRE(cut.has_value());
  BOOST_TEST(contiguous(cut->side) == spheres(graph), tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_dumbbell_has_two_spectral_clusters)
{
  const Surface graph = irregular_dumbbell();
  const Labels expected = spheres(graph);
  for (std::size_t m : {std::size_t(20), graph.number_of_faces()})
    for (const auto cluster : {k_way_clusters, recursive_two_means}) {
      Random_engine random = random_engine(0);
      BOOST_TEST(rand_error(contiguous(cluster(graph, 2, m, random)), expected) < 0.1);
    }
}

BOOST_AUTO_TEST_CASE(schemes_take_different_faces)
{
  const Surface graph = graph_with_distances(test_meshes::plate(2, 2));
  for (const Sampling_scheme& scheme : sampling_schemes)
    for (std::size_t m : {2, 5, 100}) {
      BOOST_TEST_INFO_SCOPE(scheme.name << ", " << m);
      Random_engine random = random_engine(0);
      const std::vector<Index> samples = scheme.take(graph, m, random);
      BOOST_TEST(samples.size() == std::min(m, graph.number_of_faces()));
      BOOST_TEST(std::set<Index>(samples.begin(), samples.end()).size() == samples.size());
    }
}

BOOST_AUTO_TEST_CASE(farthest_first_on_a_line)
{
  const auto distances_from = [](Index f) {
    std::vector<double> distances;
    for (int g = 0; g <= 8; ++g)
      distances.push_back(std::abs(g - static_cast<int>(f)));
    return distances;
  };
  BOOST_TEST(farthest_first(9, 0, 5, distances_from) == (std::vector<Index>{0, 8, 4, 2, 6}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(first_two_samples_by_contexts_equal_the_samples_of_the_package)
{
  const Surface graph = irregular_dumbbell();
  const internal::Sample_faces expected =
    internal::sample_faces(Execution::SEQUENTIAL, internal::shape_contexts(
      graph, internal::farthest_face_from_center(Execution::SEQUENTIAL, graph), 10, [] {}));
  Random_engine random = random_engine(0);
  BOOST_TEST(samples_by_contexts(graph, 2, random) == (std::vector<Index>{expected.s, expected.t}),
             tt::per_element());
}

// 16 faces of equal area; the largest part is halved next, the first of several.
BOOST_AUTO_TEST_CASE(recursion_cuts_the_largest_part)
{
  const Surface graph = graph_with_distances(test_meshes::plate(8, 1));
  const auto halves = [](const Part& part) {
    Sides sides(part.faces.size(), 0);
    std::fill(sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2), sides.end(), 1);
    return std::optional<Sides>(sides);
  };
  const Labels labels = contiguous(recursive_cuts(graph, 3, halves));
  BOOST_TEST(labels == (Labels{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2}),
             tt::per_element());
  const auto none = [](const Part&) { return std::optional<Sides>(); };
  BOOST_TEST(number_of_segments(recursive_cuts(graph, 3, none)) == 1u);
}

BOOST_AUTO_TEST_CASE(recursion_by_shape_context_equals_the_package)
{
  namespace params = CGAL::Spectral_segmentation::parameters;
  test_meshes::Random displacement(1);
  Mesh mesh;
  CGAL::copy_face_graph(
    test_meshes::mesh_of(
      test_meshes::displaced(test_meshes::dumbbell(12, 6), 0.01, displacement)), mesh);
  const std::size_t k = 5;
  const auto expected = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  BOOST_TEST(CGAL::segment_spectral_recursive(
               mesh, expected,
               params::zhang_liu_2005().maximum_number_of_segments(k)
                 .salience_threshold(-std::numeric_limits<double>::infinity())) == k);

  const Surface graph = paper_graph(mesh);
  Random_engine random = random_engine(0);
  const Labels labels =
    recursive_cuts_by_samples(sampling_schemes[shape_context_scheme], graph, k, random);
  BOOST_TEST(contiguous(labels) == Labels(expected.begin(), expected.end()), tt::per_element());
}

BOOST_AUTO_TEST_CASE(paired_difference_by_hand)
{
  const Paired_difference d = paired_difference({1, 2, undefined, 3}, {0, 0, 0, 0});
  BOOST_TEST(d.mean == 2, tt::tolerance(tolerance));
  BOOST_TEST(d.standard_error == std::sqrt(1. / 3), tt::tolerance(tolerance));
  BOOST_TEST(d.is_positive());
  BOOST_TEST(!d.is_negative());
  BOOST_TEST(!paired_difference({1, -1}, {0, 0}).is_positive());
}

// The part of faces 2 to 7 is cut after its second face.
BOOST_AUTO_TEST_CASE(agreement_by_hand)
{
  const Part part{Surface(), {2, 3, 4, 5, 6, 7}};
  const Sides side = {0, 0, 1, 1, 1, 1};
  const Labels along_the_cut = {0, 0, 1, 1, 2, 2, 2, 2}, nowhere_else = {0, 0, 0, 0, 1, 1, 1, 1},
               everywhere = {0, 1, 2, 3, 4, 5, 6, 7}, whole(8, 0),
               one_face_early = {0, 0, 1, 2, 2, 2, 2, 2}, one_face_late = {0, 0, 0, 0, 0, 1, 1, 1};
  for (const Labels& person : {along_the_cut, nowhere_else, everywhere})
    BOOST_TEST(agreement(part, side, person) == 1);
  BOOST_TEST(agreement(part, side, whole) == 0);
  BOOST_TEST(agreement(part, side, one_face_early) == 0.5); // face 3, of two
  BOOST_TEST(agreement(part, side, one_face_late) == 0.5);  // face 4
}

BOOST_AUTO_TEST_SUITE_END()
