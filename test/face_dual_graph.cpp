// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/order_of_locality.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/read_triangles.h>

#include <boost/graph/graph_concepts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(face_dual_graph)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::connected_components;
using CGAL::Spectral_segmentation::internal::in_order;
using CGAL::Spectral_segmentation::internal::neighbors;
using CGAL::Spectral_segmentation::internal::null_index;
using CGAL::Spectral_segmentation::internal::order_of_locality;
using CGAL::Spectral_segmentation::internal::split;
using CGAL::Spectral_segmentation::internal::total_area;
using CGAL::Spectral_segmentation::internal::Triangles;

namespace {

const std::vector<Soup>& soups()
{
  static const std::vector<Soup> result = {
    plate(1, 1), plate(4, 3), sphere(0), sphere(2), torus(2, 0.7, 3, 3), torus(2, 0.7, 9, 5),
    surface_of_revolution({{0, 0}, {1, 1}, {2, 1}}, 7), dumbbell(6, 4),
    connected_sum(torus(2, 0.7, 5, 4), torus(3, 1, 4, 6)), disjoint_union(sphere(0), plate(2, 2))};
  return result;
}

std::size_t number_of_border_edges(const Face_dual_graph& graph)
{
  std::size_t n = 0;
  for (Index h = 0; h < graph.halfedges.size(); ++h)
    n += graph.is_border(h);
  return n;
}

// Two triangles glued on all three edges.
Soup pillow() { return {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}, {2, 1, 0}}}; }

} // namespace

BOOST_AUTO_TEST_CASE(each_half_edge_leads_to_the_face_with_the_reverse_edge)
{
  for (const Soup& soup : soups()) {
    const Face_dual_graph graph = dual_graph_of(soup);
    BOOST_REQUIRE(graph.number_of_faces() == soup.triangles.size());
    BOOST_REQUIRE(graph.halfedges.size() == 3 * soup.triangles.size());
    for (Index h = 0; h < graph.halfedges.size(); ++h) {
      const Index from = graph.source_vertex(h), to = graph.target_vertex(h);
      Index expected = h / 3;
      for (Index g = 0; g < soup.triangles.size(); ++g)
        for (std::size_t i = 0; i < 3; ++i)
          if (soup.triangles[g][i] == to && soup.triangles[g][(i + 1) % 3] == from)
            expected = g;
      BOOST_TEST(graph.halfedges[h].neighbor == expected);
      BOOST_TEST(graph.is_border(h) == (expected == h / 3));
      if (!graph.is_border(h)) {
        const Index o = graph.opposite(h);
        BOOST_REQUIRE(o != null_index);
        BOOST_TEST(o / 3 == expected);
        BOOST_TEST(graph.source_vertex(o) == to);
        BOOST_TEST(graph.target_vertex(o) == from);
        BOOST_TEST(graph.opposite(o) == h);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_first_corner_is_the_smallest_vertex_whatever_the_mesh_starts_with)
{
  for (Soup soup : soups()) {
    const Face_dual_graph graph = dual_graph_of(soup);
    for (Index f = 0; f < graph.number_of_faces(); ++f) {
      std::vector<std::size_t> corners = soup.triangles[f];
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      BOOST_TEST(graph.corners[f] == corners, tt::per_element());
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      std::rotate(soup.triangles[f].begin(),
                  soup.triangles[f].begin() + static_cast<std::ptrdiff_t>(f % 3),
                  soup.triangles[f].end());
    const Face_dual_graph rotated = dual_graph_of(soup);
    BOOST_TEST((rotated.corners == graph.corners));
    BOOST_TEST((neighbors(rotated) == neighbors(graph)));
    BOOST_TEST((rotated.areas == graph.areas));
  }
}

BOOST_AUTO_TEST_CASE(border_edges_are_counted)
{
  BOOST_TEST(number_of_border_edges(dual_graph_of(plate(4, 3))) == 2u * (4 + 3));
  BOOST_TEST(number_of_border_edges(dual_graph_of(sphere(1))) == 0u);
  BOOST_TEST(number_of_border_edges(dual_graph_of(torus(2, 0.5, 6, 5))) == 0u);
  BOOST_TEST(number_of_border_edges(
               dual_graph_of(surface_of_revolution({{0, 1}, {1, 1}, {2, 1}}, 8))) == 2u * 8);
}

BOOST_AUTO_TEST_CASE(faces_that_are_glued_on_all_edges_have_three_pairs_of_half_edges)
{
  const Face_dual_graph graph = dual_graph_of(pillow());
  std::set<Index> opposites;
  for (Index h = 0; h < 3; ++h) {
    BOOST_TEST(graph.halfedges[h].neighbor == 1u);
    BOOST_TEST(graph.halfedges[3 + h].neighbor == 0u);
    BOOST_TEST(graph.opposite(graph.opposite(h)) == h);
    opposites.insert(graph.opposite(h));
  }
  BOOST_TEST(opposites == (std::set<Index>{3, 4, 5}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(it_is_a_graph_of_the_boost_graph_library)
{
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraphConcept<Face_dual_graph>));
  BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraphConcept<Face_dual_graph>));
  const Face_dual_graph graph = dual_graph_of(plate(4, 3));
  BOOST_TEST(num_vertices(graph) == 24u);
  Index next = 0;
  for (auto [f, end] = vertices(graph); f != end; ++f) {
    BOOST_TEST(*f == next++);
    BOOST_TEST(out_degree(*f, graph) == 3u);
    std::multiset<Index> targets;
    for (auto [e, last] = out_edges(*f, graph); e != last; ++e) {
      BOOST_TEST(source(*e, graph) == *f);
      targets.insert(target(*e, graph));
    }
    const auto around = neighbors(graph)[*f];
    BOOST_TEST(targets == std::multiset<Index>(around.begin(), around.end()), tt::per_element());
  }
  BOOST_TEST(next == 24u);
}

BOOST_AUTO_TEST_CASE(points_are_normalized_by_a_power_of_two)
{
  for (const Soup& soup : soups()) {
    const Face_dual_graph graph = dual_graph_of(soup);
    int exponent;
    BOOST_TEST(std::frexp(graph.unit, &exponent) == 0.5);
    double largest = 0;
    for (const auto& p : graph.points)
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    BOOST_TEST(largest <= 1);
    BOOST_TEST(largest >= 0.5);
    for (std::size_t v = 1; v < soup.points.size(); ++v) {
      const auto original = soup.points[v] - soup.points[0];
      const auto normalized = graph.unit * (graph.points[v] - graph.points[0]);
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(original[i] - normalized[i]) < 1e-14 * graph.unit);
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      const std::vector<std::size_t>& t = soup.triangles[f];
      const double squared = CGAL::squared_area(soup.points[t[0]], soup.points[t[1]],
                                                soup.points[t[2]]);
      BOOST_TEST(graph.areas[f] * graph.unit * graph.unit == std::sqrt(squared),
                 tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_scaled_by_a_power_of_two_gives_the_same_arrays)
{
  const Soup soup = sphere(2);
  const Face_dual_graph graph = dual_graph_of(soup);
  for (int exponent : {-300, -40, -1, 1, 40, 300}) {
    Soup scaled = soup;
    for (Point& p : scaled.points)
      p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                std::ldexp(p.z(), exponent));
    const Face_dual_graph other = dual_graph_of(scaled);
    BOOST_TEST((other.points == graph.points));
    BOOST_TEST((other.areas == graph.areas));
    BOOST_TEST(other.unit == std::ldexp(graph.unit, exponent));
  }
}

BOOST_AUTO_TEST_CASE(vertices_without_a_face_do_not_count)
{
  const Soup soup = sphere(1);
  const Face_dual_graph graph = dual_graph_of(soup);
  for (double x : {1e6, std::numeric_limits<double>::quiet_NaN()}) {
    Mesh mesh = mesh_of(soup);
    mesh.add_vertex(Point(x, 0, 0));
    const Face_dual_graph other = dual_graph_of(mesh);
    BOOST_TEST(other.unit == graph.unit);
    BOOST_TEST((other.areas == graph.areas));
    BOOST_TEST((other.corners == graph.corners));
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_that_is_one_point_and_an_empty_mesh_are_read)
{
  Soup soup = plate(1, 1);
  for (Point& p : soup.points)
    p = Point(7, 7, 7);
  const Face_dual_graph point = dual_graph_of(soup);
  BOOST_TEST(point.unit == 1);
  BOOST_TEST(total_area(point) == 0);
  BOOST_TEST(dual_graph_of(Soup()).number_of_faces() == 0u);
}

BOOST_AUTO_TEST_CASE(what_is_not_a_finite_triangle_mesh_is_refused)
{
  for (double bad : {std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::quiet_NaN()}) {
    Soup soup = plate(2, 2);
    soup.points[3] = Point(1, bad, 0);
    BOOST_CHECK_THROW(dual_graph_of(soup), std::invalid_argument);
  }
  const Mesh quad = mesh_of({{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)},
                             {{0, 1, 2, 3}}});
  BOOST_CHECK_THROW(triangles_of(quad), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(neighbors_are_near_in_the_order_of_locality_whatever_the_order_was)
{
  Random random(1);
  Soup soup = sphere(5);
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
  const Triangles triangles = triangles_of(mesh_of(soup));
  const std::vector<Index> order = order_of_locality(triangles.neighbors);
  std::vector<Index> place(order.size(), null_index);
  for (Index i = 0; i < order.size(); ++i)
    place[order[i]] = i;
  BOOST_TEST(std::count(place.begin(), place.end(), null_index) == 0); // all are in it

  const Face_dual_graph graph = dual_graph_of(soup);
  std::size_t number_of_near = 0;
  for (Index h = 0; h < graph.halfedges.size(); ++h)
    number_of_near += std::abs(double(place[h / 3]) - place[graph.halfedges[h].neighbor]) < 1024;
  // A block of 1024 has about 4 * 32 edges to others, of 1536.
  BOOST_TEST(double(number_of_near) > 0.9 * double(graph.halfedges.size()));
}

BOOST_AUTO_TEST_CASE(components_keep_their_order)
{
  const Soup soup = disjoint_union(disjoint_union(sphere(1), plate(2, 2)), sphere(0));
  const std::vector<Index> order = order_of_locality(triangles_of(mesh_of(soup)).neighbors);
  const std::size_t first = sphere(1).triangles.size(), second = plate(2, 2).triangles.size();
  for (std::size_t i = 0; i < order.size(); ++i) {
    BOOST_TEST((order[i] < first) == (i < first));
    BOOST_TEST((order[i] < first + second) == (i < first + second));
  }
}

BOOST_AUTO_TEST_CASE(triangles_in_another_order_are_the_same_triangles)
{
  Random random(1);
  for (const Soup& soup : soups()) {
    Mesh mesh = mesh_of(soup);
    mesh.add_vertex(Point(0, 0, 0)); // without a face
    const Triangles triangles = triangles_of(mesh);
    std::vector<Index> order(soup.triangles.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), random);
    const Triangles other = in_order(triangles, order);
    BOOST_TEST(other.unit == triangles.unit);
    BOOST_REQUIRE(other.corners.size() == order.size());
    BOOST_REQUIRE(other.neighbors.size() == order.size());
    BOOST_TEST(other.points.size() == soup.points.size());
    Index number_of_vertices = 0;
    for (Index f = 0; f < order.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Index v = other.corners[f][i];
        BOOST_TEST((other.points[v] == triangles.points[triangles.corners[order[f]][i]]));
        BOOST_TEST(order[other.neighbors[f][i]] == triangles.neighbors[order[f]][i]);
        BOOST_TEST(v <= number_of_vertices); // each comes after those before it
        number_of_vertices = std::max(number_of_vertices, v + 1);
      }
  }
}

BOOST_AUTO_TEST_CASE(components_are_numbered_by_their_first_faces)
{
  const std::vector<Soup> pieces = {plate(2, 2), sphere(0), torus(2, 0.5, 4, 3), pillow()};
  Soup soup;
  std::vector<std::size_t> piece;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    soup = disjoint_union(soup, pieces[i]);
    piece.resize(soup.triangles.size(), i);
  }
  Random random(1);
  for (int run = 0; run < 20; ++run) {
    for (std::size_t f = piece.size() - 1; f > 0; --f) {
      const std::size_t other = random() % (f + 1);
      std::swap(piece[f], piece[other]);
      std::swap(soup.triangles[f], soup.triangles[other]);
    }
    std::size_t number = 0;
    const std::vector<Index> component = connected_components(dual_graph_of(soup), number);
    BOOST_TEST(number == pieces.size());
    std::vector<std::size_t> order; // of the pieces, by their first faces
    for (std::size_t f = 0; f < piece.size(); ++f) {
      auto found = std::find(order.begin(), order.end(), piece[f]);
      if (found == order.end())
        found = order.insert(found, piece[f]);
      BOOST_TEST(component[f] == static_cast<std::size_t>(found - order.begin()));
    }
  }
}

BOOST_AUTO_TEST_CASE(faces_that_share_only_a_vertex_are_not_connected)
{
  const Face_dual_graph graph = dual_graph_of(plate(2, 2));
  // The squares at two opposite corners touch in the middle.
  std::vector<std::size_t> piece(8, 1);
  piece[0] = piece[1] = piece[6] = piece[7] = 0;
  std::size_t number = 0;
  connected_components(split(graph, piece, 2)[0], number);
  BOOST_TEST(number == 2u);
  BOOST_TEST(connected_components(Face_dual_graph(), number).empty());
  BOOST_TEST(number == 0u);
}

BOOST_AUTO_TEST_CASE(pieces_keep_their_faces_and_the_edges_between_them)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Face_dual_graph graph =
        graph_with_distances(displaced(soups()[seed % soups().size()], 0.1, random));
      const std::size_t n = graph.number_of_faces(), number_of_pieces = 1 + random() % 4;
      std::vector<std::size_t> piece(n);
      for (std::size_t& p : piece)
        p = random() % number_of_pieces;

      const std::vector<Face_dual_graph> parts = split(graph, piece, number_of_pieces);
      BOOST_REQUIRE(parts.size() == number_of_pieces);
      for (std::size_t p = 0; p < number_of_pieces; ++p) {
        const Face_dual_graph& part = parts[p];
        std::vector<Index> faces;
        std::set<Index> used_vertices;
        for (Index f = 0; f < n; ++f)
          if (piece[f] == p) {
            faces.push_back(f);
            used_vertices.insert(graph.corners[f].begin(), graph.corners[f].end());
          }
        BOOST_TEST(part.unit == graph.unit);
        BOOST_TEST(part.points.size() == used_vertices.size());
        BOOST_REQUIRE(part.number_of_faces() == faces.size());
        BOOST_REQUIRE(part.halfedges.size() == 3 * faces.size());
        for (Index k = 0; k < faces.size(); ++k) {
          BOOST_TEST(part.areas[k] == graph.areas[faces[k]]);
          for (Index i = 0; i < 3; ++i) {
            const Index h = 3 * k + i, old = 3 * faces[k] + i;
            BOOST_TEST((part.points[part.corners[k][i]] ==
                        graph.points[graph.corners[faces[k]][i]]));
            const Index across = graph.halfedges[old].neighbor;
            BOOST_TEST(faces[part.halfedges[h].neighbor] ==
                       (piece[across] == p ? across : faces[k]));
            BOOST_TEST(part.halfedges[h].geodesic == graph.halfedges[old].geodesic);
            BOOST_TEST(part.halfedges[h].angle == graph.halfedges[old].angle);
            BOOST_TEST(part.halfedges[h].combined == graph.halfedges[old].combined);
            BOOST_TEST(part.halfedges[h].concavity == graph.halfedges[old].concavity);
            BOOST_TEST(part.halfedges[h].centroids == graph.halfedges[old].centroids);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
