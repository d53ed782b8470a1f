// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_MESH_MODELS_H
#define SPECTRAL_SEGMENTATION_TEST_MESH_MODELS_H

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <vector>

// Meshes of any type that the Boost Graph Library knows.
namespace test_meshes {

// Returns the labels in the order of the faces.
template <class Graph, class NamedParameters>
Labels labels_of_graph(const Graph& graph, const NamedParameters& np)
{
  typedef typename boost::graph_traits<Graph>::face_descriptor face_descriptor;
  std::map<face_descriptor, std::size_t> ids;
  const std::size_t n =
    CGAL::segment_spectral_recursive(graph, boost::make_assoc_property_map(ids), np);
  Labels labels;
  for (face_descriptor f : faces(graph))
    labels.push_back(ids.at(f));
  if (labels.size() != ids.size() || n != number_of(labels))
    throw std::logic_error("ids and number of segments do not agree");
  return labels;
}

// Returns the labels by the default method, then those by the method of the paper. Two threads may
// call it, because it has no context of Boost.Test.
template <class Graph>
Labels labels_of_graph(const Graph& graph)
{
  namespace parameters = CGAL::Spectral_segmentation::parameters;
  Labels result = labels_of_graph(graph, parameters::salience_threshold(0.4));
  const Labels paper =
    labels_of_graph(graph, parameters::zhang_liu_2005().salience_threshold(0.4));
  result.insert(result.end(), paper.begin(), paper.end());
  return result;
}

// Adds vertices and faces in the order of the soup.
template <class Graph>
void fill(Graph& graph, const Soup& soup)
{
  typedef typename boost::property_map<Graph, CGAL::vertex_point_t>::type Point_map;
  std::vector<typename boost::property_traits<Point_map>::value_type> points;
  for (const Point& p : soup.points)
    points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, graph);
}

// Makes a manifold soup without isolated vertices, whose coordinates are exact in single precision.
inline Soup rounded(const Soup& soup)
{
  const Mesh mesh = mesh_of(soup);
  Soup result;
  std::map<Mesh::Vertex_index, std::size_t> number;
  for (Mesh::Face_index f : mesh.faces()) {
    result.triangles.emplace_back();
    for (Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh)) {
      const auto [entry, is_new] = number.emplace(v, result.points.size());
      if (is_new) {
        const Point& p = mesh.point(v);
        result.points.emplace_back(float(p.x()), float(p.y()), float(p.z()));
      }
      result.triangles.back().push_back(entry->second);
    }
  }
  return result;
}

inline const std::vector<Soup>& soups_of_models()
{
  static const std::vector<Soup> result = {
    rounded(doll()), rounded(read("cactus.off")),
    rounded(disjoint_union(dumbbell(10, 8), torus(3, 1, 14, 10))), rounded(plate(5, 4))};
  return result;
}

// Checks that a run would read the same arrays from both meshes.
template <class Graph>
void check_arrays(const Graph& graph, const Mesh& mesh)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  const auto read_arrays = [](const auto& g) {
    const auto np = CGAL::parameters::default_values();
    return internal::read_mesh_with_parameters(g, internal::numbered_faces(g, np), np);
  };
  const Surface surface = read_arrays(graph), expected = read_arrays(mesh);
  BOOST_TEST((surface.points == expected.points));
  BOOST_TEST((surface.corners == expected.corners));
  BOOST_TEST((surface.opposite == expected.opposite));
}

// Checks the arrays of a model with the faces of a mesh.
template <class Graph>
void check_arrays_of_model()
{
  check_arrays(Graph(), Mesh());
  for (const Soup& soup : soups_of_models()) {
    Graph graph;
    fill(graph, soup);
    check_arrays(graph, mesh_of(soup));
  }
}

// Checks the labels of a model, and that an empty one has none.
template <class Graph>
void check_labels_of_model()
{
  BOOST_TEST(labels_of_graph(Graph()).empty());
  const Soup& soup = soups_of_models()[0];
  Graph graph;
  fill(graph, soup);
  BOOST_TEST(labels_of_graph(graph) == labels_of_graph(mesh_of(soup)),
             boost::test_tools::per_element());
}

} // namespace test_meshes

#endif // SPECTRAL_SEGMENTATION_TEST_MESH_MODELS_H
