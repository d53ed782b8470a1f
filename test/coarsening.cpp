// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Edge_queue.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/domains.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(coarsening)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::null_index;
using internal::Coarse_mesh;
using internal::Execution;
using internal::Vector;

namespace {

// Exactly the number, with one thread or several.
Coarse_mesh coarsen(const Surface& mesh, std::size_t number_of_faces,
                    Execution execution = Execution::SEQUENTIAL)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  return internal::coarsen(execution, mesh, number_of_faces, false, monitor, 0);
}

std::vector<Coarse_mesh> coarsen_in_steps(const Surface& mesh, std::size_t number_of_faces)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  return internal::coarsen_in_steps(sequential, mesh, number_of_faces, monitor);
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
void check(const Surface& mesh, const Coarse_mesh& coarse)
{
  const Surface& graph = coarse.graph;
  const std::size_t n = graph.number_of_faces();
  BOOST_TEST_REQUIRE(coarse.faces.size() == n);
  BOOST_TEST(std::is_sorted(coarse.faces.begin(), coarse.faces.end()));
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
  BOOST_TEST_REQUIRE(coarse.vertices.size() == mesh.points.size());
  const auto corners = [&](Index f) {
    std::array<Index, 3> result;
    for (int i = 0; i < 3; ++i)
      result[i] = coarse.vertices[mesh.corners[f][i]];
    return result;
  };
  for (Index f = 0; f < n; ++f) {
    is_left[coarse.faces[f]] = 1;
    BOOST_TEST((corners(coarse.faces[f]) == graph.corners[f]));
  }
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (!is_left[f]) {
      const std::array<Index, 3> c = corners(f);
      BOOST_TEST((c[0] == c[1] || c[1] == c[2] || c[2] == c[0]));
    }
}

Soup rough_dumbbell(unsigned seed)
{
  Random random(seed);
  return displaced(dumbbell(30, 24), 0.01, random);
}

Soup turned(Soup soup)
{
  const Eigen::Matrix3d r =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  for (Point& p : soup.points) {
    const Eigen::Vector3d q = r * Eigen::Vector3d(p.x(), p.y(), p.z()) + Eigen::Vector3d(3, -1, 7);
    p = Point(q.x(), q.y(), q.z());
  }
  return soup;
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
      const Coarse_mesh coarse = coarsen(mesh, number);
      check(mesh, coarse);
      BOOST_TEST(coarse.graph.number_of_faces() <= number);
      BOOST_TEST(coarse.graph.number_of_faces() + 2 >= number);
      BOOST_TEST(euler_characteristic(coarse.graph) == euler_characteristic(mesh));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_sphere_keeps_its_volume_and_its_faces_are_alike)
{
  const Surface mesh = surface_of(sphere(5));
  const Coarse_mesh coarse = coarsen(mesh, 1000);
  const Surface& graph = coarse.graph;
  // With its vertices on the sphere a mesh of 1000 faces lacks 1 % of the volume.
  BOOST_TEST(volume(graph) == volume(mesh), boost::test_tools::tolerance(0.002));
  const double mean = internal::total_area(graph) / double(graph.number_of_faces());
  for (Index f = 0; f < graph.number_of_faces(); ++f) {
    const std::array<Index, 3>& c = graph.corners[f];
    BOOST_TEST(graph.areas[f] > mean / 5);
    BOOST_TEST(graph.areas[f] < mean * 4);
    const Vector &p = graph.points[c[0]], &q = graph.points[c[1]], &r = graph.points[c[2]];
    BOOST_TEST((q - p).cross(r - p).dot(p + q + r) > 0); // outwards
  }
}

BOOST_AUTO_TEST_CASE(a_plate_keeps_its_outline)
{
  const Surface mesh = surface_of(plate(40, 30));
  const Coarse_mesh coarse = coarsen(mesh, 100);
  BOOST_TEST(internal::total_area(coarse.graph) == internal::total_area(mesh),
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
  const Coarse_mesh coarse = coarsen(mesh, 800);
  BOOST_TEST(volume(coarse.graph) == volume(mesh), boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(the_result_moves_with_the_mesh)
{
  for (unsigned seed : {1, 2, 3}) {
    const Soup soup = rough_dumbbell(seed);
    const Coarse_mesh here = coarsen(surface_of(soup), 400),
                          there = coarsen(surface_of(turned(soup)), 400);
    BOOST_TEST((here.faces == there.faces));
    BOOST_TEST((here.vertices == there.vertices));
  }
}

namespace {

// The same soup with its vertices and faces in a random order, and faces from a random corner on;
// `face` gets the new number of each face.
Soup renumbered(const Soup& soup, Random& random, std::vector<std::size_t>& face)
{
  std::vector<std::size_t> vertex(soup.points.size());
  face.resize(soup.triangles.size());
  std::iota(vertex.begin(), vertex.end(), std::size_t(0));
  std::iota(face.begin(), face.end(), std::size_t(0));
  std::shuffle(vertex.begin(), vertex.end(), random);
  std::shuffle(face.begin(), face.end(), random);
  Soup result = soup;
  for (std::size_t v = 0; v < vertex.size(); ++v)
    result.points[vertex[v]] = soup.points[v];
  for (std::size_t f = 0; f < face.size(); ++f) {
    const std::vector<std::size_t>& t = soup.triangles[f];
    const std::size_t first = random() % 3;
    result.triangles[face[f]] = {vertex[t[first]], vertex[t[(first + 1) % 3]],
                                 vertex[t[(first + 2) % 3]]};
  }
  return result;
}

// The points of a coarse mesh in a cyclic order of each face that does not depend on numbers.
std::set<std::vector<std::array<double, 3> > > triangles_in_space(const Surface& graph)
{
  std::set<std::vector<std::array<double, 3> > > result;
  for (const std::array<Index, 3>& corners : graph.corners) {
    std::vector<std::array<double, 3> > points;
    for (Index v : corners)
      points.push_back({graph.points[v].x(), graph.points[v].y(), graph.points[v].z()});
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    result.insert(points);
  }
  return result;
}

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
    const Coarse_mesh coarse = coarsen(surface_of(renumbered(soup, random, face)), 400);
    std::set<Index> expected, left(coarse.faces.begin(), coarse.faces.end());
    for (Index f : coarsen(surface_of(soup), 400).faces)
      expected.insert(Index(face[f]));
    BOOST_TEST((left == expected));
  }
}

// So the hash decides. The mesh has no symmetry, as the principal frame of one that has some
// depends on the rounding of sums.
BOOST_AUTO_TEST_CASE(the_numbers_do_not_matter_where_most_edges_are_of_equal_length)
{
  const Soup soup = folded_plate();
  const Surface graph = surface_of(soup);
  std::set<float> lengths;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    lengths.insert(float(graph.length(h)));
  BOOST_TEST(lengths.size() == 2u);
  const auto expected = triangles_in_space(coarsen(graph, 100).graph);
  Random random(8);
  for (int run = 0; run < 10; ++run) {
    std::vector<std::size_t> face;
    const Coarse_mesh other = coarsen(surface_of(renumbered(soup, random, face)), 100);
    BOOST_TEST((triangles_in_space(other.graph) == expected));
  }
}

BOOST_AUTO_TEST_CASE(a_queue_gives_edges_by_length_then_by_the_other_number)
{
  using internal::Edge_queue;
  Random random(9);
  Edge_queue queue;
  std::vector<Edge_queue::Edge> expected; // ascending
  const auto push = [&](double least) {
    const float squared_length =
      float(least + std::ldexp(double(random() % 64), int(random() % 40) - 30));
    const Edge_queue::Edge edge(Edge_queue::key(squared_length, std::uint32_t(random() % 4)),
                                Index(random() % 1000));
    queue.push(edge);
    expected.insert(std::upper_bound(expected.begin(), expected.end(), edge), edge);
  };
  for (int i = 0; i < 2000; ++i)
    push(0);
  for (int i = 0; !expected.empty(); ++i) {
    const auto edge = queue.pop();
    BOOST_TEST_REQUIRE(edge.has_value());
    BOOST_TEST((*edge == expected.front()));
    expected.erase(expected.begin());
    // A shorter one than the last, too.
    if (i % 3 == 0 && i < 3000)
      push(random() % 2 == 0 ? 0 : 1);
  }
  BOOST_TEST(!queue.pop().has_value());
  BOOST_TEST((Edge_queue::key(0.f, 5) < Edge_queue::key(1e-40f, 0)));
  BOOST_TEST((Edge_queue::key(1.f, 0xffffffff) < Edge_queue::key(1.0000001f, 0)));
}

BOOST_AUTO_TEST_CASE(domains_have_each_face_once_and_are_compact)
{
  const Surface graph = surface_of(torus(3, 1, 100, 60));
  const auto domains = internal::domains(graph.corners, graph.points, 500);
  BOOST_TEST(domains.size() > 5u);
  std::vector<Index> all;
  for (const std::vector<Index>& faces : domains) {
    BOOST_TEST_REQUIRE(!faces.empty());
    std::vector<Vector> centroids;
    for (Index f : faces) {
      centroids.push_back(graph.centroid(f));
      all.push_back(f);
    }
    const internal::Bounding_box box(centroids);
    // Four cells wide, as 12000 faces are in two layers of cells.
    BOOST_TEST((box.largest - box.smallest).largest_coordinate() <=
               8. / 3 / unit_of(torus(3, 1, 100, 60)) * 1.0001);
  }
  std::sort(all.begin(), all.end());
  BOOST_TEST_REQUIRE(all.size() == graph.number_of_faces());
  for (Index f = 0; f < all.size(); ++f)
    BOOST_TEST(all[f] == f);
}

BOOST_AUTO_TEST_CASE(faces_are_shared_by_area_but_no_domain_gives_more_than_it_has)
{
  const std::vector<std::vector<Index> > faces = {std::vector<Index>(100), std::vector<Index>(100),
                                                  std::vector<Index>(2), std::vector<Index>(7)};
  const std::vector<double> areas = {1, 3, 4, 0}; // the last has no area
  for (double number : {1., 2., 3., 30., 102., 150., 200.}) {
    const double per_area = internal::shared_by_area(number, faces, areas);
    double sum = 0;
    for (std::size_t d = 0; d < 3; ++d)
      sum += std::min(per_area * areas[d], double(faces[d].size()));
    BOOST_TEST(sum == number, boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(internal::shared_by_area(1000, faces, areas) > 1e100); // all of them
}

BOOST_AUTO_TEST_CASE(what_is_small_enough_stays)
{
  const Soup soup = rough_dumbbell(6);
  const Surface mesh = surface_of(soup);
  const Coarse_mesh coarse = coarsen(mesh, mesh.number_of_faces());
  check(mesh, coarse);
  BOOST_TEST(coarse.graph.number_of_faces() == mesh.number_of_faces());
  BOOST_TEST(volume(coarse.graph) == volume(mesh), boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(no_component_vanishes)
{
  Soup soup = sphere(3);
  for (int i = 1; i <= 20; ++i)
    soup = disjoint_union(soup, moved(scaled(sphere(1), 0.01), 2. * i, 0, 0));
  const Surface mesh = surface_of(soup);
  const Coarse_mesh coarse = coarsen(mesh, 1);
  check(mesh, coarse);
  BOOST_TEST(coarse.graph.number_of_faces() == 21 * 4); // tetrahedra
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
  const Coarse_mesh coarse = coarsen(mesh, 200);
  check(mesh, coarse);
  BOOST_TEST(coarse.graph.number_of_faces() <= 200);
  std::map<Index, std::set<Index> > sides; // one per vertex that is left
  for (Index f = 0; f < coarse.faces.size(); ++f)
    for (Index v : coarse.graph.corners[f])
      sides[v].insert(coarse.faces[f] < mesh.number_of_faces() / 2 ? 0 : 1);
  for (const auto& [v, s] : sides)
    BOOST_TEST((s.size() == 2) == (v == coarse.vertices[0]));
}

BOOST_AUTO_TEST_CASE(faces_without_area_do_no_harm)
{
  Soup soup = sphere(3);
  for (std::size_t v : {10, 11, 12, 200, 201}) // many edges without length
    soup.points[v] = soup.points[v + 1];
  const Surface mesh = surface_of(soup);
  const Coarse_mesh coarse = coarsen(mesh, 300);
  check(mesh, coarse);
  BOOST_TEST(coarse.graph.number_of_faces() <= 300);
  const Surface flat = surface_of({{Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0),
                                               Point(3, 0, 0)}, {{0, 1, 2}, {0, 2, 3}}});
  check(flat, coarsen(flat, 1));
}

BOOST_AUTO_TEST_CASE(steps_lead_from_the_mesh_to_the_number)
{
  const Surface mesh = surface_of(sphere(5)); // 20480 faces
  BOOST_TEST(coarsen_in_steps(mesh, 4000).size() == 1);
  const std::vector<Coarse_mesh> steps = coarsen_in_steps(mesh, 100);
  BOOST_TEST_REQUIRE(steps.size() == 2);
  check(mesh, steps[0]);
  check(steps[0].graph, steps[1]);
  BOOST_TEST(steps[0].graph.number_of_faces() <= 1600);
  BOOST_TEST(steps[1].graph.number_of_faces() <= 100);
}

BOOST_AUTO_TEST_CASE(only_the_last_step_of_a_large_mesh_leaves_no_more_than_the_number)
{
  const Surface mesh = surface_of(sphere(6)); // 81920 faces
  const std::vector<Coarse_mesh> steps = coarsen_in_steps(mesh, 1000);
  BOOST_TEST_REQUIRE(steps.size() == 2);
  check(mesh, steps[0]);
  check(steps[0].graph, steps[1]);
  BOOST_TEST(steps[0].graph.number_of_faces() >= 16000);
  BOOST_TEST(steps[0].graph.number_of_faces() <= 24000);
  BOOST_TEST(steps[1].graph.number_of_faces() <= 1000);
  BOOST_TEST(steps[1].graph.number_of_faces() >= 998);
}

BOOST_AUTO_TEST_CASE(a_large_mesh_is_coarsened_in_domains_and_shows_no_seam)
{
  const Surface mesh = surface_of(sphere(6)); // 81920 faces
  const Coarse_mesh coarse = coarsen(mesh, 5000);
  check(mesh, coarse);
  const Surface& graph = coarse.graph;
  BOOST_TEST(graph.number_of_faces() <= 5000);
  BOOST_TEST(graph.number_of_faces() >= 4998);
  BOOST_TEST(euler_characteristic(graph) == 2);
  BOOST_TEST(volume(graph) == volume(mesh), boost::test_tools::tolerance(0.001));
  const double mean = internal::total_area(graph) / double(graph.number_of_faces());
  for (double area : graph.areas)
    BOOST_TEST(area < mean * 3);
  // A sliver or two are anywhere; along seams there would be hundreds.
  BOOST_TEST(std::count_if(graph.areas.begin(), graph.areas.end(),
                           [&](double area) { return area < mean / 8; }) < 5);
  const Coarse_mesh parallel = coarsen(mesh, 5000, Execution::PARALLEL);
  BOOST_TEST((parallel.faces == coarse.faces));
  BOOST_TEST((parallel.vertices == coarse.vertices));
  BOOST_TEST((parallel.graph.points == graph.points));
}

BOOST_AUTO_TEST_CASE(a_large_mesh_keeps_its_faces_where_it_has_many)
{
  // A plate of two faces, far away and large, has hardly any faces to give.
  const Soup soup = disjoint_union(sphere(6), moved(scaled(plate(1, 1), 200), 0, 0, -300));
  const Surface mesh = surface_of(soup);
  const Coarse_mesh coarse = coarsen(mesh, 5000);
  check(mesh, coarse);
  BOOST_TEST(coarse.graph.number_of_faces() <= 5000);
  BOOST_TEST(coarse.graph.number_of_faces() >= 4998);
}

BOOST_AUTO_TEST_SUITE_END()
