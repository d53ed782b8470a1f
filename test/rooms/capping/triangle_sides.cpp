// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/capping/triangle_sides.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(triangle_sides)

using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Corners;

namespace {

typedef std::vector<Corners> Triangles;

Triangles triangles_of(const Soup& soup)
{
  Triangles result;
  for (const auto& t : soup.triangles)
    result.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
  return result;
}

bool is_closed(const Triangles& triangles)
{ return internal::is_closed(internal::sorted_sides(triangles)); }

bool is_manifold(const Triangles& triangles)
{ return internal::is_manifold(triangles, internal::sorted_sides(triangles)); }

// Returns how often each directed edge occurs.
std::map<std::pair<Index, Index>, int> directed_edges(const Triangles& triangles)
{
  std::map<std::pair<Index, Index>, int> result;
  for (const Corners& t : triangles)
    for (int i = 0; i < 3; ++i)
      ++result[{t[i], t[(i + 1) % 3]}];
  return result;
}

bool is_closed_by_definition(const Triangles& triangles)
{
  const auto edges = directed_edges(triangles);
  for (const auto& [edge, number] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (number != 1 || opposite == edges.end() || opposite->second != 1)
      return false;
  }
  return true;
}

// Walks around each vertex.
bool is_manifold_by_definition(const Triangles& triangles)
{
  for (const auto& entry : directed_edges(triangles))
    if (entry.second != 1)
      return false;
  std::map<Index, std::set<std::pair<Index, Index> > > rings; // the edges opposite of each vertex
  for (const Corners& t : triangles)
    for (int i = 0; i < 3; ++i)
      rings[t[i]].emplace(t[(i + 1) % 3], t[(i + 2) % 3]);
  for (const auto& entry : rings) {
    std::set<std::pair<Index, Index> > ring = entry.second;
    std::set<Index> reached = {ring.begin()->first};
    for (bool is_growing = true; is_growing;) {
      is_growing = false;
      for (auto edge = ring.begin(); edge != ring.end();)
        if (reached.count(edge->first) + reached.count(edge->second) > 0) {
          reached.insert({edge->first, edge->second});
          edge = ring.erase(edge);
          is_growing = true;
        }
        else
          ++edge;
    }
    if (!ring.empty())
      return false;
  }
  return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(sides_are_sorted_by_their_edge)
{
  Random random(1);
  const Triangles triangles = triangles_of(random_triangles(random, 9, 40));
  const std::vector<internal::Triangle_side> sides = internal::sorted_sides(triangles);
  BOOST_TEST(sides.size() == 3 * triangles.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const internal::Triangle_side& s = sides[i];
    if (i > 0)
      BOOST_TEST((sides[i - 1] < s));
    const Corners& t = triangles[s.triangle()];
    BOOST_TEST(s.vertices.first < s.vertices.second);
    BOOST_TEST(t[s.corners[0] % 3] == s.vertices.first);
    BOOST_TEST(t[s.corners[1] % 3] == s.vertices.second);
    BOOST_TEST(s.corners[1] / 3 == s.triangle());
    BOOST_TEST(s.is_forward == (s.corners[1] % 3 == (s.corners[0] + 1) % 3));
    BOOST_TEST(t[s.apex()] == t[0] + t[1] + t[2] - s.vertices.first - s.vertices.second);
  }
  std::size_t number = 0;
  internal::for_each_edge(sides, [&](std::size_t first, std::size_t n) {
    BOOST_TEST(first == number);
    number += n;
    if (number < sides.size())
      BOOST_TEST((sides[number - 1].vertices < sides[number].vertices));
    BOOST_TEST((sides[first].vertices == sides[number - 1].vertices));
  });
  BOOST_TEST(number == sides.size());
}

// Surfaces lose a triangle, get one turned around, or have two vertices joined.
BOOST_AUTO_TEST_CASE(closed_surfaces_and_manifolds_are_as_defined)
{
  Random random(2);
  std::set<std::pair<bool, bool> > kinds;
  std::vector<Soup> soups = small_soups();
  soups.push_back(pillow());
  soups.push_back(fan_at_edge(3));
  soups.push_back(twisted_band(5, 1, 1));
  soups.push_back(disjoint_union(sphere(0), sphere(0)));
  for (const Soup& soup : soups)
    for (int change = 0; change < 40; ++change) {
      Triangles triangles = triangles_of(soup);
      const std::size_t i = random() % triangles.size();
      const Index v = triangles[i][0], w = triangles[random() % triangles.size()][1];
      if (change % 4 == 1)
        triangles.erase(triangles.begin() + std::ptrdiff_t(i));
      else if (change % 4 == 2)
        std::swap(triangles[i][1], triangles[i][2]);
      else if (change % 4 == 3)
        for (Corners& t : triangles)
          std::replace(t.begin(), t.end(), v, w);
      if (triangles.empty())
        continue;
      const bool is_closed_surface = is_closed(triangles), is_surface = is_manifold(triangles);
      kinds.emplace(is_closed_surface, is_surface);
      BOOST_TEST(is_closed_surface == is_closed_by_definition(triangles));
      bool has_degenerate_sides = false; // which joined vertices make
      for (const Corners& t : triangles)
        has_degenerate_sides |= t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
      BOOST_TEST(is_surface == (!has_degenerate_sides && is_manifold_by_definition(triangles)));
    }
  BOOST_TEST(kinds.size() == 4u);
  BOOST_TEST(!is_manifold({{0, 0, 1}}));
}

BOOST_AUTO_TEST_SUITE_END()
