// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_SPLIT_INTO_SEGMENTS_H
#define CGAL_SEGMENTED_MESH_SPLIT_INTO_SEGMENTS_H

#include <CGAL/Segmented_mesh/Closed_segment.h>
#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/closed_solid.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_sides.h>
#include <CGAL/Segmented_mesh/internal/read_segments.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
namespace Segmented_mesh {
namespace internal {

template <class Pack>
using has_only_split_tags =
  internal_np::has_only<Pack, internal_np::vertex_point_t, internal_np::geom_traits_t,
                        internal_np::close_parts_t, internal_np::faces_of_parts_t>;

template <class Range, class = void>
struct is_sequence : std::false_type {};

template <class Range>
struct is_sequence<Range, std::void_t<decltype(std::declval<Range&>().emplace_back()),
                                      decltype(std::declval<Range&>().back())> >
  : std::true_type {};

// Makes a mesh from some triangles.
template <class Point>
class Part_builder
{
  const std::vector<Point>& points_;
  std::vector<Index> number_; // the index of each point in the part

public:
  explicit Part_builder(const std::vector<Point>& points)
    : points_(points), number_(points.size(), null_index) {}

  // Makes the i-th triangle the i-th face. Doubles the points where the part is no manifold.
  template <class Mesh>
  void operator()(const std::vector<Corners>& triangles, bool is_manifold, Mesh& mesh)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 3> > polygons;
    for (const Corners& t : triangles) {
      for (Index v : t)
        if (number_[v] == null_index) {
          number_[v] = static_cast<Index>(points.size());
          points.push_back(points_[v]);
        }
      polygons.push_back({number_[t[0]], number_[t[1]], number_[t[2]]});
    }
    for (const Corners& t : triangles)
      for (Index v : t)
        number_[v] = null_index;
    if (!is_manifold)
      PMP::orient_polygon_soup(points, polygons);
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  }
};

} // namespace internal
} // namespace Segmented_mesh
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

makes a mesh of each segment of a triangle mesh, open or closed.

A part has the faces of its segment in their order, with unchanged points. If a part touches itself
at a vertex, that vertex is doubled, and if it is no oriented manifold, some faces may be turned.
With `close_parts(true)` the faces of caps follow. They close the boundaries of the part to other
segments and the borders of the mesh, as `close_segments()` does: parts of a hollow body are closed
between its walls, and a cavity that lies in one part stays. If the closed surface is inside out,
its parts are turned.

The time is O(*n* log *n*) for *n* faces, plus the time of closing.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` from `face_descriptor` to an integer type
\tparam PartRange a `BackInsertionSequence` of a model of `MutableFaceGraph` with a default
  constructor, whose internal point map has the point type of `vertex_point_map`, such as
  `std::vector<TriangleMesh>`
\tparam NamedParameters a sequence of named parameters

\param mesh the triangle mesh
\param segment_ids the id of the segment of each face: any integers, from
  `segment_spectral_recursive()` or another segmentation
\param parts receives a mesh of each segment at its end, in ascending order of the ids
\param np those below, and `vertex_point_map` and `geom_traits` of `segment_spectral_recursive()`

\cgalNamedParamsBegin
  \cgalParamNBegin{close_parts}
    \cgalParamDescription{whether the parts are closed, as 3D printing and Boolean operations
      require}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{faces_of_parts}
    \cgalParamDescription{receives for each part the faces of `mesh` that its faces come from, in
      the order of `faces(part)`; `null_face()` for a face of a cap}
    \cgalParamType{a `std::vector` of `std::vector` of
      `boost::graph_traits<TriangleMesh>::%face_descriptor`, not const}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return with `close_parts(true)` the properties of each part, in the order of the parts, as
  `CGAL::Segmented_mesh::Closed_segment`; otherwise nothing

\throws std::invalid_argument if a face is not a triangle or a coordinate is not finite. In
  this case nothing has been appended.
*/
template <class TriangleMesh, class SegmentIdMap, class PartRange,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
std::vector<Segmented_mesh::Closed_segment<Id> >
#else
std::vector<Segmented_mesh::Closed_segment<
  typename boost::property_traits<SegmentIdMap>::value_type> >
#endif
split_into_segments(const TriangleMesh& mesh, SegmentIdMap segment_ids, PartRange& parts,
                    const NamedParameters& np = NamedParameters())
{
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;
  namespace internal = Segmented_mesh::internal;
  namespace tags = Spectral_segmentation::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  const auto& pack = internal::checked_pack<internal::has_only_split_tags>(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename GetGeomTraits<TriangleMesh, Pack>::type Geom_traits;
  const auto point_map = choose_parameter(get_parameter(pack, tags::vertex_point_t()),
                                          get_const_property_map(CGAL::vertex_point, mesh));
  typedef typename boost::property_traits<
    std::decay_t<decltype(point_map)> >::value_type Point;

  const std::vector<face_descriptor> faces_of_mesh(faces(mesh).begin(), faces(mesh).end());
  const internal::Surface triangles = internal::read_triangle_mesh(
    mesh, faces_of_mesh, point_map,
    choose_parameter<Geom_traits>(get_parameter(pack, tags::geom_traits_t())),
    "split_into_segments");
  std::vector<Point> points;
  for (auto v : vertices(mesh))
    points.push_back(get(point_map, v));
  std::vector<internal::Index> labels;
  const auto ids = internal::read_segments(faces_of_mesh, segment_ids, labels);
  const std::size_t n = ids.size();

  std::vector<std::vector<internal::Corners> > triangles_of_part(n);
  std::vector<std::vector<face_descriptor> > faces_of_part(n);
  for (std::size_t f = 0; f < faces_of_mesh.size(); ++f) {
    triangles_of_part[labels[f]].push_back(triangles.corners[f]);
    faces_of_part[labels[f]].push_back(faces_of_mesh[f]);
  }
  std::vector<Segmented_mesh::Closed_segment<Id> > result;
  if (choose_parameter(get_parameter(pack, tags::close_parts), false)) {
    auto closed = internal::closed_solid(triangles.points, triangles.corners, labels, ids, true);
    for (const internal::Vector& p : closed.solid->new_points())
      points.push_back(Point(p.x(), p.y(), p.z()));
    triangles_of_part = closed.solid->triangles();
    for (std::size_t i = 0; i < n; ++i)
      faces_of_part[i].resize(triangles_of_part[i].size(), Graph_traits::null_face());
    result = std::move(closed.segments);
  }
  static_assert(internal::is_sequence<PartRange>::value,
                "the parts are received by a sequence of meshes, such as a std::vector");
  if constexpr (internal::is_sequence<PartRange>::value) { // else no second error
    internal::Part_builder<Point> build(points);
    for (std::size_t i = 0; i < n; ++i) {
      const std::vector<internal::Corners>& part = triangles_of_part[i];
      const bool is_manifold = result.empty()
                                 ? internal::is_manifold(part, internal::sorted_sides(part))
                                 : result[i].is_manifold;
      parts.emplace_back();
      build(part, is_manifold, parts.back());
    }
  }
  if constexpr (internal::is_given<Pack, tags::faces_of_parts_t>)
    get_parameter(pack, tags::faces_of_parts).get() = std::move(faces_of_part);
  return result;
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_SPLIT_INTO_SEGMENTS_H
