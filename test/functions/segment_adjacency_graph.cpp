// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/segment_adjacency_graph.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/graph/connected_components.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(segment_adjacency_graph)

namespace internal = CGAL::Spectral_segmentation::internal;
namespace tt = boost::test_tools;
namespace params = CGAL::Spectral_segmentation::parameters;
using namespace test_meshes;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

auto map_of(const std::vector<int>& ids, const Mesh& mesh)
{ return boost::make_iterator_property_map(ids.begin(), get(CGAL::face_index, mesh)); }

// Compares with sums over all edges and faces.
template <class AnyMesh>
void check_with_random_ids(const AnyMesh& mesh, Random& random)
{
  std::map<typename boost::graph_traits<AnyMesh>::face_descriptor, int> ids;
  std::map<int, double> areas;
  std::map<int, std::size_t> numbers;
  int id = 0;
  const auto points = get(CGAL::vertex_point, mesh);
  for (auto f : faces(mesh)) {
    if (random() % 30 == 0)
      id = 1000 * (int(random() % 9) - 4);
    ids[f] = id;
    ++numbers[id];
    const auto h = halfedge(f, mesh);
    areas[id] += std::sqrt(CGAL::squared_area(get(points, source(h, mesh)),
                                              get(points, target(h, mesh)),
                                              get(points, target(next(h, mesh), mesh))));
  }
  std::map<std::pair<int, int>, double> lengths;
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if (is_border(e, mesh) || ids.at(face(h, mesh)) == ids.at(face(opposite(h, mesh), mesh)))
      continue;
    const std::pair<int, int> pair =
      std::minmax({ids.at(face(h, mesh)), ids.at(face(opposite(h, mesh), mesh))});
    lengths[pair] += std::sqrt(
      CGAL::squared_distance(get(points, source(h, mesh)), get(points, target(h, mesh))));
  }

  const auto graph = CGAL::segment_adjacency_graph(mesh, boost::make_assoc_property_map(ids));
  BOOST_TEST_REQUIRE(num_vertices(graph) == areas.size());
  auto area = areas.begin();
  for (std::size_t s = 0; s < num_vertices(graph); ++s, ++area) {
    BOOST_TEST(graph[s].id == area->first);
    BOOST_TEST(graph[s].area == area->second, tt::tolerance(1e-9));
    BOOST_TEST(graph[s].number_of_faces == numbers.at(area->first));
  }
  BOOST_TEST_REQUIRE(num_edges(graph) == lengths.size());
  auto length = lengths.begin();
  for (auto e : CGAL::make_range(edges(graph))) {
    BOOST_TEST(graph[source(e, graph)].id == length->first.first);
    BOOST_TEST(graph[target(e, graph)].id == length->first.second);
    BOOST_TEST(graph[e].length == length->second, tt::tolerance(1e-9));
    BOOST_TEST(graph[e].salience == 0.);
    ++length;
  }
}

// The node of fewest faces that has all faces of two segments.
std::size_t smallest_common_node(const Segmentation_hierarchy& hierarchy, const Labels& labels,
                                 std::size_t s, std::size_t t)
{
  const auto wanted = std::count(labels.begin(), labels.end(), s) +
                      std::count(labels.begin(), labels.end(), t);
  std::size_t result = 0;
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    const auto faces = hierarchy.faces(i);
    if (std::count_if(faces.begin(), faces.end(),
                      [&](std::size_t f) { return labels[f] == s || labels[f] == t; }) == wanted &&
        hierarchy.number_of_faces(i) <= hierarchy.number_of_faces(result))
      result = i;
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(row_of_cubes)
{
  Cells cells;
  add_box(cells, {0, 0, 0}, {3, 1, 1});
  const Mesh mesh = mesh_of(scaled(boundary_of(cells), 2));
  std::vector<int> ids;
  for (Mesh::Face_index f : mesh.faces()) {
    double x = 0;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      x += mesh.point(v).x() / 3;
    ids.push_back(x < 2 ? 40 : x < 4 ? -3 : 7);
  }
  const auto graph = CGAL::segment_adjacency_graph(mesh, map_of(ids, mesh));
  BOOST_TEST_REQUIRE(num_vertices(graph) == 3);
  BOOST_TEST((graph[0].id == -3 && graph[1].id == 7 && graph[2].id == 40));
  BOOST_TEST((graph[0].area == 16 && graph[1].area == 20 && graph[2].area == 20));
  BOOST_TEST((graph[0].number_of_faces == 8 && graph[1].number_of_faces == 10));
  BOOST_TEST(num_edges(graph) == 2);
  for (std::size_t end : {1, 2}) {
    const auto [boundary, is_there] = edge(0, end, graph);
    BOOST_TEST_REQUIRE(is_there);
    BOOST_TEST(graph[boundary].length == 8.);
  }
}

BOOST_AUTO_TEST_CASE(sums_over_edges_and_faces)
{
  Random random(1);
  for (const Soup& soup : small_soups()) {
    check_with_random_ids(mesh_of(soup), random);
    CGAL::Polyhedron_3<Kernel> polyhedron;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles,
                                                                polyhedron);
    check_with_random_ids(polyhedron, random);
  }
  for (const char* name : {"elephant", "hand", "cow"})
    BOOST_TEST_CONTEXT(name)
      check_with_random_ids(mesh_of(read(name + std::string(".off"))), random);
}

BOOST_AUTO_TEST_CASE(lengths_and_areas_of_extreme_coordinates)
{
  for (double scale : {1e-150, 1e150}) {
    const Mesh mesh = mesh_of(scaled(plate(2, 1), scale));
    const auto graph = CGAL::segment_adjacency_graph(mesh, map_of({0, 0, 1, 1}, mesh));
    BOOST_TEST(graph[*edges(graph).first].length == scale, tt::tolerance(1e-12));
    BOOST_TEST(graph[0].area == scale * scale, tt::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(exact_points_and_points_of_a_map)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  CGAL::Surface_mesh<Exact::Point_3> exact;
  CGAL::make_tetrahedron(Exact::Point_3(0, 0, 0), Exact::Point_3(3, 0, 0), Exact::Point_3(0, 4, 0),
                         Exact::Point_3(0, 0, 1), exact);
  auto ids = exact.add_property_map<CGAL::SM_Face_index, unsigned char>("f:id", 5).first;
  for (auto f : faces(exact))
    for (auto v : vertices_around_face(halfedge(f, exact), exact))
      if (exact.point(v).z() != 0)
        ids[f] = 9; // all but the base
  const auto graph = CGAL::segment_adjacency_graph(exact, ids);
  BOOST_TEST_REQUIRE(num_edges(graph) == 1);
  BOOST_TEST(graph[*edges(graph).first].length == 12.); // 3 + 4 + 5
  BOOST_TEST(graph[0].area == 6.);

  std::map<CGAL::SM_Vertex_index, Point> points;
  for (auto v : vertices(exact))
    points[v] = Point(2 * CGAL::to_double(exact.point(v).x()),
                      2 * CGAL::to_double(exact.point(v).y()), 0);
  const auto flat = CGAL::segment_adjacency_graph(
    exact, ids,
    params::vertex_point_map(boost::make_assoc_property_map(points)).geom_traits(Kernel()));
  BOOST_TEST(flat[*edges(flat).first].length == 24.);
}

BOOST_AUTO_TEST_CASE(salience_equals_the_salience_of_the_cut_between_two_segments)
{
  for (const char* name : {"elephant", "hand"}) {
    const Mesh mesh = mesh_of(read(name + std::string(".off")));
    Segmentation_hierarchy hierarchy;
    const Labels labels = labels_of(mesh, params::hierarchy(hierarchy));
    Labels copy = labels;
    const auto segment_ids =
      boost::make_iterator_property_map(copy.begin(), get(CGAL::face_index, mesh));
    const auto graph =
      CGAL::segment_adjacency_graph(mesh, segment_ids, hierarchy);
    BOOST_TEST(num_vertices(graph) == number_of(labels));
    std::vector<int> component(num_vertices(graph));
    BOOST_TEST(boost::connected_components(graph, component.data()) == 1);
    for (auto e : CGAL::make_range(edges(graph))) {
      const std::size_t s = source(e, graph), t = target(e, graph);
      BOOST_TEST(graph[e].salience ==
                 hierarchy.node(smallest_common_node(hierarchy, labels, s, t)).salience);
      // So it is the threshold above which the two are one segment.
      const std::size_t n = number_of(labels);
      const Labels apart = labels_above(hierarchy, graph[e].salience, n);
      const Labels joined = labels_above(hierarchy, std::nextafter(graph[e].salience, 2), n);
      const auto f = std::find(labels.begin(), labels.end(), s) - labels.begin();
      const auto g = std::find(labels.begin(), labels.end(), t) - labels.begin();
      BOOST_TEST(apart[f] != apart[g]);
      BOOST_TEST(joined[f] == joined[g]);
    }
  }
}

// There a node may have a parent with a larger number.
BOOST_AUTO_TEST_CASE(salience_after_segments_were_merged_by_hand)
{
  const Mesh mesh = mesh_of(read("hand.off"));
  Segmentation_hierarchy hierarchy;
  labels_of(mesh, params::hierarchy(hierarchy));
  std::vector<std::size_t> nodes = hierarchy.nodes(6);
  for (std::size_t b : {3, 4, 5})
    nodes[0] = hierarchy.merge(nodes[0], nodes[b]);
  Labels labels = labels_of_number(hierarchy, hierarchy.number_of_segments());
  const auto graph = CGAL::segment_adjacency_graph(
    mesh, boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)),
    hierarchy);
  BOOST_TEST(num_edges(graph) > 5);
  for (auto e : CGAL::make_range(edges(graph)))
    BOOST_TEST(graph[e].salience ==
               hierarchy.node(smallest_common_node(hierarchy, labels, source(e, graph),
                                                   target(e, graph))).salience);
}

BOOST_AUTO_TEST_CASE(saliences_of_boundaries_reach_the_threshold)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  Segmentation_hierarchy hierarchy;
  Labels labels = labels_of(mesh, params::zhang_liu_2005().hierarchy(hierarchy));
  const auto graph = CGAL::segment_adjacency_graph(
    mesh, boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)),
    hierarchy);
  BOOST_TEST(num_vertices(graph) > 3);
  for (auto e : CGAL::make_range(edges(graph)))
    BOOST_TEST(graph[e].salience >= hierarchy.salience_threshold());
}

BOOST_AUTO_TEST_CASE(faces_of_the_hierarchy_may_have_other_numbers)
{
  const Mesh mesh = mesh_of(dumbbell(20, 10));
  std::vector<std::size_t> reversed;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    reversed.push_back(mesh.number_of_faces() - 1 - f);
  const auto numbers =
    boost::make_iterator_property_map(reversed.begin(), get(CGAL::face_index, mesh));
  Segmentation_hierarchy hierarchy;
  Labels labels = labels_of(
    mesh, params::face_index_map(numbers).maximum_number_of_segments(2).hierarchy(hierarchy));
  const auto graph = CGAL::segment_adjacency_graph(
    mesh, boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)),
    hierarchy, params::face_index_map(numbers));
  BOOST_TEST_REQUIRE(num_edges(graph) == 1);
  const auto boundary = *edges(graph).first;
  BOOST_TEST(graph[boundary].salience == hierarchy.node(0).salience);
  BOOST_TEST(graph[boundary].salience > 0);
  BOOST_TEST(graph[0].number_of_faces == labels.size() / 2);
}

BOOST_AUTO_TEST_CASE(segments_that_the_hierarchy_does_not_separate)
{
  const Mesh mesh = mesh_of(disjoint_union(sphere(1), moved(sphere(1), 9, 0, 0)));
  Segmentation_hierarchy roots;
  labels_of(mesh, params::zhang_liu_2005().maximum_number_of_segments(2).hierarchy(roots));
  BOOST_TEST_REQUIRE(roots.number_of_nodes() == 2);
  std::vector<int> ids(mesh.number_of_faces(), 0);
  ids[0] = 1; // two segments in one leaf
  const auto graph =
    CGAL::segment_adjacency_graph(mesh, map_of(ids, mesh), roots);
  BOOST_TEST_REQUIRE(num_edges(graph) == 1);
  // The segment 0 has faces of both spheres, and more of the second.
  BOOST_TEST(graph[*edges(graph).first].salience == std::numeric_limits<double>::infinity());
  std::fill(ids.begin() + 81, ids.end(), 2); // now one face of the second only
  const auto other =
    CGAL::segment_adjacency_graph(mesh, map_of(ids, mesh), roots);
  BOOST_TEST_REQUIRE(num_edges(other) == 2);
  BOOST_TEST(other[edge(0, 1, other).first].salience == 0.);
  BOOST_TEST(other[edge(0, 2, other).first].salience ==
             std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(empty_mesh)
{
  const Mesh mesh;
  const auto graph = CGAL::segment_adjacency_graph(mesh, map_of({}, mesh));
  BOOST_TEST(num_vertices(graph) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused)
{
  const auto is_of_function = [](const std::invalid_argument& e)
  { return std::string(e.what()).rfind("segment_adjacency_graph: ", 0) == 0; };
  const Mesh mesh = mesh_of(plate(1, 1));
  Segmentation_hierarchy hierarchy;
  BOOST_CHECK_EXCEPTION(CGAL::segment_adjacency_graph(mesh, map_of({0, 1}, mesh),
                                                      hierarchy),
                        std::invalid_argument, is_of_function);
  BOOST_CHECK_EXCEPTION(CGAL::segment_adjacency_graph(mesh, map_of({0, 1}, mesh),
                                                      params::face_index_map(map_of({0, 0}, mesh))),
                        std::invalid_argument, is_of_function);
  Mesh quad;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), quad);
  BOOST_CHECK_EXCEPTION(CGAL::segment_adjacency_graph(quad, map_of({0}, quad)),
                        std::invalid_argument, is_of_function);
  Mesh infinite = mesh;
  infinite.point(Mesh::Vertex_index(2)) =
    Point(0, std::numeric_limits<double>::infinity(), 0);
  BOOST_CHECK_EXCEPTION(CGAL::segment_adjacency_graph(infinite, map_of({0, 1}, infinite)),
                        std::invalid_argument, is_of_function);
}

BOOST_AUTO_TEST_SUITE_END()
