// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_SEGMENT_BOUNDARIES_H
#define CGAL_SEGMENTED_MESH_SEGMENT_BOUNDARIES_H

#include <CGAL/Spectral_segmentation/internal/door/segment_ids.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// A polyline of edges of a mesh, with one segment on its left and another one on its right.
template <class FaceGraph, class Id = std::size_t>
struct Segment_boundary
{
  /// the halfedges, each of which starts where the one before it ends; their faces are those on the
  /// left
  std::vector<typename boost::graph_traits<FaceGraph>::halfedge_descriptor> halfedges;

  /// the ids of the segments on the left and on the right; the smaller one is on the left
  std::array<Id, 2> segments;

  /// the vertices, in order, one more than there are edges; the last one of a loop is the first
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
  vertices(const FaceGraph& mesh) const
  {
    std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> result;
    result.push_back(source(halfedges.front(), mesh));
    for (const auto& h : halfedges)
      result.push_back(target(h, mesh));
    return result;
  }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// The half-edges between segments, and how they follow each other.
template <class FaceGraph, class SegmentIdMap>
class Boundary_halfedges
{
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;

  const FaceGraph& mesh_;
  SegmentIdMap segment_ids_;

  bool is_at_border(halfedge_descriptor h) const
  {
    return face(h, mesh_) == Graph_traits::null_face() ||
           face(opposite(h, mesh_), mesh_) == Graph_traits::null_face();
  }

public:
  Boundary_halfedges(const FaceGraph& mesh, SegmentIdMap segment_ids)
    : mesh_(mesh), segment_ids_(segment_ids)
  {
    static_assert(is_segment_id_map<typename Graph_traits::face_descriptor, SegmentIdMap>(),
                  "the segment ids must be a map of faces");
  }

  Id id_on_left(halfedge_descriptor h) const { return get(segment_ids_, face(h, mesh_)); }
  Id id_on_right(halfedge_descriptor h) const { return id_on_left(opposite(h, mesh_)); }

  bool contain(halfedge_descriptor h) const
  { return !is_at_border(h) && id_on_left(h) != id_on_right(h); }

  // With the same segments on its sides; none where other than two of their edges meet, and at
  // borders. All calls at a vertex take time linear in its degree.
  std::optional<halfedge_descriptor> successor(halfedge_descriptor h) const
  {
    std::optional<halfedge_descriptor> result;
    for (halfedge_descriptor g = next(h, mesh_); g != opposite(h, mesh_);
         g = next(opposite(g, mesh_), mesh_)) {
      if (is_at_border(g) || (result && contain(g)))
        return std::nullopt;
      if (contain(g))
        result = g;
    }
    return result;
  }

  std::optional<halfedge_descriptor> predecessor(halfedge_descriptor h) const
  {
    const std::optional<halfedge_descriptor> result = successor(opposite(h, mesh_));
    return result ? std::optional<halfedge_descriptor>(opposite(*result, mesh_)) : result;
  }

  // From its start on; of a loop, from h on.
  std::vector<halfedge_descriptor> polyline_through(halfedge_descriptor h) const
  {
    halfedge_descriptor first = h;
    for (auto p = predecessor(h); p; p = first == h ? std::nullopt : predecessor(first))
      first = *p;
    std::vector<halfedge_descriptor> result(1, first);
    for (auto s = successor(first); s && *s != first; s = successor(*s))
      result.push_back(*s);
    return result;
  }
};

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation

/*!
\ingroup PkgSpectralSegmentationRef

outputs the boundaries between the segments of a mesh as polylines.

A polyline goes on at a vertex where two edges of boundaries meet. It ends where three or more
meet, as those of three segments do, or those of a segment that touches itself; and at the border of
the mesh, which is no boundary itself. A polyline without an end is a loop. Each edge between two
segments is in one polyline, once. The polylines are in the order of the first faces on their left.

The points play no part. The time is O(*n*) for *n* edges.

\tparam FaceGraph a model of `FaceListGraph` with halfedges that `std::hash` takes, as those of
  \cgal's models; the faces may be any polygons
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and an integer type as value type

\tparam OutputIterator a model of `OutputIterator` that takes
  `CGAL::Spectral_segmentation::Segment_boundary<FaceGraph, Id>`, where `Id` is the value type of
  `SegmentIdMap`

\param mesh the mesh
\param segment_ids the id of the segment of each face: any numbers, as those of
  `segment_spectral_recursive()` or of another segmentation
\param out the polylines are written here

\return `out`, behind the last polyline

\sa `mark_segment_boundaries()`
*/
template <class FaceGraph, class SegmentIdMap, class OutputIterator>
OutputIterator segment_boundaries(const FaceGraph& mesh, SegmentIdMap segment_ids,
                                  OutputIterator out)
{
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;

  const Spectral_segmentation::internal::Boundary_halfedges<FaceGraph, SegmentIdMap>
    boundary_halfedges(mesh, segment_ids);
  std::unordered_set<halfedge_descriptor> is_done;
  for (auto f : faces(mesh))
    for (halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh)) {
      if (!boundary_halfedges.contain(h) || is_done.count(h))
        continue;
      const Id left = boundary_halfedges.id_on_left(h), right = boundary_halfedges.id_on_right(h);
      if (right < left)
        continue;
      Spectral_segmentation::Segment_boundary<FaceGraph, Id> boundary{
        boundary_halfedges.polyline_through(h), {left, right}};
      is_done.insert(boundary.halfedges.begin(), boundary.halfedges.end());
      *out++ = std::move(boundary);
    }
  return out;
}

/*!
\ingroup PkgSpectralSegmentationRef

marks the edges between the segments of a mesh, so that they can be given as
`edge_is_constrained_map` to the functions of the package Polygon Mesh Processing.

The value of each edge of the mesh is written: `true` if the ids of the faces at its two sides
differ, else `false`, also at borders. The points play no part. The time is O(*n*) for *n* edges.

\tparam FaceGraph a model of `FaceGraph` and `EdgeListGraph`; the faces may be any polygons
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and an integer type as value type
\tparam EdgeIsConstrainedMap a model of `WritablePropertyMap` with
  `boost::graph_traits<FaceGraph>::%edge_descriptor` as key type and `bool` as value type

\param mesh the mesh
\param segment_ids the id of the segment of each face: any numbers
\param edge_is_constrained_map the marks

\return the number of edges that were marked

\sa `segment_boundaries()`
*/
template <class FaceGraph, class SegmentIdMap, class EdgeIsConstrainedMap>
std::size_t mark_segment_boundaries(const FaceGraph& mesh, SegmentIdMap segment_ids,
                                    EdgeIsConstrainedMap edge_is_constrained_map)
{
  const Spectral_segmentation::internal::Boundary_halfedges<FaceGraph, SegmentIdMap>
    boundary_halfedges(mesh, segment_ids);
  std::size_t result = 0;
  for (auto e : edges(mesh)) {
    const bool is_marked = boundary_halfedges.contain(halfedge(e, mesh));
    put(edge_is_constrained_map, e, is_marked);
    result += is_marked ? 1 : 0;
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_SEGMENT_BOUNDARIES_H
