// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(hostile_input)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
// For input on which nothing else is known.
template <class NamedParameters>
std::size_t check_run(const Mesh& mesh, const NamedParameters& np)
{ return check_labels(mesh, labels_of(mesh, np)); }

// With the cuts that the threshold keeps, and with every cut that there is.
std::size_t check_runs(const Mesh& mesh)
{
  for_both_methods([&](const auto& np) {
    check_run(mesh, np.salience_threshold(-infinity).minimum_segment_size(0));
    check_run(mesh, np.number_of_smoothing_iterations(3).random_seed(1));
  });
  check_run(mesh, parameters::zhang_liu_2005());
  return check_run(mesh, parameters::default_values());
}

// Breaks the symmetry of the surface, which makes many cuts equally salient.
Soup dented(const Soup& soup, unsigned seed)
{
  std::mt19937 engine(seed);
  const auto factor = [&] { return 1 + 0.1 * double(engine()) / double(engine.max()); };
  return transformed(soup, [&](const Point& p) {
    const double x = factor() * p.x(), y = factor() * p.y(), z = factor() * p.z();
    return Point(x, y, z);
  });
}

const std::vector<Soup>& soups()
{
  static const std::vector<Soup> result = {
    dumbbell(12, 10), plate(9, 7), dented(dumbbell(14, 10), 1), dented(torus(3, 1, 20, 12), 2),
    dented(sphere(2), 3), disjoint_union(dumbbell(10, 8), torus(3, 1, 14, 8))};
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(an_empty_mesh_has_no_segments)
{
  BOOST_TEST(check_runs(Mesh()) == 0);
  Mesh vertices_only;
  vertices_only.add_vertex(Point(1, 2, 3));
  BOOST_TEST(check_runs(vertices_only) == 0);
  Segmentation_hierarchy hierarchy;
  BOOST_TEST(check_run(Mesh(), parameters::hierarchy(hierarchy)) == 0);
  BOOST_TEST(hierarchy.number_of_nodes() == 0);
}

BOOST_AUTO_TEST_CASE(one_face_and_two_faces)
{
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  BOOST_TEST(check_runs(mesh_of({{o, x, y}, {{0, 1, 2}}})) == 1);
  const Mesh folded = mesh_of({{o, x, y, z}, {{0, 1, 2}, {1, 0, 3}}});
  BOOST_TEST(check_runs(folded) <= 2);
  BOOST_TEST(check_run(folded, parameters::salience_threshold(-infinity)) == 2);
  // The same three vertices from both sides.
  BOOST_TEST(check_runs(mesh_of({{o, x, y}, {{0, 1, 2}, {0, 2, 1}}})) <= 2);
}

BOOST_AUTO_TEST_CASE(hundreds_of_components)
{
  Soup soup;
  for (int i = 0; i < 500; ++i) {
    const double x = 3. * i;
    const std::size_t v = soup.points.size();
    soup.points.insert(soup.points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    soup.triangles.insert(soup.triangles.end(), {{v, v + 2, v + 1}, {v, v + 1, v + 3},
                                                 {v + 1, v + 2, v + 3}, {v + 2, v, v + 3}});
  }
  const Mesh mesh = mesh_of(soup);
  BOOST_TEST(check_run(mesh, parameters::keep_components_separate(true)) == 500);
  BOOST_TEST(check_runs(mesh) >= 1); // they are near to each other, seen from afar
}

BOOST_AUTO_TEST_CASE(a_mesh_without_area_is_one_segment_for_each_component)
{
  for (const Soup& soup : {dumbbell(10, 8), plate(6, 5), torus(3, 1, 10, 8)}) {
    const auto check = [&](const auto& function)
    { BOOST_TEST(check_runs(mesh_of(transformed(soup, function))) == 1); };
    check([](const Point&) { return Point(0, 0, 0); });
    check([](const Point&) { return Point(0.1, 1e9, -1e-9); });
    check([](const Point& p) { return Point(p.x(), 0, 0); });
    check([](const Point& p) { return Point(p.x(), 2 * p.x(), -p.x()); });
  }
}

BOOST_AUTO_TEST_CASE(faces_without_area_among_others)
{
  for (const Soup& soup : soups()) {
    check_runs(mesh_of(transformed(soup, [](const Point& p) // coincident points
      { return Point(std::round(2 * p.x()) / 2, std::round(2 * p.y()) / 2, p.z()); })));
    check_runs(mesh_of(transformed(soup, [](const Point& p) // a part of no area
      { return p.z() > 0 ? Point(0, 0, p.z()) : p; })));
    check_runs(mesh_of(transformed(soup, [](const Point& p) // half of it in one point
      { return p.x() > 0 ? Point(0, 0, 0) : p; })));
  }
}

// Shapes whose time or memory was quadratic, or worse, in the number of faces.
BOOST_AUTO_TEST_CASE(thousands_of_faces_meet)
{
  const auto number_of_segments = [](const Soup& soup) {
    Labels labels(soup.triangles.size(), untouched);
    const std::size_t n = CGAL::segment_spectral_recursive(
      soup.points, soup.triangles, CGAL::make_property_map(labels),
      parameters::number_of_searches(2)); // 5 take longer
    BOOST_TEST(std::set<std::size_t>(labels.begin(), labels.end()).size() == n);
    BOOST_TEST(*std::max_element(labels.begin(), labels.end()) + 1 == n);
    return n;
  };
  std::mt19937 engine(1);
  const auto coordinate = [&] { return double(engine()) / double(engine.max()) - 0.5; };
  const std::size_t n = 5000;

  number_of_segments(fan_at_edge(n));

  Soup at_a_vertex{{Point(0, 0, 0)}, {}};
  for (std::size_t i = 0; i < 2 * n; ++i)
    at_a_vertex.points.emplace_back(coordinate(), coordinate(), coordinate());
  for (std::size_t i = 0; i < n; ++i)
    at_a_vertex.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  number_of_segments(at_a_vertex);

  Soup at_a_place{std::vector<Point>(3 * n, Point(1, 2, 3)), {}};
  for (std::size_t i = 0; i < n; ++i)
    at_a_place.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  BOOST_TEST(number_of_segments(at_a_place) == n);

  Soup crowd;
  for (int i = 0; i < 100; ++i)
    crowd.points.emplace_back(coordinate(), coordinate(), coordinate());
  for (std::size_t i = 0; i < n; ++i)
    crowd.triangles.push_back({engine() % 100, engine() % 100, engine() % 100});
  number_of_segments(crowd);

  Soup spheres; // 300 in each other, nearly at the same place
  for (int i = 0; i < 300; ++i)
    spheres = disjoint_union(spheres, transformed(sphere(1), [&](const Point& p) {
      return Point((1 + 0.001 * i) * p.x(), (1 + 0.001 * i) * p.y(), (1 + 0.001 * i) * p.z());
    }));
  number_of_segments(spheres);
}

BOOST_AUTO_TEST_CASE(slivers)
{
  for (const Soup& soup : soups())
    for (double thinness : {1e-6, 1e-13, 1e-200})
      check_runs(mesh_of(transformed(soup, [thinness](const Point& p)
        { return Point(p.x(), thinness * p.y(), p.z()); })));
}

BOOST_AUTO_TEST_CASE(any_unit_gives_about_the_same_segments)
{
  for_both_methods([](const auto& np) {
    for (const Soup& soup : soups()) {
      const Labels expected = labels_of(soup, np);
      for (double unit : {1e-150, 1e-12, 0.3, 7., 1e12, 1e150})
        BOOST_TEST(rand_index(labels_of(scaled(soup, unit), np), expected) > 0.95);
    }
  });
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_range_of_double)
{
  const double largest = (std::numeric_limits<double>::max)();
  const double smallest = std::numeric_limits<double>::denorm_min();
  for (const Soup& soup : {dumbbell(10, 8), plate(6, 5)})
    for (double unit : {largest / 8, largest / 64, 1e200, 1e-200, 1e-300, 100 * smallest})
      check_runs(mesh_of(scaled(soup, unit)));
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite_are_refused)
{
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
    for (int axis = 0; axis < 3; ++axis) {
      Mesh mesh = mesh_of(dumbbell(8, 6));
      double x[3] = {0, 0, 0};
      x[axis] = bad;
      mesh.point(Mesh::Vertex_index(7)) = Point(x[0], x[1], x[2]);
      check_refused(mesh, parameters::default_values());
    }
}

BOOST_AUTO_TEST_CASE(a_face_that_is_not_a_triangle_is_refused)
{
  Soup soup = plate(3, 3);
  soup.points.insert(soup.points.end(), {{9, 9, 9}, {10, 9, 9}, {10, 10, 9}, {9, 10, 9}});
  const std::size_t n = soup.points.size();
  soup.triangles.push_back({n - 4, n - 3, n - 2, n - 1});
  check_refused(mesh_of(soup), parameters::default_values());
}

BOOST_AUTO_TEST_SUITE_END()
