// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../stitch_borders.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(stitch_borders)

using mesh_file::Border_stitching;
using mesh_file::Index;
using mesh_file::Point;
using mesh_file::Triangle;

namespace {

std::vector<Triangle> stitched(const std::vector<Point>& points, std::vector<Triangle> triangles)
{
  Border_stitching(points, triangles)();
  return triangles;
}

std::size_t number_of_points(const std::vector<Triangle>& triangles)
{
  std::set<Index> result;
  for (const Triangle& t : triangles)
    result.insert(t.begin(), t.end());
  return result.size();
}

// Corner i of the unit cube has the digits of i as coordinates.
const std::vector<Triangle> cube{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

std::vector<Point> cube_points(double x, double y)
{
  std::vector<Point> result;
  for (int i = 0; i < 8; ++i)
    result.push_back({x + i % 2, y + i / 2 % 2, static_cast<double>(i / 4)});
  return result;
}

// Appends each triangle with points of its own, like STL.
void add_apart(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
               std::vector<Point>& apart_points, std::vector<Triangle>& apart)
{
  for (const Triangle& t : triangles) {
    const Index first = static_cast<Index>(apart_points.size());
    for (Index v : t)
      apart_points.push_back(points[v]);
    apart.push_back({first, first + 1, first + 2});
  }
}

// Two cubes, each connected in itself, the second of which has been moved.
void check_two_cubes_stay(double x, double y)
{
  std::vector<Point> points = cube_points(0, 0);
  std::vector<Triangle> triangles = cube;
  for (const Point& p : cube_points(x, y))
    points.push_back(p);
  for (const Triangle& t : cube)
    triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  BOOST_TEST((stitched(points, triangles) == triangles));
}

} // namespace

BOOST_AUTO_TEST_CASE(nothing)
{
  BOOST_TEST(stitched({}, {}).empty());
}

BOOST_AUTO_TEST_CASE(nothing_is_repeated)
{
  const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 3}};
  BOOST_TEST((stitched({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, triangles) == triangles));
}

BOOST_AUTO_TEST_CASE(two_triangles_along_an_edge)
{
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
  const std::vector<Triangle> expected{{0, 1, 2}, {3, 2, 1}};
  BOOST_TEST((stitched(points, {{0, 1, 2}, {3, 4, 5}}) == expected));
  const std::vector<Triangle> turned{{0, 1, 2}, {3, 1, 2}}; // the other way round
  BOOST_TEST((stitched(points, {{0, 1, 2}, {3, 5, 4}}) == turned));
}

// The ends of the edge are two points and one.
BOOST_AUTO_TEST_CASE(one_end_of_an_edge_is_joined_already)
{
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> expected{{0, 1, 2}, {3, 2, 1}};
  BOOST_TEST((stitched(points, {{0, 1, 2}, {3, 4, 1}}) == expected));
}

BOOST_AUTO_TEST_CASE(both_zeros_are_one_place)
{
  const std::vector<Point> points{{0., 0, 0}, {1, 0, 0}, {0., 1, 0},
                                  {1, 1, -0.}, {-0., 1, 0}, {1, -0., 0}};
  const std::vector<Triangle> expected{{0, 1, 2}, {3, 2, 1}};
  BOOST_TEST((stitched(points, {{0, 1, 2}, {3, 4, 5}}) == expected));
}

BOOST_AUTO_TEST_CASE(triangles_that_touch_at_a_point_stay)
{
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0},
                                  {-1, 0, 0}, {0, -1, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
  BOOST_TEST((stitched(points, triangles) == triangles));
}

BOOST_AUTO_TEST_CASE(triangles_apart_become_a_cube)
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  add_apart(cube_points(0, 0), cube, points, triangles);
  BOOST_TEST(number_of_points(triangles) == 36u);
  const std::vector<Triangle> result = stitched(points, triangles);
  BOOST_TEST(number_of_points(result) == 8u);
  for (std::size_t t = 0; t < cube.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      BOOST_TEST((points[result[t][i]] == cube_points(0, 0)[cube[t][i]]));
}

// A sheet whose points are repeated along a seam that ends inside, at point 4, which is not.
BOOST_AUTO_TEST_CASE(a_seam_that_ends)
{
  const std::vector<Point> points{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0},
                                  {1, 1, 0}, {0, 2, 0}, {0, 0, 0}};
  const std::vector<Triangle> sheet{{0, 1, 4}, {0, 4, 3}, {7, 2, 4}, {2, 5, 4},
                                    {3, 4, 6}, {4, 5, 6}};
  std::vector<Triangle> expected = sheet;
  expected[2] = {1, 2, 4};
  BOOST_TEST((stitched(points, sheet) == expected));
}

BOOST_AUTO_TEST_CASE(cubes_that_touch_stay_apart)
{
  check_two_cubes_stay(1, 1); // at an edge
  check_two_cubes_stay(1, 0); // at a face
  check_two_cubes_stay(0, 0); // everywhere
}

BOOST_AUTO_TEST_SUITE_END()
