// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(triangulated_loop)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Corners;
using internal::Vector;

namespace {

typedef std::vector<Vector> Loop;
typedef std::vector<Corners> Triangles;

// Makes a loop around a center in the plane z = 0, with a radius for each point, counterclockwise.
Loop star(const Vector& center, const std::vector<double>& radii)
{
  Loop result;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double u = 2 * pi * double(i) / double(radii.size());
    result.push_back(center + radii[i] * Vector(std::cos(u), std::sin(u), 0));
  }
  return result;
}

Loop reversed(const Loop& loop) { return Loop(loop.rbegin(), loop.rend()); }

// Returns the sum of the areas of triangles, which are negative if they are clockwise from above.
double area_of(const Loop& points, const Triangles& triangles, bool is_each_positive = false)
{
  double result = 0;
  for (const Corners& t : triangles) {
    const double area =
      (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z() / 2;
    if (is_each_positive)
      BOOST_TEST(area > 0);
    result += area;
  }
  return result;
}

// Returns the area of a loop by the formula of Gauss.
double area_of(const Loop& loop)
{
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result += loop[i].cross(loop[(i + 1) % loop.size()]).z() / 2;
  return result;
}

// Returns the directed edges without another triangle in the opposite direction.
std::set<std::pair<Index, Index> > border_of(const Triangles& triangles)
{
  std::set<std::pair<Index, Index> > result;
  for (const Corners& t : triangles)
    for (int i = 0; i < 3; ++i)
      if (result.erase({t[(i + 1) % 3], t[i]}) == 0)
        BOOST_TEST(result.emplace(t[i], t[(i + 1) % 3]).second);
  return result;
}

std::set<std::pair<Index, Index> > edges_of_loop(std::size_t n)
{
  std::set<std::pair<Index, Index> > result;
  for (std::size_t i = 0; i < n; ++i)
    result.emplace(Index(i), Index((i + 1) % n));
  return result;
}

Loop random_star(Random& random, std::size_t n, double least, double most)
{
  std::vector<double> radii;
  for (std::size_t i = 0; i < n; ++i)
    radii.push_back(least + (most - least) * double(random() % 1000) / 1000);
  return star({3, 2, 0}, radii);
}

} // namespace

BOOST_AUTO_TEST_CASE(flat_loops_with_holes_are_filled)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Loop outer = random_star(random, random_number(random, 4, 30), 3, 9);
    Loop hole = random_star(random, random_number(random, 3, 12), 0.5, 1);
    for (const bool has_hole : {false, true}) {
      std::vector<Loop> loops = {outer};
      if (has_hole) // in any direction
        loops.push_back(seed % 2 == 0 ? hole : reversed(hole));
      Loop all = outer;
      if (has_hole)
        all.insert(all.end(), loops[1].begin(), loops[1].end());
      const Triangles triangles = internal::flat_triangulation(loops);
      BOOST_TEST(triangles.size() == all.size() - 2 + (has_hole ? 2 : 0));
      BOOST_TEST(area_of(all, triangles, true) == area_of(outer) - has_hole * area_of(hole),
                 tt::tolerance(1e-9));
      for (const Corners& t : triangles)
        BOOST_TEST((t[0] < t[1] && t[0] < t[2]));
      // They are the same in any plane, and turned around for a loop that is.
      const Vector x = Vector(1, 2, 2) / 3, y = Vector(2, 1, -2) / 3, z = x.cross(y);
      std::vector<Loop> moved = loops;
      for (Loop& loop : moved)
        for (Vector& p : loop)
          p = 1e6 * (p.x() * x + p.y() * y + 40 * z);
      BOOST_TEST((internal::flat_triangulation(moved).size() == triangles.size()));
      const Loop backward = reversed(outer);
      BOOST_TEST(area_of(backward, internal::flat_triangulation({backward})) == -area_of(outer),
                 tt::tolerance(1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(flat_triangles_have_no_point_in_their_circle)
{
  Random random(5);
  for (int round = 0; round < 10; ++round) {
    Loop loop = random_star(random, 16, 3, 3);
    for (Vector& p : loop)
      p = Vector(p.x(), 2 * p.y() + double(random() % 100) / 1000, 0);
    for (const Corners& t : internal::flat_triangulation({loop})) {
      const Vector a = loop[t[0]], u = loop[t[1]] - a, v = loop[t[2]] - a;
      const double d = 2 * u.cross(v).z();
      const Vector center = a + Vector(v.y() * u.dot(u) - u.y() * v.dot(v),
                                       u.x() * v.dot(v) - v.x() * u.dot(u), 0) / d;
      for (const Vector& p : loop)
        BOOST_TEST((p - center).norm() > (a - center).norm() * (1 - 1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(loops_that_meet_or_are_not_flat_have_no_flat_triangles)
{
  const Loop square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const auto is_filled = [](const std::vector<Loop>& loops)
  { return !internal::flat_triangulation(loops).empty(); };
  const auto with = [&](std::size_t i, const Vector& p) {
    Loop result = square;
    result[i] = p;
    return result;
  };
  BOOST_TEST(is_filled({square}));
  BOOST_TEST(is_filled({with(2, {1, 1, 0})}));
  BOOST_TEST(!is_filled({with(2, {2, -2, 0})}));              // crosses itself
  BOOST_TEST(!is_filled({with(2, {0, 0, 0})}));               // passes a point twice
  BOOST_TEST(!is_filled({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}));
  BOOST_TEST(is_filled({with(2, {4, 4, 0.5})}));
  BOOST_TEST(!is_filled({with(2, {4, 4, 4})}));
  BOOST_TEST(is_filled({square, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}));
  BOOST_TEST(!is_filled({square, {{1, 1, 0}, {9, 1, 0}, {1, 2, 0}}})); // leaves the square
  BOOST_TEST(!is_filled({square, {{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}})); // is outside
  BOOST_TEST(!is_filled({square, {{1, 1, 0}, {2, 1, 0}, {1, 2, 2}}})); // is not in the plane
}

// The border of the triangles is the loop, in its direction.
BOOST_AUTO_TEST_CASE(bent_loops_are_filled_in_their_direction)
{
  for (std::size_t n : {3, 4, 7, 20, 41})
    for (double height : {0., 0.02, 1., 3.}) {
      Loop loop = star({0, 0, 0}, std::vector<double>(n, 2));
      for (std::size_t i = 0; i < n; ++i)
        loop[i] += height * std::sin(4 * pi * double(i) / double(n)) * Vector(0, 0, 1);
      const Triangles triangles = internal::triangulated_loop(loop);
      BOOST_TEST(triangles.size() == n - 2);
      BOOST_TEST((border_of(triangles) == edges_of_loop(n)));
    }
}

// Makes a crown of points at two heights. With 120 points its length is 70 times the diagonal.
BOOST_AUTO_TEST_CASE(a_loop_that_fills_space_is_left_open)
{
  for (std::size_t n : {12, 120}) {
    Loop crown = star({0, 0, 0}, std::vector<double>(n, 2));
    for (std::size_t i = 0; i < n; i += 2)
      crown[i] += Vector(0, 0, 4);
    BOOST_TEST(internal::triangulated_loop(crown).size() == (n == 12 ? 10u : 0u));
  }
}

BOOST_AUTO_TEST_SUITE_END()
