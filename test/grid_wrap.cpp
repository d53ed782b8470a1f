// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/grid/component_distances.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid_wrap.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(grid_wrap)

namespace tt = boost::test_tools;
namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using internal::Bounding_box;
using internal::Grid;
using internal::Grid_wrap;
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

std::size_t number_of_components(const Surface& graph)
{ return internal::connected_components(graph).number; }

// Each edge has two faces, and the faces around each vertex are one fan.
void check_closed_manifold(const Surface& graph)
{
  std::vector<std::size_t> faces_around(graph.points.size(), 0);
  std::vector<Index> outgoing(graph.points.size(), 0);
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    BOOST_TEST_REQUIRE(!graph.is_border(h));
    BOOST_TEST(graph.opposite[graph.opposite[h]] == h);
    ++faces_around[graph.source_vertex(h)];
    outgoing[graph.source_vertex(h)] = h;
  }
  for (std::size_t v = 0; v < outgoing.size(); ++v) {
    std::size_t fan = 0;
    Index h = outgoing[v];
    do {
      const Index previous = h % 3 == 0 ? h + 2 : h - 1;
      h = graph.opposite[previous];
      ++fan;
    } while (h != outgoing[v] && fan <= faces_around[v]);
    BOOST_TEST(fan == faces_around[v]);
  }
}

Surface wrap_of(const Soup& soup)
{
  const Surface graph = surface_of(soup);
  return Grid_wrap(sequential, graph).surface();
}

double volume(const Surface& graph)
{
  double result = 0;
  for (const auto& c : graph.corners)
    result += graph.points[c[0]].dot(graph.points[c[1]].cross(graph.points[c[2]])) / 6;
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(cells_and_nodes_of_a_grid)
{
  const Bounding_box box({Vector(-2.5, 0, 1), Vector(3.2, 1, 7.9)});
  const Grid grid(box, 2);
  BOOST_TEST(double(grid.number_of_nodes()) == Grid::number_of_nodes(box, 2));
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
    double sum = 0, shares = 0;
    internal::for_each_piece(t, bound, [&](const Triangle& piece, double share) {
      sum += area(piece);
      shares += share;
      BOOST_TEST(share * area(t) == area(piece), tt::tolerance(1e-9));
      for (int k = 0; k < 3; ++k)
        BOOST_TEST((piece[k] - piece[(k + 1) % 3]).norm() <= bound);
    });
    BOOST_TEST(sum == area(t), tt::tolerance(1e-9));
    BOOST_TEST(shares == 1, tt::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(nearest_elements_are_about_those_of_a_search_through_all)
{
  Random random(4);
  std::vector<Vector> points;
  for (int i = 0; i < 50; ++i)
    points.push_back(random_point(random, 8));
  const Grid grid(Bounding_box(points), 2);
  const auto squared_distance = [&](Index i, const Vector& p)
  { return (p - points[i]).squared_norm(); };
  const auto reaches = [](Index, float) { return true; };
  internal::Nearest_elements<decltype(squared_distance), decltype(reaches)>
    nearest(grid, squared_distance, reaches);
  for (Index i = 0; i < points.size(); ++i)
    for (Index node : grid.corners(grid.cell(points[i])))
      nearest.offer(node, i);
  nearest.propagate();
  std::size_t wrong = 0;
  for (Index node = 0; node < grid.number_of_nodes(); ++node) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector& p : points)
      least = (std::min)(least, (p - grid.point(node)).norm());
    const double distance = std::sqrt(double(nearest.squared_distance(node)));
    wrong += distance > least + 1e-4;
    BOOST_TEST(distance <= 1.1 * least + 1e-4);
  }
  BOOST_TEST(wrong <= grid.number_of_nodes() / 100);
}

BOOST_AUTO_TEST_CASE(the_boundary_of_any_solid_becomes_a_closed_manifold)
{
  Random random(5);
  for (int percent : {10, 50, 90})
    for (int i = 0; i < 5; ++i) {
      const Grid grid(Bounding_box({Vector(), Vector(5, 5, 5)}), 3);
      internal::Grid_function values(grid.number_of_nodes(), 0.7f);
      std::size_t inside = 0;
      for (Index node = 0; node < values.size(); ++node) {
        const Vector p = grid.point(node);
        if ((std::min)({p.x(), p.y(), p.z()}) >= 0 && p.largest_coordinate() <= 5 &&
            int(random() % 100) < percent) {
          values[node] = -0.4f;
          ++inside;
        }
      }
      const internal::Grid_function given = values;
      internal::Well_composed_solid(grid, values)();
      for (Index node = 0; node < values.size(); ++node)
        BOOST_TEST((given[node] >= 0 || values[node] < 0)); // nothing is taken away
      const Surface graph = internal::Surface_nets(grid, values)();
      BOOST_TEST((graph.number_of_faces() > 0) == (inside > 0));
      check_closed_manifold(graph);
      BOOST_TEST(volume(graph) > 0);
    }
}

BOOST_AUTO_TEST_CASE(the_wrap_of_a_sphere_is_a_larger_sphere)
{
  const Surface ball = surface_of(sphere(4));
  const Surface wrap = Grid_wrap(sequential, ball).surface();
  check_closed_manifold(wrap);
  BOOST_TEST(number_of_components(wrap) == 1u);
  const long vertices = static_cast<long>(wrap.points.size());
  BOOST_TEST(2 * vertices == 4 + static_cast<long>(wrap.number_of_faces())); // Euler
  for (const Vector& p : wrap.points)
    BOOST_TEST(p.norm() / ball.points[0].norm() == 1 + 1.2 / 46, // the offset, in deviations
               tt::tolerance(0.005));
}

BOOST_AUTO_TEST_CASE(a_wrap_depends_neither_on_orientations_nor_on_what_is_inside)
{
  const Soup alone = torus(3, 1, 40, 20);
  const Surface wrap = wrap_of(alone), other = wrap_of(turned_inside_out(alone));
  BOOST_TEST(other.number_of_faces() == wrap.number_of_faces());
  BOOST_TEST(volume(other) == volume(wrap), tt::tolerance(1e-6));
  const Surface nested = wrap_of(disjoint_union(sphere(4), scaled(sphere(3), 0.5)));
  BOOST_TEST(number_of_components(nested) == 1u);
}

BOOST_AUTO_TEST_CASE(components_near_to_each_other_have_one_wrap)
{
  const auto components_at = [](double x) {
    return number_of_components(wrap_of(disjoint_union(sphere(3), moved(sphere(3), x, 0, 0))));
  };
  BOOST_TEST(components_at(1.5) == 1u);
  BOOST_TEST(components_at(2.02) == 1u);
  BOOST_TEST(components_at(3) == 2u);
}

BOOST_AUTO_TEST_CASE(sets_of_faces_are_joined_nearest_first)
{
  Soup soup;
  const double x[4] = {0, 10, 13, 30}; // centers of spheres of radius 1
  for (double center : x)
    soup = disjoint_union(soup, moved(sphere(2), center, 0, 0));
  const Surface graph = surface_of(soup);
  const auto pairs = internal::nearest_sets_of_faces(graph, graph.components.of_face,
                                                     graph.components.number);
  const std::vector<std::pair<Index, Index> > expected = {{1, 2}, {0, 1}, {2, 3}};
  BOOST_TEST((pairs == expected));
}

BOOST_AUTO_TEST_SUITE_END()
