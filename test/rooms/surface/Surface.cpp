// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(surface)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Corners;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::normalize;
using CGAL::Spectral_segmentation::internal::null_index;
using CGAL::Spectral_segmentation::internal::start_at_smallest_vertices;

namespace {

std::size_t number_of_border_edges(const Surface& graph)
{
  std::size_t n = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    n += graph.is_border(h);
  return n;
}

} // namespace

BOOST_AUTO_TEST_CASE(each_half_edge_leads_to_the_face_with_the_reverse_edge)
{
  for (const Soup& soup : small_soups()) {
    const Surface graph = surface_of(soup);
    BOOST_REQUIRE(graph.number_of_faces() == soup.triangles.size());
    BOOST_REQUIRE(graph.number_of_halfedges() == 3 * soup.triangles.size());
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      const Index from = graph.source_vertex(h), to = graph.target_vertex(h);
      Index expected = h / 3;
      for (Index g = 0; g < soup.triangles.size(); ++g)
        for (std::size_t i = 0; i < 3; ++i)
          if (soup.triangles[g][i] == to && soup.triangles[g][(i + 1) % 3] == from)
            expected = g;
      BOOST_TEST(graph.neighbor(h) == expected);
      BOOST_TEST(graph.is_border(h) == (expected == h / 3));
      if (!graph.is_border(h)) {
        const Index o = graph.opposite[h];
        BOOST_REQUIRE(o != null_index);
        BOOST_TEST(o / 3 == expected);
        BOOST_TEST(graph.source_vertex(o) == to);
        BOOST_TEST(graph.target_vertex(o) == from);
        BOOST_TEST(graph.opposite[o] == h);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(border_edges_are_counted)
{
  BOOST_TEST(number_of_border_edges(surface_of(plate(4, 3))) == 2u * (4 + 3));
  BOOST_TEST(number_of_border_edges(surface_of(sphere(1))) == 0u);
  BOOST_TEST(number_of_border_edges(surface_of(torus(2, 0.5, 6, 5))) == 0u);
  BOOST_TEST(number_of_border_edges(
               surface_of(surface_of_revolution({{0, 1}, {1, 1}, {2, 1}}, 8))) == 2u * 8);
}

BOOST_AUTO_TEST_CASE(faces_that_are_glued_on_all_edges_have_three_pairs_of_half_edges)
{
  const Surface graph = surface_of(pillow());
  std::set<Index> opposites;
  for (Index h = 0; h < 3; ++h) {
    BOOST_TEST(graph.neighbor(h) == 1u);
    BOOST_TEST(graph.neighbor(3 + h) == 0u);
    BOOST_TEST(graph.opposite[graph.opposite[h]] == h);
    opposites.insert(graph.opposite[h]);
  }
  BOOST_TEST(opposites == (std::set<Index>{3, 4, 5}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(it_is_a_graph_of_the_boost_graph_library)
{
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraphConcept<Surface>));
  BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraphConcept<Surface>));
  static_assert(boost::is_directed_graph<Surface>::value && boost::is_multigraph<Surface>::value);
  static_assert(boost::is_vertex_list_graph<Surface>::value &&
                boost::is_incidence_graph<Surface>::value &&
                !boost::is_bidirectional_graph<Surface>::value &&
                !boost::is_edge_list_graph<Surface>::value);
  for (const Soup& soup : small_soups()) {
    const Surface graph = surface_of(soup);
    BOOST_TEST(num_vertices(graph) == soup.triangles.size());
    Index next = 0;
    std::set<Index> edges;
    for (auto [f, end] = vertices(graph); f != end; ++f) {
      BOOST_TEST(*f == next++);
      BOOST_TEST(out_degree(*f, graph) == 3u);
      std::multiset<Index> targets;
      for (auto [e, last] = out_edges(*f, graph); e != last; ++e) {
        BOOST_TEST(source(*e, graph) == *f);
        targets.insert(target(*e, graph));
        BOOST_TEST(edges.insert(*e).second); // one descriptor for each direction
      }
      BOOST_TEST(targets == (std::multiset<Index>{graph.neighbor(3 * *f),
                                                  graph.neighbor(3 * *f + 1),
                                                  graph.neighbor(3 * *f + 2)}), tt::per_element());
    }
    BOOST_TEST(next == num_vertices(graph));
    for (Index e : edges) {
      BOOST_TEST(source(graph.opposite[e], graph) == target(e, graph));
      BOOST_TEST(target(graph.opposite[e], graph) == source(e, graph));
      BOOST_TEST(graph.is_border(e) == (source(e, graph) == target(e, graph))); // a loop
    }
  }
}

BOOST_AUTO_TEST_CASE(points_are_normalized_by_a_power_of_two)
{
  for (const Soup& soup : small_soups()) {
    const Surface graph = surface_of(soup);
    const double unit = unit_of(soup);
    int exponent;
    BOOST_TEST(std::frexp(unit, &exponent) == 0.5);
    double largest = 0;
    for (const auto& p : graph.points)
      largest = std::max(largest, std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}));
    BOOST_TEST(largest <= 1);
    BOOST_TEST(largest >= 0.5);
    for (std::size_t v = 1; v < soup.points.size(); ++v) {
      const auto original = soup.points[v] - soup.points[0];
      const auto normalized = unit * (graph.points[v] - graph.points[0]);
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(original[i] - normalized[i]) < 1e-14 * unit);
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      const std::vector<std::size_t>& t = soup.triangles[f];
      const double squared = CGAL::squared_area(soup.points[t[0]], soup.points[t[1]],
                                                soup.points[t[2]]);
      BOOST_TEST(graph.areas[f] * unit * unit == std::sqrt(squared),
                 tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_scaled_by_a_power_of_two_gives_the_same_arrays)
{
  const Soup soup = sphere(2);
  const Surface graph = surface_of(soup);
  for (int exponent : {-300, -40, -1, 1, 40, 300}) {
    Soup scaled = soup;
    for (Point& p : scaled.points)
      p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                std::ldexp(p.z(), exponent));
    const Surface other = surface_of(scaled);
    BOOST_TEST((other.points == graph.points));
    BOOST_TEST((other.areas == graph.areas));
    BOOST_TEST(unit_of(scaled) == std::ldexp(unit_of(soup), exponent));
  }
}

BOOST_AUTO_TEST_CASE(points_that_are_one_and_no_points_keep_their_unit)
{
  std::vector<Vector> points(4, Vector(7, 7, 7));
  BOOST_TEST(normalize(points) == 1);
  for (const Vector& p : points)
    BOOST_TEST(p.is_zero());
  std::vector<Vector> none;
  BOOST_TEST(normalize(none) == 1);
}

BOOST_AUTO_TEST_CASE(the_largest_coordinates_do_not_overflow)
{
  const double largest = std::numeric_limits<double>::max();
  std::vector<Vector> points = {Vector(-largest, 0, 0), Vector(largest, largest, 0)};
  const double unit = normalize(points);
  BOOST_TEST(std::isfinite(unit));
  BOOST_TEST((points[1] - points[0]).x() / 2 == largest / unit);
}

BOOST_AUTO_TEST_CASE(a_face_and_its_neighbors_turn_together)
{
  Surface surface;
  surface.corners = {{7, 9, 4}, {9, 7, 5}};
  surface.opposite = {3, 1, 2, 0, 4, 5};
  start_at_smallest_vertices(surface);
  BOOST_TEST((surface.corners == std::vector<Corners>{{4, 7, 9}, {5, 9, 7}}));
  BOOST_TEST((surface.opposite == std::vector<Index>{0, 4, 2, 3, 1, 5}));
}

BOOST_AUTO_TEST_SUITE_END()
