// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../limited_hull.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(limited_hull)

using mesh_file::Convex_hull;
using mesh_file::Point;
using mesh_file::Triangle;

namespace {

const double pi = std::acos(-1.);

// Returns points of a prism, whose sides touch a circle with the radius 1 if it has many corners.
std::vector<Point> prism(int corners, double height)
{
  std::vector<Point> result;
  for (int i = 0; i < corners; ++i)
    for (double z : {0., height})
      result.push_back({std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners), z});
  return result;
}

// Returns points of a ball with the radius 1, on a spiral.
std::vector<Point> ball(int n)
{
  std::vector<Point> result;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), angle = 2.399963 * i;
    result.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return result;
}

// Returns random points of a cube, which are moved by a linear map.
std::vector<Point> random_points(int n, std::size_t seed, const Point& size)
{
  std::minstd_rand random(static_cast<unsigned>(seed + 1));
  const auto number = [&] { return double(random()) / double(random.max()); };
  std::vector<Point> result;
  for (int i = 0; i < n; ++i) {
    const double x = size[0] * number(), y = size[1] * number(), z = size[2] * number();
    result.push_back({0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z + 0.1 * x});
  }
  return result;
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Checks that each edge has a triangle on both sides, and each point is below each triangle.
void check_is_around(const Convex_hull& hull, const std::vector<Point>& points)
{
  std::vector<std::array<mesh_file::Index, 2> > edges, opposite;
  for (const Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({t[k], t[(k + 1) % 3]});
      opposite.push_back({t[(k + 1) % 3], t[k]});
    }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  BOOST_TEST((edges == opposite));
  BOOST_TEST((std::adjacent_find(edges.begin(), edges.end()) == edges.end()));
  const double size = mesh_file::extent_of(points);
  for (const Triangle& t : hull.triangles) {
    const Point &a = hull.points[t[0]], &b = hull.points[t[1]], &c = hull.points[t[2]];
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(dot(normal, normal));
    // The rounding errors of the corners turn the normal of a triangle with a small area.
    const double tolerance = (1e-9 + 4e-16 * size * size / length) * size;
    for (const Point& p : points)
      BOOST_REQUIRE_LT((dot(normal, p) - dot(normal, a)) / length, tolerance);
  }
}

// Returns the volume of a checked hull of the points with a limit, divided by that without it.
double checked_ratio(const std::vector<Point>& points, std::size_t limit)
{
  const Convex_hull hull = mesh_file::convex_hull(points, mesh_file::extent_of(points));
  const Convex_hull limited = mesh_file::limited_hull(hull, limit);
  BOOST_TEST(limited.points.size() <= limit);
  BOOST_TEST(limited.thickness == hull.thickness);
  check_is_around(limited, hull.points);
  if (hull.thickness == 0)
    check_is_around(limited, points);
  return mesh_file::volume(limited) / mesh_file::volume(hull);
}

} // namespace

BOOST_AUTO_TEST_CASE(few_points_stay)
{
  for (const Point& size : {Point{1, 1, 1}, Point{1, 20, 0.01}}) {
    const std::vector<Point> box{{0, 0, 0}, {size[0], 0, 0}, {0, size[1], 0}, {0, 0, size[2]},
                                 {size[0], size[1], 0}, {size[0], 0, size[2]},
                                 {0, size[1], size[2]}, size};
    const Convex_hull hull = mesh_file::convex_hull(box, 1);
    for (std::size_t limit : {8, 9, 64}) {
      const Convex_hull limited = mesh_file::limited_hull(hull, limit);
      BOOST_TEST((limited.points == hull.points && limited.triangles == hull.triangles));
      BOOST_TEST(mesh_file::volume(limited) == size[0] * size[1] * size[2],
                 boost::test_tools::tolerance(1e-15));
    }
    // The smallest tetrahedron around a box has 9 / 2 of its volume.
    for (std::size_t limit : {4, 5, 6, 7})
      BOOST_TEST(checked_ratio(box, limit) <= 4.5 + 1e-9);
  }
}

// A polyhedron with n vertices has at most 2 n - 4 triangles. If they are regular and touch a ball,
// its volume is about that of the ball times 1 + 3.63 / (2 n - 4), if n is large.
BOOST_AUTO_TEST_CASE(balls)
{
  for (int n : {162, 642, 2562}) {
    const std::vector<Point> points = ball(n);
    BOOST_TEST(checked_ratio(points, 64) < 1.1);
    BOOST_TEST(checked_ratio(points, 32) < 1.22);
    BOOST_TEST(checked_ratio(points, 12) < 1.8);
    BOOST_TEST(checked_ratio(points, 4) < 6.5); // 3.31 is least, for a regular one
    if (n > 255)
      BOOST_TEST(checked_ratio(points, 255) < 1.02);
  }
  BOOST_TEST(checked_ratio(ball(2562), 64) > 1.02);
}

// The area of a regular polygon with k corners around a circle is k tan(pi / k).
BOOST_AUTO_TEST_CASE(cylinders)
{
  for (double height : {0.05, 1., 20.}) {
    const std::vector<Point> points = prism(256, height);
    for (std::size_t k : {6, 16, 32, 100}) {
      const double least = double(k) * std::tan(pi / double(k)) / pi;
      const double ratio = checked_ratio(points, 2 * k);
      BOOST_TEST(ratio < 1 + 3 * (least - 1));
    }
  }
  std::vector<Point> cone = prism(400, 1);
  for (Point& p : cone)
    if (p[2] == 1)
      p = {0, 0, 1};
  BOOST_TEST(checked_ratio(cone, 33) < 1.02);
}

BOOST_AUTO_TEST_CASE(flat_parts)
{
  const std::vector<Point> disc = prism(100, 0);
  for (std::size_t limit : {4, 8, 64, 255})
    checked_ratio(disc, limit);
  BOOST_TEST(checked_ratio(disc, 64) < 1.02);
  BOOST_TEST(checked_ratio({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}}, 8) == 1);
}

BOOST_AUTO_TEST_CASE(random_hulls)
{
  for (std::size_t seed = 0; seed < 60; ++seed) {
    std::vector<Point> points = random_points(20 + 10 * int(seed), seed,
                                              {1, seed % 3 == 0 ? 1e-3 : 1., seed % 2 ? 30. : 1.});
    if (seed % 5 == 0) // planar facets that rounding bends
      for (Point& p : points)
        for (double& c : p)
          c = std::round(c * 20) / 20 + 1e-7 * c;
    for (std::size_t limit : {4, 6, 8, 13, 32, 64}) {
      const double ratio = checked_ratio(points, limit);
      BOOST_TEST(ratio >= 1 - 1e-9);
      BOOST_TEST(ratio < (limit < 8 ? 8 : limit < 32 ? 2.5 : 1.2));
    }
  }
}

BOOST_AUTO_TEST_CASE(order_of_points)
{
  std::vector<Point> points = ball(300);
  const double extent = mesh_file::extent_of(points);
  const Convex_hull first = mesh_file::limited_hull(mesh_file::convex_hull(points, extent), 40);
  std::reverse(points.begin(), points.end());
  const Convex_hull second = mesh_file::limited_hull(mesh_file::convex_hull(points, extent), 40);
  BOOST_TEST((first.points == second.points && first.triangles == second.triangles));
}

BOOST_AUTO_TEST_SUITE_END()
