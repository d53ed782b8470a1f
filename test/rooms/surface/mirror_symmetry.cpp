// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/mirror_symmetry.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(mirror_symmetry)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Mirror_symmetry;
using internal::Reflection;
using internal::Vector;

namespace {

// Maps the points of a soup, moves the surface to its frame, and returns it.
template <class Map>
Surface framed(Soup soup, const Map& map)
{
  for (Point& p : soup.points)
    p = map(p);
  Surface surface = surface_of(soup);
  internal::move_to_frame(sequential, surface);
  return surface;
}

// An egg whose three diameters differ, with dents on one side of each of two axes.
Point dented(const Point& p)
{
  return Point(1.6 * p.x() + 0.4 * p.y() * p.y(), 1.2 * p.y(), 0.8 * p.z() + 0.5 * p.x() * p.x());
}

} // namespace

BOOST_AUTO_TEST_CASE(a_reflection_by_hand)
{
  const Reflection reflection{Vector(0, 1, 0), 2};
  BOOST_TEST((reflection(Vector(1, 5, 3)) == Vector(1, -1, 3)));
  BOOST_TEST((reflection.direction(Vector(1, 5, 3)) == Vector(1, -5, 3)));
}

// The images of the faces are where the plane has them, and their images are near the faces.
BOOST_AUTO_TEST_CASE(the_plane_of_a_symmetric_body_is_found)
{
  const Surface surface = framed(sphere(4), dented);
  const Mirror_symmetry symmetry(surface);
  const std::optional<Reflection> reflection = symmetry();
  BOOST_TEST_REQUIRE(reflection.has_value());
  const std::vector<Index> image = symmetry.images(sequential, *reflection);
  for (Index f = 0; f < image.size(); ++f) {
    BOOST_TEST_REQUIRE(image[f] != internal::null_index);
    const Vector p = surface.centroid(f), q = surface.centroid(image[f]);
    BOOST_TEST((q - (*reflection)(p)).norm() < 0.05);
    BOOST_TEST((surface.centroid(image[image[f]]) - p).norm() < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_small_asymmetric_detail_changes_nothing)
{
  const Surface surface = framed(sphere(4), [](const Point& p) {
    const Point q = dented(p);
    const double distance = std::sqrt(CGAL::squared_distance(p, Point(0, 1, 0)));
    return Point(q.x(), q.y() + (std::max)(0., 0.4 - distance), q.z());
  });
  BOOST_TEST(Mirror_symmetry(surface)().has_value());
}

BOOST_AUTO_TEST_CASE(a_twisted_body_has_no_plane)
{
  const Surface surface = framed(sphere(4), [](const Point& p) {
    const double angle = 1.5 * p.x(), c = std::cos(angle), s = std::sin(angle);
    const double y = p.y() + 0.5 * p.x() * p.x(), z = 0.4 * p.z();
    return Point(3 * p.x(), c * y - s * z, s * y + c * z);
  });
  BOOST_TEST(!Mirror_symmetry(surface)().has_value());
}

// The plane that divides the length is taken, among three planes.
BOOST_AUTO_TEST_CASE(ties_go_to_the_axis_of_larger_variance)
{
  const Surface surface = framed(sphere(4), [](const Point& p)
    { return Point(2 * p.x(), p.y(), 0.5 * p.z()); });
  const std::optional<Reflection> reflection = Mirror_symmetry(surface)();
  BOOST_TEST_REQUIRE(reflection.has_value());
  double lengths[2] = {0, 0}; // along the normal, and in other directions
  for (const Vector& p : surface.points) {
    const double height = reflection->normal.dot(p);
    lengths[0] = (std::max)(lengths[0], height);
    lengths[1] = (std::max)(lengths[1], (p - height * reflection->normal).norm());
  }
  BOOST_TEST(lengths[0] > 1.5 * lengths[1]);
}

BOOST_AUTO_TEST_SUITE_END()
