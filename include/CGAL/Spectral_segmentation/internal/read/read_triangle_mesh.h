// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_TRIANGLE_MESH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_TRIANGLE_MESH_H

#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes the halfedge h, which is read last, and a halfedge of a face g opposite. An edge from a
// vertex to itself stays a border.
inline void join_to_face(Surface& surface, Index h, Index g)
{
  const Index v = surface.source_vertex(h), w = surface.target_vertex(h);
  const Corners& c = surface.corners[g];
  const Index i = c[0] == w ? (c[1] == v ? 0 : 2) : (c[1] == w ? 1 : 2);
  if (v == w || c[i] != w || c[(i + 1) % 3] != v)
    return;
  surface.opposite[h] = 3 * g + i;
  surface.opposite[3 * g + i] = h;
}

// Reads a mesh into arrays. Vertices are numbered in the order of `vertices(mesh)`, and the first
// corner of a face is its vertex of lowest index, so that every model of the same mesh gives the
// same arrays. Except for the list of its faces, the mesh is read only here, by a single thread,
// because property maps and number types may not be thread safe.
//
// Throws `std::invalid_argument` if a face is not a triangle or a coordinate is not finite. The
// message begins with `function`, the name of the function that the caller called.
template <class TriangleMesh, class FaceDescriptor, class VertexPointMap, class GeomTraits>
Surface read_triangle_mesh(const TriangleMesh& mesh, const std::vector<FaceDescriptor>& faces,
                             VertexPointMap vertex_point_map, const GeomTraits& traits,
                             const std::string& function = "segment_spectral_recursive")
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  std::vector<vertex_descriptor> vertices_of_mesh;
  vertices_of_mesh.reserve(num_vertices(mesh));
  for (vertex_descriptor v : vertices(mesh))
    vertices_of_mesh.push_back(v);
  if (vertices_of_mesh.size() >= null_index)
    throw std::invalid_argument(function + ": the mesh has too many vertices");
  const Descriptor_numbers<TriangleMesh, boost::vertex_index_t, vertex_descriptor>
    vertex_number(mesh, vertices_of_mesh);
  const Descriptor_numbers<TriangleMesh, boost::face_index_t, FaceDescriptor>
    face_number(mesh, faces);

  Surface surface;
  surface.corners.resize(faces.size());
  surface.opposite.resize(3 * faces.size());
  std::vector<char> is_used(vertices_of_mesh.size(), 0);
  for (Index f = 0; f < faces.size(); ++f) {
    const halfedge_descriptor first = halfedge(faces[f], mesh);
    halfedge_descriptor h = first;
    Corners corners, across;
    for (Index i = 0; i < 3; ++i, h = next(h, mesh)) {
      const halfedge_descriptor o = opposite(h, mesh);
      const auto g = face(o, mesh);
      corners[i] = vertex_number(target(o, mesh));
      across[i] = g == Graph_traits::null_face() ? null_index : face_number(g);
      is_used[corners[i]] = 1;
    }
    if (h != first)
      throw std::invalid_argument(function + ": face " + std::to_string(f) +
                                  " is not a triangle");
    const std::size_t smallest = std::min_element(corners.begin(), corners.end()) - corners.begin();
    std::rotate(corners.begin(), corners.begin() + smallest, corners.end());
    std::rotate(across.begin(), across.begin() + smallest, across.end());
    surface.corners[f] = corners;
    for (Index i = 0; i < 3; ++i) {
      surface.opposite[3 * f + i] = 3 * f + i;
      if (across[i] < f) // it was read before
        join_to_face(surface, 3 * f + i, across[i]);
    }
  }

  const auto x = traits.compute_x_3_object();
  const auto y = traits.compute_y_3_object();
  const auto z = traits.compute_z_3_object();
  surface.points.resize(vertices_of_mesh.size());
  for (Index v = 0; v < vertices_of_mesh.size(); ++v) {
    if (!is_used[v])
      continue;
    const auto& p = get(vertex_point_map, vertices_of_mesh[v]);
    Vector& point = surface.points[v];
    point = Vector(CGAL::to_double(x(p)), CGAL::to_double(y(p)), CGAL::to_double(z(p)));
    if (!point.is_finite())
      throw std::invalid_argument(function + ": vertex " + std::to_string(v) +
                                  " has a coordinate that is not finite");
  }
  return surface;
}

// Reads a mesh with the points and the kernel of the named parameters, or with its own.
template <class TriangleMesh, class FaceDescriptor, class CGALNamedParameters>
Surface read_mesh_with_parameters(const TriangleMesh& mesh,
                                  const std::vector<FaceDescriptor>& faces,
                                  const CGALNamedParameters& np,
                                  const std::string& function = "segment_spectral_recursive")
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename GetGeomTraits<TriangleMesh, CGALNamedParameters>::type Geom_traits;
  return read_triangle_mesh(
    mesh, faces,
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                     get_const_property_map(CGAL::vertex_point, mesh)),
    choose_parameter<Geom_traits>(get_parameter(np, CGAL::internal_np::geom_traits)), function);
}

template <class Range>
using Element = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

// Whether a type is a range of ranges of integers, but not of strings.
template <class Range, class = void>
struct is_triangle_range : std::false_type {};

template <class Range>
struct is_triangle_range<Range, std::void_t<Element<Element<Range> > > >
  : std::bool_constant<std::is_integral<Element<Element<Range> > >::value &&
                       !std::is_same<Element<Element<Range> >, char>::value> {};

// Reads points with the coordinates `p[0]`, `p[1]` and `p[2]`, and triangles of indices of points.
// Does not find the neighbors of triangles. Points that no triangle uses may have any coordinates.
//
// Throws `std::invalid_argument` if a triangle does not have three corners, a corner is not the
// index of a point, or a coordinate that is used is not finite. The message begins with `function`,
// the name of the function that the caller called.
template <class PointRange, class TriangleRange>
Surface read_triangle_soup(const PointRange& points, const TriangleRange& triangles,
                             const std::string& function = "segment_spectral_recursive")
{
  Surface result;
  for (const auto& p : points) {
    if (result.points.size() + 1 >= null_index)
      throw std::invalid_argument(function + ": there are too many points");
    result.points.push_back(
      Vector(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
  }
  const std::size_t number_of_points = result.points.size();
  std::vector<char> is_used(number_of_points, 0);
  for (const auto& triangle : triangles) {
    const std::size_t f = result.corners.size();
    const auto fail = [&](const char* what) {
      throw std::invalid_argument(function + ": triangle " + std::to_string(f) + what);
    };
    if (f + 1 >= null_index / 3)
      throw std::invalid_argument(function + ": there are too many triangles");
    Corners corners;
    std::size_t size = 0;
    for (auto corner : triangle) {
      if (size == 3)
        fail(" has more than three corners");
      if (corner < 0 || static_cast<std::size_t>(corner) >= number_of_points)
        fail(" has a corner that is no index of a point");
      corners[size++] = static_cast<Index>(corner);
    }
    if (size < 3)
      fail(" has fewer than three corners");
    for (Index v : corners) {
      if (!result.points[v].is_finite())
        fail(" has a corner with a coordinate that is not finite");
      is_used[v] = 1;
    }
    result.corners.push_back(corners);
  }
  for (std::size_t v = 0; v < number_of_points; ++v)
    if (!is_used[v])
      result.points[v] = Vector();
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_TRIANGLE_MESH_H
