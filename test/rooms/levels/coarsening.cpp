// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(coarsening)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::null_index;
using internal::Level;
using internal::Execution;
using internal::Vector;

namespace {

// The last surface, with the faces and vertices of the mesh that was given.
Level coarsen(const Surface& mesh, std::size_t number_of_faces)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  std::vector<Level> levels =
    internal::coarsened(sequential, mesh, number_of_faces, monitor);
  Level result = levels.back();
  for (std::size_t i = levels.size() - 1; i-- > 0;) {
    for (Index& f : result.parent_face)
      f = levels[i].parent_face[f];
    std::vector<Index> vertices;
    for (Index v : levels[i].coarse_vertex)
      vertices.push_back(result.coarse_vertex[v]);
    result.coarse_vertex = vertices;
  }
  return result;
}

// Returns the surface in its frame, like in a run.
Surface framed(const Soup& soup)
{
  Surface result = surface_of(soup);
  internal::move_to_frame(sequential, result);
  return result;
}

double volume(const Surface& graph)
{
  double sum = 0;
  for (const std::array<Index, 3>& c : graph.corners)
    sum += graph.points[c[0]].dot(graph.points[c[1]].cross(graph.points[c[2]]));
  return sum / 6;
}

std::size_t number_of_components(const Surface& graph)
{ return internal::connected_components(graph).number; }

// Vertices less edges plus faces, where each vertex has one fan of faces.
int euler_characteristic(const Surface& graph)
{
  int half_edges_inside = 0, border = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    ++(graph.is_border(h) ? border : half_edges_inside);
  return int(graph.points.size()) - (half_edges_inside / 2 + border) +
         int(graph.number_of_faces());
}

// All that does not depend on how much was coarse.
void check(const Surface& mesh, const Level& coarse)
{
  const Surface& graph = coarse.surface;
  const std::size_t n = graph.number_of_faces();
  BOOST_TEST_REQUIRE(coarse.parent_face.size() == n);
  BOOST_TEST(graph.opposite.size() == 3 * n);
  BOOST_TEST(graph.areas.size() == n);
  BOOST_TEST(number_of_components(graph) == number_of_components(mesh));
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (!graph.is_border(h)) {
      BOOST_TEST_REQUIRE(graph.opposite[h] != null_index);
      BOOST_TEST(graph.opposite[graph.opposite[h]] == h);
    }
  for (const std::array<Index, 3>& c : graph.corners)
    BOOST_TEST((c[0] != c[1] && c[1] != c[2] && c[2] != c[0]));

  // A face that is left has the vertices that its vertices became; two vertices of other faces are
  // one.
  std::vector<char> is_left(mesh.number_of_faces(), 0);
  BOOST_TEST_REQUIRE(coarse.coarse_vertex.size() == mesh.points.size());
  const auto corners = [&](Index f) {
    std::array<Index, 3> result;
    for (int i = 0; i < 3; ++i)
      result[i] = coarse.coarse_vertex[mesh.corners[f][i]];
    return result;
  };
  for (Index f = 0; f < n; ++f) {
    BOOST_TEST(is_left[coarse.parent_face[f]] == 0);
    is_left[coarse.parent_face[f]] = 1;
    std::array<Index, 3> c = corners(coarse.parent_face[f]);
    for (int i = 0; i < 2 && c[0] != graph.corners[f][0]; ++i)
      std::rotate(c.begin(), c.begin() + 1, c.end());
    BOOST_TEST((c == graph.corners[f]));
  }
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (!is_left[f]) {
      const std::array<Index, 3> c = corners(f);
      BOOST_TEST((c[0] == c[1] || c[1] == c[2] || c[2] == c[0]));
    }
}

// All variances differ, and no axis has two equal sides, so that noise does not turn the frame.
Soup rough_dumbbell(unsigned seed)
{
  Random random(seed);
  Soup soup = displaced(dumbbell(30, 24), 0.01, random);
  for (Point& p : soup.points)
    p = Point(1.5 * p.x() + 0.2 * p.x() * p.x(), p.y() + 0.1 * p.z() * p.z(),
              p.z() + 0.1 * p.z() * p.z());
  return soup;
}

Soup turned(Soup soup)
{
  const Eigen::Matrix3d r =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  return transformed(std::move(soup), [&](const Point& p) {
    const Eigen::Vector3d q = r * Eigen::Vector3d(p.x(), p.y(), p.z()) + Eigen::Vector3d(3, -1, 7);
    return Point(q.x(), q.y(), q.z());
  });
}

} // namespace

BOOST_AUTO_TEST_CASE(surfaces_keep_their_topology)
{
  const Soup soups[] = {sphere(4), torus(2, 0.7, 60, 30), plate(30, 20), dumbbell(30, 24),
                        disjoint_union(sphere(3), torus(2, 0.5, 40, 16)),
                        surface_of_revolution({{0, 1}, {1, 0.5}, {2, 0.8}, {3, 1}}, 100)};
  for (const Soup& soup : soups) {
    const Surface mesh = surface_of(soup);
    for (std::size_t number : {mesh.number_of_faces() / 2, std::size_t(300), std::size_t(150)}) {
      const Level coarse = coarsen(mesh, number);
      check(mesh, coarse);
      BOOST_TEST(coarse.surface.number_of_faces() <= number);
      BOOST_TEST(4 * coarse.surface.number_of_faces() >= 3 * number); // clusters may be wide
      BOOST_TEST(euler_characteristic(coarse.surface) == euler_characteristic(mesh));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_sphere_keeps_its_volume_and_its_faces_are_alike)
{
  Random random(4);
  const Surface mesh = surface_of(displaced(sphere(5), 0.002, random));
  const Level coarse = coarsen(mesh, 1000);
  const Surface& graph = coarse.surface;
  // With its vertices on the sphere a mesh of 1000 faces lacks 1 % of the volume.
  BOOST_TEST(volume(graph) == volume(mesh), boost::test_tools::tolerance(0.005));
  const double mean = internal::total_area(graph) / double(graph.number_of_faces());
  std::size_t number_of_small_faces = 0; // where the points of three clusters lie on a line
  for (Index f = 0; f < graph.number_of_faces(); ++f) {
    const std::array<Index, 3>& c = graph.corners[f];
    BOOST_TEST(graph.areas[f] < mean * 4);
    const Vector &p = graph.points[c[0]], &q = graph.points[c[1]], &r = graph.points[c[2]];
    if (graph.areas[f] < mean / 5)
      ++number_of_small_faces;
    else
      BOOST_TEST((q - p).cross(r - p).dot(p + q + r) > 0); // outwards
  }
  BOOST_TEST(number_of_small_faces < 30);
}

BOOST_AUTO_TEST_CASE(a_plate_keeps_its_outline)
{
  const Surface mesh = surface_of(plate(40, 30));
  const Level coarse = coarsen(mesh, 100);
  BOOST_TEST(internal::total_area(coarse.surface) == internal::total_area(mesh),
             boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(sharp_edges_stay)
{
  // A cylinder with flat ends: coarse at random it would lose its rims, and volume with them.
  std::vector<std::pair<double, double> > profile = {{0, 0}};
  for (int i = 1; i <= 10; ++i)
    profile.emplace_back(0, 0.1 * i);
  for (int i = 1; i <= 30; ++i)
    profile.emplace_back(0.1 * i, 1);
  for (int i = 9; i >= 0; --i)
    profile.emplace_back(3, 0.1 * i);
  const Surface mesh = surface_of(surface_of_revolution(profile, 60));
  const Level coarse = coarsen(mesh, 800);
  BOOST_TEST(volume(coarse.surface) == volume(mesh), boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(the_result_moves_with_the_mesh)
{
  for (unsigned seed : {1, 2, 3}) {
    const Soup soup = rough_dumbbell(seed);
    const Level here = coarsen(framed(soup), 400),
                         there = coarsen(framed(turned(soup)), 400);
    BOOST_TEST((here.parent_face == there.parent_face));
    BOOST_TEST((here.coarse_vertex == there.coarse_vertex));
    BOOST_TEST((here.surface.points == there.surface.points));
  }
}

BOOST_AUTO_TEST_CASE(a_mirrored_mesh_gives_the_same_surface)
{
  for (unsigned seed : {1, 2, 3}) {
    const Soup soup = rough_dumbbell(seed);
    Soup other = soup;
    for (Point& p : other.points)
      p = Point(p.x(), -p.y(), p.z());
    const Level here = coarsen(framed(soup), 400),
                         there = coarsen(framed(turned_inside_out(turned(other))), 400);
    BOOST_TEST((here.surface.points == there.surface.points));
    BOOST_TEST((here.surface.corners == there.surface.corners));
    BOOST_TEST((here.parent_face == there.parent_face));
  }
}

BOOST_AUTO_TEST_CASE(little_noise_rarely_gets_through)
{
  Random random(3);
  std::size_t number_of_same = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Soup soup = rough_dumbbell(seed);
    const Level one = coarsen(framed(soup), 400),
                         two = coarsen(framed(displaced(soup, 1e-8, random)), 400);
    number_of_same += one.surface.points == two.surface.points &&
                      one.parent_face == two.parent_face;
  }
  BOOST_TEST(number_of_same >= 9u);
}

namespace {

// Squares of a plate that form an L of unequal arms, one of them folded up.
Soup folded_plate()
{
  const std::size_t nx = 24, ny = 17;
  const Soup whole = plate(nx, ny);
  Soup soup;
  for (const Point& p : whole.points)
    soup.points.push_back(p.x() > 15 ? Point(15, p.y(), p.x() - 15) : p);
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
    if (t / 2 % nx < 10 || t / 2 / nx < 9)
      soup.triangles.push_back(whole.triangles[t]);
  CGAL::Polygon_mesh_processing::remove_isolated_points_in_polygon_soup(soup.points,
                                                                        soup.triangles);
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_numbers_of_faces_and_vertices_do_not_matter)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Soup soup = rough_dumbbell(seed);
    Random random(seed);
    std::vector<std::size_t> face;
    const Level coarse = coarsen(framed(renumbered(soup, random, face)), 400);
    std::set<Index> expected, left(coarse.parent_face.begin(), coarse.parent_face.end());
    for (Index f : coarsen(framed(soup), 400).parent_face)
      expected.insert(Index(face[f]));
    BOOST_TEST((left == expected));
  }
}

// Therefore the hash decides. The mesh has no symmetry, because the principal frame of a symmetric
// mesh depends on the rounding of sums.
BOOST_AUTO_TEST_CASE(the_numbers_do_not_matter_where_most_edges_are_of_equal_length)
{
  const Soup soup = folded_plate();
  const Surface graph = surface_of(soup);
  std::set<float> lengths;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    lengths.insert(float(graph.length(h)));
  BOOST_TEST(lengths.size() == 2u);
  const Surface expected = coarsen(framed(soup), 100).surface;
  Random random(8);
  for (int run = 0; run < 10; ++run) {
    std::vector<std::size_t> face;
    const Surface other = coarsen(framed(renumbered(soup, random, face)), 100).surface;
    BOOST_TEST((other.points == expected.points));
    BOOST_TEST((other.corners == expected.corners));
    BOOST_TEST((other.opposite == expected.opposite));
  }
}

BOOST_AUTO_TEST_CASE(small_meshes_stay)
{
  const Soup soup = rough_dumbbell(6);
  const Surface mesh = surface_of(soup);
  const Level coarse = coarsen(mesh, mesh.number_of_faces());
  check(mesh, coarse);
  BOOST_TEST(coarse.surface.number_of_faces() == mesh.number_of_faces());
  BOOST_TEST(volume(coarse.surface) == volume(mesh), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(no_component_vanishes)
{
  Soup soup = sphere(3);
  for (int i = 1; i <= 20; ++i)
    soup = disjoint_union(soup, moved(scaled(sphere(1), 0.01), 2. * i, 0, 0));
  const Surface mesh = surface_of(soup);
  const Level coarse = coarsen(mesh, 1);
  check(mesh, coarse);
  BOOST_TEST(coarse.surface.number_of_faces() == 21 * 4); // tetrahedra
}

BOOST_AUTO_TEST_CASE(hubs_of_thousands_of_faces_stay)
{
  // Two cones with a common circle.
  Soup soup{{Point(0, 0, 1), Point(0, 0, -0.8)}, {}};
  const std::size_t n = 3000;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    soup.triangles.push_back({0, i + 2, (i + 1) % n + 2});
    soup.triangles.push_back({1, (i + 1) % n + 2, i + 2});
  }
  const Surface mesh = surface_of(soup);
  const Level coarse = coarsen(mesh, 200);
  check(mesh, coarse);
  BOOST_TEST(coarse.surface.number_of_faces() <= 200);
  BOOST_TEST(volume(coarse.surface) == volume(mesh), boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_vertex_where_two_surfaces_meet_stays)
{
  // Two spheres that have one vertex in common.
  Soup soup = disjoint_union(sphere(3), moved(sphere(3), 5, 0, 0));
  const std::size_t half = soup.points.size() / 2;
  Surface mesh = surface_of(soup);
  for (std::array<Index, 3>& corners : mesh.corners)
    for (Index& v : corners)
      if (v == half)
        v = 0;
  const Level coarse = coarsen(mesh, 200);
  check(mesh, coarse);
  BOOST_TEST(coarse.surface.number_of_faces() <= 200);
  std::map<Index, std::set<Index> > sides; // one per vertex that is left
  for (Index f = 0; f < coarse.parent_face.size(); ++f)
    for (Index v : coarse.surface.corners[f])
      sides[v].insert(coarse.parent_face[f] < mesh.number_of_faces() / 2 ? 0 : 1);
  for (const auto& [v, s] : sides)
    BOOST_TEST((s.size() == 2) == (v == coarse.coarse_vertex[0]));
}

BOOST_AUTO_TEST_CASE(faces_without_area_do_no_harm)
{
  Soup soup = sphere(3);
  for (std::size_t v : {10, 11, 12, 200, 201}) // many edges without length
    soup.points[v] = soup.points[v + 1];
  const Surface mesh = surface_of(soup);
  const Level coarse = coarsen(mesh, 300);
  check(mesh, coarse);
  BOOST_TEST(coarse.surface.number_of_faces() <= 300);
  const Surface flat = surface_of({{Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0),
                                               Point(3, 0, 0)}, {{0, 1, 2}, {0, 2, 3}}});
  check(flat, coarsen(flat, 1));
}

BOOST_AUTO_TEST_CASE(a_large_mesh_becomes_even)
{
  const Surface mesh = surface_of(sphere(6)); // 81920 faces
  const Level coarse = coarsen(mesh, 5000);
  check(mesh, coarse);
  const Surface& graph = coarse.surface;
  BOOST_TEST(graph.number_of_faces() <= 5000);
  BOOST_TEST(graph.number_of_faces() >= 4998);
  BOOST_TEST(euler_characteristic(graph) == 2);
  BOOST_TEST(volume(graph) == volume(mesh), boost::test_tools::tolerance(0.002));
  const double mean = internal::total_area(graph) / double(graph.number_of_faces());
  for (double area : graph.areas)
    BOOST_TEST(area < mean * 4);
  BOOST_TEST(std::count_if(graph.areas.begin(), graph.areas.end(),
                           [&](double area) { return area < mean / 8; }) < 50);
}

namespace {

Level clustered(const Surface& mesh, double width)
{ return internal::Vertex_clustering(mesh, width)(sequential); }

} // namespace

BOOST_AUTO_TEST_CASE(clusters_keep_the_topology_whatever_their_width)
{
  Random random(5);
  const Soup soups[] = {sphere(4), torus(2, 0.2, 60, 30), plate(30, 20), dumbbell(30, 24),
                        surface_of_revolution({{0, 1}, {1, 0.5}, {2, 0.8}, {3, 1}}, 100),
                        disjoint_union(sphere(3), moved(scaled(plate(9, 9), 0.01), 3, 0, 0))};
  std::size_t number_of_smaller = 0;
  for (const Soup& soup : soups)
    for (double width : {0.01, 0.05, 0.1, 0.3, 1., 10.}) {
      const Surface mesh = framed(displaced(soup, 0.002, random));
      const Level coarse = clustered(mesh, width);
      BOOST_TEST(number_of_components(coarse.surface) == number_of_components(mesh));
      BOOST_TEST(coarse.surface.components.number == mesh.components.number);
      BOOST_TEST(euler_characteristic(coarse.surface) == euler_characteristic(mesh));
      BOOST_TEST(coarse.surface.number_of_faces() > 0u);
      number_of_smaller += coarse.surface.number_of_faces() < mesh.number_of_faces();
      for (Index h = 0; h < coarse.surface.number_of_halfedges(); ++h) {
        const Index o = coarse.surface.opposite[h];
        BOOST_TEST(coarse.surface.opposite[o] == h);
        if (o == h)
          continue;
        BOOST_TEST(coarse.surface.source_vertex(o) == coarse.surface.target_vertex(h));
        BOOST_TEST(coarse.surface.target_vertex(o) == coarse.surface.source_vertex(h));
      }
    }
  BOOST_TEST(number_of_smaller > 20u);
}

BOOST_AUTO_TEST_CASE(sheets_that_come_near_stay_apart)
{
  const Soup sheet = scaled(plate(40, 40), 0.01);
  const Surface mesh = surface_of(disjoint_union(sheet, moved(sheet, 0, 0, 1e-4)));
  const Level coarse = clustered(mesh, 0.2);
  BOOST_TEST(coarse.surface.number_of_faces() < mesh.number_of_faces() / 10);
  std::vector<Index> sheet_of(coarse.surface.points.size(), null_index);
  for (Index v = 0; v < coarse.coarse_vertex.size(); ++v) {
    const Index side = v < sheet.points.size() ? 0 : 1;
    Index& of_vertex = sheet_of[coarse.coarse_vertex[v]];
    BOOST_TEST((of_vertex == null_index || of_vertex == side));
    of_vertex = side;
  }
}

BOOST_AUTO_TEST_CASE(a_cluster_stays_on_the_planes_around_it)
{
  // A roof: two planes that meet in the line x = z = 0.
  Soup soup = plate(60, 30);
  for (Point& p : soup.points)
    p = Point(p.x() - 30, p.y(), -std::abs(p.x() - 30));
  const Surface mesh = framed(soup);
  const Surface roof = clustered(mesh, 0.11).surface;
  BOOST_TEST(roof.number_of_faces() < mesh.number_of_faces() / 3);
  const Vector first = mesh.normal(0).normalized();
  const Vector second = mesh.normal(Index(mesh.number_of_faces()) - 1).normalized();
  for (const Vector& p : roof.points) {
    const double to_first = std::abs(first.dot(p - mesh.points[mesh.corners[0][0]]));
    const double to_second = std::abs(second.dot(p - mesh.points[mesh.corners.back()[0]]));
    BOOST_TEST(std::min(to_first, to_second) < 0.11 / 50);
  }
}

BOOST_AUTO_TEST_SUITE_END()
