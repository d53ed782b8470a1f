// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/model/surrounding_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cstddef>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(is_convex)

using namespace test_meshes;

namespace {

bool is_convex_in_frame(const Soup& soup)
{
  Surface surface = surface_of(soup);
  CGAL::Spectral_segmentation::internal::move_to_frame(sequential, surface);
  return CGAL::Spectral_segmentation::internal::is_convex(surface);
}

} // namespace

BOOST_AUTO_TEST_CASE(hulls_are_convex_until_a_vertex_is_pushed_in)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Hull_point;
  typedef CGAL::Surface_mesh<Hull_point> Hull;
  const auto hull_of = [](const auto& points) {
    Hull hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    hull.collect_garbage();
    return hull;
  };
  const auto soup_of = [](const Hull& hull) {
    Soup soup;
    for (const Hull_point& p : hull.points())
      soup.points.emplace_back(p.x(), p.y(), p.z());
    for (Hull::Face_index f : hull.faces()) {
      soup.triangles.emplace_back();
      for (Hull::Vertex_index v : hull.vertices_around_face(hull.halfedge(f)))
        soup.triangles.back().push_back(std::size_t(v));
    }
    return soup;
  };
  Random random(7);
  std::normal_distribution<double> coordinate;
  std::size_t number_of_dents = 0;
  for (std::size_t number : {4, 5, 8, 30, 300})
    for (int repeat = 0; repeat < 5; ++repeat) {
      std::vector<Hull_point> points;
      for (std::size_t i = 0; i < number; ++i) {
        const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
        points.emplace_back(5 * x, y, z);
      }
      Hull hull = hull_of(points);
      BOOST_TEST(is_convex_in_frame(soup_of(hull)));
      Hull_point& p = hull.point(*hull.vertices().begin());
      p = CGAL::midpoint(p, Hull_point(0, 0, 0));
      if (hull_of(hull.points()).number_of_vertices() == hull.number_of_vertices())
        continue;
      ++number_of_dents;
      BOOST_TEST(!is_convex_in_frame(soup_of(hull)));
    }
  BOOST_TEST(number_of_dents > 10);
}

BOOST_AUTO_TEST_CASE(flat_faces_may_be_rounded)
{
  const Soup cube = {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                      Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), Point(0, 1, 1)},
                     {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                      {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}}};
  Random random(1);
  for (double rounding_of_float : {0., 1e-7})
    BOOST_TEST(is_convex_in_frame(displaced(cube, rounding_of_float, random)));
}

BOOST_AUTO_TEST_CASE(other_surfaces_are_not)
{
  BOOST_TEST(is_convex_in_frame(sphere(2)));
  for (const Soup& soup : {turned_inside_out(sphere(2)), plate(3, 2), torus(2, 0.7, 9, 5),
                           dumbbell(6, 4), pillow()})
    BOOST_TEST(!is_convex_in_frame(soup));
}

BOOST_AUTO_TEST_SUITE_END()
