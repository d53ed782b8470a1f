// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/curvature_angles.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(face_distances)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Dihedral;
using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::dihedral;
using CGAL::Spectral_segmentation::internal::equalize;
using CGAL::Spectral_segmentation::internal::geodesic_distance;
using CGAL::Spectral_segmentation::internal::curvature_angles;

namespace {

// A distance of 1 or less in single precision on the grid of 2^-20.
const double rounding = 1e-6;

double shortest_by_search(const Vector& a, const Vector& b, const Vector& f, const Vector& g)
{
  const auto length = [&](double t) {
    const Vector p = a + t * (b - a);
    return (f - p).norm() + (g - p).norm();
  };
  const double inside = boost::math::tools::brent_find_minima(length, 0., 1., 52).second;
  return std::min({inside, length(0), length(1)});
}

// Returns two squares with the common edge from (0, 0, 0) to (1, 0, 0). Both go down, or up if the
// slope is positive.
Soup roof(double slope)
{
  const double y = std::cos(slope), z = std::sin(slope);
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(0, y, z), Point(1, -y, z)},
          {{0, 1, 2}, {1, 0, 3}}};
}

// The dihedral of the only inner edge of a roof.
Dihedral dihedral_of(const Soup& soup)
{
  const Surface graph = surface_of(soup);
  const std::vector<Vector> normals = face_normals(graph, graph.points);
  Index h = 0;
  while (graph.is_border(h))
    ++h;
  return dihedral(normals[0], normals[1],
                  graph.points[graph.target_vertex(h)] - graph.points[graph.source_vertex(h)]);
}

struct Expected_edge
{
  Index halfedge;
  double geodesic;
  double angle; // not equalized
  bool concave;
};

// The inner edges of a mesh and their distances, by CGAL's geometry.
std::vector<Expected_edge> expected_edges(const Soup& soup, const Surface& graph,
                                          const Distance_weights& weights)
{
  const auto corner = [&](Index h) { return soup.points[graph.source_vertex(h)]; };
  const auto third_corner = [&](Index h)
  { return soup.points[graph.corners[h / 3][(h + 2) % 3]]; };
  const auto vector = [](const Point& p) { return Vector(p.x(), p.y(), p.z()); };
  std::vector<Expected_edge> edges;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    if (graph.is_border(h) || graph.opposite[h] < h)
      continue;
    const Point a = corner(h), b = corner(graph.opposite[h]);
    const Point c = third_corner(h), d = third_corner(graph.opposite[h]);
    const auto n = CGAL::normal(a, b, c), m = CGAL::normal(b, a, d);
    Expected_edge e;
    e.halfedge = h;
    e.geodesic = shortest_by_search(vector(a), vector(b), vector(CGAL::centroid(a, b, c)),
                                    vector(CGAL::centroid(a, b, d)));
    e.concave = CGAL::orientation(a, b, c, d) == CGAL::POSITIVE;
    const double cosine = n * m / std::sqrt(n.squared_length() * m.squared_length());
    e.angle = (e.concave ? weights.concave : weights.convex) * (1 - cosine);
    edges.push_back(e);
  }
  double mean = 0;
  for (const Expected_edge& e : edges)
    mean += e.geodesic / static_cast<double>(edges.size());
  for (Expected_edge& e : edges)
    e.geodesic /= mean;
  return edges;
}

// The mean rank of values[i] among all, scaled to [0, 1].
template <class Values>
double rank_by_counting(const Values& values, std::size_t i)
{
  double smaller = 0, equal = 0;
  for (const auto& value : values) {
    smaller += value < values[i];
    equal += value == values[i];
  }
  return (smaller + (equal - 1) / 2) / static_cast<double>(values.size() - 1);
}

// Returns the fraction of the weight that smaller values have, and half of the equal ones.
double rank_by_adding(const std::vector<float>& values, const std::vector<double>& weights,
                       std::size_t i)
{
  double below = 0, total = 0;
  for (std::size_t j = 0; j < values.size(); ++j) {
    below += values[j] < values[i] ? weights[j] : values[j] == values[i] ? weights[j] / 2 : 0;
    total += weights[j];
  }
  return below / total;
}

std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations)
{
  return CGAL::Spectral_segmentation::internal::smoothed_points(graph, iterations,
                                                                [] { return true; });
}

// One step at a time, over the vertices of the mesh.
std::vector<Vector> smoothed_by_vertex(const Soup& soup, std::vector<Vector> points,
                                       std::size_t iterations)
{
  const Mesh mesh = mesh_of(soup);
  for (; iterations > 0; --iterations) {
    const std::vector<Vector> old = points;
    for (Mesh::Vertex_index v : mesh.vertices()) {
      if (mesh.is_border(v))
        continue;
      Vector sum;
      for (Mesh::Vertex_index w : vertices_around_target(mesh.halfedge(v), mesh))
        sum += old[w];
      points[v] = (old[v] + sum / mesh.degree(v)) / 2;
    }
  }
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(geodesic_distance_worked_by_hand)
{
  const Vector a(0, 0, 0), b(2, 0, 0);
  const auto distance = [&](const Vector& f, const Vector& g)
  { return geodesic_distance(a, b, f, g); };
  const auto tolerance = tt::tolerance(1e-14);

  // The straight line, in one plane and around a fold.
  BOOST_TEST(distance({0.5, 1, 0}, {1.5, -1, 0}) == std::sqrt(5.), tolerance);
  BOOST_TEST(distance({0.5, 1, 0}, {1.5, 0, 1}) == std::sqrt(5.), tolerance);
  BOOST_TEST(distance({0.5, 1, 0}, {1.5, 1, 0}) == std::sqrt(5.), tolerance);
  BOOST_TEST(distance({1, 3, 0}, {1, 0, -4}) == 7., tolerance);
  // Over an end of the edge.
  BOOST_TEST(distance({3, 1, 0}, {3, -1, 0}) == 2 * std::sqrt(2.), tolerance);
  BOOST_TEST(distance({-1, 1, 0}, {-1, 0, 1}) == 2 * std::sqrt(2.), tolerance);
  BOOST_TEST(distance({1.5, 1, 0}, {6, -3, 0}) == std::sqrt(1.25) + 5, tolerance);
  // Along the edge.
  BOOST_TEST(distance({0.5, 0, 0}, {1.5, 0, 0}) == 1., tolerance);
  BOOST_TEST(distance({-1, 0, 0}, {4, 0, 0}) == 5., tolerance);
  BOOST_TEST(distance({3, 0, 0}, {4, 0, 0}) == 3., tolerance);
  // An edge of length 0.
  BOOST_TEST(geodesic_distance(a, a, {3, 4, 0}, {0, 0, 2}) == 7., tolerance);
}

BOOST_AUTO_TEST_CASE(geodesic_distance_is_the_shortest_way_over_the_edge)
{
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      std::uniform_real_distribution<double> coordinate(-1, 1);
      std::array<Vector, 4> p;
      for (Vector& v : p)
        v = Vector(coordinate(random), coordinate(random), coordinate(random));
      const Vector f = (p[0] + p[1] + p[2]) / 3, g = (p[0] + p[1] + p[3]) / 3;
      BOOST_TEST(geodesic_distance(p[0], p[1], f, g) == shortest_by_search(p[0], p[1], f, g),
                 tt::tolerance(1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(roofs_are_convex_and_valleys_concave)
{
  for (double slope : {1e-5, 0.01, 0.3, pi / 6, pi / 4, pi / 3, 1.5}) {
    // The normals lean by the slope to either side.
    const double one_minus_cosine = 2 * std::sin(slope) * std::sin(slope);
    for (bool is_valley : {false, true}) {
      const Soup soup = roof(is_valley ? slope : -slope);
      const Dihedral d = dihedral_of(soup), inverse = dihedral_of(turned_inside_out(soup));
      BOOST_TEST(d.is_concave == is_valley);
      BOOST_TEST(inverse.is_concave == !is_valley);
      BOOST_TEST(d.one_minus_cosine == one_minus_cosine, tt::tolerance(1e-9));
      BOOST_TEST(inverse.one_minus_cosine == one_minus_cosine, tt::tolerance(1e-9));
    }
  }
  for (double slope : {0., 1e-9, -1e-9}) {
    BOOST_TEST(!dihedral_of(roof(slope)).is_concave);
    BOOST_TEST(dihedral_of(roof(slope)).one_minus_cosine == 0);
  }
}

BOOST_AUTO_TEST_CASE(distances_on_random_meshes_agree_with_the_definition)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::vector<Soup> shapes = {plate(5, 4), sphere(1), torus(2, 0.7, 7, 6),
                                        dumbbell(7, 4)};
      const Soup soup = displaced(shapes[seed % shapes.size()], 0.15, random);
      const Distance_weights weights = {0.25, 0.5 + seed % 3, 0.2 * (seed % 5)};
      Surface graph = surface_of(soup);
      set_face_distances(graph, weights);

      const std::vector<Expected_edge> edges = expected_edges(soup, graph, weights);
      std::vector<double> angles;
      for (const Expected_edge& e : edges)
        angles.push_back(e.angle);
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge_weights& h = graph.weights[edges[i].halfedge];
        const double angle = rank_by_counting(angles, i);
        BOOST_TEST(h.concavity == (edges[i].concave ? h.angle : 0));
        BOOST_TEST(std::abs(h.geodesic - edges[i].geodesic) < rounding);
        BOOST_TEST(std::abs(h.angle - angle) < rounding);
        BOOST_TEST(std::abs(h.combined - (0.75 * angle + 0.25 * edges[i].geodesic)) < rounding);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(both_sides_of_an_edge_agree_and_the_border_has_no_distance)
{
  Random random(1);
  const Surface graph = graph_with_distances(displaced(plate(4, 3), 0.2, random));
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    const Edge_weights& e = graph.weights[h];
    if (graph.is_border(h)) {
      BOOST_TEST(e.geodesic + e.angle + e.combined == 0);
      BOOST_TEST(e.concavity == 0);
      continue;
    }
    const Edge_weights& o = graph.weights[graph.opposite[h]];
    BOOST_TEST(e.geodesic == o.geodesic);
    BOOST_TEST(e.angle == o.angle);
    BOOST_TEST(e.combined == o.combined);
    BOOST_TEST(e.concavity == o.concavity);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_of_the_geodesic_distances_is_1)
{
  for (const Soup& soup : {sphere(2), plate(9, 2), dumbbell(9, 9)}) {
    const Surface graph = graph_with_distances(soup);
    double sum = 0, number = 0;
    for (Index h = 0; h < graph.number_of_halfedges(); ++h)
      if (!graph.is_border(h)) {
        sum += graph.weights[h].geodesic;
        ++number;
      }
    BOOST_TEST(std::abs(sum / number - 1) < rounding);
  }
}

BOOST_AUTO_TEST_CASE(a_geodesic_weight_of_0_or_1_leaves_one_distance)
{
  Random random(2);
  Surface graph = surface_of(displaced(sphere(1), 0.1, random));
  set_face_distances(graph, {0, 1, 0.1});
  for (const Edge_weights& h : graph.weights)
    BOOST_TEST(h.combined == h.angle);
  set_face_distances(graph, {1, 1, 0.1});
  for (const Edge_weights& h : graph.weights)
    BOOST_TEST(h.combined == h.geodesic);
}

// A strip of three quads with a valley of 60 degrees and a ridge of 90: 0.5 and 1 as 1 - cosine.
BOOST_AUTO_TEST_CASE(the_weight_of_concave_edges_decides_against_sharper_convex_ones)
{
  const double c = std::cos(pi / 3), s = std::sin(pi / 3);
  const std::vector<Point> profile = {Point(0, 0, 0), Point(1, 0, 0), Point(1 + c, 0, s),
                                      Point(1 + c + s, 0, s - c)};
  Soup soup = plate(3, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    soup.points[i] = profile[i];
    soup.points[4 + i] = Point(profile[i].x(), 1, profile[i].z());
  }
  Surface graph = surface_of(soup);
  const auto angle_between = [&](Index f, Index g) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (graph.neighbor(h) == g)
        return graph.weights[h].angle;
    return -1.f;
  };
  // Three of the five inner edges are flat, and have the mean of the lowest ranks.
  set_face_distances(graph, {0.01, 1, 0.1});
  BOOST_TEST(angle_between(0, 3) == 1.f);    // the valley
  BOOST_TEST(angle_between(2, 5) == 0.75f);  // the ridge
  BOOST_TEST(angle_between(0, 1) == 0.25f);
  set_face_distances(graph, {0.01, 1, 1});
  BOOST_TEST(angle_between(0, 3) == 0.75f);
  BOOST_TEST(angle_between(2, 5) == 1.f);
  set_face_distances(graph, {0.01, 1, 0});
  BOOST_TEST(angle_between(0, 3) == 1.f);
  BOOST_TEST(angle_between(2, 5) == 0.375f); // flat like the other three
  set_face_distances(graph, {0.01, 0, 0});
  BOOST_TEST(angle_between(0, 3) == 0.5f);
}

BOOST_AUTO_TEST_CASE(turned_inside_out_concave_and_convex_edges_swap)
{
  Random random(3);
  const Soup soup = displaced(torus(2, 0.7, 8, 6), 0.1, random);
  const Surface graph = graph_with_distances(soup),
                        inverse = graph_with_distances(turned_inside_out(soup));
  std::size_t number_of_concave = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    Index same = 3 * (h / 3);
    while (inverse.source_vertex(same) != graph.target_vertex(h) ||
           inverse.target_vertex(same) != graph.source_vertex(h))
      ++same;
    const bool is_concave = graph.weights[h].concavity > 0;
    BOOST_TEST(is_concave != (inverse.weights[same].concavity > 0));
    BOOST_TEST(graph.weights[h].geodesic == inverse.weights[same].geodesic);
    number_of_concave += is_concave;
  }
  BOOST_TEST(number_of_concave > 0u);
  BOOST_TEST(number_of_concave < graph.number_of_halfedges());
}

BOOST_AUTO_TEST_CASE(equalized_values_are_mean_ranks)
{
  BOOST_TEST(equalize({}).empty());
  BOOST_TEST(equalize({7.f}) == std::vector<double>({0.5}), tt::per_element());
  BOOST_TEST(equalize({3.f, 1.f, 2.f}) == std::vector<double>({1, 0, 0.5}),
             tt::per_element());
  BOOST_TEST(equalize({2.f, 1.f, 2.f, 5.f, 2.f}) ==
               std::vector<double>({0.5, 0, 0.5, 1, 0.5}),
             tt::per_element());
  BOOST_TEST(equalize({4.f, 4.f, 4.f}) == std::vector<double>({0.5, 0.5, 0.5}),
             tt::per_element());
  for (unsigned seed = 1; seed <= 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      std::vector<float> values(2 + random() % 200);
      const unsigned number_of_values = 1 + random() % 300; // the fewer the more ties
      for (float& value : values)
        value = static_cast<float>(random() % number_of_values) / 7;
      const std::vector<double> result = equalize(values);
      for (std::size_t i = 0; i < values.size(); ++i)
        BOOST_TEST(result[i] == rank_by_counting(values, i));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_value_takes_as_much_room_as_its_weight)
{
  BOOST_TEST(equalize({}, {}).empty());
  BOOST_TEST(equalize({7.f}, {3}) == std::vector<double>({0.5}), tt::per_element());
  BOOST_TEST(equalize({3.f, 1.f, 2.f}, {2, 1, 1}) ==
               std::vector<double>({0.75, 0.125, 0.375}),
             tt::per_element());
  BOOST_TEST(equalize({5.f, 1.f, 5.f}, {1, 2, 5}) ==
               std::vector<double>({0.625, 0.125, 0.625}),
             tt::per_element());
  BOOST_TEST(equalize({2.f, 1.f}, {0, 0}) == std::vector<double>({0.5, 0.5}),
             tt::per_element());
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      std::vector<float> values(1 + random() % 200);
      std::vector<double> weights(values.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(random() % 50) / 7;
        weights[i] = 0.1 * (1 + random() % 100);
      }
      const std::vector<double> result = equalize(values, weights);
      for (std::size_t i = 0; i < values.size(); ++i)
        BOOST_TEST(result[i] == rank_by_adding(values, weights, i), tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(curvature_replaces_the_dihedral_angle_with_a_radius)
{
  for (unsigned seed = 1; seed <= 8; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::vector<Soup> shapes = {plate(9, 7), sphere(2), torus(2, 0.7, 16, 10),
                                        dumbbell(12, 8)};
      Surface graph = surface_of(displaced(shapes[seed % shapes.size()], 0.1, random));
      const Distance_weights weights = {0.25, 1, 0.2, 0.04};
      set_face_distances(graph, weights);
      const std::vector<Vector> normals = face_normals(graph, graph.points);
      const std::vector<double> bending =
        curvature_angles(sequential, graph, graph.points, normals, 0.04);
      std::vector<Index> edges;
      std::vector<float> values;
      std::vector<double> lengths;
      for (Index h = 0; h < graph.number_of_halfedges(); ++h)
        if (!graph.is_border(h) && h < graph.opposite[h]) {
          edges.push_back(h);
          values.push_back(float((bending[h] < 0 ? 1 : 0.2) * (1 - std::cos(bending[h]))));
          lengths.push_back(graph.length(h));
        }
      bool differs = false;
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const Edge_weights& h = graph.weights[edges[e]];
        const double angle = rank_by_adding(values, lengths, e);
        BOOST_TEST(std::abs(h.angle - angle) < rounding);
        BOOST_TEST(h.concavity == (bending[edges[e]] < 0 ? h.angle : 0));
        BOOST_TEST(std::abs(h.combined - (0.75 * angle + 0.25 * h.geodesic)) < 2 * rounding);
        const Index i = edges[e];
        const Dihedral d = dihedral(normals[i / 3], normals[graph.neighbor(i)],
                                    graph.points[graph.target_vertex(i)] -
                                      graph.points[graph.source_vertex(i)]);
        differs = differs || (bending[i] < 0) != d.is_concave;
      }
      BOOST_TEST(differs);
    }
  }
}

namespace {

// A face above the edge from 0 to 1, a face without area along it, and two faces below, bent away.
Soup roof_with_a_needle()
{
  return {{Point(0, 0, 0), Point(2, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(1, 0, -1)},
          {{0, 1, 3}, {1, 0, 2}, {2, 0, 4}, {1, 2, 4}}};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_face_without_area_takes_the_normal_across_its_longest_edge)
{
  const Surface graph = graph_with_distances(roof_with_a_needle());
  const std::vector<Vector> normals = face_normals(graph, graph.points);
  BOOST_TEST(graph.areas[1] == 0);
  BOOST_TEST((normals[0] == Vector(0, 0, 1)));
  BOOST_TEST((normals[1] == normals[0]));
  BOOST_TEST((normals[2] == Vector(0, -1, 0)));
  BOOST_TEST((normals[3] == Vector(0, -1, 0)));
  // So the fold lies between the needle and the lower faces.
  for (Index h = 3; h < 6; ++h)
    BOOST_TEST(graph.weights[h].angle == (graph.neighbor(h) == 0 ? 1 / 6.f : 5 / 6.f),
               tt::tolerance(1e-5f));
}

BOOST_AUTO_TEST_CASE(faces_without_area_pass_a_normal_on)
{
  // The lower face on the right is a second needle.
  Soup soup = roof_with_a_needle();
  soup.points.emplace_back(1.5, 0, 0);
  soup.triangles.back() = {1, 2, 5};
  const Surface graph = surface_of(soup);
  const std::vector<Vector> normals = face_normals(graph, graph.points);
  BOOST_TEST((normals[1] == Vector(0, 0, 1)));
  BOOST_TEST((normals[3] == Vector(0, 0, 1)));
}

BOOST_AUTO_TEST_CASE(a_mesh_without_area_has_no_angles)
{
  for (double length : {0., 1.}) {
    Soup soup = sphere(1);
    for (Point& p : soup.points)
      p = Point(length * p.x(), 0, 0);
    const Surface graph = graph_with_distances(soup);
    for (const Edge_weights& h : graph.weights) {
      BOOST_TEST(h.concavity == 0);
      BOOST_TEST(h.angle == 0.5f);
      BOOST_TEST(h.geodesic >= 0);
      BOOST_TEST(std::isfinite(h.combined));
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_are_computed_from_the_given_points)
{
  Random random(4);
  const Soup soup = sphere(1), other = displaced(soup, 0.1, random);
  Surface graph = surface_of(soup);
  const std::vector<Vector> points = surface_of(other).points;
  CGAL::Spectral_segmentation::internal::set_face_distances(
    sequential, graph, points, face_normals(graph, points), weights_of_paper);
  const Surface expected = graph_with_distances(other);
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    BOOST_TEST(graph.weights[h].combined == expected.weights[h].combined);
}

BOOST_AUTO_TEST_CASE(no_step_changes_nothing)
{
  const Surface graph = surface_of(sphere(1));
  BOOST_TEST((smoothed_points(graph, 0) == graph.points));
}

BOOST_AUTO_TEST_CASE(the_peak_over_a_fixed_rim_halves_its_height)
{
  const Soup soup = surface_of_revolution({{0, 1}, {1, 0}}, 6);
  const Surface graph = surface_of(soup);
  const std::size_t peak = soup.points.size() - 1;
  for (std::size_t steps : {1, 2, 5}) {
    const std::vector<Vector> points = smoothed_points(graph, steps);
    const Vector height = points[peak] - (points[0] + points[3]) / 2;
    const Vector old_height = graph.points[peak] - (graph.points[0] + graph.points[3]) / 2;
    BOOST_TEST((height * double(1 << steps) - old_height).norm() < 1e-14);
    for (std::size_t v = 0; v < peak; ++v)
      BOOST_TEST((points[v] == graph.points[v]));
  }
}

BOOST_AUTO_TEST_CASE(an_octahedron_shrinks_to_half_its_size_in_each_step)
{
  const Soup soup = surface_of_revolution({{-1, 0}, {0, 1}, {1, 0}}, 4);
  const Surface graph = surface_of(soup);
  const std::vector<Vector> points = smoothed_points(graph, 3);
  for (std::size_t v = 0; v < 6; ++v)
    BOOST_TEST((points[v] - graph.points[v] / 8).norm() < 1e-15);
}

BOOST_AUTO_TEST_CASE(all_vertices_move_at_once_half_the_way_to_the_mean_of_their_neighbors)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::vector<Soup> shapes = {plate(5, 4), sphere(1), torus(2, 0.7, 6, 5),
                                        surface_of_revolution({{0, 0}, {1, 1}, {2, 1}}, 8)};
      const Soup soup = displaced(shapes[seed % shapes.size()], 0.3, random);
      const Surface graph = surface_of(soup);
      const std::size_t steps = 1 + seed % 3;
      const std::vector<Vector> points = smoothed_points(graph, steps);
      const std::vector<Vector> expected = smoothed_by_vertex(soup, graph.points, steps);
      for (std::size_t v = 0; v < points.size(); ++v)
        BOOST_TEST((points[v] - expected[v]).norm() < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_vertex_without_a_face_stays)
{
  Soup soup = sphere(0);
  soup.points.emplace_back(5, 5, 5);
  const Surface graph = surface_of(soup);
  BOOST_TEST((smoothed_points(graph, 2).back() == graph.points.back()));
}

BOOST_AUTO_TEST_SUITE_END()
