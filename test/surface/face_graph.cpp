// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <boost/graph/graph_concepts.hpp>

#include <cstddef>
#include <set>
#include <utility>

BOOST_AUTO_TEST_SUITE(face_graph)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::null_index;

namespace {

std::size_t number_of_border_edges(const Face_graph& graph)
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
    const Face_graph graph = face_graph_of(soup);
    BOOST_REQUIRE(graph.number_of_faces() == soup.triangles.size());
    BOOST_REQUIRE(graph.number_of_halfedges() == 3 * soup.triangles.size());
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      const Index from = graph.source_vertex(h), to = graph.target_vertex(h);
      Index expected = h / 3;
      for (Index g = 0; g < soup.triangles.size(); ++g)
        for (std::size_t i = 0; i < 3; ++i)
          if (soup.triangles[g][i] == to && soup.triangles[g][(i + 1) % 3] == from)
            expected = g;
      BOOST_TEST(graph.neighbors[h] == expected);
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

BOOST_AUTO_TEST_CASE(border_edges_are_counted)
{
  BOOST_TEST(number_of_border_edges(face_graph_of(plate(4, 3))) == 2u * (4 + 3));
  BOOST_TEST(number_of_border_edges(face_graph_of(sphere(1))) == 0u);
  BOOST_TEST(number_of_border_edges(face_graph_of(torus(2, 0.5, 6, 5))) == 0u);
  BOOST_TEST(number_of_border_edges(
               face_graph_of(surface_of_revolution({{0, 1}, {1, 1}, {2, 1}}, 8))) == 2u * 8);
}

BOOST_AUTO_TEST_CASE(faces_that_are_glued_on_all_edges_have_three_pairs_of_half_edges)
{
  const Face_graph graph = face_graph_of(pillow());
  std::set<Index> opposites;
  for (Index h = 0; h < 3; ++h) {
    BOOST_TEST(graph.neighbors[h] == 1u);
    BOOST_TEST(graph.neighbors[3 + h] == 0u);
    BOOST_TEST(graph.opposite(graph.opposite(h)) == h);
    opposites.insert(graph.opposite(h));
  }
  BOOST_TEST(opposites == (std::set<Index>{3, 4, 5}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(an_edge_whose_sides_do_not_match_counts_as_border)
{
  // Each face says that it is next to the other at its first edge, but they run along it alike; at
  // its last edge the first face is glued to itself.
  Triangles triangles;
  triangles.corners = {{0, 1, 2}, {0, 1, 3}};
  triangles.neighbors = {{1, 0, 0}, {0, 1, 1}};
  triangles.points.resize(4);
  const Face_graph graph =
    CGAL::Spectral_segmentation::internal::face_graph(sequential, std::move(triangles));
  BOOST_TEST(number_of_border_edges(graph) == 6u);
}

BOOST_AUTO_TEST_CASE(it_is_a_graph_of_the_boost_graph_library)
{
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraphConcept<Face_graph>));
  BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraphConcept<Face_graph>));
  const Face_graph graph = face_graph_of(plate(4, 3));
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
    const auto around = graph.neighbors.begin() + 3 * *f;
    BOOST_TEST(targets == std::multiset<Index>(around, around + 3), tt::per_element());
  }
  BOOST_TEST(next == 24u);
}

BOOST_AUTO_TEST_SUITE_END()
