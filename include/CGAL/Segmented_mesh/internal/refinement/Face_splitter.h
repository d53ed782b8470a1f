// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_FACE_SPLITTER_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_FACE_SPLITTER_H

#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Splits the faces of a mesh by Euler operations. The constructor computes everything that can be
// computed before the mesh changes.
template <class TriangleMesh, class VertexPointMap, class GeomTraits>
class Face_splitter
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  TriangleMesh& mesh_;
  VertexPointMap points_;
  const Refinement& refinement_;
  std::vector<halfedge_descriptor> edges_; // the edges that get a point
  std::vector<std::pair<face_descriptor, vertex_descriptor> > faces_; // split faces, corners 0
  std::vector<Point> edge_points_, centroids_;

  halfedge_descriptor halfedge_from(vertex_descriptor v, face_descriptor f) const
  {
    halfedge_descriptor h = halfedge(f, mesh_);
    while (source(h, mesh_) != v)
      h = next(h, mesh_);
    return h;
  }

  // Returns the halves of the edges of a face; an edge without a point counts as both of its
  // halves.
  std::array<halfedge_descriptor, 6> sides_of(halfedge_descriptor h,
                                              const Refinement::Split_face& s) const
  {
    std::array<halfedge_descriptor, 6> sides;
    for (int i = 0; i < 3; ++i) {
      sides[2 * i] = h;
      if (s.points[i] != null_index)
        h = next(h, mesh_);
      sides[2 * i + 1] = h;
      h = next(h, mesh_);
    }
    return sides;
  }

public:
  Face_splitter(TriangleMesh& mesh, VertexPointMap points, const GeomTraits& traits,
               const Refinement& refinement, const std::vector<face_descriptor>& faces,
               const std::vector<Corners>& corners)
    : mesh_(mesh), points_(points), refinement_(refinement)
  {
    typedef typename GeomTraits::FT FT;
    std::vector<vertex_descriptor> vertices_of_mesh;
    for (vertex_descriptor v : vertices(mesh))
      vertices_of_mesh.push_back(v);
    const auto corner = [&](Index h) { return vertices_of_mesh[corners[h / 3][h % 3]]; };
    const auto barycenter = traits.construct_barycenter_3_object();
    const auto centroid = traits.construct_centroid_3_object();
    for (const Refinement::Edge_point& p : refinement.points) {
      const halfedge_descriptor h = halfedge_from(corner(p.halfedge), faces[p.halfedge / 3]);
      edges_.push_back(h);
      edge_points_.push_back(barycenter(get(points, source(h, mesh)), FT(1 - p.position),
                                        get(points, target(h, mesh))));
    }
    for (const Refinement::Split_face& s : refinement.split_faces) {
      const Index h = 3 * s.face;
      faces_.emplace_back(faces[s.face], corner(h));
      if (s.apex == Refinement::centroid)
        centroids_.push_back(centroid(get(points, corner(h)), get(points, corner(h + 1)),
                                      get(points, corner(h + 2))));
    }
  }

  // Splits the faces, and calls set_label(f, label) for the faces that were split and for the new
  // faces.
  template <class SetLabel>
  void operator()(const SetLabel& set_label)
  {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      put(points_, target(Euler::split_edge(edges_[i], mesh_), mesh_), edge_points_[i]);
    auto next_centroid = centroids_.begin();
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Refinement::Split_face& s = refinement_.split_faces[i];
      const halfedge_descriptor start = halfedge_from(faces_[i].second, faces_[i].first);
      const std::array<halfedge_descriptor, 6> sides = sides_of(start, s);
      if (s.apex == Refinement::centroid)
        put(points_, target(Euler::add_center_vertex(start, mesh_), mesh_), *next_centroid++);
      else // this half of an edge leads to the apex
        while (!CGAL::is_triangle(sides[2 * s.apex], mesh_))
          Euler::split_face(sides[2 * s.apex], next(next(sides[2 * s.apex], mesh_), mesh_), mesh_);
      for (int k = 0; k < 6; ++k)
        set_label(face(sides[k], mesh_), s.labels[k]);
    }
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_FACE_SPLITTER_H
