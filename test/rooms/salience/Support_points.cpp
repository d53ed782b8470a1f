// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/salience/Support_points.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(support_points)

namespace internal = CGAL::Spectral_segmentation::internal;
namespace directions = internal::directions;
using namespace test_meshes;
using internal::Support_set;
using internal::Vector_of_floats;

namespace {

// Returns the largest distance of a corner of the faces along a direction.
float farthest(const Surface& mesh, const std::vector<Index>& faces, int direction)
{
  const Vector_of_floats d = directions::coordinates()[direction];
  float result = -std::numeric_limits<float>::infinity();
  for (Index f : faces)
    for (Index v : mesh.corners[f])
      result = (std::max)(result, d.dot(Vector_of_floats(mesh.points[v])));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(directions_have_length_1_and_are_spread)
{
  const directions::Coordinates& c = directions::coordinates();
  for (int i = 0; i < directions::number; ++i) {
    BOOST_TEST(std::abs(c[i].dot(c[i]) - 1) < 1e-6);
    BOOST_TEST(directions::neighbors()[i][0] == i);
    for (int j = 0; j < i; ++j)
      BOOST_TEST(c[i].dot(c[j]) < std::cos(0.2)); // 96 disks cover a sphere with a radius of 0.2
  }
}

BOOST_AUTO_TEST_CASE(the_nearest_direction_is_that_of_a_search_through_all)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10000; ++i) {
    const Vector_of_floats v(
      internal::Vector(normal(random), normal(random), normal(random)).normalized());
    const directions::Coordinates& c = directions::coordinates();
    int best = 0;
    for (int d = 1; d < directions::number; ++d)
      if (v.dot(c[d]) > v.dot(c[best]))
        best = d;
    BOOST_TEST(directions::nearest(v) == best);
  }
}

// Sets of faces have whole blocks of 32 faces, parts of blocks, or one face.
BOOST_AUTO_TEST_CASE(support_points_are_those_of_a_search_through_all_corners)
{
  for (const Soup& soup : {doll(), torus(2, 0.7, 14, 9), plate(5, 4)}) {
    const Surface mesh = surface_of(soup);
    const internal::Support_points support_points(mesh);
    const Index n = static_cast<Index>(mesh.number_of_faces());
    std::mt19937 random(2);
    for (int i = 0; i < 40; ++i) {
      const Index first = static_cast<Index>(random() % n), step = 1 + random() % 3,
                  end = first + 1 + static_cast<Index>(random() % (n - first));
      std::vector<Index> faces;
      for (Index f = first; f < end; f += step)
        faces.push_back(f);
      const Support_set set = support_points(faces);
      for (int d = 0; d < directions::number; ++d) {
        BOOST_TEST(std::abs(set.distances[d] - farthest(mesh, faces, d)) < 1e-5);
        const Vector_of_floats& p = support_points.point(set.points[d]);
        BOOST_TEST(std::abs(directions::coordinates()[d].dot(p) - set.distances[d]) < 1e-5);
        BOOST_TEST(std::any_of(faces.begin(), faces.end(), [&](Index f) {
          const auto& c = mesh.corners[f];
          return std::count(c.begin(), c.end(), set.points[d]) > 0;
        }));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
