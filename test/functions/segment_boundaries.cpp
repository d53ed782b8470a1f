// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/segment_boundaries.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(segment_boundaries)

namespace PMP = CGAL::Polygon_mesh_processing;
using namespace test_meshes;

namespace {

typedef CGAL::Polyhedron_3<Kernel> Polyhedron;

// By the place of the centroid of each face.
template <class Function>
std::vector<int> ids_by(const Mesh& mesh, const Function& id_at)
{
  std::vector<int> result;
  for (Mesh::Face_index f : mesh.faces()) {
    const auto v = mesh.vertices_around_face(mesh.halfedge(f)).begin();
    result.push_back(id_at(CGAL::centroid(mesh.point(*v), mesh.point(*std::next(v)),
                                          mesh.point(*std::next(v, 2)))));
  }
  return result;
}

auto map_of(const std::vector<int>& ids, const Mesh& mesh)
{ return boost::make_iterator_property_map(ids.begin(), get(CGAL::face_index, mesh)); }

template <class Function>
auto boundaries_by(const Mesh& mesh, const Function& id_at)
{
  const std::vector<int> ids = ids_by(mesh, id_at);
  return CGAL::segment_boundaries(mesh, map_of(ids, mesh));
}

// Compares with the result of a loop over all edges. Returns the number of polylines.
template <class AnyMesh, class SegmentIdMap>
std::size_t check(const AnyMesh& mesh, SegmentIdMap segment_ids)
{
  typedef boost::graph_traits<AnyMesh> Traits;
  std::set<typename Traits::edge_descriptor> expected;
  std::map<typename Traits::vertex_descriptor, int> degree; // in the graph of these edges
  std::set<typename Traits::vertex_descriptor> border;
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    const auto f = face(h, mesh), g = face(opposite(h, mesh), mesh);
    const bool is_border = f == Traits::null_face() || g == Traits::null_face();
    if (!is_border && get(segment_ids, f) == get(segment_ids, g))
      continue;
    if (!is_border)
      expected.insert(e);
    for (auto v : {source(h, mesh), target(h, mesh)})
      if (is_border)
        border.insert(v);
      else
        ++degree[v];
  }

  const auto boundaries = CGAL::segment_boundaries(mesh, segment_ids);
  std::set<typename Traits::edge_descriptor> found;
  for (const auto& b : boundaries) {
    BOOST_TEST_REQUIRE(!b.halfedges.empty());
    BOOST_TEST(b.segments[0] < b.segments[1]);
    const auto vertices = b.vertices(mesh);
    BOOST_TEST_REQUIRE(vertices.size() == b.halfedges.size() + 1);
    for (std::size_t i = 0; i < b.halfedges.size(); ++i) {
      const auto h = b.halfedges[i];
      BOOST_TEST(found.insert(edge(h, mesh)).second);
      BOOST_TEST((source(h, mesh) == vertices[i] && target(h, mesh) == vertices[i + 1]));
      BOOST_TEST(get(segment_ids, face(h, mesh)) == b.segments[0]);
      BOOST_TEST(get(segment_ids, face(opposite(h, mesh), mesh)) == b.segments[1]);
      if (i > 0)
        BOOST_TEST((degree[vertices[i]] == 2 && border.count(vertices[i]) == 0));
    }
    const bool is_passed = degree[vertices.front()] == 2 && border.count(vertices.front()) == 0;
    const bool is_passed_at_end =
      degree[vertices.back()] == 2 && border.count(vertices.back()) == 0;
    BOOST_TEST((is_passed ? vertices.front() == vertices.back() : !is_passed_at_end));
  }
  BOOST_TEST((found == expected));

  std::map<typename Traits::edge_descriptor, bool> marks;
  BOOST_TEST(CGAL::mark_segment_boundaries(mesh, segment_ids,
                                           boost::make_assoc_property_map(marks)) ==
             expected.size());
  BOOST_TEST(marks.size() == num_edges(mesh));
  for (const auto& [e, mark] : marks)
    BOOST_TEST(mark == (expected.count(e) > 0));
  return boundaries.size();
}

// With any numbers as ids, first in patches, then each face for itself.
template <class AnyMesh>
void check_with_random_ids(const AnyMesh& mesh, Random& random)
{
  constexpr int numbers[] = {(std::numeric_limits<int>::min)(), -1, 0, 7,
                             (std::numeric_limits<int>::max)()};
  std::map<typename boost::graph_traits<AnyMesh>::face_descriptor, int> ids;
  int id = 0;
  for (auto f : faces(mesh)) {
    if (random() % 10 == 0)
      id = numbers[random() % 5];
    ids[f] = id;
  }
  check(mesh, boost::make_assoc_property_map(ids));
  for (auto& entry : ids)
    entry.second = numbers[random() % 5];
  check(mesh, boost::make_assoc_property_map(ids));
}

} // namespace

BOOST_AUTO_TEST_CASE(boundaries_of_a_row_of_cubes_are_loops)
{
  Cells cells;
  add_box(cells, {0, 0, 0}, {3, 1, 1});
  const Mesh mesh = mesh_of(boundary_of(cells));
  const auto boundaries = boundaries_by(
    mesh, [](const Point& p) { return (std::min)(int(p.x()), 2) * 4 - 7; });
  BOOST_TEST_REQUIRE(boundaries.size() == 2);
  for (const auto& b : boundaries) {
    BOOST_TEST_REQUIRE(b.halfedges.size() == 4);
    const double x = b.segments[0] == -7 ? 1 : 2;
    BOOST_TEST(b.segments[1] == b.segments[0] + 4);
    const auto vertices = b.vertices(mesh);
    BOOST_TEST(vertices.front() == vertices.back());
    BOOST_TEST(std::set<Mesh::Vertex_index>(vertices.begin(), vertices.end()).size() == 4);
    double signed_area = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &p = mesh.point(vertices[i]), &q = mesh.point(vertices[i + 1]);
      BOOST_TEST(p.x() == x);
      signed_area += (p.y() * q.z() - p.z() * q.y()) / 2;
    }
    BOOST_TEST(signed_area == -1.); // clockwise, seen from the segment of larger x, on the right
  }
}

BOOST_AUTO_TEST_CASE(three_segments_meet_at_a_vertex)
{
  const Mesh mesh = mesh_of(plate(2, 2));
  const auto boundaries = boundaries_by(
    mesh, [](const Point& p) { return p.x() < 1 ? 0 : p.y() < 1 ? 1 : 2; });
  BOOST_TEST_REQUIRE(boundaries.size() == 3);
  std::map<std::array<int, 2>, std::set<std::size_t> > ends; // the vertex in the middle is 4
  for (const auto& b : boundaries)
    for (Mesh::Vertex_index v : b.vertices(mesh))
      ends[b.segments].insert(v);
  BOOST_TEST((ends[{0, 1}] == std::set<std::size_t>{1, 4}));
  BOOST_TEST((ends[{0, 2}] == std::set<std::size_t>{7, 4}));
  BOOST_TEST((ends[{1, 2}] == std::set<std::size_t>{5, 4}));
}

BOOST_AUTO_TEST_CASE(arc_from_border_to_border)
{
  const Mesh mesh = mesh_of(plate(4, 3));
  const auto boundaries = boundaries_by(mesh, [](const Point& p) { return p.x() < 2 ? 9 : -9; });
  BOOST_TEST_REQUIRE(boundaries.size() == 1);
  std::vector<double> heights; // the smaller id is on the right, so it goes down
  for (Mesh::Vertex_index v : boundaries[0].vertices(mesh)) {
    BOOST_TEST(mesh.point(v).x() == 2.);
    heights.push_back(mesh.point(v).y());
  }
  BOOST_TEST((heights == std::vector<double>{3, 2, 1, 0}));
}

BOOST_AUTO_TEST_CASE(segment_that_touches_itself_has_two_loops)
{
  const Mesh mesh = mesh_of(plate(4, 4));
  const auto boundaries = boundaries_by(mesh, [](const Point& p) {
    return int(p.x()) == int(p.y()) && (int(p.x()) == 1 || int(p.x()) == 2) ? 1 : 0;
  });
  BOOST_TEST_REQUIRE(boundaries.size() == 2);
  for (const auto& b : boundaries) {
    BOOST_TEST(b.halfedges.size() == 4);
    const auto vertices = b.vertices(mesh);
    BOOST_TEST(vertices.front() == vertices.back());
    BOOST_TEST(mesh.point(vertices.front()) == Point(2, 2, 0));
  }
}

// The sides of a cube need not be triangles.
BOOST_AUTO_TEST_CASE(faces_may_be_polygons)
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  BOOST_TEST_REQUIRE(mesh.number_of_faces() == 6);
  BOOST_TEST(check(mesh, map_of({5, 4, 3, 2, 1, 0}, mesh)) == 12);
  BOOST_TEST(check(mesh, map_of({5, 4, 4, 4, 4, 4}, mesh)) == 1);
  BOOST_TEST(check(mesh, map_of({5, 5, 5, 5, 5, 5}, mesh)) == 0);
}

BOOST_AUTO_TEST_CASE(edges_between_segments_of_small_meshes)
{
  Random random(1);
  for (const Soup& soup : small_soups())
    for (int run = 0; run < 5; ++run)
      check_with_random_ids(mesh_of(soup), random);
  const Mesh mesh = mesh_of(pillow());
  BOOST_TEST(check(mesh, map_of({0, 1}, mesh)) == 1);
  BOOST_TEST(check(Mesh(), map_of({}, mesh)) == 0);
}

BOOST_AUTO_TEST_CASE(edges_between_segments_of_polyhedra)
{
  Random random(2);
  for (const Soup& soup : small_soups()) {
    Polyhedron mesh;
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    check_with_random_ids(mesh, random);
  }
}

// Faces that are left out are beyond a border.
BOOST_AUTO_TEST_CASE(edges_between_segments_of_a_selection)
{
  const Mesh mesh = mesh_of(sphere(3));
  std::vector<int> ids = ids_by(mesh, [](const Point& p) { return p.z() > 0.5; });
  const CGAL::Face_filtered_graph<Mesh> cap(mesh, 1, map_of(ids, mesh));
  ids = ids_by(mesh, [](const Point& p) { return p.x() > 0; });
  BOOST_TEST(check(mesh, map_of(ids, mesh)) == 1); // a loop
  const auto boundaries = CGAL::segment_boundaries(cap, map_of(ids, mesh));
  BOOST_TEST_REQUIRE(boundaries.size() == 1); // an arc
  for (Mesh::Halfedge_index h : boundaries[0].halfedges)
    BOOST_TEST((cap.is_in_cc(mesh.face(h)) && cap.is_in_cc(mesh.face(mesh.opposite(h)))));
  const auto vertices = boundaries[0].vertices(cap);
  BOOST_TEST(vertices.front() != vertices.back());
}

BOOST_AUTO_TEST_CASE(edges_between_segments_of_real_meshes)
{
  Random random(3);
  for (const char* name : {"elephant", "hand", "cow"})
    BOOST_TEST_CONTEXT(name) {
      const Mesh mesh = mesh_of(read(name + std::string(".off")));
      check_with_random_ids(mesh, random);
    }
}

BOOST_AUTO_TEST_CASE(connected_components_between_marks_are_the_segments)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  Labels labels;
  const auto segment_ids = map_to(labels, mesh);
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  std::map<Mesh::Edge_index, bool> marks;
  const auto marks_of_edges = boost::make_assoc_property_map(marks);
  CGAL::mark_segment_boundaries(mesh, segment_ids, marks_of_edges);
  Labels components;
  BOOST_TEST(PMP::connected_components(
               mesh, map_to(components, mesh),
               CGAL::parameters::edge_is_constrained_map(marks_of_edges)) == n);
  BOOST_TEST(rand_index(labels, components) == 1.);
}

BOOST_AUTO_TEST_SUITE_END()
