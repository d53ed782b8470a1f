// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

BOOST_AUTO_TEST_SUITE(patch)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::Calibrated_part_salience;
using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Weighted_part_salience;
using CGAL::Spectral_segmentation::internal::Patch;
using CGAL::Spectral_segmentation::internal::Edge_weights;

namespace {

typedef std::vector<Index> Faces;

Salience_factors factors_of(const Surface& graph, const Faces& faces)
{
  Patch q(graph);
  for (Index f : faces)
    q.add(f);
  return q.factors();
}

void check_factors(const Salience_factors& factors, double size, double cut_strength,
                   double protrusiveness)
{
  BOOST_TEST(std::abs(factors.size - size) < 1e-9);
  BOOST_TEST(std::abs(factors.cut_strength - cut_strength) < 1e-9);
  BOOST_TEST(std::abs(factors.protrusiveness - protrusiveness) < 1e-9);
}

// A plate of 3 x 3 unit squares with a unit cube on the one in the middle: 16 faces of the plate, 8
// of the walls of the cube (2 for each, that towards -y first, counterclockwise), 2 of its top.
Soup cube_on_a_plate()
{
  Soup soup = plate(3, 3);
  soup.triangles.erase(soup.triangles.begin() + 8, soup.triangles.begin() + 10);
  const std::size_t bottom[] = {5, 6, 10, 9}, top[] = {16, 17, 18, 19};
  for (std::size_t v : bottom)
    soup.points.emplace_back(soup.points[v].x(), soup.points[v].y(), 1.);
  const auto add_quad = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    add_quad(bottom[i], bottom[next], top[next], top[i]);
  }
  add_quad(top[0], top[1], top[2], top[3]);
  return soup;
}

const Faces cube = {16, 17, 18, 19, 20, 21, 22, 23, 24, 25};

Faces all_but(const Surface& graph, const Faces& faces)
{
  Faces rest;
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    if (std::find(faces.begin(), faces.end(), f) == faces.end())
      rest.push_back(f);
  return rest;
}

// A connected set of some faces of the graph, in the order of a walk.
Faces random_patch(const Surface& graph, Random& random)
{
  const std::size_t size = 1 + random() % (graph.number_of_faces() - 1);
  Faces patch(1, static_cast<Index>(random() % graph.number_of_faces()));
  while (patch.size() < size) {
    const Index h = static_cast<Index>(3 * patch[random() % patch.size()] + random() % 3);
    const Index f = graph.neighbor(h);
    if (std::find(patch.begin(), patch.end(), f) == patch.end())
      patch.push_back(f);
  }
  return patch;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_cube_on_a_plate)
{
  const Surface graph = graph_with_distances(cube_on_a_plate());
  // The cut is a unit square, whose corners have variances 1/4, on the sharpest concave edges.
  const Salience_factors factors = factors_of(graph, cube);
  check_factors(factors, 5. / 13, 1, 4. / 5);
  BOOST_TEST(Weighted_part_salience()(factors) == 0.1 * 5 / 13 + 0.6 + 0.3 * 4 / 5,
             tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_cut_along_convex_edges_has_no_strength)
{
  const Surface graph = graph_with_distances(cube_on_a_plate());
  check_factors(factors_of(graph, {24, 25}), 1. / 13, 0, 0);
}

BOOST_AUTO_TEST_CASE(a_cut_that_is_neither_planar_nor_concave_all_along)
{
  const Surface graph = graph_with_distances(cube_on_a_plate());
  // One wall is left out: three concave edges of six; the six vertices have variance 1/4 along the
  // wall and across it the covariance matrix (2/9 1/9, 1/9 2/9) with eigenvalues 1/3 and 1/9.
  check_factors(factors_of(graph, Faces(cube.begin() + 2, cube.end())), 4. / 13, 1. / 2,
                1 - std::sqrt(1. / 12));
}

BOOST_AUTO_TEST_CASE(a_square_loop_on_a_flat_plate)
{
  const Surface graph = graph_with_distances(plate(6, 5));
  // Eight vertices around 2 x 2 squares, at -1, 0 and 1 three, two and three times in x and in y.
  Faces square;
  for (Index y : {1, 2})
    for (Index x : {2, 3})
      for (Index i : {0, 1})
        square.push_back(2 * (6 * y + x) + i);
  check_factors(factors_of(graph, square), 4. / 30, 0, 1 - 4 * 0.75 / 4);
}

BOOST_AUTO_TEST_CASE(a_straight_cut_encloses_no_base_area)
{
  const Surface graph = graph_with_distances(plate(6, 5));
  Faces rows(24);
  std::iota(rows.begin(), rows.end(), Index(0));
  const Salience_factors factors = factors_of(graph, rows);
  BOOST_TEST(factors.size == 12. / 30, tt::tolerance(1e-12));
  BOOST_TEST(factors.protrusiveness == 1, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(strength_is_relative_to_the_largest_angle_of_the_part)
{
  Surface graph = graph_with_distances(cube_on_a_plate());
  for (Edge_weights& w : graph.weights) {
    w.angle = w.concavity > 0 ? 0.25f : 0.125f;
    w.concavity = w.concavity > 0 ? 0.25f : 0;
  }
  // An edge at the border of the part does not count.
  for (Index h = 0; h < graph.weights.size(); ++h)
    if (graph.is_border(h))
      graph.weights[h].angle = 1;
  BOOST_TEST(factors_of(graph, cube).cut_strength == 1);
  for (Index h = 72; h < 78; ++h)
    graph.weights[h].angle = 0.5f;
  BOOST_TEST(factors_of(graph, cube).cut_strength == 0.5);
  for (Edge_weights& w : graph.weights)
    w.angle = w.concavity = 0;
  BOOST_TEST(factors_of(graph, cube).cut_strength == 0);
}

BOOST_AUTO_TEST_CASE(both_sides_of_a_cut_and_all_orders_of_faces_give_the_same_factors)
{
  for (unsigned seed = 1; seed <= 100; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup shape = seed % 2 ? sphere(1) : plate(5, 4);
      const Surface graph = graph_with_distances(displaced(shape, 0.2, random));
      Faces patch = random_patch(graph, random), rest = all_but(graph, patch);
      const Salience_factors factors = factors_of(graph, patch);
      for (Faces* side : {&patch, &rest}) {
        std::shuffle(side->begin(), side->end(), random);
        const Salience_factors other = factors_of(graph, *side);
        check_factors(other, factors.size, factors.cut_strength, factors.protrusiveness);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(factors_do_not_depend_on_scale_and_place)
{
  Random random(1);
  const Soup soup = displaced(sphere(1), 0.2, random);
  const Surface graph = graph_with_distances(soup);
  for (double scale : {1e-9, 0.3, 7., 1e6}) {
    Soup moved = soup;
    for (Point& p : moved.points)
      p = Point(scale * (p.x() + 5), scale * (p.y() - 3), scale * p.z());
    const Surface other = graph_with_distances(moved);
    for (int run = 0; run < 20; ++run) {
      const Faces patch = random_patch(graph, random);
      const Salience_factors expected = factors_of(graph, patch);
      check_factors(factors_of(other, patch), expected.size, expected.cut_strength,
                    expected.protrusiveness);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_side_knows_its_areas)
{
  const Surface graph = graph_with_distances(cube_on_a_plate());
  const double unit_area = 13 / std::accumulate(graph.areas.begin(), graph.areas.end(), 0.);
  Patch q(graph);
  for (Index f : cube)
    q.add(f);
  BOOST_TEST(q.area() * unit_area == 5, tt::tolerance(1e-12));
  BOOST_TEST(q.area_of_rest() * unit_area == 8, tt::tolerance(1e-12));
  BOOST_TEST(q.smaller_area() * unit_area == 5, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(reliable_features_leave_boundaries_to_the_network_of_merging)
{
  const Calibrated_part_salience salience;
  Salience_factors f;
  f.is_boundary = true;
  f.size = 0.3;
  f.cut_strength = 0.5;
  f.log_relative_part_area = -1;
  const double without = salience(f), in_merging = salience.in_merging(f);
  BOOST_TEST(std::abs(without - in_merging) > 0.001);
  f.feature_weight = 0.5;
  f.feature_reliability = 0.2;
  BOOST_TEST(salience(f) == without, tt::tolerance(1e-12));
  f.feature_reliability = 0.4;
  BOOST_TEST(salience(f) == salience.in_merging(f), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_weighted_salience_is_the_weighted_sum)
{
  Salience_factors factors;
  factors.size = 0.25;
  factors.cut_strength = 0.5;
  factors.protrusiveness = -2;
  BOOST_TEST(Weighted_part_salience()(factors) == 0.1 * 0.25 + 0.6 * 0.5 - 0.3 * 2,
             tt::tolerance(1e-14));
  BOOST_TEST((Weighted_part_salience{1, 0, 0}(factors)) == 0.25);
  BOOST_TEST((Weighted_part_salience{0, 1, 0}(factors)) == 0.5);
  BOOST_TEST((Weighted_part_salience{0, 0, 1}(factors)) == -2);
}

BOOST_AUTO_TEST_SUITE_END()
