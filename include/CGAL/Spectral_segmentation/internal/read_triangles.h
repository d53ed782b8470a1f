// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_TRIANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_TRIANGLES_H

#include <CGAL/Spectral_segmentation/internal/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/mesh_numbering.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Moves the points that faces use into [-1, 1]^3 and returns the length of 1 in the old unit,
// a power of two, so that scaling rounds nothing.
inline double normalize(std::vector<Vector>& points, const std::vector<char>& is_used)
{
  Vector smallest = Vector::Constant(std::numeric_limits<double>::infinity());
  Vector largest = -smallest;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_used[v]) {
      smallest = smallest.cwiseMin(points[v]);
      largest = largest.cwiseMax(points[v]);
    }
  const Vector center = smallest / 2 + largest / 2;
  const double half_extent = (largest / 2 - smallest / 2).maxCoeff();
  const double unit =
    half_extent > 0 ? std::ldexp(1., (std::min)(std::ilogb(half_extent) + 1, 1023)) : 1;
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] = is_used[v] ? Vector((points[v] - center) / unit) : Vector(Vector::Zero());
  return unit;
}

// Reads a mesh into arrays. Vertices are numbered in the order of `vertices(mesh)` and the first
// corner of a face is its smallest vertex, so that every model of the same mesh gives the same
// arrays. Coordinates are normalized. But for the list of its faces this is all that a run reads of
// the mesh, in one thread, as property maps and number types need not stand several.
//
// Throws `std::invalid_argument` if a face is not a triangle or a coordinate is not finite.
template <class TriangleMesh, class FaceDescriptor, class VertexPointMap, class GeomTraits>
Triangles read_triangles(const TriangleMesh& mesh, const std::vector<FaceDescriptor>& faces,
                         VertexPointMap vertex_point_map, const GeomTraits& traits)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  std::vector<vertex_descriptor> vertices_of_mesh;
  for (vertex_descriptor v : vertices(mesh))
    vertices_of_mesh.push_back(v);
  if (vertices_of_mesh.size() >= null_index)
    throw std::invalid_argument("segment_spectral_recursive: the mesh has too many vertices");
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
      throw std::invalid_argument("segment_spectral_recursive: face " + std::to_string(f) +
                                  " is not a triangle");
    std::array<Index, 3>& corners = triangles.corners[f];
    Neighbors& neighbors = triangles.neighbors[f];
    for (int i = 0; i < 3; ++i, h = next(h, mesh)) {
      corners[i] = vertex_number(source(h, mesh));
      is_used[corners[i]] = 1;
      const auto across = face(opposite(h, mesh), mesh);
      const Index number =
        across == Graph_traits::null_face() ? null_index : face_number(across);
      neighbors[i] = number == null_index ? f : number;
    }
    const auto first = std::min_element(corners.begin(), corners.end()) - corners.begin();
    std::rotate(corners.begin(), corners.begin() + first, corners.end());
    std::rotate(neighbors.begin(), neighbors.begin() + first, neighbors.end());
  }

  const auto x = traits.compute_x_3_object();
  const auto y = traits.compute_y_3_object();
  const auto z = traits.compute_z_3_object();
  triangles.points.resize(vertices_of_mesh.size(), Vector::Zero());
  for (Index v = 0; v < vertices_of_mesh.size(); ++v) {
    if (!is_used[v])
      continue;
    const auto& p = get(vertex_point_map, vertices_of_mesh[v]);
    Vector& point = triangles.points[v];
    point = Vector(CGAL::to_double(x(p)), CGAL::to_double(y(p)), CGAL::to_double(z(p)));
    if (!point.allFinite())
      throw std::invalid_argument("segment_spectral_recursive: vertex " + std::to_string(v) +
                                  " has a coordinate that is not finite");
  }
  triangles.unit = normalize(triangles.points, is_used);
  return triangles;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_TRIANGLES_H
