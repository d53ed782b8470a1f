// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "random_point.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/capping/wall_caps.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(wall_caps)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Corners;
using internal::Loop;
using internal::Vector;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Two polylines: the points of p come first.
struct Two_sides
{
  std::vector<Vector> points;
  Loop p, q;

  Two_sides(Random& random, std::size_t n, std::size_t m)
  {
    for (Index v = 0; v < n + m; ++v) {
      points.push_back(random_point(random));
      (v < n ? p : q).push_back(v);
    }
  }

  double squared_distance(Index v, Index w) const { return (points[v] - points[w]).squared_norm(); }

  // Returns the smallest sum of the squared lengths of the edges after p[i] q[j], by trying all
  // sequences of triangles.
  template <class Is_usable>
  double smallest_cost(std::size_t i, std::size_t j, const Is_usable& is_usable) const
  {
    if (i + 1 == p.size() && j + 1 == q.size())
      return 0;
    double result = infinity;
    if (i + 1 < p.size() && is_usable({p[i], p[i + 1], q[j]}))
      result = squared_distance(p[i + 1], q[j]) + smallest_cost(i + 1, j, is_usable);
    if (j + 1 < q.size() && is_usable({q[j + 1], q[j], p[i]}))
      result = (std::min)(result, squared_distance(p[i], q[j + 1]) +
                                    smallest_cost(i, j + 1, is_usable));
    return result;
  }
};

} // namespace

// A third of the triangles is not usable.
BOOST_AUTO_TEST_CASE(strips_have_the_shortest_edges_of_all)
{
  int number_without_strip = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const std::size_t n = random_number(random, 1, 6), m = random_number(random, 2, 6);
    const Two_sides s(random, n, m);
    const auto is_usable = [&](const Corners& t)
    { return (31 * t[0] + 17 * t[1] + 7 * t[2] + seed) % 3 != 0; };
    const double expected = s.smallest_cost(0, 0, is_usable);
    const std::vector<Corners> strip =
      internal::Strip_triangulation(s.points, s.p, s.q)(is_usable);
    number_without_strip += std::isinf(expected);
    if (std::isinf(expected)) {
      BOOST_TEST(strip.empty());
      continue;
    }
    BOOST_TEST_REQUIRE(strip.size() == n + m - 2);
    std::size_t i = 0, j = 0; // the edge between p[i] and q[j]
    double cost = 0;
    for (const Corners& t : strip) {
      BOOST_TEST(is_usable(t));
      const bool is_along_p = i + 1 < n && t == Corners{s.p[i], s.p[i + 1], s.q[j]};
      if (!is_along_p)
        BOOST_TEST_REQUIRE((j + 1 < m && t == Corners{s.q[j + 1], s.q[j], s.p[i]}));
      ++(is_along_p ? i : j);
      cost += s.squared_distance(s.p[i], s.q[j]);
    }
    BOOST_TEST(cost == expected, tt::tolerance(1e-12));
  }
  BOOST_TEST(number_without_strip > 20);
  BOOST_TEST(number_without_strip < 180);
}

BOOST_AUTO_TEST_CASE(distances_of_loops_are_means_over_the_smaller)
{
  const std::vector<Vector> points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 3}, {1, 0, 5}, {90, 0, 0}};
  BOOST_TEST(internal::distance(points, {0, 1}, {2, 3, 4}) == (3 + std::sqrt(10.)) / 2,
             tt::tolerance(1e-12));
  BOOST_TEST(internal::distance(points, {2, 3, 4}, {0, 1}) == (3 + std::sqrt(10.)) / 2,
             tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
