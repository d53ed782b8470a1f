// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(shortest_paths)

namespace tt = boost::test_tools;
namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Geodesic_paths;
using CGAL::Spectral_segmentation::internal::Weighting;
using CGAL::Spectral_segmentation::internal::geodesic_paths;

namespace {

const Weighting weightings[] = {&Edge_weights::geodesic, &Edge_weights::angle,
                                &Edge_weights::combined};
const double infinity = std::numeric_limits<double>::infinity();

Surface random_graph(Random& random)
{
  const std::vector<Soup> shapes = {plate(5, 4), sphere(0), sphere(1), torus(2, 0.7, 6, 5),
                                    dumbbell(5, 4)};
  const Surface graph =
    graph_with_distances(displaced(shapes[random() % shapes.size()], 0.2, random));
  const std::size_t n = graph.number_of_faces();
  return random_part(graph, n / 2 + random() % (n / 2 + 1), random);
}

template <class Weight>
void set_weights(Surface& graph, Weighting weighting, const Weight& weight)
{
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (!graph.is_border(h))
      graph.weights[h].*weighting = graph.weights[graph.opposite[h]].*weighting = weight();
}

// Weights from 0 to 512, most of them small, and many equal.
void make_uneven(Surface& graph, Weighting weighting, Random& random)
{
  set_weights(graph, weighting, [&]
    { return random() % 4 == 0 ? 0.f : std::ldexp(1.f, 9 - int(random() % 30)); });
}

std::vector<std::vector<double> > floyd_warshall(const Surface& graph, Weighting weighting)
{
  const std::size_t n = graph.number_of_faces();
  std::vector<std::vector<double> > d(n, std::vector<double>(n, infinity));
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    double& distance = d[h / 3][graph.neighbor(h)];
    distance = std::min(distance, double(graph.weights[h].*weighting));
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

// Distances lie on a grid, so that they agree in every bit.
BOOST_AUTO_TEST_CASE(distances_equal_distances_by_floyd_and_warshall)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Surface graph = random_graph(random);
      if (seed > 30)
        for (Weighting weighting : weightings)
          make_uneven(graph, weighting, random);
      for (Weighting weighting : weightings) {
        const std::vector<std::vector<double> > expected = floyd_warshall(graph, weighting);
        for (Index source = 0; source < graph.number_of_faces(); ++source)
          BOOST_TEST(internal::shortest_paths(graph, weighting, source) == expected[source],
                     tt::per_element());
      }
    }
  }
}

namespace {

// Relaxes all edges until nothing changes.
std::vector<double> bellman_ford(const Surface& graph, Weighting weighting,
                                 std::vector<double> distance)
{
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      const double length = distance[h / 3] + graph.weights[h].*weighting;
      if (length < distance[graph.neighbor(h)]) {
        distance[graph.neighbor(h)] = length;
        has_changed = true;
      }
    }
  }
  return distance;
}

std::vector<double> distances_at_start(const Surface& graph, Index source)
{
  std::vector<double> distance(graph.number_of_faces(), infinity);
  distance[source] = 0;
  return distance;
}

// Sums the angles over the nearest, then the first neighbor on a shortest path.
std::vector<float> angles_by_definition(const Surface& graph,
                                        const std::vector<double>& distance)
{
  std::vector<Index> faces(distance.size());
  std::iota(faces.begin(), faces.end(), 0);
  std::stable_sort(faces.begin(), faces.end(),
                   [&](Index f, Index g) { return distance[f] < distance[g]; });
  std::vector<float> angles(distance.size(), 0);
  for (Index f : faces) {
    std::pair<double, Index> nearest(infinity, 0);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = graph.neighbor(h);
      const std::pair<double, Index> candidate(distance[g], g);
      if (g != f && distance[g] + graph.weights[h].geodesic == distance[f] &&
          candidate < nearest) {
        nearest = candidate;
        angles[f] = angles[g] + graph.weights[h].angle;
      }
    }
  }
  return angles;
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_on_real_meshes_equal_distances_by_bellman_and_ford)
{
  for (const char* name : {"elephant.off", "hand.off", "dino.off", "mushroom.off"})
    BOOST_TEST_CONTEXT(name) {
      Surface graph = surface_of(read(name));
      for (double concavity_radius : {0., 0.01}) {
        set_face_distances(graph, {0.03, 1, 0.1, concavity_radius});
        const Index source = static_cast<Index>(graph.number_of_faces() / 2);
        for (Weighting weighting : weightings)
          BOOST_TEST((internal::shortest_paths(graph, weighting, source) ==
                      bellman_ford(graph, weighting, distances_at_start(graph, source))));
        const Geodesic_paths paths = geodesic_paths(graph, source);
        BOOST_TEST((paths.angles == angles_by_definition(graph, paths.lengths)));
      }
    }
}

BOOST_AUTO_TEST_CASE(the_nearest_of_several_sources_counts)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Surface graph = random_graph(random);
      const Weighting weighting = weightings[seed % 3];
      if (seed % 2 == 0)
        make_uneven(graph, weighting, random);
      std::vector<double> distance(graph.number_of_faces(), infinity);
      std::vector<Index> sources;
      for (int i = 0; i < 4; ++i) {
        const Index source = static_cast<Index>(random() % distance.size());
        if (distance[source] == infinity)
          sources.push_back(source);
        distance[source] = std::ldexp(double(random() % 8), -2); // where its paths begin
      }
      const std::vector<double> expected = bellman_ford(graph, weighting, distance);
      internal::run_dijkstra(graph, sources,
                             [&](Index h) -> double { return graph.weights[h].*weighting; },
                             distance, boost::dijkstra_visitor<>());
      BOOST_TEST(distance == expected, tt::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(angles_are_summed_along_the_paths_over_the_nearest_neighbors)
{
  for (unsigned seed = 1; seed <= 100; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Surface graph = random_graph(random);
      // Few values, so that many paths are as short.
      set_weights(graph, &Edge_weights::geodesic, [&] { return 1 + float(random() % 3); });
      const Index source = static_cast<Index>(random() % graph.number_of_faces());
      const Geodesic_paths paths = geodesic_paths(graph, source);
      BOOST_TEST(paths.lengths == floyd_warshall(graph, &Edge_weights::geodesic)[source],
                 tt::per_element());
      BOOST_TEST(paths.angles == angles_by_definition(graph, paths.lengths), tt::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_single_face_is_at_distance_0)
{
  Random random(1);
  const Surface graph = random_part(graph_with_distances(sphere(0)), 1, random);
  const std::vector<double> distance = internal::shortest_paths(graph, &Edge_weights::geodesic, 0);
  BOOST_TEST(distance == std::vector<double>({0}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(ways_of_length_0_are_ways)
{
  Surface graph = surface_of(plate(3, 3));
  graph.weights.resize(graph.number_of_halfedges());
  BOOST_TEST(internal::shortest_paths(graph, &Edge_weights::combined, 4) ==
             std::vector<double>(graph.number_of_faces(), 0.), tt::per_element());
  BOOST_TEST(geodesic_paths(graph, 4).lengths == std::vector<double>(graph.number_of_faces(), 0.),
             tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
