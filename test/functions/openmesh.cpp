// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <boost/mpl/list.hpp>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <vector>

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;

namespace {

struct Double_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};

// The first two hold coordinates in single precision.
typedef boost::mpl::list<
  OpenMesh::PolyMesh_ArrayKernelT<>, OpenMesh::TriMesh_ArrayKernelT<>,
  OpenMesh::PolyMesh_ArrayKernelT<Double_traits>, OpenMesh::TriMesh_ArrayKernelT<Double_traits> >
  Models;

// By both methods.
template <class Graph>
Labels labels_of_graph(const Graph& graph)
{
  typedef typename boost::graph_traits<Graph>::face_descriptor face_descriptor;
  Labels labels;
  for_both_methods([&](const auto& np) {
    std::map<face_descriptor, std::size_t> ids;
    CGAL::segment_spectral_recursive(graph, boost::make_assoc_property_map(ids),
                                     np.salience_threshold(0.4));
    for (face_descriptor f : faces(graph))
      labels.push_back(ids.at(f));
  });
  return labels;
}

// A soup whose coordinates are exact in single precision.
Soup rounded(Soup soup)
{
  for (Point& p : soup.points)
    p = Point(float(p.x()), float(p.y()), float(p.z()));
  return soup;
}

// Vertices and faces are added in the order of the soup.
template <class Graph>
void fill(Graph& graph, const Soup& soup)
{
  typedef typename boost::property_map<Graph, CGAL::vertex_point_t>::type Point_map;
  std::vector<typename boost::property_traits<Point_map>::value_type> points;
  for (const Point& p : soup.points)
    points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, graph);
}

std::vector<Soup> soups()
{
  return {rounded(read("cactus.off")), rounded(doll()),
          rounded(disjoint_union(dumbbell(10, 8), torus(3, 1, 14, 10))), rounded(plate(5, 4))};
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(labels_are_those_of_a_surface_mesh, Graph, Models)
{
  for (const Soup& soup : soups()) {
    Graph graph;
    fill(graph, soup);
    BOOST_TEST(labels_of_graph(graph) == labels_of_graph(mesh_of(soup)), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(deleted_faces_are_left_out, Graph, Models)
{
  const Soup whole = rounded(doll());
  Soup rest = whole;
  rest.triangles.clear();
  Graph graph;
  graph.request_face_status();
  graph.request_edge_status();
  graph.request_halfedge_status();
  graph.request_vertex_status();
  fill(graph, whole);
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
    if (f % 50 == 0)
      graph.delete_face(graph.face_handle(unsigned(f)), false);
    else
      rest.triangles.push_back(whole.triangles[f]);
  BOOST_TEST(labels_of_graph(graph) == labels_of_graph(mesh_of(rest)), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_face_that_is_not_a_triangle_is_refused)
{
  OpenMesh::PolyMesh_ArrayKernelT<Double_traits> square;
  fill(square, {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, {{0, 1, 2, 3}}});
  BOOST_CHECK_THROW(labels_of_graph(square), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_empty_mesh_has_no_segments, Graph, Models)
{ BOOST_TEST(labels_of_graph(Graph()).empty()); }
