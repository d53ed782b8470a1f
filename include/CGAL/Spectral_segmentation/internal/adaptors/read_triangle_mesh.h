// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_READ_TRIANGLE_MESH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_READ_TRIANGLE_MESH_H

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/adaptors/numbered_descriptors.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Reads a mesh into arrays. Vertices are numbered in the order of `vertices(mesh)`, and the first
// corner of a face is its vertex of lowest index, so that every model of the same mesh gives the
// same arrays. Except for the list of its faces, the mesh is read only here, by a single thread,
// because property maps and number types may not be thread safe.
//
// Throws `std::invalid_argument` if a face is not a triangle or a coordinate is not finite. The
// message begins with `function`, the name of the function that the caller called.
template <class TriangleMesh, class FaceDescriptor, class VertexPointMap, class GeomTraits>
Triangles read_triangle_mesh(const TriangleMesh& mesh, const std::vector<FaceDescriptor>& faces,
                             VertexPointMap vertex_point_map, const GeomTraits& traits,
                             const std::string& function = "segment_spectral_recursive")
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  std::vector<vertex_descriptor> vertices_of_mesh;
  for (vertex_descriptor v : vertices(mesh))
    vertices_of_mesh.push_back(v);
  if (vertices_of_mesh.size() >= null_index)
    throw std::invalid_argument(function + ": the mesh has too many vertices");
  const Descriptor_numbers<TriangleMesh, boost::vertex_index_t, vertex_descriptor>
    vertex_number(mesh, vertices_of_mesh);
  const Descriptor_numbers<TriangleMesh, boost::face_index_t, FaceDescriptor>
    face_number(mesh, faces);

  Triangles triangles;
  triangles.corners.resize(faces.size());
  triangles.neighbors.resize(faces.size());
  std::vector<char> is_used(vertices_of_mesh.size(), 0);
  for (Index f = 0; f < faces.size(); ++f) {
    halfedge_descriptor h = halfedge(faces[f], mesh);
    if (!CGAL::is_triangle(h, mesh))
      throw std::invalid_argument(function + ": face " + std::to_string(f) +
                                  " is not a triangle");
    Corners& corners = triangles.corners[f];
    Neighbors& neighbors = triangles.neighbors[f];
    for (int i = 0; i < 3; ++i, h = next(h, mesh)) {
      corners[i] = vertex_number(source(h, mesh));
      is_used[corners[i]] = 1;
      const auto across = face(opposite(h, mesh), mesh);
      const Index number =
        across == Graph_traits::null_face() ? null_index : face_number(across);
      neighbors[i] = number == null_index ? f : number;
    }
    start_at_smallest_vertex(corners, neighbors);
  }

  const auto x = traits.compute_x_3_object();
  const auto y = traits.compute_y_3_object();
  const auto z = traits.compute_z_3_object();
  triangles.points.resize(vertices_of_mesh.size());
  for (Index v = 0; v < vertices_of_mesh.size(); ++v) {
    if (!is_used[v])
      continue;
    const auto& p = get(vertex_point_map, vertices_of_mesh[v]);
    Vector& point = triangles.points[v];
    point = Vector(CGAL::to_double(x(p)), CGAL::to_double(y(p)), CGAL::to_double(z(p)));
    if (!point.is_finite())
      throw std::invalid_argument(function + ": vertex " + std::to_string(v) +
                                  " has a coordinate that is not finite");
  }
  return triangles;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_READ_TRIANGLE_MESH_H
