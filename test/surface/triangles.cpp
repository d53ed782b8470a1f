// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(triangles)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Corners;
using CGAL::Spectral_segmentation::internal::Neighbors;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::normalize;
using CGAL::Spectral_segmentation::internal::start_at_smallest_vertex;

BOOST_AUTO_TEST_CASE(points_are_normalized_by_a_power_of_two)
{
  for (const Soup& soup : small_soups()) {
    const Face_graph graph = face_graph_of(soup);
    const double unit = unit_of(soup);
    int exponent;
    BOOST_TEST(std::frexp(unit, &exponent) == 0.5);
    double largest = 0;
    for (const auto& p : graph.points)
      largest = std::max(largest, std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}));
    BOOST_TEST(largest <= 1);
    BOOST_TEST(largest >= 0.5);
    for (std::size_t v = 1; v < soup.points.size(); ++v) {
      const auto original = soup.points[v] - soup.points[0];
      const auto normalized = unit * (graph.points[v] - graph.points[0]);
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(original[i] - normalized[i]) < 1e-14 * unit);
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      const std::vector<std::size_t>& t = soup.triangles[f];
      const double squared = CGAL::squared_area(soup.points[t[0]], soup.points[t[1]],
                                                soup.points[t[2]]);
      BOOST_TEST(graph.areas[f] * unit * unit == std::sqrt(squared),
                 tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_scaled_by_a_power_of_two_gives_the_same_arrays)
{
  const Soup soup = sphere(2);
  const Face_graph graph = face_graph_of(soup);
  for (int exponent : {-300, -40, -1, 1, 40, 300}) {
    Soup scaled = soup;
    for (Point& p : scaled.points)
      p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                std::ldexp(p.z(), exponent));
    const Face_graph other = face_graph_of(scaled);
    BOOST_TEST((other.points == graph.points));
    BOOST_TEST((other.areas == graph.areas));
    BOOST_TEST(unit_of(scaled) == std::ldexp(unit_of(soup), exponent));
  }
}

BOOST_AUTO_TEST_CASE(points_that_are_one_and_no_points_keep_their_unit)
{
  std::vector<Vector> points(4, Vector(7, 7, 7));
  BOOST_TEST(normalize(points) == 1);
  for (const Vector& p : points)
    BOOST_TEST(p.is_zero());
  std::vector<Vector> none;
  BOOST_TEST(normalize(none) == 1);
}

BOOST_AUTO_TEST_CASE(the_largest_coordinates_do_not_overflow)
{
  const double largest = std::numeric_limits<double>::max();
  std::vector<Vector> points = {Vector(-largest, 0, 0), Vector(largest, largest, 0)};
  const double unit = normalize(points);
  BOOST_TEST(std::isfinite(unit));
  BOOST_TEST((points[1] - points[0]).x() / 2 == largest / unit);
}

BOOST_AUTO_TEST_CASE(a_face_and_its_neighbors_turn_together)
{
  Corners corners = {7, 9, 4};
  Neighbors neighbors = {10, 20, 30};
  start_at_smallest_vertex(corners, neighbors);
  BOOST_TEST((corners == Corners{4, 7, 9}));
  BOOST_TEST((neighbors == Neighbors{30, 10, 20}));
}

BOOST_AUTO_TEST_SUITE_END()
