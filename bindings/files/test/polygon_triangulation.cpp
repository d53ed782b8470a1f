// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Polygon_triangulation.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(polygon_triangulation)

using mesh_file::Index;
using mesh_file::Point;
using mesh_file::Polygon;
using mesh_file::Polygon_triangulation;
using mesh_file::Triangle;

typedef std::vector<std::array<double, 2> > Plane_polygon;
typedef std::array<Point, 2> Plane; // the directions of x and y

namespace {

std::vector<Triangle> triangles_of(const std::vector<Point>& points,
                                   const std::vector<Index>& corners)
{
  std::vector<Triangle> result;
  Polygon_triangulation triangulate(points);
  triangulate(Polygon(corners.data(), corners.data() + corners.size()), result);
  return result;
}

std::vector<Index> first_numbers(std::size_t n)
{
  std::vector<Index> result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

// By the shoelace formula.
double area(const Plane_polygon& polygon)
{
  double result = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    result += polygon[j][0] * polygon[i][1] - polygon[i][0] * polygon[j][1];
  return result / 2;
}

// Coordinate planes, and others.
std::vector<Plane> planes()
{
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const double a = std::sqrt(0.5), b = std::sqrt(1. / 3), c = std::sqrt(1. / 6);
  return {{{x, y}}, {{y, z}}, {{z, x}}, {{y, x}}, {{z, y}}, {{x, z}},
          {{{a, a, 0}, z}}, {{{a, -a, 0}, {c, c, -2 * c}}}, {{{c, c, -2 * c}, {-b, -b, -b}}},
          {{{0.6, 0, 0.8}, {0, -1, 0}}}};
}

// The signed area seen against the normal of the plane.
double area(const Plane_polygon& polygon, const Triangle& t)
{ return area(Plane_polygon{polygon[t[0]], polygon[t[1]], polygon[t[2]]}); }

void check_in_plane(const Plane_polygon& polygon, const Plane& plane)
{
  std::vector<Point> points;
  for (const auto& p : polygon) {
    points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      points.back()[k] = 7 + p[0] * plane[0][k] + p[1] * plane[1][k];
  }
  const std::vector<Triangle> triangles = triangles_of(points, first_numbers(polygon.size()));
  BOOST_TEST(triangles.size() == polygon.size() - 2);
  const double sign = area(polygon) < 0 ? -1 : 1;
  double sum = 0;
  std::set<std::pair<Index, Index> > edges;
  for (const Triangle& t : triangles) {
    BOOST_TEST(sign * area(polygon, t) > -1e-12);
    sum += std::abs(area(polygon, t));
    for (std::size_t i = 0; i < 3; ++i)
      BOOST_TEST(edges.emplace(t[i], t[(i + 1) % 3]).second);
  }
  BOOST_TEST(sum == std::abs(area(polygon)), boost::test_tools::tolerance(1e-9));
  for (Index i = 0; i < polygon.size(); ++i) // in the direction that they have in the polygon
    BOOST_TEST(edges.count({i, (i + 1) % static_cast<Index>(polygon.size())}) == 1);
}

void check(Plane_polygon polygon)
{
  for (int turn = 0; turn < 2; ++turn, std::reverse(polygon.begin(), polygon.end()))
    for (const Plane& plane : planes())
      check_in_plane(polygon, plane);
}

Plane_polygon regular(std::size_t n, double radius, double other_radius)
{
  Plane_polygon result;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = i % 2 == 0 ? radius : other_radius;
    const double angle = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(n);
    result.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(convex)
{
  check({{0, 0}, {4, 0}, {0, 3}});
  check({{0, 0}, {4, 0}, {5, 3}, {0, 3}});
  check(regular(17, 1, 1));
}

BOOST_AUTO_TEST_CASE(nonconvex)
{
  check({{0, 0}, {4, 0}, {1, 1}, {0, 4}});                                   // an arrow head
  check({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});                   // L
  check({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});   // U
  // A notch into a corner, whose ear would have the shortest new edge
  check({{0, 0}, {1, 1}, {1, 10}, {0.5, 10}, {0, 0.5}, {-0.5, 10}, {-1, 10}, {-1, 1}});
  check(regular(24, 1, 0.2));                                                // a star
}

BOOST_AUTO_TEST_CASE(comb)
{
  Plane_polygon polygon{{0, -1}, {40, -1}};
  for (int tooth = 20; tooth-- > 0;) {
    polygon.push_back({2. * tooth + 1.75, 10});
    polygon.push_back({2. * tooth + 0.25, tooth % 3 * 0.1});
  }
  check(polygon);
}

BOOST_AUTO_TEST_CASE(spiral)
{
  Plane_polygon polygon;
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i <= 60; ++i) {
      const int step = side == 0 ? i : 60 - i;
      const double angle = 0.3 * step, radius = 1 + 0.1 * step + 0.8 * side;
      polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  check(polygon);
}

BOOST_AUTO_TEST_CASE(corners_on_the_sides)
{
  check({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  check({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}});
}

// A square with a square hole, to which a bridge leads: two places are passed twice.
BOOST_AUTO_TEST_CASE(a_bridge_to_a_hole)
{
  check({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});
}

BOOST_AUTO_TEST_CASE(the_shorter_diagonal_of_a_quadrilateral)
{
  for (double width : {1., 3.}) {
    const std::vector<Point> points{{-width, 0, 5}, {0, -2, 5}, {width, 0, 5}, {0, 2, 5}};
    for (const Triangle& t : triangles_of(points, {0, 1, 2, 3})) {
      const bool has_width = std::count(t.begin(), t.end(), 0) && std::count(t.begin(), t.end(), 2);
      BOOST_TEST(has_width == (width < 2));
    }
  }
}

// Not in a plane: what counts is that no edge is lost and no corner left out.
BOOST_AUTO_TEST_CASE(a_saddle)
{
  std::vector<Point> points;
  for (const auto& p : regular(12, 1, 1))
    points.push_back({p[0], p[1], 0.4 * (p[0] * p[0] - p[1] * p[1])});
  const std::vector<Triangle> triangles = triangles_of(points, first_numbers(12));
  BOOST_TEST(triangles.size() == 10u);
  std::set<std::pair<Index, Index> > edges;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      BOOST_TEST(edges.emplace(t[i], t[(i + 1) % 3]).second);
  for (Index i = 0; i < 12; ++i)
    BOOST_TEST(edges.count({i, (i + 1) % 12}) == 1);
}

BOOST_AUTO_TEST_CASE(any_scale)
{
  for (double scale : {1e-300, 1e-150, 1e150, 1.7e308}) {
    const std::vector<Point> points{{-scale, -scale, scale}, {scale, -scale, scale},
                                    {-0.5 * scale, -0.5 * scale, scale}, {-scale, scale, scale}};
    const std::vector<Triangle> triangles = triangles_of(points, {0, 1, 2, 3});
    BOOST_TEST(triangles.size() == 2u);
    for (const Triangle& t : triangles) // corner 2 is reflex, so that both have it
      BOOST_TEST(std::count(t.begin(), t.end(), 2) == 1);
  }
}

BOOST_AUTO_TEST_CASE(too_few_corners)
{
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  BOOST_TEST(triangles_of(points, {}).empty());
  BOOST_TEST(triangles_of(points, {0}).empty());
  BOOST_TEST(triangles_of(points, {0, 1}).empty());
  BOOST_TEST(triangles_of(points, {0, 1, 0}).empty());
  BOOST_TEST(triangles_of(points, {1, 1, 1, 1}).empty());
  BOOST_TEST(triangles_of(points, {0, 1, 2}).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_corner_twice)
{
  const std::vector<Point> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::vector<Triangle> triangles = triangles_of(points, {0, 1, 1, 2, 3});
  BOOST_TEST(triangles.size() == 2u);
  double sum = 0;
  for (const Triangle& t : triangles)
    sum += area({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, t);
  BOOST_TEST(sum == 4);
}

BOOST_AUTO_TEST_CASE(thousands_of_corners_on_a_line)
{
  const std::size_t n = 4000;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({static_cast<double>(i), 0, 2. * static_cast<double>(i)});
  const std::vector<Triangle> triangles = triangles_of(points, first_numbers(n));
  BOOST_TEST(triangles.size() == n - 2);
  std::vector<char> is_used(n, 0);
  for (const Triangle& t : triangles)
    for (Index v : t)
      is_used[v] = 1;
  BOOST_TEST(std::count(is_used.begin(), is_used.end(), 1) == static_cast<std::ptrdiff_t>(n));
}

BOOST_AUTO_TEST_CASE(three_points_thousands_of_times)
{
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Index> corners;
  for (Index i = 0; i < 2700; ++i)
    corners.push_back(i % 3);
  const std::vector<Triangle> triangles = triangles_of(points, corners);
  BOOST_TEST(!triangles.empty());
  BOOST_TEST(triangles.size() <= 2698u);
  for (const Triangle& t : triangles)
    BOOST_TEST((t[0] != t[1] && t[1] != t[2] && t[2] != t[0]));
}

BOOST_AUTO_TEST_SUITE_END()
