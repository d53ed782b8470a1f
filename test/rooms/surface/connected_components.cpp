// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(connected_components)

namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using internal::Part_extractor;
using internal::split;

BOOST_AUTO_TEST_CASE(components_are_numbered_by_their_first_faces)
{
  const std::vector<Soup> pieces = {plate(2, 2), sphere(0), torus(2, 0.5, 4, 3), pillow()};
  Soup soup;
  std::vector<std::size_t> piece;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    soup = disjoint_union(soup, pieces[i]);
    piece.resize(soup.triangles.size(), i);
  }
  Random random(1);
  for (int run = 0; run < 20; ++run) {
    for (std::size_t f = piece.size() - 1; f > 0; --f) {
      const std::size_t other = random() % (f + 1);
      std::swap(piece[f], piece[other]);
      std::swap(soup.triangles[f], soup.triangles[other]);
    }
    const internal::Components component = internal::connected_components(surface_of(soup));
    BOOST_TEST(component.number == pieces.size());
    std::vector<std::size_t> order; // the pieces by their first faces
    for (std::size_t f = 0; f < piece.size(); ++f) {
      auto found = std::find(order.begin(), order.end(), piece[f]);
      if (found == order.end())
        found = order.insert(found, piece[f]);
      BOOST_TEST(component[f] == static_cast<std::size_t>(found - order.begin()));
    }
  }
}

BOOST_AUTO_TEST_CASE(faces_with_only_a_common_vertex_are_not_connected)
{
  const Surface graph = surface_of(plate(2, 2));
  // The squares at two opposite corners touch in the middle.
  std::vector<std::size_t> piece(8, 1);
  piece[0] = piece[1] = piece[6] = piece[7] = 0;
  BOOST_TEST(internal::connected_components(split(graph, piece, 2)[0]).number == 2u);
  BOOST_TEST(internal::connected_components(Surface()).number == 0u);
}

BOOST_AUTO_TEST_CASE(the_caller_may_part_neighbors)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph = surface_of(small_soups()[seed % small_soups().size()]);
      const Index n = Index(graph.number_of_faces());
      std::vector<char> color(n);
      for (char& c : color)
        c = random() % 3;
      // The least face that is reached from each over faces of its color, by relaxation.
      std::vector<Index> least(n);
      for (Index f = 0; f < n; ++f)
        least[f] = f;
      for (bool has_changed = true; has_changed;) {
        has_changed = false;
        for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
          const Index f = h / 3, g = graph.neighbor(h);
          if (color[f] == color[g] && least[g] < least[f]) {
            least[f] = least[g];
            has_changed = true;
          }
        }
      }
      const internal::Components component = internal::connected_components(graph, color);
      std::size_t expected_number = 0;
      for (Index f = 0; f < n; ++f) {
        BOOST_TEST(component[f] == component[least[f]]);
        if (least[f] == f)
          BOOST_TEST(component[f] == expected_number++);
      }
      BOOST_TEST(component.number == expected_number);

      const std::vector<double> areas = internal::component_areas(graph, component);
      std::vector<double> expected(component.number, 0);
      for (Index f = 0; f < n; ++f)
        expected[component[f]] += graph.areas[f];
      BOOST_TEST(areas == expected, boost::test_tools::per_element());
    }
  }
}

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
