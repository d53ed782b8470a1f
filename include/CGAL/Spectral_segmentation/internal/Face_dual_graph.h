// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FACE_DUAL_GRAPH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FACE_DUAL_GRAPH_H

#include <CGAL/Spectral_segmentation/internal/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>

#include <Eigen/Geometry>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Distances of adjacent faces are on a grid of 2^-20, on which sums of doubles are exact: the
// length of a path does not depend on the order of its sum, and faces that tie on paper tie in the
// machine.
constexpr double grid_step = 1. / (1 << 20);
inline double on_grid(double x) { return std::floor(x / grid_step + 0.5) * grid_step; }

// The faces of a part of the mesh, as arrays; a model of BGL's `VertexListGraph` and
// `IncidenceGraph` whose vertices are the faces.
//
// Half-edge 3f+i belongs to face f and runs from its corner i to its corner (i+1)%3. An edge on
// the border of the part leads back to its own face, where no graph algorithm takes notice of it.
class Face_dual_graph
{
public:
  struct Halfedge
  {
    Index neighbor;      // face across the edge
    float geodesic = 0;  // G, normalized (Section 3)
    float angle = 0;     // H, equalized
    float combined = 0;  // d, Equation 1
    float concavity = 0; // the part of H that is due to concave bending
    float centroids = 0; // the distance of the centroids of the two faces, straight
  };

  std::vector<Halfedge> halfedges;
  std::vector<std::array<Index, 3> > corners; // vertices of a face
  std::vector<double> areas;
  std::vector<float> thickness;               // of the body under a face; empty if not measured
  std::vector<Vector> points;                 // of the vertices
  double unit = 1;                            // the length of 1 in the coordinates of the mesh

  std::size_t number_of_faces() const { return corners.size(); }

  Index source_vertex(Index h) const { return corners[h / 3][h % 3]; }
  Index target_vertex(Index h) const { return corners[h / 3][(h + 1) % 3]; }
  bool is_border(Index h) const { return halfedges[h].neighbor == h / 3; }

  double length(Index h) const
  { return (points[target_vertex(h)] - points[source_vertex(h)]).norm(); }

  Vector centroid(Index f) const { return centroid(f, points); }

  // The same with the vertices at other points.
  Vector centroid(Index f, const std::vector<Vector>& other_points) const
  {
    const std::array<Index, 3>& c = corners[f];
    return (other_points[c[0]] + other_points[c[1]] + other_points[c[2]]) / 3;
  }

  // The half-edge on the other side of an edge that is not on the border.
  Index opposite(Index h) const
  {
    const Index g = halfedges[h].neighbor;
    for (Index o = 3 * g; o < 3 * g + 3; ++o)
      if (halfedges[o].neighbor == h / 3 && source_vertex(o) == target_vertex(h) &&
          target_vertex(o) == source_vertex(h))
        return o;
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

// Sets what follows from the corners and the points: areas, and distances of centroids.
template <class ConcurrencyTag>
void set_sizes(Face_dual_graph& graph)
{
  graph.areas.resize(graph.number_of_faces());
  for_each_index<ConcurrencyTag>(graph.number_of_faces(), [&](Index f) {
    const std::array<Index, 3>& c = graph.corners[f];
    graph.areas[f] = (graph.points[c[1]] - graph.points[c[0]])
                       .cross(graph.points[c[2]] - graph.points[c[0]]).norm() / 2;
    const Vector centroid = graph.centroid(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      graph.halfedges[h].centroids =
        static_cast<float>((graph.centroid(graph.halfedges[h].neighbor) - centroid).norm());
  });
}

// Face distances are left open. An edge whose sides do not match, as of a face that is glued to
// itself, counts as border.
template <class ConcurrencyTag>
Face_dual_graph dual_graph(Triangles triangles)
{
  Face_dual_graph graph;
  graph.corners = std::move(triangles.corners);
  graph.points = std::move(triangles.points);
  graph.unit = triangles.unit;
  graph.halfedges.resize(3 * graph.number_of_faces());
  for_each_index<ConcurrencyTag>(graph.halfedges.size(), [&](Index h) {
    const Index f = h / 3, g = triangles.neighbors[f][h % 3];
    const Neighbors neighbors = triangles.neighbors[g];
    const std::array<Index, 3> corners = graph.corners[g];
    bool is_matched = false;
    for (int i = 0; i < 3; ++i)
      is_matched |= neighbors[i] == f && corners[i] == graph.target_vertex(h) &&
                    corners[(i + 1) % 3] == graph.source_vertex(h);
    graph.halfedges[h].neighbor = is_matched ? g : f;
  });
  set_sizes<ConcurrencyTag>(graph);
  return graph;
}

inline Index num_vertices(const Face_dual_graph& g)
{ return static_cast<Index>(g.number_of_faces()); }

inline std::pair<Face_dual_graph::vertex_iterator, Face_dual_graph::vertex_iterator>
vertices(const Face_dual_graph& g)
{ return {Face_dual_graph::vertex_iterator(0), Face_dual_graph::vertex_iterator(num_vertices(g))}; }

inline std::pair<Face_dual_graph::out_edge_iterator, Face_dual_graph::out_edge_iterator>
out_edges(Index f, const Face_dual_graph&)
{
  return {Face_dual_graph::out_edge_iterator(3 * f), Face_dual_graph::out_edge_iterator(3 * f + 3)};
}

inline Index out_degree(Index, const Face_dual_graph&) { return 3; }
inline Index source(Index h, const Face_dual_graph&) { return h / 3; }
inline Index target(Index h, const Face_dual_graph& g) { return g.halfedges[h].neighbor; }

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FACE_DUAL_GRAPH_H
