// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_IO_HIERARCHY_JSON_H
#define CGAL_SPECTRAL_SEGMENTATION_IO_HIERARCHY_JSON_H

// This is the only public header that needs nlohmann-json. Its CMake package has the target
// nlohmann_json::nlohmann_json.

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/json/hierarchy_json.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Pack>
using has_only_mesh_tags =
  internal_np::has_only<Pack, internal_np::vertex_point_t, internal_np::face_index_t,
                        internal_np::geom_traits_t>;

// Writes each key on a line of its own.
inline void write_json(std::ostream& os, const Json& json)
{
  const char* separator = "{\n";
  for (const auto& item : json.items()) {
    os << separator << Json(item.key()).dump() << ": " << item.value().dump();
    separator = ",\n";
  }
  os << "\n}\n";
  if (!os)
    throw std::runtime_error("write_hierarchy: the stream cannot be written");
}

inline void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& h,
                            const std::vector<std::size_t>& nodes, const Surface& triangles)
{
  check_number_of_faces(triangles.corners.size(), h.number_of_faces());
  const std::vector<std::size_t> labels = h.labels(nodes);
  Json json = json_of_hierarchy(
    h, nodes, labels,
    segment_extents(triangles.points, triangles.corners, labels, nodes.size()));
  add_faces(h, json);
  write_json(os, json);
}

} // namespace internal
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

writes a hierarchy as JSON, with the chosen segments.

The section \ref Spectral_segmentation_json documents the keys. The segments have neither neighbors
nor bounding boxes; the overloads that take the mesh write these too. Numbers are written with all
their digits. The time is linear in the size of the text, which is 3 bytes for each face; with
`smooth_boundaries` each face has three more numbers.

\param os the stream
\param hierarchy the hierarchy
\param nodes the node of each segment, such as `hierarchy.nodes()`

\throws std::invalid_argument if the nodes do not contain each face exactly once
\throws std::runtime_error if the stream fails
*/
inline void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& hierarchy,
                            const std::vector<std::size_t>& nodes)
{
  internal::Json json =
    internal::json_of_hierarchy(hierarchy, nodes, hierarchy.labels(nodes), {});
  internal::add_faces(hierarchy, json);
  internal::write_json(os, json);
}

/// \ingroup PkgSpectralSegmentationRef
/// writes a hierarchy as JSON, with the segments that the run returned; see above.
inline void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& hierarchy)
{ write_hierarchy(os, hierarchy, hierarchy.nodes()); }

/*!
\ingroup PkgSpectralSegmentationRef

writes a hierarchy as JSON, with the chosen segments, their neighbors and bounding boxes.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam NamedParameters a sequence of named parameters

\param os the stream
\param hierarchy the hierarchy
\param nodes the node of each segment, such as `hierarchy.nodes()`
\param mesh the mesh of the run
\param np `vertex_point_map`, `face_index_map` and `geom_traits`; see
  `segment_spectral_recursive()`

\throws std::invalid_argument if the nodes do not contain each face exactly once, a face of the mesh
  is not a triangle, or the mesh has another number of faces
\throws std::runtime_error if the stream fails
*/
#ifdef DOXYGEN_RUNNING
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& hierarchy,
                     const std::vector<std::size_t>& nodes, const TriangleMesh& mesh,
                     const NamedParameters& np = parameters::default_values());
#else
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_triangle_range<NamedParameters>::value, int> = 0>
void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& hierarchy,
                     const std::vector<std::size_t>& nodes, const TriangleMesh& mesh,
                     const NamedParameters& np = NamedParameters())
{
  const auto& pack = internal::checked_pack<internal::has_only_mesh_tags>(np);
  internal::write_hierarchy(
    os, hierarchy, nodes,
    internal::read_mesh_with_parameters(mesh, internal::numbered_faces(mesh, pack), pack,
                                        "write_hierarchy"));
}
#endif

/*!
\ingroup PkgSpectralSegmentationRef

writes a hierarchy as JSON, with the chosen segments, their neighbors and bounding boxes, for points
and triangles.

\tparam PointRange a range of points `p` with coordinates `p[0]`, `p[1]` and `p[2]`
\tparam TriangleRange a range of ranges of three integers

\param os the stream
\param hierarchy the hierarchy
\param nodes the node of each segment, such as `hierarchy.nodes()`
\param points the points of the run
\param triangles the indices of the three corner points of each triangle of the run
*/
#ifdef DOXYGEN_RUNNING
template <class PointRange, class TriangleRange>
#else
template <class PointRange, class TriangleRange,
          std::enable_if_t<internal::is_triangle_range<TriangleRange>::value, int> = 0>
#endif
void write_hierarchy(std::ostream& os, const Segmentation_hierarchy& hierarchy,
                     const std::vector<std::size_t>& nodes, const PointRange& points,
                     const TriangleRange& triangles)
{
  internal::write_hierarchy(
    os, hierarchy, nodes, internal::read_triangle_soup(points, triangles, "write_hierarchy"));
}

/*!
\ingroup PkgSpectralSegmentationRef

reads a hierarchy that `write_hierarchy()` or `segment_mesh --hierarchy` has written. It has the
same nodes, and gives the same labels.

The input is validated completely: every text gives either a usable hierarchy or an exception. The
time and the memory are nearly linear in the size of the text.

\throws std::runtime_error with an error message, if the text is not well-formed, contradicts
  itself, or has another version
*/
inline Segmentation_hierarchy read_hierarchy(std::istream& is)
{ return internal::Hierarchy_reader(is)(); }

/*!
\ingroup PkgSpectralSegmentationRef

reads a hierarchy, like the function above, and the nodes of the chosen segments.

\param is the stream
\param nodes receives the node of each segment; unchanged if an exception is thrown
*/
inline Segmentation_hierarchy read_hierarchy(std::istream& is, std::vector<std::size_t>& nodes)
{
  internal::Hierarchy_reader reader(is);
  Segmentation_hierarchy result = reader();
  nodes = reader.segments(result);
  return result;
}

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_IO_HIERARCHY_JSON_H
