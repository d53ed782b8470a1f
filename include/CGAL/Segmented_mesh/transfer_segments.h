// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_TRANSFER_SEGMENTS_H
#define CGAL_SEGMENTED_MESH_TRANSFER_SEGMENTS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/read_segments.h>
#include <CGAL/Segmented_mesh/internal/transferred_labels.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
namespace Segmented_mesh {
namespace internal {

template <class Pack>
using has_only_transfer_tags =
  internal_np::has_only<Pack, internal_np::vertex_point_t, internal_np::geom_traits_t>;

} // namespace internal
} // namespace Segmented_mesh
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

carries the segments of a triangle mesh to another mesh of the same shape, such as a decimated,
remeshed, refined, repaired or slightly deformed copy.

Each face of `to` gets the id of the face of `from` that is nearest to its centroid. A face of
`from` that faces away from the face of `to` counts as farther, by about the length of an edge;
therefore the two sides of a thin sheet keep their ids if both meshes are oriented alike. Of faces
at the same distance the first one in `faces(from)` counts. If a small piece comes off its segment
in `to`, with less than a tenth of the area of the segment's largest piece there, it gets the ids of
the segments around it. Every id of `to` is an id of `from`, but a segment that is smaller than the
faces of `to` may vanish.

If both meshes have the same faces in the same order, each face of `to` gets the id of the face of
`from` at the same position. This is the case if the faces have the same vertices by their positions
in `vertices(from)` and `vertices(to)`, wherever their points are, or if they have the same points.

The meshes must be at the same place and have the same unit. The same input gives the same result on
every run and for every data structure that holds the same meshes.

The expected time is O((*n* + *m*) log *n*) for *n* faces of `from` and *m* faces of `to` that are
near each other. The memory is O(*n* + *m*).

\tparam FromMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam FromSegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<FromMesh>::%face_descriptor` as key type and an integer type as value type
\tparam ToMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam ToSegmentIdMap a model of `WritablePropertyMap` with
  `boost::graph_traits<ToMesh>::%face_descriptor` as key type and an integer type as value type
\tparam FromNamedParameters a sequence of named parameters
\tparam ToNamedParameters a sequence of named parameters

\param from the triangle mesh whose segments are known
\param from_ids the id of the segment of each face of `from`: any integers, from
  `segment_spectral_recursive()` or another segmentation
\param to the other triangle mesh
\param to_ids receives the id of the segment of each face of `to`
\param np_from `vertex_point_map` and `geom_traits` of `segment_spectral_recursive()`, for `from`
\param np_to the same named parameters, for `to`

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, or `from` has
  no faces while `to` has some
\throws std::overflow_error if the value type of `to_ids` is too small for an id

If there is an exception, no id has been written.
*/
template <class FromMesh, class FromSegmentIdMap, class ToMesh, class ToSegmentIdMap,
          class FromNamedParameters = CGAL::parameters::Default_named_parameters,
          class ToNamedParameters = CGAL::parameters::Default_named_parameters>
void transfer_segments(const FromMesh& from, FromSegmentIdMap from_ids, const ToMesh& to,
                       ToSegmentIdMap to_ids,
                       const FromNamedParameters& np_from = FromNamedParameters(),
                       const ToNamedParameters& np_to = ToNamedParameters())
{
  namespace internal = Segmented_mesh::internal;
  typedef typename boost::graph_traits<FromMesh>::face_descriptor From_face;
  typedef typename boost::graph_traits<ToMesh>::face_descriptor To_face;

  const std::vector<From_face> from_faces(faces(from).begin(), faces(from).end());
  const std::vector<To_face> to_faces(faces(to).begin(), faces(to).end());
  const internal::Surface from_surface = internal::read_mesh_with_parameters(
    from, from_faces, internal::checked_pack<internal::has_only_transfer_tags>(np_from),
    "transfer_segments");
  const internal::Surface to_surface = internal::read_mesh_with_parameters(
    to, to_faces, internal::checked_pack<internal::has_only_transfer_tags>(np_to),
    "transfer_segments");
  std::vector<internal::Index> labels;
  const auto ids = internal::read_segments(from_faces, from_ids, labels);
  if (to_faces.empty())
    return;
  if (from_faces.empty())
    throw std::invalid_argument("transfer_segments: the mesh with the segments has no faces");

  if constexpr (internal::is_segment_id_map<To_face, ToSegmentIdMap>()) {
    typedef typename boost::property_traits<FromSegmentIdMap>::value_type From_id;
    typedef typename boost::property_traits<ToSegmentIdMap>::value_type To_id;
    std::vector<To_id> id_of_label;
    for (From_id id : ids) {
      id_of_label.push_back(static_cast<To_id>(id));
      if (static_cast<From_id>(id_of_label.back()) != id ||
          (id_of_label.back() < To_id(0)) != (id < From_id(0)))
        throw std::overflow_error("transfer_segments: an id is too large for the type of the ids "
                                  "that are written");
    }
    labels = internal::transferred_labels(from_surface, labels, to_surface);
    for (std::size_t f = 0; f < to_faces.size(); ++f)
      put(to_ids, to_faces[f], id_of_label[labels[f]]);
  }
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_TRANSFER_SEGMENTS_H
