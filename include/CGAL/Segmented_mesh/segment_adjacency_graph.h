// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_SEGMENT_ADJACENCY_GRAPH_H
#define CGAL_SEGMENTED_MESH_SEGMENT_ADJACENCY_GRAPH_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/read_segments.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Segmented_mesh {

/// \ingroup PkgSpectralSegmentationRef
/// The properties of a vertex of a `Segment_adjacency_graph`, which is a segment.
template <class Id = std::size_t>
struct Segment_properties
{
  Id id = 0;                       ///< the id of the segment
  std::size_t number_of_faces = 0; ///< at least 1
  double area = 0;                 ///< in the square of the unit of the mesh's coordinates
};

/// \ingroup PkgSpectralSegmentationRef
/// The properties of an edge of a `Segment_adjacency_graph`, which stands for all edges of the mesh
/// between two segments.
struct Segment_adjacency_properties
{
  /// the sum of the lengths of these edges, in the unit of the mesh's coordinates
  double length = 0;
  /// the salience of the cut that separates the two segments; 0 if no hierarchy was given
  double salience = 0;
};

/// \ingroup PkgSpectralSegmentationRef
/// A graph of segments, as `CGAL::segment_adjacency_graph()` returns it. It is a model of the graph
/// concepts of the Boost Graph Library, except `AdjacencyMatrix`. Vertices are integers.
template <class Id = std::size_t>
using Segment_adjacency_graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Segment_properties<Id>,
                        Segment_adjacency_properties>;

/// \cond SKIP_IN_MANUAL
namespace internal {

using Spectral_segmentation::Segmentation_hierarchy;

template <class Pack>
using has_only_adjacency_tags =
  internal_np::has_only<Pack, internal_np::vertex_point_t, internal_np::geom_traits_t,
                        internal_np::face_index_t>;

// Returns for each segment the leaf of a hierarchy that covers most of its area.
inline std::vector<std::size_t> largest_leaves(const Segmentation_hierarchy& hierarchy,
                                               const std::vector<Index>& labels,
                                               const std::vector<double>& area_of_face,
                                               std::size_t number_of_segments)
{
  if (hierarchy.number_of_faces() != labels.size())
    throw std::invalid_argument("segment_adjacency_graph: the hierarchy belongs to a mesh with "
                                "another number of faces");
  std::vector<std::size_t> result(number_of_segments, null_node);
  std::vector<double> largest_area(number_of_segments, -1);
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    if (!hierarchy.node(i).is_leaf())
      continue;
    std::map<Index, double> area_of_segment; // the area of each segment within the leaf
    for (std::size_t f : hierarchy.faces(i))
      area_of_segment[labels[f]] += area_of_face[f];
    for (const auto& [label, area] : area_of_segment)
      if (area > largest_area[label]) {
        largest_area[label] = area;
        result[label] = i;
      }
  }
  return result;
}

// Returns the salience of the cut that separates two leaves, which is the cut of their lowest
// common ancestor.
inline double salience_between(const Segmentation_hierarchy& hierarchy, std::size_t a,
                               std::size_t b)
{
  if (a == b)
    return 0;
  std::set<std::size_t> above_a;
  for (; a != null_node; a = hierarchy.node(a).parent)
    above_a.insert(a);
  while (b != null_node && above_a.count(b) == 0)
    b = hierarchy.node(b).parent;
  return b == null_node ? std::numeric_limits<double>::infinity()
                                   : hierarchy.node(b).salience;
}

// Returns the graph, with saliences if `hierarchy` is not null.
template <class TriangleMesh, class SegmentIdMap, class NamedParameters>
Segment_adjacency_graph<typename boost::property_traits<SegmentIdMap>::value_type>
make_adjacency_graph(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                     const Segmentation_hierarchy* hierarchy, const NamedParameters& np)
{
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;

  const auto& pack = checked_pack<has_only_adjacency_tags>(np);
  const auto faces_of_mesh = numbered_faces(mesh, pack, "segment_adjacency_graph");
  Surface surface =
    read_mesh_with_parameters(mesh, faces_of_mesh, pack, "segment_adjacency_graph");
  const double unit = normalize(surface.points);
  std::vector<Index> labels;
  const std::vector<Id> ids = read_segments(faces_of_mesh, segment_ids, labels);

  Segment_adjacency_graph<Id> graph(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
    graph[i].id = ids[i];
  std::vector<double> area_of_face;
  std::map<std::pair<Index, Index>, double> lengths; // one per boundary
  for (Index f = 0; f < labels.size(); ++f) {
    area_of_face.push_back(surface.normal(f).norm() / 2 * unit * unit);
    ++graph[labels[f]].number_of_faces;
    graph[labels[f]].area += area_of_face.back();
    for (Index i = 0; i < 3; ++i) {
      const Index other = labels[surface.neighbor(3 * f + i)];
      if (labels[f] < other) // each edge counts once
        lengths[{labels[f], other}] += surface.length(3 * f + i) * unit;
    }
  }

  std::vector<std::size_t> leaves;
  if (hierarchy)
    leaves = largest_leaves(*hierarchy, labels, area_of_face, ids.size());
  for (const auto& [segments, length] : lengths) {
    Segment_adjacency_properties properties{length, 0};
    if (hierarchy)
      properties.salience =
        salience_between(*hierarchy, leaves[segments.first], leaves[segments.second]);
    boost::add_edge(segments.first, segments.second, properties, graph);
  }
  return graph;
}

} // namespace internal
/// \endcond

} // namespace Segmented_mesh

/*!
\ingroup PkgSpectralSegmentationRef

returns the graph of the segments of a triangle mesh. Two segments are adjacent if an edge of the
mesh separates them.

Vertex *i* of the graph is the segment with the *i*-th smallest id, counted from 0; for the ids of
`segment_spectral_recursive()` it is segment *i*. The edges are sorted by their vertices, the
smaller vertex of an edge first. There are no parallel edges and no loops.

With `hierarchy`, each edge of the graph gets the salience of the cut that separates its two
segments, which is the cut of the smallest node that contains both. With the default salience of the
calibrated method (default) it is a probability, and at any higher threshold the two segments are
one. All pairs of segments on different sides of this cut have this salience;
therefore it does not describe a single boundary. If a segment is not a node of the hierarchy,
because its boundary was smoothed or its id changed, the leaf that covers most of its area takes its
place. The salience is 0 between two segments with the same leaf, and infinite between two roots.

The time is O(*n* log *s*) for *n* faces and *s* segments. With a hierarchy of depth *d* it is
O(*d*) more for each edge of the graph.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and integers as values
\tparam NamedParameters a sequence of named parameters

\param mesh the triangle mesh
\param segment_ids the id of the segment of each face: any integers, from
  `segment_spectral_recursive()` or another segmentation
\param hierarchy the hierarchy of the run that made the ids, for the saliences
\param np those below, and `vertex_point_map` and `geom_traits` of `segment_spectral_recursive()`

\cgalNamedParamsBegin
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{the indices of the faces in `hierarchy`, if its run was given such a map}
    \cgalParamType{a type like `SegmentIdMap`}
    \cgalParamDefault{the position of the face in `faces(mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a `CGAL::Segmented_mesh::Segment_adjacency_graph` with the value type of
  `SegmentIdMap`

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, the hierarchy
  has another number of faces, or the values of `face_index_map` are not the indices from 0 to the
  number of faces - 1
*/
template <class TriangleMesh, class SegmentIdMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
Segmented_mesh::Segment_adjacency_graph<Id>
#else
Segmented_mesh::Segment_adjacency_graph<
  typename boost::property_traits<SegmentIdMap>::value_type>
#endif
segment_adjacency_graph(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                        const Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                        const NamedParameters& np = NamedParameters())
{ return Segmented_mesh::internal::make_adjacency_graph(mesh, segment_ids, &hierarchy, np); }

/*!
\ingroup PkgSpectralSegmentationRef

returns the graph of the segments of a triangle mesh, without a hierarchy: all saliences are 0.
Otherwise it is the same as the function above.
*/
template <class TriangleMesh, class SegmentIdMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Segmented_mesh::Segment_adjacency_graph<
  typename boost::property_traits<SegmentIdMap>::value_type>
segment_adjacency_graph(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                        const NamedParameters& np = NamedParameters())
{ return Segmented_mesh::internal::make_adjacency_graph(mesh, segment_ids, nullptr, np); }

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_SEGMENT_ADJACENCY_GRAPH_H
