// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/door/read_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(read_triangles)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::total_area;

BOOST_AUTO_TEST_CASE(the_first_corner_is_the_smallest_vertex_whatever_the_mesh_starts_with)
{
  for (Soup soup : small_soups()) {
    const Face_graph graph = dual_graph_of(soup);
    for (Index f = 0; f < graph.number_of_faces(); ++f) {
      std::vector<std::size_t> corners = soup.triangles[f];
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      BOOST_TEST(graph.corners[f] == corners, tt::per_element());
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      std::rotate(soup.triangles[f].begin(),
                  soup.triangles[f].begin() + static_cast<std::ptrdiff_t>(f % 3),
                  soup.triangles[f].end());
    const Face_graph rotated = dual_graph_of(soup);
    BOOST_TEST((rotated.corners == graph.corners));
    BOOST_TEST((neighbors(rotated) == neighbors(graph)));
    BOOST_TEST((rotated.areas == graph.areas));
  }
}

BOOST_AUTO_TEST_CASE(points_are_normalized_by_a_power_of_two)
{
  for (const Soup& soup : small_soups()) {
    const Face_graph graph = dual_graph_of(soup);
    int exponent;
    BOOST_TEST(std::frexp(graph.unit, &exponent) == 0.5);
    double largest = 0;
    for (const auto& p : graph.points)
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    BOOST_TEST(largest <= 1);
    BOOST_TEST(largest >= 0.5);
    for (std::size_t v = 1; v < soup.points.size(); ++v) {
      const auto original = soup.points[v] - soup.points[0];
      const auto normalized = graph.unit * (graph.points[v] - graph.points[0]);
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(original[i] - normalized[i]) < 1e-14 * graph.unit);
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      const std::vector<std::size_t>& t = soup.triangles[f];
      const double squared = CGAL::squared_area(soup.points[t[0]], soup.points[t[1]],
                                                soup.points[t[2]]);
      BOOST_TEST(graph.areas[f] * graph.unit * graph.unit == std::sqrt(squared),
                 tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_scaled_by_a_power_of_two_gives_the_same_arrays)
{
  const Soup soup = sphere(2);
  const Face_graph graph = dual_graph_of(soup);
  for (int exponent : {-300, -40, -1, 1, 40, 300}) {
    Soup scaled = soup;
    for (Point& p : scaled.points)
      p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                std::ldexp(p.z(), exponent));
    const Face_graph other = dual_graph_of(scaled);
    BOOST_TEST((other.points == graph.points));
    BOOST_TEST((other.areas == graph.areas));
    BOOST_TEST(other.unit == std::ldexp(graph.unit, exponent));
  }
}

BOOST_AUTO_TEST_CASE(vertices_without_a_face_do_not_count)
{
  const Soup soup = sphere(1);
  const Face_graph graph = dual_graph_of(soup);
  for (double x : {1e6, std::numeric_limits<double>::quiet_NaN()}) {
    Mesh mesh = mesh_of(soup);
    mesh.add_vertex(Point(x, 0, 0));
    const Face_graph other = dual_graph_of(mesh);
    BOOST_TEST(other.unit == graph.unit);
    BOOST_TEST((other.areas == graph.areas));
    BOOST_TEST((other.corners == graph.corners));
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_that_is_one_point_and_an_empty_mesh_are_read)
{
  Soup soup = plate(1, 1);
  for (Point& p : soup.points)
    p = Point(7, 7, 7);
  const Face_graph point = dual_graph_of(soup);
  BOOST_TEST(point.unit == 1);
  BOOST_TEST(total_area(point) == 0);
  BOOST_TEST(dual_graph_of(Soup()).number_of_faces() == 0u);
}

BOOST_AUTO_TEST_CASE(what_is_not_a_finite_triangle_mesh_is_refused)
{
  for (double bad : {std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::quiet_NaN()}) {
    Soup soup = plate(2, 2);
    soup.points[3] = Point(1, bad, 0);
    BOOST_CHECK_THROW(dual_graph_of(soup), std::invalid_argument);
  }
  const Mesh quad = mesh_of({{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)},
                             {{0, 1, 2, 3}}});
  BOOST_CHECK_THROW(triangles_of(quad), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
