// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/segment_spectral_recursive.h>

#include <Eigen/Core>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// The function that takes points and triangles.
BOOST_AUTO_TEST_SUITE(triangle_soup)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::internal::is_triangle_range;
using CGAL::Spectral_segmentation::internal::read_triangle_soup;

namespace {

auto map_to_positions(Labels& labels, std::size_t n)
{
  labels.assign(n, untouched);
  return boost::make_iterator_property_map(labels.begin(),
                                           boost::typed_identity_property_map<std::size_t>());
}

template <class Points, class Triangles, class NamedParameters>
Labels labels_of_triangles(const Points& points, const Triangles& triangles,
                           const NamedParameters& np)
{
  Labels labels;
  const auto map = map_to_positions(
    labels, std::size_t(std::distance(std::begin(triangles), std::end(triangles))));
  const std::size_t n = CGAL::segment_spectral_recursive(points, triangles, map, np);
  BOOST_TEST(n == number_of(labels));
  return labels;
}

template <class NamedParameters>
Labels labels_of_triangles(const Soup& soup, const NamedParameters& np)
{ return labels_of_triangles(soup.points, soup.triangles, np); }

const std::vector<Soup>& soups()
{
  static const std::vector<Soup> result = [] {
    std::vector<Soup> soups = small_soups();
    Random random(2);
    soups.push_back(doll());
    soups.push_back(displaced(dumbbell(14, 10), 0.05, random));
    soups.push_back(disjoint_union(doll(), moved(dumbbell(10, 8), 20, 0, 0)));
    return soups;
  }();
  return result;
}

// Throws an exception of the type and writes nothing.
template <class Exception, class Id = std::size_t, class Points, class Triangles>
void check_refused(const Points& points, const Triangles& triangles, const std::string& what)
{
  BOOST_TEST_CONTEXT(what) {
    std::vector<Id> ids(triangles.size(), Id(77));
    const auto map = boost::make_iterator_property_map(
      ids.begin(), boost::typed_identity_property_map<std::size_t>());
    BOOST_CHECK_EXCEPTION(CGAL::segment_spectral_recursive(points, triangles, map), Exception,
                          [&](const Exception& e)
                          { return std::string(e.what()).find(what) != std::string::npos; });
    BOOST_TEST(std::count(ids.begin(), ids.end(), Id(77)) == std::ptrdiff_t(ids.size()));
  }
}

typedef std::vector<std::array<double, 3> > Points;
typedef std::vector<std::array<int, 3> > Triples;

} // namespace

BOOST_AUTO_TEST_CASE(labels_with_groups_equal_the_labels_of_the_mesh)
{
  const auto group = [](std::size_t f) { return int(f / 40 % 3); };
  for_both_methods([&](const auto& np) {
    for (std::size_t i = 0; i < soups().size(); ++i)
      BOOST_TEST_CONTEXT("soup " << i) {
        const auto all_cuts =
          np.salience_threshold(0).minimum_segment_size(0).number_of_coarse_faces(20);
        const Labels expected =
          labels_of(soups()[i], all_cuts.face_group_map(
                                  boost::make_function_property_map<Mesh::Face_index>(group)));
        BOOST_TEST((labels_of_triangles(soups()[i], all_cuts.face_group_map(
                      boost::make_function_property_map<std::size_t>(group))) == expected));
      }
  });
}

BOOST_AUTO_TEST_CASE(points_and_triangles_of_any_type_are_taken)
{
  const Soup& soup = doll();
  const std::size_t n = soup.points.size();
  Points arrays;
  std::vector<Eigen::Vector3d> vectors;
  std::list<Point> list(soup.points.begin(), soup.points.end());
  std::vector<std::vector<double> > of_vectors;
  double carray[400][3];
  BOOST_TEST_REQUIRE(n <= 400);
  for (std::size_t v = 0; v < n; ++v) {
    const Point& p = soup.points[v];
    arrays.push_back({p.x(), p.y(), p.z()});
    vectors.emplace_back(p.x(), p.y(), p.z());
    of_vectors.push_back({p.x(), p.y(), p.z()});
  }
  for (std::size_t v = 0; v < 400; ++v)
    for (int i = 0; i < 3; ++i)
      carray[v][i] = v < n ? soup.points[v][i] : 0;
  Triples triples;
  std::vector<std::array<std::uint16_t, 3> > small_indices;
  std::list<std::list<long long> > lists;
  for (const std::vector<std::size_t>& t : soup.triangles) {
    triples.push_back({int(t[0]), int(t[1]), int(t[2])});
    small_indices.push_back({std::uint16_t(t[0]), std::uint16_t(t[1]), std::uint16_t(t[2])});
    lists.emplace_back(t.begin(), t.end());
  }

  const Surface expected = read_triangle_soup(soup.points, soup.triangles);
  const auto check = [&](const auto& points, const auto& triangles) {
    static_assert(is_triangle_range<std::decay_t<decltype(triangles)> >::value, "");
    const Surface surface = read_triangle_soup(points, triangles);
    BOOST_TEST(std::equal(expected.points.begin(), expected.points.end(),
                          surface.points.begin()));
    BOOST_TEST((surface.corners == expected.corners));
  };
  check(arrays, soup.triangles);
  check(arrays, triples);
  check(vectors, triples);
  check(list, lists);
  BOOST_TEST(labels_of_triangles(list, lists, parameters::default_values()) ==
             labels_of(soup, parameters::default_values()), boost::test_tools::per_element());
  check(of_vectors, small_indices);
  check(carray, triples);
}

BOOST_AUTO_TEST_CASE(ids_are_written_without_a_pack_and_with_threads_or_without)
{
  const Soup& soup = doll();
  Labels labels;
  const auto map = map_to_positions(labels, soup.triangles.size());
  CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(soup.points, soup.triangles, map);
  BOOST_TEST((labels == labels_of(soup, parameters::default_values())));
}

// Three half-planes at a common edge: two of them, which are oriented alike and bend the least, are
// one surface, and the third is another.
BOOST_AUTO_TEST_CASE(an_edge_of_three_faces)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0.1}, {0.5, -1, 0.1}, {0.5, 0, 1}};
  const Triples triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  for_both_methods([&](const auto& np) {
    const auto components = np.keep_components_separate(true).maximum_number_of_segments(1);
    BOOST_TEST((labels_of_triangles(points, triangles, components) == Labels{0, 0, 1}));
  });
}

// Two solids with a common edge stay apart, although each face at the edge bends less with one of
// the other solid.
BOOST_AUTO_TEST_CASE(an_edge_of_four_faces)
{
  // A dihedral angle of 45 degrees at the edge, and another that is opposite
  const Soup tetrahedron = {
    {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 1, 1)},
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  Soup two = disjoint_union(tetrahedron, tetrahedron);
  for (std::size_t v = 4; v < 8; ++v)
    two.points[v] = Point(two.points[v].x(), -two.points[v].y(), -two.points[v].z());
  for_both_methods([&](const auto& np) {
    const auto components = np.keep_components_separate(true).maximum_number_of_segments(1);
    const Labels expected = {0, 0, 0, 0, 1, 1, 1, 1};
    BOOST_TEST((labels_of_triangles(two, components) == expected));
    Soup at_edge = two;
    for (std::vector<std::size_t>& t : at_edge.triangles)
      for (std::size_t& v : t)
        if (v == 4 || v == 5)
          v -= 4;
    BOOST_TEST((labels_of_triangles(at_edge, components) == expected));
  });
}

BOOST_AUTO_TEST_CASE(points_at_the_same_place_stay_different)
{
  const Soup soup = loose_triangles(sphere(1));
  for_both_methods([&](const auto& np)
    {
      const Labels labels = labels_of_triangles(soup, np.keep_components_separate(true));
      BOOST_TEST(number_of(labels) == soup.triangles.size());
    });
}

BOOST_AUTO_TEST_CASE(no_triangles)
{
  BOOST_TEST(labels_of_triangles(Points(), Triples(), parameters::default_values()).empty());
  const Points nowhere = {{std::numeric_limits<double>::quiet_NaN(), 0, 0}};
  BOOST_TEST(labels_of_triangles(nowhere, Triples(), parameters::default_values()).empty());
}

BOOST_AUTO_TEST_CASE(polygons_other_than_triangles_are_refused)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  typedef std::vector<std::vector<long long> > Any;
  typedef std::invalid_argument Error;
  check_refused<Error>(points, Triples{{0, 1, 2}, {0, 1, 4}}, "triangle 1");
  check_refused<Error>(points, Triples{{0, 1, -1}, {0, 1, 2}}, "triangle 0");
  check_refused<Error>(points, Any{{0, 1, 2}, {0, 1, 1LL << 32}}, "triangle 1");
  check_refused<Error>(points, std::vector<std::array<std::size_t, 3> >{{0, 1, std::size_t(-1)}},
                       "triangle 0");
  check_refused<Error>(points, Any{{0, 1, 2}, {0, 1}}, "fewer than three corners");
  check_refused<Error>(points, Any{{0, 1, 2}, {}}, "fewer than three corners");
  check_refused<Error>(points, Any{{0, 1, 2, 3}, {0, 1, 2}}, "more than three corners");
  for (double bad : {infinity, -infinity, not_a_number})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Points spoiled = points;
      spoiled[3][axis] = bad;
      check_refused<Error>(spoiled, Triples{{0, 1, 2}, {0, 1, 3}}, "not finite");
      // The point is not refused if no triangle has it.
      BOOST_TEST(
        labels_of_triangles(spoiled, Triples{{0, 1, 2}}, parameters::default_values()).size() == 1);
    }
}

BOOST_AUTO_TEST_CASE(an_id_type_that_is_too_small_is_refused)
{
  Points points;
  Triples triangles;
  for (int i = 0; i < 129; ++i) { // far from each other, in a square
    const double x = 100. * (i % 12), y = 100. * (i / 12);
    points.insert(points.end(), {{x, y, 0}, {x + 1, y, 0}, {x, y + 1, 0}});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  check_refused<std::overflow_error, signed char>(points, triangles, "too small");
  triangles.pop_back();
  std::vector<signed char> ids(128);
  BOOST_TEST(CGAL::segment_spectral_recursive(
               points, triangles, boost::make_iterator_property_map(
                 ids.begin(), boost::typed_identity_property_map<std::size_t>())) == 128);
  BOOST_TEST(int(ids.back()) == 127);
}

BOOST_AUTO_TEST_CASE(a_triangle_may_have_a_corner_twice)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for_both_methods([&](const auto& np) {
    const Labels labels =
      labels_of_triangles(points, Triples{{0, 1, 2}, {0, 0, 1}, {2, 2, 2}}, np);
    check_numbering(labels);
  });
}

BOOST_AUTO_TEST_SUITE_END()
