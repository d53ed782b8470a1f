// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Longest_edge_bisection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(longest_edge_bisection)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Longest_edge_bisection;
using CGAL::Spectral_segmentation::internal::Level;
using CGAL::Spectral_segmentation::internal::bound_of_edges;
using CGAL::Spectral_segmentation::internal::edge_length;

namespace {

Level refined(const Surface& graph, double length)
{ return Longest_edge_bisection(graph, length)(sequential); }

double longest_edge(const Surface& graph)
{
  double result = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    result = (std::max)(result, graph.length(h));
  return result;
}

double length_of_border(const Surface& graph)
{
  double result = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (graph.is_border(h))
      result += graph.length(h);
  return result;
}

// Returns the characteristic of a graph whose edges all match.
long euler_characteristic(const Surface& graph)
{
  long twice_edges = 0;
  std::set<Index> vertices;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    vertices.insert(graph.source_vertex(h));
    twice_edges += graph.is_border(h) ? 2 : 1;
  }
  return static_cast<long>(vertices.size()) - twice_edges / 2 +
         static_cast<long>(graph.number_of_faces());
}

} // namespace

BOOST_AUTO_TEST_CASE(the_surface_stays_and_no_edge_is_longer_than_the_bound)
{
  for (const Soup& soup : small_soups())
    for (double fraction : {0.07, 0.3, 0.9}) {
      const Surface graph = surface_of(soup);
      const double length = fraction * longest_edge(graph);
      const Level result = refined(graph, length);
      BOOST_TEST(longest_edge(result.surface) <= length * (1 + 1e-6));
      BOOST_TEST(euler_characteristic(result.surface) == euler_characteristic(graph));
      BOOST_TEST(length_of_border(result.surface) == length_of_border(graph), tt::tolerance(1e-12));
      BOOST_REQUIRE(result.parent_face.size() == result.surface.number_of_faces());
      BOOST_TEST(std::is_sorted(result.parent_face.begin(), result.parent_face.end()));
      std::vector<double> areas(graph.number_of_faces(), 0);
      for (Index f = 0; f < result.parent_face.size(); ++f)
        areas[result.parent_face[f]] += result.surface.areas[f];
      BOOST_TEST(areas == graph.areas, tt::tolerance(1e-9) << tt::per_element());
    }
}

BOOST_AUTO_TEST_CASE(faces_on_both_sides_of_an_edge_cut_it_alike)
{
  for (const Soup& soup : small_soups()) {
    const Surface graph = surface_of(soup);
    const Surface result = refined(graph, 0.2 * longest_edge(graph)).surface;
    for (Index h = 0; h < result.number_of_halfedges(); ++h)
      if (!result.is_border(h))
        BOOST_TEST(result.opposite[result.opposite[h]] == h);
  }
}

BOOST_AUTO_TEST_CASE(a_right_triangle_is_halved_at_its_hypotenuse)
{
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(4, 0, 0), Point(0, 3, 0)};
  soup.triangles = {{0, 1, 2}};
  const Surface graph = surface_of(soup);
  const Level result = refined(graph, 0.9 * longest_edge(graph));
  BOOST_TEST(result.parent_face == std::vector<Index>({0, 0}), tt::per_element());
  BOOST_REQUIRE(result.surface.points.size() == 4u);
  const double distance =
    (result.surface.points[3] - (graph.points[1] + graph.points[2]) / 2).norm();
  BOOST_TEST(distance == 0);
}

BOOST_AUTO_TEST_CASE(a_mesh_without_long_edges_stays_as_it_is)
{
  const Surface graph = surface_of(sphere(2));
  const double number_of_faces = static_cast<double>(graph.number_of_faces());
  BOOST_TEST(!bound_of_edges(sequential, graph, number_of_faces / 2, 16 * number_of_faces));
  const Level result = refined(graph, longest_edge(graph) * (1 + 1e-6));
  BOOST_TEST((result.surface.corners == graph.corners));
  BOOST_TEST(result.surface.opposite == graph.opposite, tt::per_element());
}

BOOST_AUTO_TEST_CASE(an_even_mesh_has_edges_of_the_length_of_its_number_of_faces)
{
  // Equilateral triangles: 20 of an icosahedron
  const Surface graph = surface_of(sphere(0));
  BOOST_TEST(edge_length(20 * graph.areas[0], 20) == graph.length(0), tt::tolerance(1e-9));
}

// Halves of longest edges differ in length, so there are up to four times the faces of an even
// mesh.
BOOST_AUTO_TEST_CASE(the_bound_gives_about_the_number_of_faces)
{
  for (const Soup& soup : {sphere(0), sphere(1), torus(3, 1, 8, 5), plate(2, 1)})
    for (double number_of_faces : {500., 4000.}) {
      const Surface graph = surface_of(soup);
      const auto bound = bound_of_edges(sequential, graph, number_of_faces, 16 * number_of_faces);
      BOOST_REQUIRE(bound.has_value());
      const double result = static_cast<double>(refined(graph, *bound).parent_face.size());
      BOOST_TEST(result >= number_of_faces);
      BOOST_TEST(result <= 4 * number_of_faces);
    }
}

BOOST_AUTO_TEST_CASE(a_long_needle_raises_the_bound)
{
  for (double length : {1e3, 1e6, 1e9}) {
    const Surface graph =
      surface_of({{Point(0, 0, 0), Point(1, 0, 0), Point(1, length, 0)}, {{0, 1, 2}}});
    const auto bound = bound_of_edges(sequential, graph, 4000, 16 * 4000);
    BOOST_REQUIRE(bound.has_value());
    BOOST_TEST(refined(graph, *bound).parent_face.size() <= 4u * 16 * 4000);
  }
}

BOOST_AUTO_TEST_CASE(many_needles_raise_the_bound)
{
  Soup soup; // 1000 needles side by side, each of which would become hundreds of faces
  for (int i = 0; i <= 1000; ++i)
    for (int side : {0, 1})
      soup.points.push_back(Point(0.001 * i, side, 0));
  for (std::size_t i = 0; i < 2000; i += 2) {
    soup.triangles.push_back({i, i + 2, i + 1});
    soup.triangles.push_back({i + 1, i + 2, i + 3});
  }
  const Surface graph = surface_of(soup);
  const auto bound = bound_of_edges(sequential, graph, 4000, 16 * 4000);
  BOOST_REQUIRE(bound.has_value());
  BOOST_TEST(*bound > edge_length(1, 4000));
  BOOST_TEST(refined(graph, *bound).parent_face.size() <= 4u * 16 * 4000);
}

BOOST_AUTO_TEST_SUITE_END()
