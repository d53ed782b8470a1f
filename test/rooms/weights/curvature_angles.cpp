// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/curvature_angles.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(curvature_angles)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Vector;

namespace {

std::vector<double> angles_of(const Surface& graph, double radius)
{
  return CGAL::Spectral_segmentation::internal::curvature_angles(sequential, graph, graph.points,
                                                  face_normals(graph, graph.points), radius);
}

// The length over which the surface bends by an angle, in the coordinates of the graph.
double way(const Surface& graph, double radius)
{ return 2 * radius * std::sqrt(std::accumulate(graph.areas.begin(), graph.areas.end(), 0.)); }

Vector edge_of(const Surface& graph, Index h)
{ return graph.points[graph.target_vertex(h)] - graph.points[graph.source_vertex(h)]; }

double mean(const std::vector<double>& values)
{ return std::accumulate(values.begin(), values.end(), 0.) / double(values.size()); }

// Around the z axis, open, of radius 1 and height 4.
Soup cylinder(std::size_t n_around)
{ return surface_of_revolution({{-2, 1}, {-1.5, 1}, {-0.5, 1}, {0, 1}, {1, 1}, {2, 1}}, n_around); }

} // namespace

BOOST_AUTO_TEST_CASE(a_plate_does_not_bend)
{
  for (double angle : angles_of(surface_of(plate(6, 5)), 0.1))
    BOOST_TEST(angle == 0);
}

BOOST_AUTO_TEST_CASE(a_plate_does_not_bend_in_any_position)
{
  Soup soup = plate(20, 20);
  for (Point& p : soup.points)
    p = Point(p.x(), p.y(), p.x() / 3 + p.y() / 7);
  const Surface graph = surface_of(soup);
  for (double angle : angles_of(graph, 0.01))
    BOOST_TEST(angle == 0);
}

namespace {

// The unit sphere has the tensor 1 - nn', nn' the projection on the normal. A step of backward
// Euler divides nn' - 1/3, of eigenvalue 6 on the sphere, by 1 and 6 times the time of the step.
double bending_of_sphere(double radius)
{
  const double step = radius * radius * 4 * pi / 8;
  return 2 * radius * std::sqrt(4 * pi) * (2 + 1 / ((1 + 6 * step) * (1 + 6 * step))) / 3;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sphere_bends_by_the_way_over_its_radius_everywhere)
{
  for (double size : {1., 7., 1000.})
    for (double radius : {0.02, 0.05, 0.1})
      for (double angle : angles_of(surface_of(scaled(sphere(3), size)), radius))
        BOOST_TEST(angle == bending_of_sphere(radius), tt::tolerance(0.025));
}

BOOST_AUTO_TEST_CASE(the_angle_does_not_depend_on_the_triangulation)
{
  for (std::size_t level : {2, 3, 4})
    BOOST_TEST(mean(angles_of(surface_of(sphere(level)), 0.1)) == bending_of_sphere(0.1),
               tt::tolerance(0.01));
}

// Euler: the curvature across an edge is that around the axis times the squared cosine of its angle
// to the axis. It holds exactly, as each triangle has the same tensor in proportion to its area.
BOOST_AUTO_TEST_CASE(a_cylinder_bends_across_its_axis_only)
{
  for (std::size_t n : {5, 12, 40})
    for (double radius : {0.02, 0.1}) {
      const Surface graph = surface_of(cylinder(n));
      const double side = 2 * std::sin(pi / double(n)) / unit_of(cylinder(n));
      const double along = way(graph, radius) * 2 * pi / double(n) / side;
      const std::vector<double> angles = angles_of(graph, radius);
      for (Index h = 0; h < angles.size(); ++h) {
        const Vector edge = edge_of(graph, h);
        BOOST_TEST(std::abs(angles[h] - along * edge.z() * edge.z() / edge.squared_norm()) < 1e-12);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_torus_is_concave_around_its_hole_only)
{
  const std::size_t n_tube = 24;
  const Surface graph = surface_of(torus(3, 1, 72, n_tube));
  const double unit = unit_of(torus(3, 1, 72, n_tube)), length = way(graph, 0.02) * unit;
  const std::vector<double> angles = angles_of(graph, 0.02);
  for (Index h = 0; h < angles.size(); ++h) {
    const Index a = graph.source_vertex(h), b = graph.target_vertex(h);
    const Vector middle = (graph.points[a] + graph.points[b]) / 2 * unit;
    const double from_axis = std::hypot(middle.x(), middle.y());
    if (a / n_tube == b / n_tube) // around the tube
      BOOST_TEST(std::abs(angles[h] - length * (from_axis - 3) / from_axis) < 0.05 * length);
    else if (a % n_tube == b % n_tube)
      BOOST_TEST(std::abs(angles[h] - length) < 0.05 * length);
  }
}

BOOST_AUTO_TEST_CASE(turned_inside_out_convex_is_concave)
{
  for (const Soup& soup : {sphere(1), cylinder(9), torus(3, 1, 9, 8)}) {
    const std::vector<double> angles = angles_of(surface_of(soup), 0.05);
    const Surface inside_out = surface_of(turned_inside_out(soup));
    const std::vector<double> reversed = angles_of(inside_out, 0.05);
    double sum = 0;
    for (Index h = 0; h < angles.size(); ++h) {
      // A face has its first corner as before, and its edges in reverse.
      BOOST_TEST(std::abs(reversed[h] + angles[3 * (h / 3) + 2 - h % 3]) < 1e-12);
      sum += angles[h];
    }
    BOOST_TEST(sum > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_valley_is_negative_and_a_ridge_is_positive)
{
  for (double rise : {-1., 1.}) {
    const Surface graph = surface_of(
      {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, rise), Point(1, -1, rise)},
       {{0, 1, 2}, {1, 0, 3}}});
    // Both slopes have 45 degrees: a right angle over the area of both, along an edge of length 1.
    const double area = std::sqrt(2.);
    const double expected = -rise * 0.2 * std::sqrt(area) * pi / 2 / area;
    const std::vector<double> angles = angles_of(graph, 0.1);
    for (Index h = 0; h < 6; ++h) {
      if (graph.is_border(h))
        BOOST_TEST(angles[h] == 0);
      else
        BOOST_TEST(angles[h] == expected, tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(both_sides_of_an_edge_have_the_same_angle)
{
  Random random(3);
  const Surface graph = surface_of(displaced(torus(2, 0.7, 12, 8), 0.2, random));
  const std::vector<double> angles = angles_of(graph, 0.05);
  double largest = 0, smallest = 0;
  for (Index h = 0; h < angles.size(); ++h) {
    BOOST_TEST(std::abs(angles[h] - angles[graph.opposite[h]]) < 1e-12);
    largest = std::max(largest, angles[h]);
    smallest = std::min(smallest, angles[h]);
  }
  BOOST_TEST(largest > 0.1);
  BOOST_TEST(smallest < -0.1);
}

BOOST_AUTO_TEST_CASE(no_angle_is_more_than_half_a_turn)
{
  for (double angle : angles_of(surface_of(sphere(1)), 10))
    BOOST_TEST(angle == pi);
  for (double angle : angles_of(surface_of(turned_inside_out(sphere(1))), 10))
    BOOST_TEST(angle == -pi);
}

BOOST_AUTO_TEST_CASE(faces_without_area_leave_the_angles_finite)
{
  Soup soup = sphere(1);
  soup.points[soup.triangles[0][0]] = soup.points[soup.triangles[0][1]];
  for (double angle : angles_of(surface_of(soup), 0.05))
    BOOST_TEST(std::isfinite(angle));
}

BOOST_AUTO_TEST_SUITE_END()
