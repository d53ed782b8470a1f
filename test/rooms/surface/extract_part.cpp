// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(extract_part)

using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Part_extractor;
using CGAL::Spectral_segmentation::internal::split;

BOOST_AUTO_TEST_CASE(parts_keep_their_faces_and_the_edges_between_them)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph =
        graph_with_distances(displaced(small_soups()[seed % small_soups().size()], 0.1, random));
      const std::size_t n = graph.number_of_faces(), number_of_parts = 1 + random() % 4;
      std::vector<std::size_t> part_of(n);
      for (std::size_t& p : part_of)
        p = random() % number_of_parts;

      const std::vector<Surface> parts = split(graph, part_of, number_of_parts);
      BOOST_REQUIRE(parts.size() == number_of_parts);
      for (std::size_t p = 0; p < number_of_parts; ++p) {
        const Surface& part = parts[p];
        std::vector<Index> faces;
        std::set<Index> used_vertices;
        for (Index f = 0; f < n; ++f)
          if (part_of[f] == p) {
            faces.push_back(f);
            used_vertices.insert(graph.corners[f].begin(), graph.corners[f].end());
          }
        BOOST_TEST(part.points.size() == used_vertices.size());
        BOOST_REQUIRE(part.number_of_faces() == faces.size());
        BOOST_REQUIRE(part.opposite.size() == 3 * faces.size());
        for (Index k = 0; k < faces.size(); ++k) {
          BOOST_TEST(part.areas[k] == graph.areas[faces[k]]);
          for (Index i = 0; i < 3; ++i) {
            const Index h = 3 * k + i, old = 3 * faces[k] + i;
            BOOST_TEST((part.points[part.corners[k][i]] ==
                        graph.points[graph.corners[faces[k]][i]]));
            const Index across = graph.neighbor(old);
            BOOST_TEST(faces[part.neighbor(h)] ==
                       (part_of[across] == p ? across : faces[k]));
            BOOST_TEST(part.weights[h].geodesic == graph.weights[old].geodesic);
            BOOST_TEST(part.weights[h].angle == graph.weights[old].angle);
            BOOST_TEST(part.weights[h].combined == graph.weights[old].combined);
            BOOST_TEST(part.weights[h].concavity == graph.weights[old].concavity);
            BOOST_TEST(part.weights[h].centroids == graph.weights[old].centroids);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(an_empty_graph_has_no_parts)
{
  BOOST_TEST(split(Surface(), std::vector<Index>(), 0).empty());
}

BOOST_AUTO_TEST_CASE(parts_of_a_graph_without_weights_have_none)
{
  const Surface graph = surface_of(plate(3, 2));
  for (const Surface& part :
       split(graph, std::vector<int>({0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1}), 2)) {
    BOOST_TEST(part.number_of_faces() == 6u);
    BOOST_TEST(part.weights.empty());
  }
}

BOOST_AUTO_TEST_CASE(faces_have_the_order_in_which_they_are_given)
{
  Random random(2);
  const Surface graph = graph_with_distances(displaced(torus(2, 0.7, 6, 5), 0.1, random));
  Part_extractor extract(graph);
  for (int run = 0; run < 5; ++run) { // an extractor serves for several parts
    std::vector<Index> faces(graph.number_of_faces());
    for (Index f = 0; f < faces.size(); ++f)
      faces[f] = f;
    std::shuffle(faces.begin(), faces.end(), random);
    faces.resize(25);
    const Surface part = extract(faces);
    BOOST_TEST_REQUIRE(part.number_of_faces() == faces.size());
    for (Index i = 0; i < faces.size(); ++i)
      for (Index j = 0; j < 3; ++j) {
        const Index h = 3 * i + j, old = 3 * faces[i] + j;
        BOOST_TEST((part.points[part.source_vertex(h)] == graph.points[graph.source_vertex(old)]));
        BOOST_TEST(part.weights[h].combined == graph.weights[old].combined);
        const auto across = std::find(faces.begin(), faces.end(), graph.neighbor(old));
        BOOST_TEST(part.neighbor(h) ==
                   (across == faces.end() ? i : static_cast<Index>(across - faces.begin())));
      }
  }
}

BOOST_AUTO_TEST_SUITE_END()
