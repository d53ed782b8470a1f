// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_SEGMENT_BOUNDARIES_H
#define CGAL_SEGMENTED_MESH_SEGMENT_BOUNDARIES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/read_segments.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Segmented_mesh {

/// \ingroup PkgSpectralSegmentationRef
/// A polyline of edges of a mesh that has one segment on its left and another one on its right.
template <class FaceGraph, class Id = std::size_t>
struct Segment_boundary
{
  /// the halfedges in order; each starts at the end of the previous one. Their faces are the faces
  /// on the left.
  std::vector<typename boost::graph_traits<FaceGraph>::halfedge_descriptor> halfedges;

  /// the ids of the segments on the left and on the right; the smaller id is on the left
  std::array<Id, 2> segments;

  /// the vertices in order, one more than there are edges; the last vertex of a loop is its first
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

// The halfedges between segments, in the order in which they follow each other.
template <class FaceGraph, class SegmentIdMap>
class Boundary_halfedges
{
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;

  const FaceGraph& mesh_;
  SegmentIdMap segment_ids_;

public:
  Boundary_halfedges(const FaceGraph& mesh, SegmentIdMap segment_ids)
    : mesh_(mesh), segment_ids_(segment_ids)
  {
    static_assert(is_segment_id_map<typename Graph_traits::face_descriptor, SegmentIdMap>(),
                  "the segment ids must be a map of faces");
  }

  bool is_at_border(halfedge_descriptor h) const
  {
    return face(h, mesh_) == Graph_traits::null_face() ||
           face(opposite(h, mesh_), mesh_) == Graph_traits::null_face();
  }

  Id id_on_left(halfedge_descriptor h) const { return get(segment_ids_, face(h, mesh_)); }
  Id id_on_right(halfedge_descriptor h) const { return id_on_left(opposite(h, mesh_)); }

  bool contain(halfedge_descriptor h) const
  { return !is_at_border(h) && id_on_left(h) != id_on_right(h); }

  // Returns the next halfedge of the polyline; none at a mesh border or where three or more
  // boundary edges meet. All calls at one vertex together take time linear in its degree.
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

  // Returns the polyline through h from its start on; a loop starts at h.
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

} // namespace Segmented_mesh

/*!
\ingroup PkgSpectralSegmentationRef

returns the boundaries between the segments of a mesh as polylines.

A polyline continues at a vertex where two boundary edges meet. It ends where three or more boundary
edges meet, because three segments meet there or a segment touches itself. It also ends at the
border of the mesh, which is not a boundary between segments. A polyline without an end is a loop.
Each edge between two segments is in exactly one polyline, once. The polylines are in the order of
the first faces on their left.

The points are not used. The time is O(*n*) for *n* edges.

\tparam FaceGraph a model of `FaceListGraph` whose halfedges `std::hash` accepts, like the
  halfedges of \cgal's models; the faces may be any polygons
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and an integer type as value type

\param mesh the mesh
\param segment_ids the id of the segment of each face: any integers, from
  `segment_spectral_recursive()` or another segmentation

\sa `mark_segment_boundaries()`
*/
template <class FaceGraph, class SegmentIdMap>
#ifdef DOXYGEN_RUNNING
std::vector<Segmented_mesh::Segment_boundary<FaceGraph, Id> >
#else
std::vector<Segmented_mesh::Segment_boundary<
  FaceGraph, typename boost::property_traits<SegmentIdMap>::value_type> >
#endif
segment_boundaries(const FaceGraph& mesh, SegmentIdMap segment_ids)
{
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;

  const Segmented_mesh::internal::Boundary_halfedges<FaceGraph, SegmentIdMap>
    boundary_halfedges(mesh, segment_ids);
  std::vector<Segmented_mesh::Segment_boundary<FaceGraph, Id> > result;
  std::unordered_set<halfedge_descriptor> is_done;
  for (auto f : faces(mesh))
    for (halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh)) {
      if (!boundary_halfedges.contain(h) || is_done.count(h))
        continue;
      const Id left = boundary_halfedges.id_on_left(h), right = boundary_halfedges.id_on_right(h);
      if (right < left)
        continue;
      result.push_back({boundary_halfedges.polyline_through(h), {left, right}});
      is_done.insert(result.back().halfedges.begin(), result.back().halfedges.end());
    }
  return result;
}

/*!
\ingroup PkgSpectralSegmentationRef

marks the edges between the segments of a mesh, for functions of the package Polygon Mesh Processing
that take an `edge_is_constrained_map`.

The function writes a value for each edge of the mesh: `true` if the ids of the faces on its two
sides differ, otherwise `false`, including border edges. The points are not used. The time is O(*n*)
for *n* edges.

\tparam FaceGraph a model of `FaceGraph` and `EdgeListGraph`; the faces may be any polygons
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and an integer type as value type
\tparam EdgeIsConstrainedMap a model of `WritablePropertyMap` with
  `boost::graph_traits<FaceGraph>::%edge_descriptor` as key type and `bool` as value type

\param mesh the mesh
\param segment_ids the id of the segment of each face: any integers
\param edge_is_constrained_map receives the marks

\return the number of edges that were marked

\sa `segment_boundaries()`
*/
template <class FaceGraph, class SegmentIdMap, class EdgeIsConstrainedMap>
std::size_t mark_segment_boundaries(const FaceGraph& mesh, SegmentIdMap segment_ids,
                                    EdgeIsConstrainedMap edge_is_constrained_map)
{
  const Segmented_mesh::internal::Boundary_halfedges<FaceGraph, SegmentIdMap>
    boundary_halfedges(mesh, segment_ids);
  std::size_t result = 0;
  for (auto e : edges(mesh)) {
    const bool is_marked = boundary_halfedges.contain(halfedge(e, mesh));
    put(edge_is_constrained_map, e, is_marked);
    result += is_marked ? 1 : 0;
  }
  return result;
}

/*!
\ingroup PkgSpectralSegmentationRef

removes teeth of single triangles from the boundaries between segments, the smoothing after a
segmentation in Section 2 of Zhang and Liu 2005.

A tooth is a triangle with two edges in the boundary to the same other segment, and the third edge
in the interior of its own. It gets the id of the other segment, so that one edge of the boundary
replaces two. This goes on until there is no tooth. The segments keep their number, and connected
segments stay connected. Triangles are looked at in the order of `faces(mesh)`. Constraints of the
segmentation are not known here. For smooth curves instead, see `refine_segment_boundaries()`.

The points are not used. The time is O(*n*) for *n* faces, because each step shortens the boundary.

\tparam FaceGraph a model of `FaceListGraph`; faces that are no triangles keep their ids
\tparam SegmentIdMap a model of `ReadWritePropertyMap` with
  `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and an integer type as value type

\param mesh the mesh
\param segment_ids the id of the segment of each face: any integers; they are changed

\return the number of changes of an id
*/
template <class FaceGraph, class SegmentIdMap>
std::size_t smooth_segment_boundaries(const FaceGraph& mesh, SegmentIdMap segment_ids)
{
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  const Segmented_mesh::internal::Boundary_halfedges<FaceGraph, SegmentIdMap>
    boundary_halfedges(mesh, segment_ids);
  std::vector<face_descriptor> candidates(faces(mesh).begin(), faces(mesh).end());
  std::size_t result = 0;
  while (!candidates.empty()) {
    std::vector<face_descriptor> neighbors; // of faces that have changed
    for (face_descriptor f : candidates)
      for (auto h : halfedges_around_face(halfedge(f, mesh), mesh)) {
        const auto i = next(h, mesh), j = next(i, mesh);
        if (next(j, mesh) != h || boundary_halfedges.is_at_border(h) ||
            boundary_halfedges.contain(h) || !boundary_halfedges.contain(i) ||
            !boundary_halfedges.contain(j) ||
            boundary_halfedges.id_on_right(i) != boundary_halfedges.id_on_right(j))
          continue;
        put(segment_ids, f, boundary_halfedges.id_on_right(i));
        ++result;
        for (auto g : {h, i, j})
          neighbors.push_back(face(opposite(g, mesh), mesh));
        break;
      }
    candidates.swap(neighbors);
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_SEGMENT_BOUNDARIES_H
