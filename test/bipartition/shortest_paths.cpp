// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"
#include "../benchmark/dijkstra_search.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/shortest_paths.h>
#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>

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
using CGAL::Spectral_segmentation::internal::Path_angles;
using CGAL::Spectral_segmentation::internal::Path_lengths;
using CGAL::Spectral_segmentation::internal::Weighted_graph;
using CGAL::Spectral_segmentation::internal::Weighting;
using CGAL::Spectral_segmentation::internal::grow_paths;
using segmentation_benchmark::grow_paths_by_dijkstra;
using segmentation_benchmark::shortest_paths_by_dijkstra;

namespace {

const Weighting weightings[] = {&Edge_weights::geodesic, &Edge_weights::angle,
                                &Edge_weights::combined};
const double infinity = std::numeric_limits<double>::infinity();

Face_graph random_graph(Random& random)
{
  const std::vector<Soup> shapes = {plate(5, 4), sphere(0), sphere(1), torus(2, 0.7, 6, 5),
                                    dumbbell(5, 4)};
  const Face_graph graph =
    graph_with_distances(displaced(shapes[random() % shapes.size()], 0.2, random));
  const std::size_t n = graph.number_of_faces();
  return random_part(graph, n / 2 + random() % (n / 2 + 1), random);
}

template <class Weight>
void set_weights(Face_graph& graph, Weighting weighting, const Weight& weight)
{
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (!graph.is_border(h))
      graph.weights[h].*weighting = graph.weights[graph.opposite(h)].*weighting = weight();
}

// Weights from 0 to 512, most of them small, and many equal.
void make_uneven(Face_graph& graph, Weighting weighting, Random& random)
{
  set_weights(graph, weighting, [&]
    { return random() % 4 == 0 ? 0.f : std::ldexp(1.f, 9 - int(random() % 30)); });
}

std::vector<std::vector<double> > floyd_warshall(const Face_graph& graph, Weighting weighting)
{
  const std::size_t n = graph.number_of_faces();
  std::vector<std::vector<double> > d(n, std::vector<double>(n, infinity));
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    double& distance = d[h / 3][graph.neighbors[h]];
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
BOOST_AUTO_TEST_CASE(distances_equal_those_of_floyd_and_warshall)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Face_graph graph = random_graph(random);
      if (seed > 30)
        for (Weighting weighting : weightings)
          make_uneven(graph, weighting, random);
      for (Weighting weighting : weightings) {
        const std::vector<std::vector<double> > expected = floyd_warshall(graph, weighting);
        for (Index source = 0; source < graph.number_of_faces(); ++source) {
          BOOST_TEST(internal::shortest_paths({graph, weighting}, source) == expected[source],
                     tt::per_element());
          BOOST_TEST(shortest_paths_by_dijkstra({graph, weighting}, source) == expected[source],
                     tt::per_element());
        }
      }
    }
  }
}

namespace {

// In every bit, for all that a run asks of a search: distances by any weighting, and the angles
// along the shortest geodesic paths.
void check_that_both_searches_agree(const Face_graph& graph, Index source)
{
  const std::size_t n = graph.number_of_faces();
  for (Weighting weighting : weightings)
    BOOST_TEST((internal::shortest_paths({graph, weighting}, source) ==
                shortest_paths_by_dijkstra({graph, weighting}, source)));
  const Weighted_graph weighted(graph, &Edge_weights::geodesic);
  Path_angles by_buckets(n), by_dijkstra(n);
  grow_paths(weighted, source, by_buckets);
  grow_paths_by_dijkstra(weighted, source, by_dijkstra);
  Index number_of_differences = 0;
  for (Index f = 0; f < n; ++f)
    number_of_differences += by_buckets.length(f) != by_dijkstra.length(f) ||
                             by_buckets.angles(f) != by_dijkstra.angles(f);
  BOOST_TEST(number_of_differences == 0u);
}

} // namespace

BOOST_AUTO_TEST_CASE(both_searches_agree_on_real_meshes_and_their_parts)
{
  Random random(1);
  for (const char* name : {"elephant.off", "hand.off", "dino.off", "camel.off", "mushroom.off"})
    BOOST_TEST_CONTEXT(name) {
      Face_graph graph = face_graph_of(read(name));
      for (double concavity_radius : {0., 0.01}) {
        set_face_distances(graph, {0.03, 1, 0.1, concavity_radius});
        for (Index source : {Index(0), Index(graph.number_of_faces() / 2)})
          check_that_both_searches_agree(graph, source);
      }
      for (int i = 0; i < 3; ++i)
        check_that_both_searches_agree(
          random_part(graph, 100 + random() % (graph.number_of_faces() / 2), random), 0);
    }
}

BOOST_AUTO_TEST_CASE(both_searches_agree_on_a_coarse_mesh)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  Face_graph graph = internal::coarsen(sequential, face_graph_of(read("elephant.off")), 800, false,
                                       monitor, 0).graph;
  set_face_distances(graph, weights_of_calibrated_method);
  for (Index source = 0; source < graph.number_of_faces(); source += 100)
    check_that_both_searches_agree(graph, source);
}

BOOST_AUTO_TEST_CASE(of_several_sources_the_nearest_counts)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Face_graph graph = random_graph(random);
      const Weighting weighting = weightings[seed % 3];
      if (seed % 2 == 0)
        make_uneven(graph, weighting, random);
      const std::size_t n = graph.number_of_faces();
      std::vector<double> expected(n, infinity);
      Path_lengths by_buckets(n), by_dijkstra(n);
      for (int i = 0; i < 4; ++i) {
        const Index source = static_cast<Index>(random() % n);
        grow_paths(Weighted_graph(graph, weighting), source, by_buckets);
        grow_paths_by_dijkstra(Weighted_graph(graph, weighting), source, by_dijkstra);
        const std::vector<double> distance = floyd_warshall(graph, weighting)[source];
        for (Index f = 0; f < n; ++f)
          expected[f] = std::min(expected[f], distance[f]);
        BOOST_TEST(by_buckets.lengths == expected, tt::per_element());
        BOOST_TEST(by_dijkstra.lengths == expected, tt::per_element());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(angles_are_summed_along_the_paths_over_the_nearest_neighbors)
{
  for (unsigned seed = 1; seed <= 100; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Face_graph graph = random_graph(random);
      const Weighting weighting = weightings[seed % 3];
      // Few values, so that many paths are as short.
      set_weights(graph, weighting, [&] { return 1 + float(random() % 3); });
      const std::size_t n = graph.number_of_faces();
      const Index source = static_cast<Index>(random() % n);
      const std::vector<double> distance = floyd_warshall(graph, weighting)[source];

      std::vector<Index> faces(n);
      std::iota(faces.begin(), faces.end(), 0);
      std::stable_sort(faces.begin(), faces.end(),
                       [&](Index f, Index g) { return distance[f] < distance[g]; });
      std::vector<float> expected(n, 0);
      for (Index f : faces) {
        std::pair<double, Index> nearest(infinity, 0);
        for (Index h = 3 * f; h < 3 * f + 3; ++h) {
          const Index g = graph.neighbors[h];
          const std::pair<double, Index> candidate(distance[g], g);
          if (distance[g] + graph.weights[h].*weighting == distance[f] && candidate < nearest) {
            nearest = candidate;
            expected[f] = expected[g] + graph.weights[h].angle;
          }
        }
      }

      Path_angles by_buckets(n), by_dijkstra(n);
      grow_paths(Weighted_graph(graph, weighting), source, by_buckets);
      grow_paths_by_dijkstra(Weighted_graph(graph, weighting), source, by_dijkstra);
      for (Index f = 0; f < n; ++f) {
        BOOST_TEST(by_buckets.length(f) == distance[f]);
        BOOST_TEST(by_buckets.angles(f) == expected[f]);
        BOOST_TEST(by_dijkstra.angles(f) == expected[f]);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_single_face_is_at_distance_0)
{
  Random random(1);
  const Face_graph graph = random_part(graph_with_distances(sphere(0)), 1, random);
  const std::vector<double> distance = internal::shortest_paths({graph, &Edge_weights::geodesic}, 0);
  BOOST_TEST(distance == std::vector<double>({0}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(ways_of_length_0_are_ways)
{
  Face_graph graph = face_graph_of(plate(3, 3));
  graph.weights.resize(graph.number_of_halfedges());
  BOOST_TEST(internal::shortest_paths({graph, &Edge_weights::combined}, 4) ==
             std::vector<double>(graph.number_of_faces(), 0.), tt::per_element());
  Path_angles paths(graph.number_of_faces());
  grow_paths(Weighted_graph(graph, &Edge_weights::combined), 4, paths);
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    BOOST_TEST(paths.length(f) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
