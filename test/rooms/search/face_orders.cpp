// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(face_orders)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Sample_faces;
using CGAL::Spectral_segmentation::internal::Shape_contexts;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::farthest_face_from_center;
using CGAL::Spectral_segmentation::internal::null_index;
using CGAL::Spectral_segmentation::internal::random_face;
using CGAL::Spectral_segmentation::internal::sample_faces;
using CGAL::Spectral_segmentation::internal::shape_contexts;
using CGAL::Spectral_segmentation::internal::shortest_paths;

namespace {

Surface random_graph(Random& random)
{
  const std::vector<Soup> shapes = {plate(5, 4), sphere(1), torus(2, 0.7, 6, 5), dumbbell(5, 4)};
  return graph_with_distances(displaced(shapes[random() % shapes.size()], 0.2, random));
}

// Gives each edge a random length and a random angle, so that no two ways have the same length.
void randomize_distances(Surface& graph, Random& random)
{
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    if (graph.is_border(h) || graph.opposite[h] < h)
      continue;
    Edge_weights &e = graph.weights[h], &o = graph.weights[graph.opposite[h]];
    e.geodesic = o.geodesic = std::ldexp(float(1 + random() % (1u << 20)), -20);
    e.angle = o.angle = std::ldexp(float(random() % 1025), -10);
  }
}

std::vector<double> geodesic_distances(const Surface& graph, Index source)
{ return shortest_paths(graph, &Edge_weights::geodesic, source); }

// The sum of the angles along the only shortest way from f to `reference`, walked backwards.
double context_by_walking(const Surface& graph, Index f, Index reference,
                          const std::vector<double>& from_reference)
{
  double sum = 0;
  while (f != reference) {
    Index way = null_index;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (!graph.is_border(h) && from_reference[graph.neighbor(h)] +
                                   graph.weights[h].geodesic == from_reference[f]) {
        BOOST_REQUIRE(way == null_index);
        way = h;
      }
    BOOST_REQUIRE(way != null_index);
    sum += graph.weights[way].angle;
    f = graph.neighbor(way);
  }
  return sum;
}

Shape_contexts contexts_of(const Surface& graph, Index first, std::size_t k)
{ return shape_contexts(graph, first, k, [] {}); }

double squared_distance(const Shape_contexts& contexts, Index f, const std::vector<double>& from)
{
  double sum = 0;
  for (std::size_t j = 0; j < from.size(); ++j)
    sum += std::pow(contexts.values(f, j) - from[j], 2);
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_first_reference_is_farthest_from_the_center_of_area)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup soup = displaced(seed % 2 ? plate(6, 3) : sphere(1), 0.2, random);
      const Surface graph = surface_of(soup);
      const auto corner = [&](std::size_t f, std::size_t i)
      { return soup.points[soup.triangles[f][i]]; };
      CGAL::Vector_3<Kernel> moment(0, 0, 0);
      double area = 0;
      std::vector<Point> centroids;
      for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        const double a =
          std::sqrt(CGAL::squared_area(corner(f, 0), corner(f, 1), corner(f, 2)));
        centroids.push_back(CGAL::centroid(corner(f, 0), corner(f, 1), corner(f, 2)));
        moment = moment + a * (centroids.back() - CGAL::ORIGIN);
        area += a;
      }
      const Point center = CGAL::ORIGIN + moment / area;
      double largest = 0;
      for (const Point& p : centroids)
        largest = std::max(largest, CGAL::squared_distance(p, center));
      BOOST_TEST(CGAL::squared_distance(centroids[farthest_face_from_center(sequential, graph)],
                                        center) == largest,
                 tt::tolerance(1e-5));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_first_of_equally_far_faces_is_taken)
{
  BOOST_TEST(farthest_face_from_center(sequential, surface_of(sphere(0))) == 0u);
}

BOOST_AUTO_TEST_CASE(references_are_mutually_farthest)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph = random_graph(random);
      const Index first = static_cast<Index>(random() % graph.number_of_faces());
      const std::size_t k = 1 + random() % 10;
      const Shape_contexts contexts = contexts_of(graph, first, k);
      BOOST_REQUIRE(contexts.references.size() == k);
      BOOST_REQUIRE(std::size_t(contexts.values.cols()) == k);
      BOOST_TEST(contexts.references[0] == first);
      std::vector<double> to_nearest(graph.number_of_faces(),
                                     std::numeric_limits<double>::infinity());
      for (std::size_t j = 0; j + 1 < k; ++j) {
        const std::vector<double> distance = geodesic_distances(graph, contexts.references[j]);
        for (std::size_t f = 0; f < distance.size(); ++f)
          to_nearest[f] = std::min(to_nearest[f], distance[f]);
        Index farthest = 0;
        for (Index f = 0; f < graph.number_of_faces(); ++f)
          if (to_nearest[f] > to_nearest[farthest])
            farthest = f;
        BOOST_TEST(contexts.references[j + 1] == farthest);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(contexts_are_sums_of_angles_along_the_shortest_geodesic_paths)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Surface graph = random_graph(random);
      randomize_distances(graph, random);
      const Shape_contexts contexts = contexts_of(graph, 0, 5);
      for (std::size_t j = 0; j < 5; ++j) {
        const Index reference = contexts.references[j];
        const std::vector<double> distance = geodesic_distances(graph, reference);
        for (Index f = 0; f < graph.number_of_faces(); ++f)
          BOOST_TEST(contexts.values(f, j) == context_by_walking(graph, f, reference, distance));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_first_reference_does_not_depend_on_the_size_of_the_part)
{
  Random random(3);
  Surface part = random_graph(random);
  const Index farthest = farthest_face_from_center(sequential, part);
  BOOST_TEST(farthest != 0u);
  for (Vector& p : part.points)
    p = p / 65536 + Vector(0.5, 0.25, -0.5);
  BOOST_TEST(farthest_face_from_center(sequential, part) == farthest);
}

BOOST_AUTO_TEST_CASE(there_are_no_more_references_than_faces)
{
  Random random(1);
  const Surface graph = random_graph(random);
  const std::size_t n = graph.number_of_faces();
  const Shape_contexts all = contexts_of(graph, 3, n + 100);
  BOOST_TEST(all.references.size() == n);
  BOOST_TEST(std::set<Index>(all.references.begin(), all.references.end()).size() == n);
}

BOOST_AUTO_TEST_CASE(the_caller_is_asked_before_each_search)
{
  const Surface graph = graph_with_distances(sphere(1));
  for (std::size_t k : {1, 4, 10}) {
    std::size_t calls = 0;
    shape_contexts(graph, 0, k, [&] { ++calls; });
    BOOST_TEST(calls == k);
  }
  const auto stop = [] { throw std::runtime_error("stop"); };
  BOOST_CHECK_THROW(shape_contexts(graph, 0, 3, stop), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(samples_have_the_largest_context_and_the_one_that_differs_most)
{
  for (unsigned seed = 1; seed <= 200; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::size_t k = 1 + random() % 10;
      const Index n = static_cast<Index>(2 + random() % 50);
      Shape_contexts contexts;
      contexts.references.resize(k);
      const unsigned number_of_values = 1 + random() % 20; // the fewer the more ties
      contexts.values = Eigen::MatrixXf::NullaryExpr(n, k, [&]
        { return static_cast<float>(random() % number_of_values); });

      const Sample_faces samples = sample_faces(sequential, contexts);
      BOOST_REQUIRE(samples.s < n);
      BOOST_REQUIRE(samples.t < n);
      BOOST_TEST(samples.s != samples.t);
      const std::vector<double> origin(k, 0.);
      std::vector<double> of_s;
      for (std::size_t j = 0; j < k; ++j)
        of_s.push_back(contexts.values(samples.s, j));
      const double norm_s = squared_distance(contexts, samples.s, origin);
      const double difference_t = squared_distance(contexts, samples.t, of_s);
      for (Index f = 0; f < n; ++f) {
        const double norm = squared_distance(contexts, f, origin);
        BOOST_TEST((f < samples.s ? norm < norm_s : norm <= norm_s));
        const double difference = squared_distance(contexts, f, of_s);
        if (f != samples.s)
          BOOST_TEST((f < samples.t ? difference < difference_t : difference <= difference_t));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_random_face_depends_on_seed_and_part_and_is_reproducible)
{
  const Surface graph = surface_of(sphere(3));
  std::set<Index> by_seed, by_part;
  for (Index i = 0; i < 100; ++i) {
    const Index f = random_face(graph, i, 0);
    BOOST_TEST(f < graph.number_of_faces());
    BOOST_TEST(random_face(graph, i, 0) == f);
    by_seed.insert(f);
    by_part.insert(random_face(graph, 0, i));
  }
  // About 4 of 100 random ones out of 1280 meet.
  BOOST_TEST(by_seed.size() > 80u);
  BOOST_TEST(by_part.size() > 80u);
  BOOST_TEST(random_face(graph, 1, 0) != random_face(graph, 1 + (std::uint64_t(1) << 32), 0));
}

BOOST_AUTO_TEST_SUITE_END()
