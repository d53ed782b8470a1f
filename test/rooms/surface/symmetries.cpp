// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/symmetries.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(symmetries)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Rigid_motion;
using internal::Symmetry_search;
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
  const Rigid_motion reflection = Rigid_motion::reflection(Vector(0, 1, 0), 2);
  BOOST_TEST((reflection(Vector(1, 5, 3)) == Vector(1, -1, 3)));
  BOOST_TEST((reflection.direction(Vector(1, 5, 3)) == Vector(1, -5, 3)));
}

// A quarter of a turn about the line through (1, 0, 0) along the z-axis
BOOST_AUTO_TEST_CASE(a_rotation_by_hand)
{
  const Rigid_motion rotation = Rigid_motion::rotation(Vector(0, 0, 1), Vector(1, 0, 0), 0.25);
  BOOST_TEST((rotation(Vector(3, 0, 5)) - Vector(1, 2, 5)).norm() < 1e-12);
  BOOST_TEST((rotation.direction(Vector(3, 0, 5)) - Vector(0, 3, 5)).norm() < 1e-12);
}

namespace {

// Checks that the image of each face is where a motion maps the face.
void check_images(const Surface& surface, const Rigid_motion& motion)
{
  const std::vector<Index> image = Symmetry_search(surface).images(sequential, motion);
  std::size_t number = 0; // of faces with an image there
  for (Index f = 0; f < image.size(); ++f)
    number += image[f] != internal::null_index &&
              (surface.centroid(image[f]) - motion(surface.centroid(f))).norm() < 0.05;
  BOOST_TEST(number == image.size());
}

// Maps a point of a sphere to one of a flat body with n lobes, whose axis is oblique. A twist makes
// the lobes slanted, so that no plane maps the body to itself.
Point lobed(const Point& p, int n, double twist)
{
  const double angle = std::atan2(p.y(), p.x()) + twist * p.z();
  const double r = std::hypot(p.x(), p.y()) * (1 + 0.4 * std::cos(n * angle));
  const double phi = std::atan2(p.y(), p.x());
  const double x = r * std::cos(phi), y = r * std::sin(phi), z = 0.6 * p.z();
  return Point(0.8 * x - 0.6 * z + 1, y, 0.6 * x + 0.8 * z - 2);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_plane_of_a_symmetric_body_is_found)
{
  const Surface surface = framed(sphere(4), dented);
  const std::vector<Rigid_motion> motions = Symmetry_search(surface).symmetries();
  BOOST_TEST_REQUIRE(motions.size() == 1u);
  check_images(surface, motions[0]);
  const Vector v(1, 2, 3);
  BOOST_TEST((motions[0](motions[0](v)) - v).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_twisted_body_has_no_symmetry)
{
  const Surface surface = framed(sphere(4), [](const Point& p) {
    const double angle = 1.5 * p.x(), c = std::cos(angle), s = std::sin(angle);
    const double y = p.y() + 0.5 * p.x() * p.x(), z = 0.4 * p.z();
    return Point(3 * p.x(), c * y - s * z, s * y + c * z);
  });
  BOOST_TEST(Symmetry_search(surface).symmetries().empty());
}

// The plane that divides the length is taken, among three planes.
BOOST_AUTO_TEST_CASE(ties_go_to_the_axis_of_larger_variance)
{
  const Surface surface = framed(sphere(4), [](const Point& p)
    { return Point(2 * p.x(), p.y(), 0.5 * p.z()); });
  const std::vector<Rigid_motion> motions = Symmetry_search(surface).symmetries();
  BOOST_TEST_REQUIRE(motions.size() == 1u);
  double lengths[2] = {0, 0}; // along the normal, and in other directions
  for (const Vector& p : surface.points) {
    const double height = motions[0].axis().dot(p);
    lengths[0] = (std::max)(lengths[0], height);
    lengths[1] = (std::max)(lengths[1], (p - height * motions[0].axis()).norm());
  }
  BOOST_TEST(lengths[0] > 1.5 * lengths[1]);
}

// A body with six lobes is mapped to itself by thirds of a turn, too; the sixths are taken.
BOOST_AUTO_TEST_CASE(rotations_of_bodies_with_equal_lobes_are_found)
{
  for (int n : {3, 4, 5, 6, 11})
    for (double twist : {0., 0.5}) {
      const Surface surface =
        framed(sphere(4), [&](const Point& p) { return lobed(p, n, twist); });
      const std::vector<Rigid_motion> motions = Symmetry_search(surface).symmetries();
      BOOST_TEST_REQUIRE(motions.size() == static_cast<std::size_t>(n - 1));
      for (const Rigid_motion& motion : motions)
        check_images(surface, motion);
      Vector p = surface.points[0];
      for (int i = 0; i < n; ++i)
        p = motions[0](p);
      BOOST_TEST((p - surface.points[0]).norm() < 1e-9); // n times 1/n turn
    }
}

// It has one reflection, and no rotation: any angle maps it to itself.
BOOST_AUTO_TEST_CASE(a_surface_of_revolution_has_no_rotations)
{
  const Surface surface = framed(sphere(4), [](const Point& p)
    { return Point(p.x(), p.y(), 0.5 * p.z() + 0.3 * p.z() * p.z()); });
  BOOST_TEST(Symmetry_search(surface).symmetries().size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
