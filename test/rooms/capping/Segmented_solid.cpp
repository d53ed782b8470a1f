// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "random_point.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/capping/Segmented_solid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(segmented_solid)

using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Corners;
using internal::Loop;
using internal::Segmented_solid;
using internal::Vector;

namespace {

// The unit octahedron, scaled, whose upper half is a segment; vertex i is on an axis.
struct Octahedron
{
  std::vector<Vector> points;
  std::vector<Corners> triangles;
  std::vector<Index> segment;

  explicit Octahedron(double scale)
    : triangles({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                 {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}), segment({0, 0, 0, 0, 1, 1, 1, 1})
  {
    for (const Vector& p : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(-1, 0, 0), Vector(0, -1, 0),
                            Vector(0, 0, 1), Vector(0, 0, -1)})
      points.push_back(scale * p);
  }

  Segmented_solid solid() const { return {points, triangles, segment, 2}; }
};

} // namespace

// No other direction has a smaller largest angle to the normals.
BOOST_AUTO_TEST_CASE(most_visible_normals_have_the_smallest_largest_angle)
{
  const auto smallest_cosine = [](const std::vector<Vector>& normals, const Vector& direction) {
    double result = 1;
    for (const Vector& n : normals)
      result = (std::min)(result, n.dot(direction));
    return result;
  };
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    std::vector<Vector> normals;
    for (std::size_t i = random_number(random, 1, 12); i > 0; --i)
      normals.push_back((random_point(random) - Vector(0.2, 0.2, 0.2)).normalized());
    const Vector result = internal::most_visible_normal(normals);
    double best = 0;
    for (int i = 0; i < 3000; ++i)
      best = (std::max)(best, smallest_cosine(normals, (random_point(random) -
                                                        Vector(0.5, 0.5, 0.5)).normalized()));
    if (result.is_zero())
      BOOST_TEST(best < 0.05);
    else
      BOOST_TEST(smallest_cosine(normals, result) > best - 0.01);
  }
  BOOST_TEST(internal::most_visible_normal({}).is_zero());
  BOOST_TEST(internal::most_visible_normal({{0, 0, 1}, {0, 0, -1}}).is_zero());
  BOOST_TEST((internal::most_visible_normal({{0, 0, 1}, {0, 1, 0}, {0, 1, 0}}) -
              Vector(0, 1, 1).normalized()).norm() < 0.01);
}

BOOST_AUTO_TEST_CASE(units_are_exact)
{
  const Octahedron octahedron(3e7);
  Segmented_solid solid = octahedron.solid();
  for (std::size_t v = 0; v < 6; ++v)
    BOOST_TEST((solid.points()[v] * solid.unit() - octahedron.points[v]).is_zero());
  BOOST_TEST(std::abs(solid.points()[0].x() - 1.5) < 0.5); // from 1 to 2
  BOOST_TEST(solid.add_point(solid.points()[4]) == 6u);
  BOOST_TEST((solid.new_points()[0] - octahedron.points[4]).is_zero());
}

// At the corners of the square between the segments, also of a surface that is inside out
BOOST_AUTO_TEST_CASE(directions_lead_into_the_solid)
{
  for (bool is_inside_out : {false, true}) {
    Octahedron octahedron(1);
    if (is_inside_out)
      for (Corners& t : octahedron.triangles)
        std::swap(t[1], t[2]);
    Segmented_solid solid = octahedron.solid();
    solid.set_orientation();
    for (Index v = 0; v < 4; ++v)
      BOOST_TEST((solid.inward(v) + octahedron.points[v]).norm() < 1e-9);
    solid.set_closed(0); // only the lower half is left
    for (Index v = 0; v < 4; ++v)
      BOOST_TEST(solid.inward(v).z() > 0.1);
    solid.turn_outward();
    BOOST_TEST((solid.triangles()[0][0] == Corners{0, 1, 4}));
  }
}

BOOST_AUTO_TEST_CASE(caps_must_be_inside_and_free)
{
  const Octahedron octahedron(1);
  Segmented_solid solid = octahedron.solid();
  solid.set_orientation();
  const internal::Border border = solid.borders().border(0);
  const internal::Opening opening(0, border, {Loop{0, 3, 2, 1}});
  const std::vector<Corners> square = {{0, 3, 2}, {0, 2, 1}}, other = {{1, 0, 3}, {1, 3, 2}};
  BOOST_TEST(solid.fit(square, opening));
  BOOST_TEST(solid.fit(other, opening));
  const Index low = solid.add_point({0, 0, -0.5}), outside = solid.add_point({3, 3, 0.1});
  BOOST_TEST(solid.fit({{0, 3, low}, {3, 2, low}, {2, 1, low}, {1, 0, low}}, opening));
  BOOST_TEST(!solid.fit({{1, 0, outside}}, opening)); // leaves the solid
  BOOST_TEST(!solid.fit({{0, 3, 2}, {3, 2, 1}}, opening)); // they overlap
  BOOST_TEST(solid.fit({{0, 2, low}}, opening));
  internal::Cap cap;
  cap.add(square, 1);
  solid.reserve(cap);
  BOOST_TEST(!solid.fit({{0, 2, low}}, opening)); // the edge from 0 to 2 is taken
  BOOST_TEST(!solid.fit(other, opening));         // would intersect it
  solid.release({cap});
  BOOST_TEST(solid.fit(square, opening));
  solid.reserve(cap);
  solid.add(cap, 0);
  BOOST_TEST(solid.borders().border(0).empty());
  BOOST_TEST(solid.borders().border(1).empty());
  BOOST_TEST(solid.caps().triangles.size() == 4u);
  for (const auto& triangles : solid.triangles())
    BOOST_TEST(internal::is_closed(internal::sorted_sides(triangles)));
}

BOOST_AUTO_TEST_SUITE_END()
