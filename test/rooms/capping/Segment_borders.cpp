// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/capping/Segment_borders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(segment_borders)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Arc;
using internal::Border;
using internal::Corners;
using internal::Loop;
using internal::null_index;
using internal::Segment_borders;
using internal::Vector;
using internal::Vertex_pair;
using internal::vertex_pair;

namespace {

typedef std::vector<std::vector<Corners> > Segments; // the triangles of each

// Returns a segment for each label.
template <class Label>
Segments segments_of(const Soup& soup, const Label& label)
{
  Segments result;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& t = soup.triangles[f];
    result.resize((std::max)(result.size(), std::size_t(label(f)) + 1));
    result[label(f)].push_back({Index(t[0]), Index(t[1]), Index(t[2])});
  }
  return result;
}

// Returns the edges that an odd number of triangles have. The value is the number of times that
// they pass it upwards, less the number of times downwards.
std::map<Vertex_pair, int> odd_edges(const std::vector<Corners>& triangles)
{
  std::map<Vertex_pair, int> number, direction;
  for (const Corners& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const Index v = t[i], w = t[(i + 1) % 3];
      ++number[vertex_pair(v, w)];
      direction[vertex_pair(v, w)] += v < w ? 1 : -1;
    }
  for (const auto& [edge, n] : number)
    if (n % 2 == 0)
      direction.erase(edge);
  return direction;
}

std::map<Vertex_pair, int> directions_of(const Border& border)
{
  std::map<Vertex_pair, int> result;
  for (const auto& [edge, border_edge] : border)
    result[edge] = border_edge.direction;
  return result;
}

// Makes a regular polygon with sides of length 1.
std::vector<Vector> polygon(std::size_t n)
{
  std::vector<Vector> result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(Vector(std::cos(2 * pi * double(i) / double(n)),
                            std::sin(2 * pi * double(i) / double(n)), 0) /
                     (2 * std::sin(pi / double(n))));
  return result;
}

Loop loop_of(std::size_t n)
{
  Loop result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

// Returns the segments of arcs around a polygon whose sides have these neighbors.
std::vector<Index> long_arcs(const std::vector<Index>& neighbors, std::vector<double>& lengths)
{
  const std::size_t n = neighbors.size();
  Segments segments(1 + *std::max_element(neighbors.begin(), neighbors.end()));
  const Index center = Index(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index v = Index(i), w = Index((i + 1) % n);
    segments[0].push_back({v, w, center});
    segments[neighbors[i]].push_back({w, v, center + 1});
  }
  Loop loop = loop_of(n);
  std::vector<Index> result;
  for (const Arc& a : Segment_borders(segments).long_arcs(polygon(n), loop, 0)) {
    result.push_back(a.segment);
    lengths.push_back(a.length);
    BOOST_TEST(a.length == double(a.end - a.begin), tt::tolerance(1e-9));
    const bool begins_there = neighbors[loop[a.begin]] == a.segment,
               ends_there = neighbors[loop[a.end - 1]] == a.segment;
    BOOST_TEST((begins_there || ends_there)); // another arc may have joined it at one end
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(borders_have_the_edges_of_an_odd_number_of_triangles)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const Soup soup = random_triangles(random, 10, 30);
    const Segments segments = segments_of(soup, [](std::size_t f) { return f % 3; });
    const Segment_borders borders(segments);
    std::vector<Corners> all;
    std::vector<char> is_at_border(soup.points.size(), 0);
    for (Index s = 0; s < segments.size(); ++s) {
      BOOST_TEST((directions_of(borders.border(s)) == odd_edges(segments[s])));
      all.insert(all.end(), segments[s].begin(), segments[s].end());
      for (const auto& [edge, border_edge] : borders.border(s)) {
        is_at_border[edge.first] = is_at_border[edge.second] = 1;
        bool has_triangle = false;
        for (const Corners& t : segments[s])
          has_triangle |= std::set<Index>(t.begin(), t.end()) ==
                          std::set<Index>{edge.first, edge.second, border_edge.apex};
        BOOST_TEST(has_triangle);
      }
    }
    BOOST_TEST((borders.vertices(soup.points.size()) == is_at_border));
    std::set<Vertex_pair> surface_border, expected;
    for (const auto& entry : borders.border_of_surface())
      surface_border.insert(entry.first);
    for (const auto& entry : odd_edges(all))
      expected.insert(entry.first);
    BOOST_TEST((surface_border == expected));
  }
}

BOOST_AUTO_TEST_CASE(added_triangles_count_like_given_ones)
{
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const Soup soup = random_triangles(random, 8, 30);
    const Segments all = segments_of(soup, [](std::size_t f) { return f % 2; });
    Segments first = all;
    std::vector<Corners> added;
    if (all.size() < 2)
      continue;
    added.assign(all[1].begin() + std::ptrdiff_t(all[1].size() / 2), all[1].end());
    first[1].resize(all[1].size() / 2);
    Segment_borders borders(first);
    for (const Corners& t : added)
      borders.add_triangle(1, t);
    const Segment_borders expected(all);
    const auto edges = [](const Border& border) {
      std::set<Vertex_pair> result;
      for (const auto& entry : border)
        result.insert(entry.first);
      return result;
    };
    for (Index s : {0, 1})
      BOOST_TEST((edges(borders.border(s)) == edges(expected.border(s))));
    BOOST_TEST((edges(borders.border_of_surface()) == edges(expected.border_of_surface())));
  }
}

BOOST_AUTO_TEST_CASE(loops_use_each_border_edge_once_and_no_vertex_twice)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Soup soup = random_triangles(random, 12, 30);
    const Border border =
      Segment_borders(segments_of(soup, [](std::size_t) { return 0; })).border(0);
    std::set<Vertex_pair> edges;
    for (const Loop& loop : internal::split_into_loops(border)) {
      BOOST_TEST(loop.size() >= 3u);
      BOOST_TEST(std::set<Index>(loop.begin(), loop.end()).size() == loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vertex_pair edge = vertex_pair(loop[i], loop[(i + 1) % loop.size()]);
        BOOST_TEST(edges.insert(edge).second);
        BOOST_TEST(border.count(edge) == 1u);
      }
    }
    BOOST_TEST(edges.size() == border.size());
  }
}

// Two squares of a checkerboard meet in a vertex. Each has a loop, against its triangles.
BOOST_AUTO_TEST_CASE(loops_run_against_the_triangles)
{
  const Soup soup = plate(2, 2);
  const Segments segments = segments_of(soup, [](std::size_t f) { return (f / 2 + f / 4) % 2; });
  for (const std::vector<Corners>& triangles : segments) {
    const auto loops = internal::split_into_loops(Segment_borders(segments).border(
      Index(&triangles - segments.data())));
    BOOST_TEST(loops.size() == 2u);
    std::set<std::vector<Index> > directed;
    for (const Corners& t : triangles)
      for (int i = 0; i < 3; ++i)
        directed.insert({t[(i + 1) % 3], t[i]});
    for (const Loop& loop : loops) {
      BOOST_TEST(loop.size() == 4u);
      for (std::size_t i = 0; i < loop.size(); ++i)
        BOOST_TEST(directed.count({loop[i], loop[(i + 1) % loop.size()]}) == 1u);
    }
  }
}

// Arcs of less than a tenth of the loop go to the longer arc beside them.
BOOST_AUTO_TEST_CASE(short_arcs_join_the_longer_arc_beside_them)
{
  const auto arcs_of = [](const std::vector<Index>& numbers) { // the length of arcs 1, 2, ...
    std::vector<Index> neighbors;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      neighbors.insert(neighbors.end(), numbers[i], Index(i + 1));
    std::vector<double> lengths;
    const std::vector<Index> segments = long_arcs(neighbors, lengths);
    std::map<Index, double> result;
    for (std::size_t i = 0; i < segments.size(); ++i)
      result[segments[i]] += std::round(lengths[i]);
    return result;
  };
  typedef std::map<Index, double> Lengths;
  BOOST_TEST((arcs_of({20}) == Lengths{{1, 20}}));
  BOOST_TEST((arcs_of({10, 6, 4}) == Lengths{{1, 10}, {2, 6}, {3, 4}}));
  BOOST_TEST((arcs_of({89, 11}) == Lengths{{1, 89}, {2, 11}}));
  BOOST_TEST((arcs_of({91, 9}) == Lengths{{1, 100}}));
  BOOST_TEST((arcs_of({10, 1, 9}) == Lengths{{1, 11}, {3, 9}}));
  BOOST_TEST((arcs_of({9, 1, 10}) == Lengths{{1, 9}, {3, 11}}));
  BOOST_TEST((arcs_of({1, 9, 10}) == Lengths{{2, 9}, {3, 11}})); // the first is after the last
  std::vector<double> lengths;
  std::vector<Index> many(104);
  for (std::size_t i = 0; i < many.size(); ++i)
    many[i] = i % 2 == 0 ? 1 : 2 + (i % 4) / 2;
  BOOST_TEST(long_arcs(many, lengths) == std::vector<Index>{1}, tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
