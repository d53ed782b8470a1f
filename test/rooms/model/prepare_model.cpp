// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/model/prepare_model.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(prepare_model)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Options;
using internal::Constraints;
using internal::Vector;

namespace {

// A mesh of several components, prepared like in a run
struct Prepared_model
{
  internal::Level level;
  internal::Face_map map;
  internal::Assembled_model model;

  Prepared_model(const Soup& soup, const Options& options = Options(),
                 const Constraints& constraints = Constraints())
    : level(internal::first_level(read_surface(soup)))
  {
    internal::Run_control control;
    internal::Run_monitor monitor(control);
    const internal::Method_constants method = internal::constants_of(options.method);
    const internal::Feature_source features;
    model = internal::prepare_model(
      level, map, {options, method, constraints, features, sequential, monitor, 0});
  }

  const Surface& mesh() const { return level.surface; }
  std::size_t number_of_faces() const { return mesh().number_of_faces(); }
  std::size_t number_of_walls() const { return model.walls.surface.number_of_faces(); }
};

Options separate_components()
{
  Options result;
  result.keep_components_separate = true;
  return result;
}

Options exact_number(std::size_t number)
{
  Options result;
  result.number_of_segments = number;
  return result;
}

Vector vector_of(const Point& p) { return Vector(p.x(), p.y(), p.z()); }

double area_of(const Soup& soup, std::size_t f)
{
  const std::vector<std::size_t>& t = soup.triangles[f];
  return std::sqrt(CGAL::squared_area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
}

// Returns six times the volume that each component encloses.
std::vector<double> volumes_of(const Surface& surface)
{
  std::vector<double> result(surface.components.number, 0);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    result[surface.components[f]] +=
      surface.normal(f).dot(surface.points[surface.corners[f][0]]);
  return result;
}

// Checks that a part has the points that were given.
void check_points(const internal::Part_of_model& part, const Soup& soup)
{
  for (Index f = 0; f < part.mesh.surface.number_of_faces(); ++f) {
    std::set<Vector> points, given;
    for (Index v : part.mesh.surface.corners[f])
      points.insert(part.mesh.surface.points[v]);
    for (std::size_t v : soup.triangles[part.mesh.parent_face[f]])
      given.insert(vector_of(soup.points[v]));
    BOOST_TEST((points == given));
  }
}

Soup ball(double radius, double x) { return moved(scaled(sphere(2), radius), x, 0, 0); }
Soup hollow_ball() { return disjoint_union(ball(1, 0), turned_inside_out(ball(0.98, 0))); }
const std::size_t faces_of_ball = 320;

} // namespace

// A torus, its copy at the same place, and a hollow ball; a ball that is inside out
BOOST_AUTO_TEST_CASE(faces_keep_their_areas_and_distances)
{
  const Soup ring = moved(torus(3, 1, 24, 12), 9, 1, 0);
  const std::size_t n = ring.triangles.size();
  const Soup soup = scaled(disjoint_union(disjoint_union(disjoint_union(ring, ring), hollow_ball()),
                                          turned_inside_out(ball(0.7, -5))), 170);
  for (const Options& options : {Options(), separate_components(), Options::zhang_liu_2005()}) {
    const Prepared_model p(soup, options);
    const bool are_kept = options.keep_components_separate;
    BOOST_TEST(p.mesh().components.number == (are_kept ? 5u : 3u));
    BOOST_TEST(p.number_of_walls() == (are_kept ? 0u : faces_of_ball));
    std::set<Index> faces;
    const Vector origin = p.mesh().centroid(p.map.face[0]);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      const Index g = p.map.face[f];
      faces.insert(g);
      const bool is_wall = g >= p.number_of_faces();
      const double area = is_wall ? p.model.walls.surface.areas[g - p.number_of_faces()]
                                  : p.mesh().areas[g];
      BOOST_TEST(area * p.map.unit * p.map.unit == area_of(soup, f), tt::tolerance(1e-9));
      if (!is_wall)
        BOOST_TEST((p.mesh().centroid(g) - origin).norm() * p.map.unit ==
                   std::sqrt(CGAL::squared_distance(centroid(soup, f), centroid(soup, 0))),
                   tt::tolerance(1e-4));
    }
    BOOST_TEST(faces.size() == soup.triangles.size() - (are_kept ? 0 : n));
    BOOST_TEST(*faces.rbegin() == faces.size() - 1);
    for (double volume : volumes_of(p.mesh())) // a wall that is kept was inside out
      BOOST_TEST(volume > 0);
  }
}

BOOST_AUTO_TEST_CASE(duplicate_faces_get_the_face_of_their_original)
{
  const std::size_t n = faces_of_ball;
  const Soup soup = disjoint_union(disjoint_union(ball(1, 0), ball(2, 5)),
                                   turned_inside_out(ball(2, 5)));
  const Prepared_model p(soup, exact_number(2 * n));
  BOOST_TEST(p.number_of_faces() == 2 * n);
  for (std::size_t f = 0; f < n; ++f)
    BOOST_TEST(p.map.face[2 * n + f] == p.map.face[n + f]);
  BOOST_CHECK_THROW(Prepared_model(soup, exact_number(2 * n + 1)), std::invalid_argument);
  BOOST_TEST(Prepared_model(disjoint_union(ball(1, 0), ball(1, 0))).model.parts.empty());
  BOOST_TEST(Prepared_model(soup, separate_components()).number_of_faces() == 3 * n);
}

// The areas are as 9 : 0.81 : 16 : 1, so the two small balls together have 1.81 of 26.81.
BOOST_AUTO_TEST_CASE(small_components_are_one_part)
{
  const std::size_t n = faces_of_ball;
  const Soup soup = disjoint_union(disjoint_union(ball(3, 50), ball(0.9, 45)),
                                   disjoint_union(ball(4, 0), ball(1, -30)));
  for (const Options& options : {Options(), separate_components()}) {
    const Prepared_model p(soup, options);
    BOOST_TEST_REQUIRE(p.model.parts.size() == 3u);
    const std::vector<std::vector<std::size_t> > balls = {{0}, {2}, {1, 3}};
    const double fractions[] = {1, 1, 1.81 / 26.81};
    for (std::size_t i = 0; i < 3; ++i) {
      const internal::Part_of_model& part = p.model.parts[i];
      BOOST_TEST(part.fraction_of_model == fractions[i], tt::tolerance(1e-9));
      std::vector<Index> faces;
      for (std::size_t b : balls[i])
        for (std::size_t f = b * n; f < (b + 1) * n; ++f)
          faces.push_back(Index(f));
      BOOST_TEST(part.mesh.parent_face == faces, tt::per_element());
      check_points(part, soup);
    }
  }
  BOOST_TEST(Prepared_model(soup, Options::zhang_liu_2005()).model.parts.empty());
}

// The order of the faces changes the numbers of the components. The plate is a floor.
BOOST_AUTO_TEST_CASE(fractions_follow_the_numbers_of_components)
{
  const std::size_t n = faces_of_ball;
  const Soup floor = moved(plate(60, 60), -30, -30, -3);
  const Soup soup = disjoint_union(disjoint_union(ball(1, 9), ball(2, 3)),
                                   disjoint_union(ball(0.5, -9), floor));
  const Prepared_model p(soup);
  const double fractions[] = {1 / 5.25, 4 / 5.25, 0.25 / 5.25};
  bool are_renumbered = false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Index c = p.mesh().components[p.map.face[i * n]];
    are_renumbered = are_renumbered || c != i;
    if (i < 3)
      BOOST_TEST(p.model.fractions.fraction[c] == fractions[i], tt::tolerance(1e-9));
    BOOST_TEST((p.model.fractions.is_surrounding[c] != 0) == (i == 3));
  }
  BOOST_TEST(are_renumbered);
}

// The first two balls are duplicates.
BOOST_AUTO_TEST_CASE(faces_of_walls_get_the_nearest_outer_faces)
{
  const std::size_t n = faces_of_ball;
  const Soup soup = disjoint_union(disjoint_union(ball(1, 5), ball(1, 5)), hollow_ball());
  const Prepared_model p(soup);
  BOOST_TEST_REQUIRE(p.model.outer_face.size() == n);
  for (std::size_t i = 0; i < n; ++i) {
    BOOST_TEST(p.model.walls.parent_face[i] == 3 * n + i);
    BOOST_TEST(p.map.face[3 * n + i] == 2 * n + i);
    const Point c = centroid(soup, 3 * n + i);
    const auto distance = [&](std::size_t f) {
      const std::vector<std::size_t>& t = soup.triangles[f];
      return CGAL::squared_distance(c, Kernel::Triangle_3(soup.points[t[0]], soup.points[t[1]],
                                                          soup.points[t[2]]));
    };
    double smallest = distance(2 * n);
    for (std::size_t f = 2 * n; f < 3 * n; ++f)
      smallest = (std::min)(smallest, distance(f));
    BOOST_TEST(distance(p.model.outer_face[i]) == smallest, tt::tolerance(1e-9));
  }
  BOOST_TEST(p.model.parts.size() == 2u);
  for (const internal::Part_of_model& part : p.model.parts)
    check_points(part, soup);
}

// A ball and its duplicate come first, so that faces have other indices than the caller's.
BOOST_AUTO_TEST_CASE(constraints_and_numbers_of_segments_keep_walls)
{
  const std::size_t n = faces_of_ball;
  const Soup soup = disjoint_union(disjoint_union(ball(1, 5), ball(1, 5)), hollow_ball());
  Constraints on_outer_wall, on_inner_wall;
  on_outer_wall.seeds = {{Index(2 * n), 1}};
  on_inner_wall.must_link = {{Index(3 * n), Index(3 * n + 1)}};
  BOOST_TEST(Prepared_model(soup, Options(), on_outer_wall).number_of_walls() == n);
  BOOST_TEST(Prepared_model(soup, Options(), on_inner_wall).number_of_walls() == 0u);
  BOOST_TEST(Prepared_model(soup, exact_number(2 * n)).number_of_walls() == n);
  const Prepared_model all(soup, exact_number(2 * n + 1));
  BOOST_TEST(all.number_of_walls() == 0u);
  BOOST_TEST(all.model.outer_face.empty());
  BOOST_TEST(all.number_of_faces() == 3 * n);
}

// The fractions of the area are below 1/100 and above.
BOOST_AUTO_TEST_CASE(small_components_have_no_walls)
{
  for (const Soup& inner : {ball(0.98, 0), turned_inside_out(ball(0.98, 0))}) {
    const Soup hollow = disjoint_union(ball(1, 0), inner);
    BOOST_TEST(Prepared_model(disjoint_union(ball(11, 50), hollow)).number_of_walls() == 0u);
    BOOST_TEST(Prepared_model(disjoint_union(ball(8, 50), hollow)).number_of_walls() ==
               faces_of_ball);
  }
}

// Both halves of a tube have their own vertices where they meet.
BOOST_AUTO_TEST_CASE(patches_are_joined_unless_they_are_kept)
{
  const Soup soup = disjoint_union(surface_of_revolution({{0, 1}, {1, 1}}, 9),
                                   surface_of_revolution({{1, 1}, {2, 1}}, 9));
  BOOST_TEST(Prepared_model(soup).mesh().components.number == 1u);
  BOOST_TEST(Prepared_model(soup, separate_components()).mesh().components.number == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
