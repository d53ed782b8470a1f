// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/search/cut_proposals.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(minimum_cut)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Band_network;
using internal::Face_at_distance;
using internal::Vector;
using internal::capacity;
using internal::faces_near_cut;
using internal::halfedges_of_cut;
using internal::minimum_cut_within;

namespace {

const auto single_precision = boost::test_tools::tolerance(1e-6);

typedef std::vector<char> Sides;

const double infinity = std::numeric_limits<double>::infinity();

Surface graph_of(const Soup& soup)
{ return graph_with_distances(soup, weights_of_calibrated_method); }

Surface random_graph(Random& random)
{
  const std::vector<Soup> shapes = {plate(9, 7), sphere(2), torus(2, 0.7, 16, 10),
                                    dumbbell(12, 8)};
  return graph_of(displaced(shapes[random() % shapes.size()], 0.05, random));
}

double area_of_side(const Surface& graph, const Sides& side, char s)
{
  double area = 0;
  for (Index f = 0; f < side.size(); ++f)
    if (side[f] == s)
      area += graph.areas[f];
  return area;
}

// A set of faces that grows at random from one face, and the rest; 0 for the smaller of the two.
Sides random_sides(const Surface& graph, Random& random)
{
  Sides side(graph.number_of_faces(), 1);
  std::vector<Index> front(1, Index(random() % side.size()));
  for (std::size_t n = 1 + random() % (side.size() - 1); n > 0;) {
    std::swap(front[random() % front.size()], front.back());
    const Index f = front.back();
    front.pop_back();
    if (side[f] == 0)
      continue;
    side[f] = 0;
    --n;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      front.push_back(graph.neighbor(h));
  }
  if (area_of_side(graph, side, 0) > area_of_side(graph, side, 1))
    for (char& s : side)
      s = 1 - s;
  return side;
}

// From the cut, over faces of one side; shortened until nothing changes.
std::vector<double> distances_by_relaxation(const Surface& graph, const Sides& side)
{
  std::vector<double> distance(graph.number_of_faces(), infinity);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      const Index f = h / 3, g = graph.neighbor(h);
      const Vector from = side[f] == side[g]
        ? graph.centroid(g)
        : (graph.points[graph.source_vertex(h)] + graph.points[graph.target_vertex(h)]) / 2;
      const double d =
        (side[f] == side[g] ? distance[g] : 0) + (graph.centroid(f) - from).norm();
      if (d < distance[f]) {
        distance[f] = d;
        has_changed = true;
      }
    }
  }
  return distance;
}

std::vector<Face_at_distance> near_cut(const Surface& graph, const Sides& side,
                                       double radius)
{ return faces_near_cut(graph, side, halfedges_of_cut(graph, side), radius); }

// Returns the cheapest cut in the neighborhood of a cut, whose Q has this area.
Sides minimum_cut_around(const Surface& graph, const Sides& side, double area_of_q)
{
  std::vector<Index> band;
  for (const Face_at_distance& f :
       near_cut(graph, side, internal::constants::neighborhood_radius * std::sqrt(area_of_q)))
    band.push_back(f.face);
  return minimum_cut_within(graph, band, side);
}

double capacity_of_cut(const Surface& graph, const Sides& side)
{
  double sum = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (side[h / 3] == 0 && side[graph.neighbor(h)] == 1)
      sum += capacity(graph, h);
  return sum;
}

// Returns the sides of a dumbbell, whose center is the origin.
Sides above(const Surface& graph, double unit, double z)
{
  Sides side(graph.number_of_faces());
  for (Index f = 0; f < side.size(); ++f)
    side[f] = graph.centroid(f).z() * unit > z ? 0 : 1;
  return side;
}

struct Random_network
{
  struct Arc
  {
    int from, to; // source: -1, sink: -2
    double capacity;
  };

  int n;
  std::vector<Arc> arcs;

  // Few different capacities, so that there are many minimum cuts.
  explicit Random_network(Random& random) : n(1 + int(random() % 10))
  {
    for (std::size_t i = random() % 30; i > 0; --i) {
      const int kind = int(random() % 4), a = int(random() % n), b = int(random() % n);
      const double capacity = double(random() % 5) / 4;
      if (kind == 0)
        arcs.push_back({-1, a, capacity});
      else if (kind == 1)
        arcs.push_back({a, -2, capacity});
      else if (a != b)
        arcs.push_back({a, b, capacity});
    }
  }

  double capacity_of_cut(unsigned at_source) const
  {
    const auto is_at_source = [&](int i) { return i == -1 || (i >= 0 && (at_source >> i & 1)); };
    double sum = 0;
    for (const Arc& a : arcs)
      if (is_at_source(a.from) != is_at_source(a.to))
        sum += a.capacity;
    return sum;
  }

  std::vector<bool> minimum_cut() const
  {
    Band_network network(n);
    for (const Arc& a : arcs)
      if (a.from == -1)
        network.join_to_source(a.to, a.capacity);
      else if (a.to == -2)
        network.join_to_sink(a.from, a.capacity);
      else
        network.join(a.from, a.to, a.capacity);
    return network.minimum_cut();
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(distances_run_from_the_middle_of_the_cut_over_the_centroids)
{
  const Surface graph = graph_of(plate(4, 1));
  const double unit = unit_of(plate(4, 1));
  const Sides side = {0, 0, 0, 0, 1, 1, 1, 1}; // cut at x = 2
  const double first = std::sqrt(5.) / 6, step = std::sqrt(2.) / 3;
  const double next = first + step, third = next + std::sqrt(5.) / 3;
  const std::vector<double> expected = {third, third + step, first, next,
                                        next, first, third + step, third};
  const std::vector<Face_at_distance> all = near_cut(graph, side, 100);
  BOOST_TEST(all.size() == 8);
  for (const Face_at_distance& f : all)
    BOOST_TEST(f.distance * unit == expected[f.face], single_precision);
}

BOOST_AUTO_TEST_CASE(faces_near_a_cut_are_those_within_the_radius_nearest_first)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph = random_graph(random);
      const Sides side = random_sides(graph, random);
      const std::vector<double> expected = distances_by_relaxation(graph, side);
      const double largest = *std::max_element(expected.begin(), expected.end());
      const double radius = (std::min)(largest, 1e9) * double(random() % 11) / 10;

      const std::vector<Face_at_distance> near = near_cut(graph, side, radius);
      std::set<Index> faces;
      for (std::size_t i = 0; i < near.size(); ++i) {
        faces.insert(near[i].face);
        BOOST_TEST(near[i].distance == expected[near[i].face], single_precision);
        if (i > 0)
          BOOST_TEST(near[i - 1].distance <= near[i].distance);
      }
      BOOST_TEST(faces.size() == near.size());
      const auto is_near = [&](double d) { return d <= radius; };
      BOOST_TEST(near.size() ==
                 std::size_t(std::count_if(expected.begin(), expected.end(), is_near)));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_face_is_near_where_there_is_no_cut)
{
  const Surface graph = graph_of(sphere(1));
  BOOST_TEST(near_cut(graph, Sides(graph.number_of_faces(), 1), infinity).empty());
}

BOOST_AUTO_TEST_CASE(an_edge_costs_its_length_and_little_of_it_where_it_is_concave)
{
  Surface graph = graph_of(plate(1, 1));
  const auto tolerance = boost::test_tools::tolerance(1e-5);
  for (Index h = 0; h < 6; ++h)
    BOOST_TEST(capacity(graph, h) == graph.length(h) * 1.05, tolerance);
  graph.weights[1].concavity = 1;
  BOOST_TEST(capacity(graph, 1) == graph.length(1) * 0.05, tolerance);
  graph.weights[1].concavity = 0.5;
  BOOST_TEST(capacity(graph, 1) == graph.length(1) * 0.3, tolerance);
}

BOOST_AUTO_TEST_CASE(a_network_has_the_smallest_of_its_minimum_cuts)
{
  for (unsigned seed = 1; seed <= 400; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Random_network network(random);
      double least = infinity;
      unsigned in_all = 0; // the intersection of the minimum cuts
      for (unsigned cut = 0; cut < (1u << network.n); ++cut) {
        const double c = network.capacity_of_cut(cut);
        in_all = c < least ? cut : c == least ? in_all & cut : in_all;
        least = (std::min)(c, least);
      }
      const std::vector<bool> is_at_source = network.minimum_cut();
      BOOST_TEST_REQUIRE(is_at_source.size() == std::size_t(network.n));
      unsigned cut = 0;
      for (int i = 0; i < network.n; ++i)
        cut |= unsigned(is_at_source[i]) << i;
      BOOST_TEST(network.capacity_of_cut(cut) == least);
      BOOST_TEST(cut == in_all);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_cut_some_rings_from_the_neck_moves_to_the_neck)
{
  const Soup soup = dumbbell(20, 15);
  const Surface graph = graph_of(soup);
  const double unit = unit_of(soup);
  const Sides top = above(graph, unit, 0);
  for (std::size_t ring : {0, 1, 2, 3}) {
    // Vertex 0 is the pole, ring 14 the neck.
    const double z = soup.points[1 + 20 * (14 + ring)].z();
    const Sides before = above(graph, unit, z);
    const Sides after = minimum_cut_around(graph, before, area_of_side(graph, before, 0));
    BOOST_TEST(after == top, boost::test_tools::per_element());
    if (ring > 0)
      BOOST_TEST(capacity_of_cut(graph, after) < capacity_of_cut(graph, before));
  }
}

BOOST_AUTO_TEST_CASE(a_cut_out_of_reach_of_the_neck_stays_away_from_it)
{
  const Soup soup = dumbbell(20, 15);
  const Surface graph = graph_of(soup);
  const Sides before = above(graph, unit_of(soup), 1.5);
  const double area = area_of_side(graph, before, 0);
  const Sides after = minimum_cut_around(graph, before, area);
  BOOST_TEST(area_of_side(graph, after, 0) < 2 * area);
}

BOOST_AUTO_TEST_CASE(no_cut_becomes_more_expensive_and_faces_far_from_it_stay)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph = random_graph(random);
      const Sides before = random_sides(graph, random);
      const double area = area_of_side(graph, before, 0);
      const Sides after = minimum_cut_around(graph, before, area);
      BOOST_TEST(capacity_of_cut(graph, after) <= capacity_of_cut(graph, before));
      for (char s : {char(0), char(1)})
        BOOST_TEST(std::count(after.begin(), after.end(), s) > 0);
      const std::vector<double> distance = distances_by_relaxation(graph, before);
      for (Index f = 0; f < after.size(); ++f)
        if (distance[f] > 0.35 * std::sqrt(area))
          BOOST_TEST(after[f] == before[f]);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_cut_within_reach_is_cheaper)
{
  const Surface whole = graph_of(torus(2, 0.7, 12, 8));
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph = random_part(whole, 2 + random() % 9, random);
      const std::size_t n = graph.number_of_faces();
      const Sides before = random_sides(graph, random);
      const double area = area_of_side(graph, before, 0);
      const double radius = 0.35 * std::sqrt(4 * area); // to reach beyond the faces at the cut

      std::vector<bool> is_fixed(n, true);
      std::vector<std::size_t> farthest(2, n), number_of_fixed(2);
      for (const Face_at_distance& f : near_cut(graph, before, radius)) {
        is_fixed[f.face] = false;
        farthest[std::size_t(before[f.face])] = f.face;
      }
      for (std::size_t f = 0; f < n; ++f)
        number_of_fixed[std::size_t(before[f])] += is_fixed[f];
      for (std::size_t s : {0, 1})
        if (number_of_fixed[s] == 0)
          is_fixed[farthest[s]] = true;

      double least = infinity;
      for (unsigned cut = 0; cut < (1u << n); ++cut) {
        Sides side(n);
        bool is_allowed = true;
        for (std::size_t f = 0; f < n; ++f) {
          side[f] = char(cut >> f & 1);
          is_allowed = is_allowed && (!is_fixed[f] || side[f] == before[f]);
        }
        if (is_allowed)
          least = (std::min)(least, capacity_of_cut(graph, side));
      }
      BOOST_TEST(capacity_of_cut(graph, minimum_cut_around(graph, before, 4 * area)) == least);
    }
  }
}

BOOST_AUTO_TEST_CASE(two_faces_keep_a_side_each)
{
  const Surface graph = graph_of(plate(1, 1));
  for (double area_of_q : {0., 0.5, 1e6}) {
    const Sides after = minimum_cut_around(graph, {1, 0}, area_of_q);
    BOOST_TEST((after == Sides{1, 0}));
  }
}

BOOST_AUTO_TEST_SUITE_END()
