// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(read_triangle_soup)

using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::read_triangle_soup;

namespace {

const double bad_coordinates[] = {std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};

} // namespace

BOOST_AUTO_TEST_CASE(points_and_corners_equal_the_soup)
{
  for (const Soup& soup : small_soups()) {
    const Surface triangles = read_triangle_soup(soup.points, soup.triangles);
    BOOST_TEST_REQUIRE(triangles.points.size() == soup.points.size());
    BOOST_TEST_REQUIRE(triangles.corners.size() == soup.triangles.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(triangles.points[v][i] == soup.points[v][i]);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        BOOST_TEST(triangles.corners[f][i] == soup.triangles[f][i]);
  }
}

// Whatever becomes of the run, they must not enter the extent of the mesh.
BOOST_AUTO_TEST_CASE(points_that_no_triangle_uses_may_be_anything)
{
  for (double bad : bad_coordinates) {
    Soup soup = plate(2, 2);
    soup.points.emplace_back(0, bad, 0);
    const Surface triangles = read_triangle_soup(soup.points, soup.triangles);
    BOOST_TEST_REQUIRE(triangles.points.size() == soup.points.size());
    BOOST_TEST(triangles.points.back().is_zero());
  }
}

BOOST_AUTO_TEST_CASE(arrays_of_numbers_are_points_and_triangles_too)
{
  const std::vector<std::array<float, 3> > points = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  const std::vector<std::array<unsigned char, 3> > corners = {{2, 0, 1}};
  const Surface triangles = read_triangle_soup(points, corners);
  BOOST_TEST(triangles.points[2].y() == 0.5);
  BOOST_TEST((triangles.corners.front() ==
              CGAL::Spectral_segmentation::internal::Corners{2, 0, 1}));
  BOOST_TEST(read_triangle_soup(std::vector<Point>(), std::vector<std::array<int, 3> >())
               .corners.empty());
}

BOOST_AUTO_TEST_SUITE_END()
