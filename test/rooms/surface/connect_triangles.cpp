// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(connect_triangles)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Corners;
using internal::Vector;

namespace {

// Returns triangles without neighbors.
Surface unconnected(const Soup& soup)
{
  Surface result;
  for (const Point& p : soup.points)
    result.points.push_back(Vector(p.x(), p.y(), p.z()));
  for (const std::vector<std::size_t>& t : soup.triangles)
    result.corners.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
  return result;
}

bool is_same_cycle(const Corners& a, Corners b)
{
  for (int i = 0; i < 3; ++i, std::rotate(b.begin(), b.begin() + 1, b.end()))
    if (a == b)
      return true;
  return false;
}

Corners reversed(const Corners& c) { return {c[0], c[2], c[1]}; }

// Returns whether each face was turned. Checks the properties that hold for every soup.
std::vector<char> connect(const Soup& soup, Surface& triangles)
{
  triangles = unconnected(soup);
  internal::connect_triangles(triangles);
  const std::size_t n = soup.triangles.size();
  BOOST_TEST_REQUIRE(triangles.corners.size() == n);
  BOOST_TEST_REQUIRE(triangles.opposite.size() == 3 * n);
  BOOST_TEST(triangles.points.size() == soup.points.size());
  const std::vector<Corners> before = unconnected(soup).corners;
  std::vector<char> is_turned;
  for (std::size_t f = 0; f < n; ++f) {
    const Corners& c = triangles.corners[f];
    is_turned.push_back(!is_same_cycle(c, before[f]));
    BOOST_TEST((is_same_cycle(c, before[f]) || is_same_cycle(c, reversed(before[f]))));
    BOOST_TEST(c[0] == *std::min_element(c.begin(), c.end()));
  }
  // Neighbors know of each other, along the same edge in opposite directions.
  for (Index h = 0; h < 3 * n; ++h) {
    const Index o = triangles.opposite[h];
    BOOST_TEST(triangles.opposite[o] == h);
    if (triangles.is_border(h))
      continue;
    BOOST_TEST(o / 3 != h / 3);
    BOOST_TEST(triangles.source_vertex(o) == triangles.target_vertex(h));
    BOOST_TEST(triangles.target_vertex(o) == triangles.source_vertex(h));
  }
  return is_turned;
}

Soup turned_at_random(Soup soup, Random& random)
{
  for (std::vector<std::size_t>& t : soup.triangles) {
    std::rotate(t.begin(), t.begin() + std::ptrdiff_t(random() % 3), t.end());
    if (random() % 2 == 0)
      std::swap(t[0], t[1]);
  }
  return soup;
}

double volume(const Surface& triangles)
{
  double sum = 0;
  for (const Corners& c : triangles.corners)
    sum += triangles.points[c[0]].dot(triangles.points[c[1]].cross(triangles.points[c[2]])) / 6;
  return sum;
}

double area(const Surface& triangles, std::size_t f)
{ return triangles.normal(Index(f)).norm() / 2; }

std::size_t number_of_components(const Surface& triangles)
{ return internal::connected_components(triangles).number; }

std::multiset<Index> neighbors(const Surface& triangles, Index f)
{
  return {triangles.neighbor(3 * f), triangles.neighbor(3 * f + 1), triangles.neighbor(3 * f + 2)};
}

std::size_t number_of_inner_edges(const Surface& triangles)
{
  std::size_t number = 0;
  for (Index h = 0; h < triangles.number_of_halfedges(); ++h)
    number += !triangles.is_border(h);
  return number / 2;
}

// Compares all pairs of edges of faces, if no edge has more than two faces: all edges with two
// faces connect them.
std::vector<std::set<Index> > neighbors_by_comparing_pairs(const Soup& soup)
{
  std::vector<std::set<Index> > result(soup.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t g = 0; g < soup.triangles.size(); ++g)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const std::vector<std::size_t>&a = soup.triangles[f], &b = soup.triangles[g];
          if (f != g &&
              std::minmax(a[i], a[(i + 1) % 3]) == std::minmax(b[j], b[(j + 1) % 3]))
            result[f].insert(Index(g));
        }
  return result;
}

Soup part_of(const Soup& soup, std::size_t number_of_faces, Random& random)
{
  const Surface part = random_part(surface_of(soup), number_of_faces, random);
  Soup result;
  for (const Vector& p : part.points)
    result.points.emplace_back(p.x(), p.y(), p.z());
  for (const Corners& c : part.corners)
    result.triangles.push_back({c[0], c[1], c[2]});
  return result;
}

// Every other triangle of a fan runs along the edge downwards.
Soup fan(std::size_t n)
{
  Soup soup = fan_at_edge(n);
  for (std::size_t i = 1; i < n; i += 2)
    std::swap(soup.triangles[i][0], soup.triangles[i][1]);
  return soup;
}

// Returns a cube of side 1, oriented outwards.
Soup cube(double x, double y)
{
  Soup soup = {{Point(x, y, 0), Point(x + 1, y, 0), Point(x + 1, y + 1, 0), Point(x, y + 1, 0),
                Point(x, y, 1), Point(x + 1, y, 1), Point(x + 1, y + 1, 1), Point(x, y + 1, 1)},
               {}};
  for (const std::vector<std::size_t>& q : std::vector<std::vector<std::size_t> >{
         {3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    soup.triangles.push_back({q[0], q[1], q[2]});
    soup.triangles.push_back({q[0], q[2], q[3]});
  }
  return soup;
}

// The same with equal points made one.
Soup welded(const Soup& soup)
{
  Soup result;
  std::vector<std::size_t> number;
  for (const Point& p : soup.points) {
    const auto found = std::find(result.points.begin(), result.points.end(), p);
    number.push_back(std::size_t(found - result.points.begin()));
    if (found == result.points.end())
      result.points.push_back(p);
  }
  for (const std::vector<std::size_t>& t : soup.triangles)
    result.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return result;
}

std::vector<Soup> closed_soups()
{
  return {sphere(1), torus(2, 0.7, 9, 5), dumbbell(8, 6),
          connected_sum(torus(2, 0.7, 5, 4), torus(3, 1, 4, 6)),
          surface_of_revolution({{0, 0}, {0, 1}, {2, 1}, {2, 0}}, 7)};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_closed_surface_of_turned_triangles_is_oriented_outwards)
{
  Random random(1);
  for (const Soup& soup : closed_soups())
    for (int run = 0; run < 10; ++run) {
      Surface triangles;
      connect(turned_at_random(soup, random), triangles);
      const Surface expected = read_surface(soup);
      BOOST_TEST((triangles.corners == expected.corners));
      BOOST_TEST((triangles.opposite == expected.opposite));
      BOOST_TEST(volume(triangles) > 0);
    }
}

BOOST_AUTO_TEST_CASE(outwards_does_not_depend_on_the_place)
{
  Random random(2);
  for (const Soup& soup : closed_soups()) {
    Surface triangles;
    connect(turned_at_random(moved(soup, -100, 30, 1000), random), triangles);
    BOOST_TEST((triangles.corners == read_surface(soup).corners));
  }
}

BOOST_AUTO_TEST_CASE(oriented_surfaces_stay_also_if_they_point_inward)
{
  std::vector<Soup> soups = small_soups();
  for (const Soup& soup : small_soups())
    soups.push_back(turned_inside_out(soup));
  // Each component by itself.
  soups.push_back(disjoint_union(sphere(1), turned_inside_out(moved(sphere(1), 5, 0, 0))));
  for (const Soup& soup : soups) {
    Surface triangles;
    const std::vector<char> is_turned = connect(soup, triangles);
    BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), 1) == 0);
    const Surface expected = read_surface(soup);
    BOOST_TEST((triangles.corners == expected.corners));
    BOOST_TEST((triangles.opposite == expected.opposite));
  }
}

BOOST_AUTO_TEST_CASE(one_turned_triangle_is_turned_back)
{
  // Inwards but for one triangle is mixed, so the surface is closed and goes outwards.
  for (const Soup& soup : closed_soups())
    for (bool is_inwards : {false, true}) {
      Soup other = is_inwards ? turned_inside_out(soup) : soup;
      std::swap(other.triangles[5][0], other.triangles[5][1]);
      Surface triangles;
      connect(other, triangles);
      BOOST_TEST((triangles.corners == read_surface(soup).corners));
    }
}

BOOST_AUTO_TEST_CASE(an_open_surface_is_oriented_as_most_of_its_area_is)
{
  // 2 * 9 small triangles against 2 large ones.
  Soup soup = plate(10, 1);
  for (Point& p : soup.points)
    if (p.x() == 10)
      p = Point(40, p.y(), 0);
  for (std::size_t number_of_turned : {2, 4, 18}) {
    Soup other = soup; // the large ones, and some more
    for (std::size_t i = 0; i < number_of_turned; ++i)
      std::swap(other.triangles[19 - i][0], other.triangles[19 - i][1]);
    Surface triangles;
    connect(other, triangles);
    BOOST_TEST((triangles.corners == read_surface(turned_inside_out(soup)).corners));
  }
  for (std::size_t small : {3, 10}) {
    Soup other = soup;
    std::swap(other.triangles[small][0], other.triangles[small][1]);
    Surface triangles;
    connect(other, triangles);
    BOOST_TEST((triangles.corners == read_surface(soup).corners));
  }
}

BOOST_AUTO_TEST_CASE(random_surfaces_get_the_neighbors_of_a_search_through_all_pairs)
{
  const std::vector<Soup> shapes = {plate(9, 7), sphere(2), torus(2, 0.7, 12, 8), dumbbell(9, 7)};
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Soup soup;
      for (int i = 0; i < 3; ++i) {
        const Soup shape = displaced(shapes[random() % shapes.size()], 0.1, random);
        soup = disjoint_union(
          soup, part_of(shape, 1 + random() % (shape.triangles.size() - 1), random));
      }
      std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
      const Soup turned = turned_at_random(soup, random);
      Surface triangles;
      const std::vector<char> is_turned = connect(turned, triangles);

      const std::vector<std::set<Index> > expected = neighbors_by_comparing_pairs(soup);
      for (Index f = 0; f < expected.size(); ++f) {
        const std::multiset<Index> around = neighbors(triangles, f);
        std::set<Index> found(around.begin(), around.end());
        found.erase(f);
        BOOST_TEST(found == expected[f], tt::per_element());
      }
      // All faces of a component are as in the soup, or none is; most of its area is as it was
      // given.
      const internal::Components component = internal::connected_components(triangles);
      const std::size_t number = component.number;
      const Surface original = unconnected(soup);
      std::vector<std::set<bool> > is_as_original(number);
      std::vector<double> kept(number, 0), turned_area(number, 0);
      for (Index f = 0; f < triangles.number_of_faces(); ++f) {
        is_as_original[component[f]].insert(
          is_same_cycle(triangles.corners[f], original.corners[f]));
        (is_turned[f] ? turned_area : kept)[component[f]] += area(triangles, f);
      }
      for (std::size_t c = 0; c < number; ++c) {
        BOOST_TEST(is_as_original[c].size() == 1u);
        BOOST_TEST(kept[c] >= turned_area[c] * (1 - 1e-12));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_flat_two_of_three_sheets_are_neighbors)
{
  const std::vector<Point> points = {Point(0, 0, 0), Point(0, 1, 0), Point(-1, 0.5, 0.1),
                                     Point(1, 0.5, 0), Point(0, 0.5, 1)};
  // The third sheet runs along the edge as the first or as the second; in any order of the sheets.
  for (const std::vector<std::size_t>& third :
       {std::vector<std::size_t>{0, 1, 4}, std::vector<std::size_t>{1, 0, 4}}) {
    std::vector<int> order = {0, 1, 2};
    do {
      const std::vector<std::vector<std::size_t> > sheets = {{0, 1, 2}, {1, 0, 3}, third};
      Soup soup{points, {}};
      std::vector<Index> number(3);
      for (int i = 0; i < 3; ++i) {
        soup.triangles.push_back(sheets[std::size_t(order[i])]);
        number[std::size_t(order[i])] = Index(i);
      }
      Surface triangles;
      const std::vector<char> is_turned = connect(soup, triangles);
      BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), 1) == 0);
      BOOST_TEST(number_of_inner_edges(triangles) == 1u);
      BOOST_TEST(neighbors(triangles, number[0]).count(number[1]) == 1u);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

BOOST_AUTO_TEST_CASE(the_flat_two_of_sheets_that_all_have_to_be_turned_are_neighbors)
{
  const Soup soup = {{Point(0, 0, 0), Point(0, 1, 0), Point(0, 0.5, 1), Point(-1, 0.5, 0.1),
                      Point(1, 0.5, 0)}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  Surface triangles;
  connect(soup, triangles);
  BOOST_TEST(number_of_inner_edges(triangles) == 1u);
  BOOST_TEST(neighbors(triangles, 1).count(2) == 1u);
}

BOOST_AUTO_TEST_CASE(sheets_that_are_oriented_alike_come_before_flatter_ones_that_are_not)
{
  // The second sheet is flat against the first, but runs along the edge as that does.
  const Soup soup = {{Point(0, 0, 0), Point(0, 1, 0), Point(-1, 0.5, 0), Point(1, 0.5, 0),
                      Point(0, 0.5, 1)}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}};
  Surface triangles;
  const std::vector<char> is_turned = connect(soup, triangles);
  BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), 1) == 0);
  BOOST_TEST(number_of_inner_edges(triangles) == 1u);
  BOOST_TEST(neighbors(triangles, 2).count(2) == 2u);
}

BOOST_AUTO_TEST_CASE(a_moebius_strip_loses_one_edge)
{
  for (std::size_t n : {5, 6, 20}) {
    const Soup soup = twisted_band(n, 1, 1);
    Random random(3);
    for (int run = 0; run < 5; ++run) {
      const Soup turned = turned_at_random(soup, random);
      Surface triangles;
      connect(turned, triangles);
      BOOST_TEST(number_of_inner_edges(triangles) == 2 * n - 1);
      BOOST_TEST(number_of_components(triangles) == 1u);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_closed_surface_with_one_side_is_opened)
{
  // The projective plane with 6 vertices.
  Random random(4);
  Soup soup;
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                    {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  for (int i = 0; i < 6; ++i)
    soup.points.emplace_back(double(random() % 100), double(random() % 100),
                             double(random() % 100));
  for (const std::set<Index>& neighbors : neighbors_by_comparing_pairs(soup))
    BOOST_TEST(neighbors.size() == 3u); // it is closed
  Surface triangles;
  connect(soup, triangles);
  BOOST_TEST(number_of_components(triangles) == 1u);
  BOOST_TEST(number_of_inner_edges(triangles) < 15u);
}

BOOST_AUTO_TEST_CASE(two_cubes_with_a_common_edge_stay_two)
{
  const Soup soup = welded(disjoint_union(cube(0, 0), cube(1, 1)));
  BOOST_TEST(soup.points.size() == 14u);
  Surface triangles;
  const std::vector<char> is_turned = connect(soup, triangles);
  BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), 1) == 0);
  BOOST_TEST(number_of_components(triangles) == 2u);
  BOOST_TEST(number_of_inner_edges(triangles) == 36u);
  // Whatever the order and the orientation of their triangles, all edges are inside: two spheres
  // that are slit along an edge and sewn together crosswise are one sphere.
  Random random(5);
  for (int run = 0; run < 30; ++run) {
    Soup other = turned_at_random(soup, random);
    std::shuffle(other.triangles.begin(), other.triangles.end(), random);
    connect(other, triangles);
    BOOST_TEST(number_of_inner_edges(triangles) == 36u);
    BOOST_TEST(number_of_components(triangles) <= 2u);
  }
}

BOOST_AUTO_TEST_CASE(a_second_copy_of_a_triangle_is_left_alone)
{
  for (const Soup& soup : closed_soups()) {
    Soup other = soup;
    const std::vector<std::size_t> t = soup.triangles[4];
    other.triangles.push_back({t[1], t[2], t[0]});
    Surface triangles;
    connect(other, triangles);
    const Surface expected = read_surface(soup);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      BOOST_TEST((triangles.corners[f] == expected.corners[f]));
      for (std::size_t h = 3 * f; h < 3 * f + 3; ++h)
        BOOST_TEST(triangles.opposite[h] == expected.opposite[h]);
    }
    const Index copy = Index(soup.triangles.size());
    BOOST_TEST(neighbors(triangles, copy).count(copy) == 3u);
  }
  // Two that are alone become the two sides of one.
  Surface triangles;
  const std::vector<char> is_turned =
    connect({{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}, {1, 2, 0}}}, triangles);
  BOOST_TEST(number_of_inner_edges(triangles) == 3u);
  BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), 1) == 1);
}

BOOST_AUTO_TEST_CASE(triangles_with_a_repeated_corner_do_no_harm)
{
  for (const Soup& soup : closed_soups()) {
    const std::size_t a = soup.triangles[2][0], b = soup.triangles[2][1];
    for (const std::vector<std::size_t>& t : std::vector<std::vector<std::size_t> >{
           {a, a, a}, {a, a, b}, {a, b, a}, {b, a, a}, {a, b, b}}) {
      Soup other = soup;
      other.triangles.push_back(t);
      Surface triangles;
      connect(other, triangles);
      const Surface expected = read_surface(soup);
      for (std::size_t f = 0; f < soup.triangles.size(); ++f)
        BOOST_TEST((triangles.corners[f] == expected.corners[f]));
      BOOST_TEST(number_of_inner_edges(triangles) >= soup.triangles.size() * 3 / 2);
    }
  }
  Surface triangles;
  connect({{Point(0, 0, 0), Point(1, 0, 0)}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}}, triangles);
  BOOST_TEST(triangles.opposite.size() == 9u);
}

BOOST_AUTO_TEST_CASE(no_faces_are_neighbors_at_an_edge_of_very_many)
{
  for (std::size_t n : {2, 4, 8, 16}) {
    Surface triangles;
    connect(fan(n), triangles);
    BOOST_TEST(number_of_inner_edges(triangles) == n / 2);
  }
  for (std::size_t n : {17, 18, 100}) {
    Surface triangles;
    const std::vector<char> is_turned = connect(fan(n), triangles);
    BOOST_TEST(number_of_inner_edges(triangles) == 0u);
    BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), 1) == 0);
  }
}

BOOST_AUTO_TEST_CASE(random_triangles_of_few_points_are_connected_somehow)
{
  for (unsigned seed = 1; seed <= 300; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Soup soup;
      const std::size_t n = 1 + random() % 12;
      for (std::size_t i = 0; i < n; ++i)
        soup.points.emplace_back(double(random() % 5), double(random() % 5), double(random() % 5));
      for (std::size_t i = random() % 80; i > 0; --i)
        soup.triangles.push_back({random() % n, random() % n, random() % n});
      Surface triangles;
      connect(soup, triangles); // checks them
    }
  }
}

// Solids of unit cubes that have squares, edges and corners in common.
BOOST_AUTO_TEST_CASE(solids_that_touch_are_components)
{
  const auto box = [](const Cell& low, const Cell& high) {
    Cells cells;
    add_box(cells, low, high);
    return boundary_of(cells);
  };
  const std::vector<Soup> solids = {box({0, 0, 0}, {3, 3, 3}), box({3, 0, 0}, {5, 3, 3}),
                                    box({1, 1, 3}, {2, 2, 5}), box({3, 3, 0}, {5, 5, 3})};
  Soup all;
  std::vector<std::size_t> solid_of_face;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    all = disjoint_union(all, solids[i]);
    solid_of_face.resize(all.triangles.size(), i);
  }
  all = welded(all);
  for (unsigned seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      std::vector<std::size_t> face;
      Soup soup = renumbered(all, random, face);
      if (seed % 2 == 1) // faces that point inward
        soup = turned_inside_out(soup);
      Surface triangles;
      connect(soup, triangles);
      const auto components = internal::connected_components(triangles);
      BOOST_TEST(components.number == solids.size());
      BOOST_TEST(number_of_inner_edges(triangles) == 3 * soup.triangles.size() / 2);
      std::map<std::size_t, std::size_t> component;
      for (std::size_t f = 0; f < solid_of_face.size(); ++f) {
        const std::size_t c = components[static_cast<Index>(face[f])];
        BOOST_TEST(component.emplace(solid_of_face[f], c).first->second == c);
      }
    }
}

BOOST_AUTO_TEST_CASE(no_triangles_are_no_surface)
{
  Surface triangles;
  connect(Soup(), triangles);
  connect({{Point(0, 0, 0)}, {}}, triangles);
  BOOST_TEST(triangles.opposite.empty());
}

BOOST_AUTO_TEST_SUITE_END()
