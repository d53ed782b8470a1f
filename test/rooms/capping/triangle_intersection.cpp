// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

BOOST_AUTO_TEST_SUITE(triangle_intersection)

using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Corners;
using internal::Vector;

namespace {

typedef std::vector<Corners> Triangles;

// Returns whether two triangles intersect, for all orders of their corners.
bool intersect_in_all_orders(const std::vector<Vector>& points, Corners s, Corners t)
{
  const bool result = internal::do_intersect(points, s, t);
  std::sort(s.begin(), s.end());
  do {
    std::sort(t.begin(), t.end());
    do {
      BOOST_TEST(internal::do_intersect(points, s, t) == result);
      BOOST_TEST(internal::do_intersect(points, t, s) == result);
    } while (std::next_permutation(t.begin(), t.end()));
  } while (std::next_permutation(s.begin(), s.end()));
  return result;
}

// Random triangles that are not degenerate, and their points.
struct Random_triangles
{
  std::vector<Vector> points;
  Triangles triangles;

  Random_triangles(Random& random, std::size_t most_points, std::size_t most_triangles)
  {
    const Soup soup = random_triangles(random, most_points, most_triangles);
    for (const Point& p : soup.points)
      points.push_back(Vector(p.x(), p.y(), p.z()));
    for (const auto& t : soup.triangles) {
      const Corners corners = {Index(t[0]), Index(t[1]), Index(t[2])};
      if (!internal::is_degenerate(points, corners))
        triangles.push_back(corners);
    }
  }

  bool intersect_any(const Triangles& others, const Corners& t) const
  {
    return std::any_of(others.begin(), others.end(), [&](const Corners& other)
                       { return internal::do_intersect(points, t, other); });
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(triangles_may_meet_in_common_corners_and_edges_only)
{
  const Vector o(0, 0, 0), x(4, 0, 0), y(0, 4, 0);
  const auto with = [&](const Vector& p, const Vector& q, const Vector& r)
  { return std::vector<Vector>{o, x, y, p, q, r}; };
  const auto is_crossed_by = [&](const Vector& p, const Vector& q, const Vector& r)
  { return intersect_in_all_orders(with(p, q, r), {0, 1, 2}, {3, 4, 5}); };
  BOOST_TEST(!is_crossed_by({0, 0, 1}, {4, 0, 1}, {0, 4, 1}));
  BOOST_TEST(is_crossed_by({1, 1, 1}, {1, 1, -1}, {9, 9, 0}));
  BOOST_TEST(is_crossed_by({0, 0, 0}, {-1, 0, 1}, {0, -1, 1})); // a corner at the same place
  BOOST_TEST(!is_crossed_by({3, 3, 1}, {3, 3, -1}, {9, 9, 0}));

  const auto is_crossed_at_corner = [&](const Vector& p, const Vector& q)
  { return intersect_in_all_orders(with(p, q, q), {0, 1, 2}, {0, 3, 4}); };
  BOOST_TEST(!is_crossed_at_corner({-1, 0, 1}, {0, -1, 1}));
  BOOST_TEST(!is_crossed_at_corner({-1, 0, 0}, {0, -1, 0})); // in one plane
  BOOST_TEST(!is_crossed_at_corner({1, 1, 1}, {1, 1, 2}));
  BOOST_TEST(is_crossed_at_corner({1, 1, 1}, {1, 1, -1}));   // its edge passes through the middle
  BOOST_TEST(is_crossed_at_corner({9, 9, 1}, {9, 9, -1}));   // the edge xy passes through it
  BOOST_TEST(is_crossed_at_corner({2, 2, 0}, {-1, -1, 3}));  // touches xy
  BOOST_TEST(is_crossed_at_corner({5, 1, 0}, {1, 5, 0}));

  const auto is_crossed_at_edge = [&](const Vector& p)
  { return intersect_in_all_orders(with(p, p, p), {0, 1, 2}, {1, 0, 3}); };
  BOOST_TEST(!is_crossed_at_edge({1, -1, 0}));
  BOOST_TEST(!is_crossed_at_edge({1, 1, 1e-300}));
  BOOST_TEST(is_crossed_at_edge({1, 1, 0})); // folded over
  BOOST_TEST(intersect_in_all_orders(with(o, o, o), {0, 1, 2}, {2, 1, 0}));
}

BOOST_AUTO_TEST_CASE(areas_and_volumes)
{
  const std::vector<Vector> points = {{1, 1, 1}, {3, 1, 1}, {1, 4, 1}, {1, 1, 6}, {5, 1, 1}};
  BOOST_TEST(internal::tetrahedron_volume(points[0], points[1], points[2], points[3]) == 5);
  BOOST_TEST(internal::tetrahedron_volume(points[1], points[0], points[2], points[3]) == -5);
  BOOST_TEST((internal::normal(points, {0, 1, 2}) - Vector(0, 0, 6)).is_zero());
  BOOST_TEST(internal::is_degenerate(points, {0, 1, 4}));
  BOOST_TEST(internal::is_degenerate(points, {0, 0, 2}));
  BOOST_TEST(!internal::is_degenerate(points, {0, 1, 2}));
}

BOOST_AUTO_TEST_CASE(sets_intersect_themselves_if_two_triangles_do)
{
  std::size_t number_of_free_sets = 0;
  const unsigned number_of_sets = 300;
  for (unsigned seed = 1; seed <= number_of_sets; ++seed) {
    Random random(seed);
    const Random_triangles set(random, 20, 5);
    bool expected = false;
    for (std::size_t i = 0; i < set.triangles.size(); ++i)
      expected = expected || set.intersect_any(Triangles(set.triangles.begin(),
                                                         set.triangles.begin() + std::ptrdiff_t(i)),
                                               set.triangles[i]);
    BOOST_TEST(internal::do_self_intersect(set.points, set.triangles) == expected);
    number_of_free_sets += !expected;
  }
  BOOST_TEST(number_of_free_sets > number_of_sets / 5);
  BOOST_TEST(number_of_free_sets < number_of_sets * 4 / 5);
}

// Inserts and removes triangles at random, and degenerate ones, which do not count.
BOOST_AUTO_TEST_CASE(trees_find_the_triangles_that_are_inserted)
{
  std::size_t number_of_found = 0, number_of_tests = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Random_triangles all(random, 40, 60);
    if (all.triangles.size() < 10)
      continue;
    const auto next = [&] { return all.triangles[random() % all.triangles.size()]; };
    Triangles inserted = {next(), next()};
    Triangles given = inserted;
    given.push_back({0, 0, 1});
    internal::Triangle_tree tree(all.points, given);
    for (int step = 0; step < 40; ++step) {
      const std::size_t kind = random() % 4;
      if (kind == 0) {
        inserted.push_back(next());
        tree.insert({{1, 1, 1}, inserted.back()});
      }
      else if (kind == 1 && inserted.size() > 1) {
        inserted.pop_back();
        tree.remove_last(1);
      }
      else if (kind == 2)
        tree.update();
      for (int i = 0; i < 10; ++i) {
        const Corners t = next();
        const bool is_found = tree.intersects(t);
        BOOST_TEST(is_found == all.intersect_any(inserted, t));
        number_of_found += is_found;
        ++number_of_tests;
      }
    }
  }
  BOOST_TEST(number_of_found > number_of_tests / 5);
  BOOST_TEST(number_of_found < number_of_tests * 4 / 5);
}

BOOST_AUTO_TEST_SUITE_END()
