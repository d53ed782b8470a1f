// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_FACE_GRAPH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_FACE_GRAPH_H

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/utility/concurrency.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The weights of an edge for the search (Section 3).
struct Edge_weights
{
  float geodesic = 0;  // G, normalized
  float angle = 0;     // H, equalized
  float combined = 0;  // d, Equation 1
  float concavity = 0; // the part of H that is due to concave edges
  float centroids = 0; // the straight distance between the centroids of the two faces
};

// The faces of the mesh, or of a part of it, as arrays. It is a model of BGL's `VertexListGraph`
// and `IncidenceGraph` whose vertices are the faces.
//
// Halfedge 3f+i belongs to face f and runs from its corner i to its corner (i+1)%3. An edge on the
// border of the part leads back to its own face, where no graph algorithm takes notice of it.
struct Face_graph
{
  std::vector<Corners> corners;      // one per face
  std::vector<Index> neighbors;      // the face across each halfedge
  std::vector<double> areas;         // one per face
  std::vector<Vector> points;        // one per vertex
  std::vector<Edge_weights> weights; // one per halfedge; empty if no cut is searched

  std::size_t number_of_faces() const { return corners.size(); }
  Index number_of_halfedges() const { return static_cast<Index>(neighbors.size()); }

  Index source_vertex(Index h) const { return corners[h / 3][h % 3]; }
  Index target_vertex(Index h) const { return corners[h / 3][(h + 1) % 3]; }
  bool is_border(Index h) const { return neighbors[h] == h / 3; }

  double length(Index h) const
  { return (points[target_vertex(h)] - points[source_vertex(h)]).norm(); }

  Vector centroid(Index f) const { return centroid(f, points); }

  // Returns the centroid of a face whose vertices are at other points.
  Vector centroid(Index f, const std::vector<Vector>& other_points) const
  {
    const Corners& c = corners[f];
    return (other_points[c[0]] + other_points[c[1]] + other_points[c[2]]) / 3;
  }

  // Returns the halfedge on the other side of an edge that is not on the border.
  Index opposite(Index h) const
  {
    CGAL_precondition(!is_border(h));
    const Index g = neighbors[h];
    for (Index o = 3 * g; o < 3 * g + 3; ++o)
      if (neighbors[o] == h / 3 && source_vertex(o) == target_vertex(h) &&
          target_vertex(o) == source_vertex(h))
        return o;
    CGAL_assertion_msg(false, "the sides of an edge do not match");
    return null_index;
  }

  // BGL
  typedef Index vertex_descriptor;
  typedef Index edge_descriptor;
  typedef boost::undirected_tag directed_category;
  typedef boost::allow_parallel_edge_tag edge_parallel_category;
  struct traversal_category : boost::vertex_list_graph_tag, boost::incidence_graph_tag {};
  typedef boost::counting_iterator<Index> vertex_iterator;
  typedef boost::counting_iterator<Index> out_edge_iterator;
  typedef Index vertices_size_type;
  typedef Index edges_size_type;
  typedef Index degree_size_type;
  static vertex_descriptor null_vertex() { return null_index; }
};

inline void set_areas(Execution execution, Face_graph& graph)
{
  graph.areas.resize(graph.number_of_faces());
  for_each_index(execution, graph.number_of_faces(), [&](std::size_t f) {
    const Corners& c = graph.corners[f];
    graph.areas[f] = (graph.points[c[1]] - graph.points[c[0]])
                       .cross(graph.points[c[2]] - graph.points[c[0]]).norm() / 2;
  });
}

// Returns the graph, without weights. An edge whose sides do not match, such as an edge of a face
// glued to itself, counts as border.
inline Face_graph face_graph(Execution execution, Triangles triangles)
{
  Face_graph graph;
  graph.corners = std::move(triangles.corners);
  graph.points = std::move(triangles.points);
  graph.neighbors.resize(3 * graph.number_of_faces());
  for_each_index(execution, graph.neighbors.size(), [&](std::size_t i) {
    const Index h = static_cast<Index>(i), f = h / 3, g = triangles.neighbors[f][h % 3];
    const Neighbors neighbors = triangles.neighbors[g];
    const Corners corners = graph.corners[g];
    bool is_matched = false;
    for (int k = 0; k < 3; ++k)
      is_matched |= neighbors[k] == f && corners[k] == graph.target_vertex(h) &&
                    corners[(k + 1) % 3] == graph.source_vertex(h);
    graph.neighbors[h] = is_matched ? g : f;
  });
  set_areas(execution, graph);
  return graph;
}

inline Index num_vertices(const Face_graph& g)
{ return static_cast<Index>(g.number_of_faces()); }

inline std::pair<Face_graph::vertex_iterator, Face_graph::vertex_iterator>
vertices(const Face_graph& g)
{ return {Face_graph::vertex_iterator(0), Face_graph::vertex_iterator(num_vertices(g))}; }

inline std::pair<Face_graph::out_edge_iterator, Face_graph::out_edge_iterator>
out_edges(Index f, const Face_graph&)
{ return {Face_graph::out_edge_iterator(3 * f), Face_graph::out_edge_iterator(3 * f + 3)}; }

inline Index out_degree(Index, const Face_graph&) { return 3; }
inline Index source(Index h, const Face_graph&) { return h / 3; }
inline Index target(Index h, const Face_graph& g) { return g.neighbors[h]; }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_FACE_GRAPH_H
