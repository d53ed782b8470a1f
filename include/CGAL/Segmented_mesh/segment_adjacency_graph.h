// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_SEGMENT_ADJACENCY_GRAPH_H
#define CGAL_SEGMENTED_MESH_SEGMENT_ADJACENCY_GRAPH_H

#include <CGAL/Spectral_segmentation/internal/door/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/door/segment_ids.h>
#include <CGAL/Spectral_segmentation/internal/door/read_surface.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// What a vertex of a `Segment_adjacency_graph` holds.
template <class Id = std::size_t>
struct Segment_properties
{
  Id id = 0;                       ///< the id of the segment
  std::size_t number_of_faces = 0; ///< at least 1
  double area = 0;                 ///< in the square of the unit of the mesh's coordinates
};

/// \ingroup PkgSpectralSegmentationRef
/// What an edge of a `Segment_adjacency_graph` holds: all edges of the mesh between two segments.
struct Segment_adjacency_properties
{
  double length = 0;   ///< the sum of their lengths, in the unit of the mesh's coordinates
  double salience = 0; ///< of the cut that separates the two, if a hierarchy was given
};

/// \ingroup PkgSpectralSegmentationRef
/// A graph of segments, as `CGAL::segment_adjacency_graph()` makes it. It is a model of the graph
/// concepts of the Boost Graph Library but `AdjacencyMatrix`; vertices are numbers.
template <class Id = std::size_t>
using Segment_adjacency_graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Segment_properties<Id>,
                        Segment_adjacency_properties>;

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Pack>
using has_only_adjacency_tags =
  internal_np::has_only<Pack, internal_np::vertex_point_t, internal_np::geom_traits_t,
                        internal_np::face_index_t>;

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation

/*!
\ingroup PkgSpectralSegmentationRef

returns the graph of the segments of a triangle mesh: two segments are adjacent if faces of them
have an edge in common.

Vertex *i* of the graph is the segment of the *i*-th smallest id; for the ids of
`segment_spectral_recursive()` it is segment *i*. The edges are sorted by their vertices, the
smaller one of an edge first. There are no parallel edges and no loops.

The time is O(*n* log *s*) for *n* faces and *s* segments.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam SegmentIdMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
  type
\tparam NamedParameters a sequence of named parameters, of the namespace
  `CGAL::Spectral_segmentation::parameters` or of `CGAL::parameters`

\param mesh the triangle mesh
\param segment_ids the id of the segment of each face: any numbers, as those of
  `segment_spectral_recursive()` or of another segmentation
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{the numbers of the faces in messages, and in the hierarchy of the other
      overload if that run was given a map}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
      type}
    \cgalParamDefault{the position of the face in `faces(mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `mesh`}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a point type of
      `geom_traits` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class with the functors `Compute_x_3`, `Compute_y_3`, `Compute_z_3` of `Kernel`
      and the functions `compute_x_3_object()` etc.}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a `CGAL::Spectral_segmentation::Segment_adjacency_graph` with the value type of
  `SegmentIdMap`

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, or the numbers
  of `face_index_map` are not those from 0 to the number of faces - 1
*/
template <class TriangleMesh, class SegmentIdMap,
          class NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
Spectral_segmentation::Segment_adjacency_graph<Id>
#else
Spectral_segmentation::Segment_adjacency_graph<
  typename boost::property_traits<SegmentIdMap>::value_type>
#endif
segment_adjacency_graph(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                        const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;

  const auto& pack = internal::checked_pack<internal::has_only_adjacency_tags>(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename GetGeomTraits<TriangleMesh, Pack>::type Geom_traits;
  const auto point_map = choose_parameter(get_parameter(pack, internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, mesh));

  const auto faces_of_mesh = internal::numbered_faces(mesh, pack, "segment_adjacency_graph");
  internal::Surface surface = internal::read_triangle_mesh(
    mesh, faces_of_mesh, point_map,
    choose_parameter<Geom_traits>(get_parameter(pack, internal_np::geom_traits)),
    "segment_adjacency_graph");
  const double unit = internal::normalize(surface.points);
  std::vector<internal::Index> labels;
  const std::vector<Id> ids = internal::read_segments(faces_of_mesh, segment_ids, labels);

  Spectral_segmentation::Segment_adjacency_graph<Id> graph(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
    graph[i].id = ids[i];
  std::map<std::pair<internal::Index, internal::Index>, double> lengths; // of each boundary
  for (internal::Index f = 0; f < labels.size(); ++f) {
    ++graph[labels[f]].number_of_faces;
    graph[labels[f]].area += surface.area_vector(f).norm() / 2 * unit * unit;
    for (internal::Index h = 3 * f; h < 3 * f + 3; ++h) {
      const internal::Index other = labels[surface.neighbor(h)];
      if (labels[f] < other) // so each edge counts once
        lengths[{labels[f], other}] += surface.length(h) * unit;
    }
  }
  for (const auto& [segments, length] : lengths)
    boost::add_edge(segments.first, segments.second,
                    Spectral_segmentation::Segment_adjacency_properties{length, 0}, graph);
  return graph;
}

/*!
\ingroup PkgSpectralSegmentationRef

the same with saliences: each edge of the graph gets that of the cut which separates the two
segments, `hierarchy.salience_between()`.

With the default salience of the default method it is a probability, and at any higher threshold the
two are one segment. All segments on one side of this cut have it in common with all on the other
side, so it tells nothing of a single boundary. A segment counts as the leaf with the most faces of
it. So its boundaries may be smoothed, or its id be changed; the salience is 0 between two segments
that count as one leaf.

The time is O(*d*) more for each edge of the graph, for a depth *d* of the hierarchy.

\param mesh the triangle mesh
\param segment_ids the id of the segment of each face
\param hierarchy the `CGAL::Spectral_segmentation::Segmentation_hierarchy` of the run
\param np the named parameters above; a `face_index_map` if the run was given one

\throws std::invalid_argument as above, or if the hierarchy has another number of faces
*/
template <class TriangleMesh, class SegmentIdMap, class Hierarchy,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<
              std::is_same<Hierarchy, Spectral_segmentation::Segmentation_hierarchy>::value, int> = 0
#endif
          >
auto segment_adjacency_graph(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                             const Hierarchy& hierarchy,
                             const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  auto graph = segment_adjacency_graph(mesh, segment_ids, np);
  const auto faces_of_mesh = internal::numbered_faces(
    mesh, internal::checked_pack<internal::has_only_adjacency_tags>(np));
  if (hierarchy.number_of_faces() != faces_of_mesh.size())
    throw std::invalid_argument("segment_adjacency_graph: the hierarchy is that of a mesh with "
                                "another number of faces");
  std::vector<internal::Index> labels;
  internal::read_segments(faces_of_mesh, segment_ids, labels);
  std::vector<std::size_t> leaf(num_vertices(graph)), most(num_vertices(graph), 0); // of segments
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    if (!hierarchy.node(i).is_leaf())
      continue;
    std::map<internal::Index, std::size_t> number; // of the faces of each segment in the leaf
    for (std::size_t f : hierarchy.faces(i))
      ++number[labels[f]];
    for (const auto& [label, n] : number)
      if (n > most[label]) {
        most[label] = n;
        leaf[label] = i;
      }
  }
  for (auto e : make_range(edges(graph)))
    graph[e].salience = hierarchy.salience_between(leaf[source(e, graph)], leaf[target(e, graph)]);
  return graph;
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_SEGMENT_ADJACENCY_GRAPH_H
