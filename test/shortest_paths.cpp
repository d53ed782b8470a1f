// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE shortest_paths
#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Weighting;
using CGAL::Spectral_segmentation::internal::shortest_paths;

namespace {

typedef Face_dual_graph::Halfedge Halfedge;

const Weighting weightings[] = {&Halfedge::geodesic, &Halfedge::angle, &Halfedge::combined};
const double infinity = std::numeric_limits<double>::infinity();

Face_dual_graph random_graph(Random& random)
{
  const std::vector<Soup> shapes = {plate(5, 4), sphere(0), sphere(1), torus(2, 0.7, 6, 5),
                                    dumbbell(5, 4)};
  const Face_dual_graph graph =
    graph_with_distances(displaced(shapes[random() % shapes.size()], 0.2, random));
  const std::size_t n = graph.number_of_faces();
  return random_part(graph, n / 2 + random() % (n / 2 + 1), random);
}

std::vector<std::vector<double> > floyd_warshall(const Face_dual_graph& graph, Weighting weighting)
{
  const std::size_t n = graph.number_of_faces();
  std::vector<std::vector<double> > d(n, std::vector<double>(n, infinity));
  for (Index h = 0; h < graph.halfedges.size(); ++h) {
    double& distance = d[h / 3][graph.halfedges[h].neighbor];
    distance = std::min(distance, double(graph.halfedges[h].*weighting));
  }
  for (std::size_t f = 0; f < n; ++f)
    d[f][f] = 0;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  return d;
}

} // namespace

// Distances lie on a grid, so that the two agree in every bit.
BOOST_AUTO_TEST_CASE(distances_equal_those_of_floyd_and_warshall)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Face_dual_graph graph = random_graph(random);
      for (Weighting weighting : weightings) {
        const std::vector<std::vector<double> > expected = floyd_warshall(graph, weighting);
        for (Index source = 0; source < graph.number_of_faces(); ++source)
          BOOST_TEST(shortest_paths(graph, source, weighting) == expected[source],
                     tt::per_element());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_way_is_relaxed_from_a_face_with_a_final_distance)
{
  for (unsigned seed = 1; seed <= 100; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Face_dual_graph graph = random_graph(random);
      const Weighting weighting = weightings[seed % 3];
      const Index source = static_cast<Index>(random() % graph.number_of_faces());
      std::vector<Index> relaxed;
      const std::vector<double> distance = shortest_paths(
        graph, source, weighting, [&](Index h) { relaxed.push_back(h); });

      std::vector<double> so_far(graph.number_of_faces(), infinity);
      so_far[source] = 0;
      double last = 0;
      for (Index h : relaxed) {
        BOOST_TEST(so_far[h / 3] == distance[h / 3]);
        BOOST_TEST(distance[h / 3] >= last); // from the nearest face to the farthest
        last = distance[h / 3];
        double& there = so_far[graph.halfedges[h].neighbor];
        const double length = distance[h / 3] + graph.halfedges[h].*weighting;
        BOOST_TEST(length < there);
        there = length;
      }
      BOOST_TEST(so_far == distance, tt::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_single_face_is_at_distance_0)
{
  Random random(1);
  const Face_dual_graph graph = random_part(dual_graph_of(sphere(0)), 1, random);
  BOOST_TEST(shortest_paths(graph, 0, &Halfedge::geodesic) == std::vector<double>({0}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(ways_of_length_0_are_ways)
{
  Face_dual_graph graph = dual_graph_of(plate(3, 3)); // its distances are 0
  BOOST_TEST(shortest_paths(graph, 4, &Halfedge::combined) ==
             std::vector<double>(graph.number_of_faces(), 0.), tt::per_element());
}
