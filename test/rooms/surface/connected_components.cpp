// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(connected_components)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
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

BOOST_AUTO_TEST_SUITE_END()
