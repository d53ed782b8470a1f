// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/model/set_contacts.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(set_contacts)

namespace tt = boost::test_tools;
namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using internal::Bounding_box;
using internal::Grid;
using internal::Index;
using internal::Triangle;
using internal::Vector;

namespace {

double random_coordinate(Random& random, double extent)
{ return extent * (2 * double(random() % 100001) / 100000 - 1); }

Vector random_point(Random& random, double extent)
{
  const double x = random_coordinate(random, extent), y = random_coordinate(random, extent);
  return Vector(x, y, random_coordinate(random, extent));
}

} // namespace

BOOST_AUTO_TEST_CASE(cells_and_nodes_of_a_grid)
{
  const Bounding_box box({Vector(-2.5, 0, 1), Vector(3.2, 1, 7.9)});
  const Grid grid(box);
  BOOST_TEST(grid.number_of_nodes() == 16u * 4 * 10); // the first two are powers of 2
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector p = Vector(-2.5, 0, 1) + 0.5 * (random_point(random, 1) + Vector(1, 1, 1));
    const Vector corner = grid.point(grid.cell(p));
    for (int k = 0; k < 3; ++k) {
      BOOST_TEST(corner[k] <= p[k]);
      BOOST_TEST(p[k] < corner[k] + 1);
    }
    std::set<Index> neighbors;
    grid.for_each_neighbor(grid.cell(p), [&](Index node) {
      BOOST_TEST((grid.point(node) - corner).norm() == 1);
      neighbors.insert(node);
    });
    BOOST_TEST(neighbors.size() == 6u);
    BOOST_TEST((grid.point(grid.corners(grid.cell(p))[7]) - corner).squared_norm() == 3);
  }
  std::size_t at_corner = 0;
  grid.for_each_neighbor(0, [&](Index) { ++at_corner; });
  BOOST_TEST(at_corner == 3u);
}

BOOST_AUTO_TEST_CASE(distances_from_a_triangle)
{
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    Triangle t = {random_point(random, 1), random_point(random, 1), random_point(random, 1)};
    if (i % 4 == 1)
      t[2] = t[0];
    if (i % 4 == 2)
      t[2] = 3 * t[0] - 2 * t[1];
    const Vector p = random_point(random, 2);
    double least = std::numeric_limits<double>::infinity();
    constexpr int n = 200; // points along an edge
    for (int a = 0; a <= n; ++a)
      for (int b = 0; a + b <= n; ++b) {
        const Vector q = double(a) / n * t[0] + double(b) / n * t[1] + double(n - a - b) / n * t[2];
        least = (std::min)(least, (p - q).norm());
      }
    const double distance = std::sqrt(internal::squared_distance_to_triangle(p, t));
    BOOST_TEST(distance <= least + 1e-9);
    BOOST_TEST(distance >= least - 0.05);
  }
}

BOOST_AUTO_TEST_CASE(pieces_of_a_triangle_are_all_of_it)
{
  Random random(3);
  for (double bound : {0.1, 0.5, 10.}) {
    const Triangle t = {random_point(random, 1), random_point(random, 1), random_point(random, 1)};
    const auto area = [](const Triangle& of)
    { return (of[1] - of[0]).cross(of[2] - of[0]).norm() / 2; };
    double sum = 0, fractions = 0;
    internal::for_each_piece(t, bound, [&](const Triangle& piece, double fraction) {
      sum += area(piece);
      fractions += fraction;
      BOOST_TEST(fraction * area(t) == area(piece), tt::tolerance(1e-9));
      for (int k = 0; k < 3; ++k)
        BOOST_TEST((piece[k] - piece[(k + 1) % 3]).norm() <= bound);
    });
    BOOST_TEST(sum == area(t), tt::tolerance(1e-9));
    BOOST_TEST(fractions == 1, tt::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(nearest_points_are_near_the_results_of_a_search_through_all)
{
  Random random(4);
  std::vector<Vector> points;
  for (int i = 0; i < 50; ++i)
    points.push_back(random_point(random, 8));
  const Grid grid((Bounding_box(points)));
  const internal::Step_counter count_steps = [](std::size_t) {};
  internal::Nearest_points nearest(grid, points, count_steps);
  for (Index i = 0; i < points.size(); ++i)
    for (Index node : grid.corners(grid.cell(points[i])))
      nearest.offer(node, i);
  nearest.propagate();
  std::size_t wrong = 0;
  for (Index node = 0; node < grid.number_of_nodes(); ++node) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector& p : points)
      least = (std::min)(least, (p - grid.point(node)).norm());
    const double distance = (points[nearest[node]] - grid.point(node)).norm();
    wrong += distance > least + 1e-4;
    BOOST_TEST(distance <= 1.1 * least + 1e-4);
  }
  BOOST_TEST(wrong <= grid.number_of_nodes() / 100);
}

BOOST_AUTO_TEST_CASE(contact_grows_with_the_area_of_contact)
{
  // Two plates lie on a plate, one with four times the area of the other.
  Soup soup = scaled(plate(8, 8), 1. / 8);
  soup = disjoint_union(soup, moved(scaled(plate(8, 8), 0.4 / 8), 0.05, 0.05, 0.002));
  soup = disjoint_union(soup, moved(scaled(plate(8, 8), 0.2 / 8), 0.7, 0.7, 0.002));
  const Surface graph = surface_of(soup);
  double area[2] = {0, 0};
  for (const internal::Set_contact& c : internal::set_contacts(graph, graph.components.labels))
    if (c.sets[0] == 0)
      area[c.sets[1] - 1] = double(c.area);
  BOOST_TEST(area[0] / area[1] == 4, tt::tolerance(0.2));
}

BOOST_AUTO_TEST_CASE(steps_are_counted_all_along)
{
  // There are 64 cells along the mesh, and pieces of less than half a cell.
  const Soup soup = disjoint_union(plate(8, 8), moved(plate(8, 8), 0, 0, 0.3));
  const Surface graph = surface_of(soup);
  std::size_t all = 0;
  const auto contacts = [&](const internal::Step_counter& count_steps)
  { return internal::set_contacts(graph, graph.components.labels, count_steps).size(); };
  BOOST_TEST(contacts([&](std::size_t number) { all += number; }) == 1);
  BOOST_TEST(all > 2 * 2 * 64 * 64);
  struct Ended {};
  for (std::size_t end : {std::size_t(1), all / 4, all / 2, all - 1}) {
    std::size_t left = end;
    const auto count = [&](std::size_t number) {
      if (number > left)
        throw Ended();
      left -= number;
    };
    BOOST_CHECK_THROW(contacts(count), Ended);
  }
}

// The edges of a minimum spanning tree, by Kruskal's algorithm.
BOOST_AUTO_TEST_CASE(nearest_sets_come_first)
{
  Soup soup;
  const double x[4] = {0, 10, 13, 30}; // centers of spheres of radius 1
  for (double center : x)
    soup = disjoint_union(soup, moved(sphere(2), center, 0, 0));
  const Surface graph = surface_of(soup);
  internal::Disjoint_sets joined(graph.components.number);
  std::vector<std::pair<Index, Index> > pairs;
  for (const internal::Set_contact& c :
       internal::set_contacts(graph, graph.components.labels, [](std::size_t) {}))
    if (joined.representative(c.sets[0]) != joined.representative(c.sets[1])) {
      joined.join(c.sets[0], c.sets[1]);
      pairs.emplace_back(c.sets[0], c.sets[1]);
    }
  const std::vector<std::pair<Index, Index> > expected = {{1, 2}, {0, 1}, {2, 3}};
  BOOST_TEST((pairs == expected));
}

BOOST_AUTO_TEST_SUITE_END()
