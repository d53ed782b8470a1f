// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/mesh/extract_part.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(parts)

using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::connected_components;
using CGAL::Spectral_segmentation::internal::split;

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
    std::size_t number = 0;
    const std::vector<Index> component = connected_components(dual_graph_of(soup), number);
    BOOST_TEST(number == pieces.size());
    std::vector<std::size_t> order; // of the pieces, by their first faces
    for (std::size_t f = 0; f < piece.size(); ++f) {
      auto found = std::find(order.begin(), order.end(), piece[f]);
      if (found == order.end())
        found = order.insert(found, piece[f]);
      BOOST_TEST(component[f] == static_cast<std::size_t>(found - order.begin()));
    }
  }
}

BOOST_AUTO_TEST_CASE(faces_that_share_only_a_vertex_are_not_connected)
{
  const Face_graph graph = dual_graph_of(plate(2, 2));
  // The squares at two opposite corners touch in the middle.
  std::vector<std::size_t> piece(8, 1);
  piece[0] = piece[1] = piece[6] = piece[7] = 0;
  std::size_t number = 0;
  connected_components(split(graph, piece, 2)[0], number);
  BOOST_TEST(number == 2u);
  BOOST_TEST(connected_components(Face_graph(), number).empty());
  BOOST_TEST(number == 0u);
}

BOOST_AUTO_TEST_CASE(pieces_keep_their_faces_and_the_edges_between_them)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Face_graph graph =
        graph_with_distances(displaced(small_soups()[seed % small_soups().size()], 0.1, random));
      const std::size_t n = graph.number_of_faces(), number_of_regions = 1 + random() % 4;
      std::vector<std::size_t> piece(n);
      for (std::size_t& p : piece)
        p = random() % number_of_regions;

      const std::vector<Face_graph> parts = split(graph, piece, number_of_regions);
      BOOST_REQUIRE(parts.size() == number_of_regions);
      for (std::size_t p = 0; p < number_of_regions; ++p) {
        const Face_graph& part = parts[p];
        std::vector<Index> faces;
        std::set<Index> used_vertices;
        for (Index f = 0; f < n; ++f)
          if (piece[f] == p) {
            faces.push_back(f);
            used_vertices.insert(graph.corners[f].begin(), graph.corners[f].end());
          }
        BOOST_TEST(part.unit == graph.unit);
        BOOST_TEST(part.points.size() == used_vertices.size());
        BOOST_REQUIRE(part.number_of_faces() == faces.size());
        BOOST_REQUIRE(part.halfedges.size() == 3 * faces.size());
        for (Index k = 0; k < faces.size(); ++k) {
          BOOST_TEST(part.areas[k] == graph.areas[faces[k]]);
          for (Index i = 0; i < 3; ++i) {
            const Index h = 3 * k + i, old = 3 * faces[k] + i;
            BOOST_TEST((part.points[part.corners[k][i]] ==
                        graph.points[graph.corners[faces[k]][i]]));
            const Index across = graph.halfedges[old].neighbor;
            BOOST_TEST(faces[part.halfedges[h].neighbor] ==
                       (piece[across] == p ? across : faces[k]));
            BOOST_TEST(part.halfedges[h].geodesic == graph.halfedges[old].geodesic);
            BOOST_TEST(part.halfedges[h].angle == graph.halfedges[old].angle);
            BOOST_TEST(part.halfedges[h].combined == graph.halfedges[old].combined);
            BOOST_TEST(part.halfedges[h].concavity == graph.halfedges[old].concavity);
            BOOST_TEST(part.halfedges[h].centroids == graph.halfedges[old].centroids);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(an_empty_graph_has_no_pieces)
{
  BOOST_TEST(split(Face_graph(), std::vector<Index>(), 0).empty());
}

BOOST_AUTO_TEST_SUITE_END()
