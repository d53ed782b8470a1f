// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_REFINE_SEGMENT_BOUNDARIES_H
#define CGAL_SPECTRAL_SEGMENTATION_REFINE_SEGMENT_BOUNDARIES_H

#include <CGAL/Spectral_segmentation/internal/door/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/door/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/internal/refinement/Boundary_refinement.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
namespace Spectral_segmentation {
namespace internal {

template <class Pack>
using has_only_refinement_tags =
  internal_np::has_only<Pack, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
                        CGAL::internal_np::number_of_iterations_t>;

template <class CGALNamedParameters>
const CGALNamedParameters& cgal_refinement_pack(const Named_parameters<CGALNamedParameters>& np)
{
  static_assert(has_only_refinement_tags<CGALNamedParameters>::value,
                "this pack holds a named parameter that refine_segment_boundaries does not use");
  return np.cgal_parameters();
}

template <class T, class Tag, class Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
cgal_refinement_pack(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  static_assert(has_only_refinement_tags<CGAL::Named_function_parameters<T, Tag, Base> >::value,
                "this pack holds a named parameter that refine_segment_boundaries does not use");
  return np;
}

// The ids of the faces as labels from 0 on, in the order of the ids, which are returned.
template <class FaceDescriptor, class SegmentIdMap>
std::vector<typename boost::property_traits<SegmentIdMap>::value_type>
read_segments(const std::vector<FaceDescriptor>& faces, SegmentIdMap segment_ids,
              std::vector<Index>& labels)
{
  typedef typename boost::property_traits<SegmentIdMap>::value_type Id;
  static_assert(std::is_integral<Id>::value && !std::is_same<Id, bool>::value,
                "the values of the segment id map must be of an integer type");
  std::vector<Id> id_of_face;
  id_of_face.reserve(faces.size());
  for (const FaceDescriptor& f : faces)
    id_of_face.push_back(get(segment_ids, f));
  std::vector<Id> ids = id_of_face;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  labels.reserve(faces.size());
  for (Id id : id_of_face)
    labels.push_back(
      static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()));
  return ids;
}

// Splits the faces of a mesh by Euler operations. What can be computed before is computed by the
// constructor.
template <class TriangleMesh, class VertexPointMap, class GeomTraits>
class Mesh_refiner
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  TriangleMesh& mesh_;
  VertexPointMap points_;
  const Refinement& refinement_;
  std::vector<halfedge_descriptor> edges_; // that get a point
  std::vector<std::pair<face_descriptor, vertex_descriptor> > faces_; // with their corner 0
  std::vector<Point> edge_points_, centers_;

  halfedge_descriptor halfedge_from(vertex_descriptor v, face_descriptor f) const
  {
    halfedge_descriptor h = halfedge(f, mesh_);
    while (source(h, mesh_) != v)
      h = next(h, mesh_);
    return h;
  }

  // Cuts off the triangle at the source of a half-edge. Returns a half-edge of what remains.
  halfedge_descriptor cut_corner(halfedge_descriptor h)
  {
    return opposite(Euler::split_face(h, prev(prev(h, mesh_), mesh_), mesh_), mesh_);
  }

  template <class SetLabel>
  void split(halfedge_descriptor start, const Refinement::Split_face& s, const Point* center,
             const SetLabel& set_label)
  {
    std::array<halfedge_descriptor, 6> sides; // halves of the edges
    std::array<bool, 3> has_point;
    halfedge_descriptor h = start;
    for (int i = 0; i < 3; ++i) {
      has_point[i] = s.points[i] != null_index;
      sides[2 * i] = h;
      if (has_point[i])
        h = next(h, mesh_);
      sides[2 * i + 1] = h;
      h = next(h, mesh_);
    }

    const int number_of_points = has_point[0] + has_point[1] + has_point[2];
    if (center != nullptr) {
      h = Euler::add_center_vertex(start, mesh_);
      put(points_, target(h, mesh_), *center);
    }
    else if (number_of_points == 3) {
      for (int i = 0; i < 3; ++i)
        h = cut_corner(sides[2 * i]);
      set_label(face(h, mesh_), s.labels[0]);
    }
    else {
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (has_point[i] && (number_of_points == 1 || has_point[k])) {
          cut_corner(sides[2 * i]);
          if (number_of_points == 2)
            cut_corner(sides[2 * (s.diagonal == 0 ? j : k)]);
        }
      }
    }
    for (int i = 0; i < 6; ++i)
      set_label(face(sides[i], mesh_), s.labels[i]);
  }

public:
  Mesh_refiner(TriangleMesh& mesh, VertexPointMap points, const GeomTraits& traits,
               const Refinement& refinement, const std::vector<face_descriptor>& faces,
               const std::vector<Corners>& corners)
    : mesh_(mesh), points_(points), refinement_(refinement)
  {
    typedef typename GeomTraits::FT FT;
    std::vector<vertex_descriptor> vertices_of_mesh;
    for (vertex_descriptor v : vertices(mesh))
      vertices_of_mesh.push_back(v);
    const auto corner = [&](Index h) { return vertices_of_mesh[corners[h / 3][h % 3]]; };
    const auto barycenter = traits.construct_barycenter_3_object();
    for (const Refinement::Edge_point& p : refinement.points) {
      const halfedge_descriptor h = halfedge_from(corner(p.halfedge), faces[p.halfedge / 3]);
      edges_.push_back(h);
      edge_points_.push_back(barycenter(get(points, source(h, mesh)), FT(1 - p.position),
                                        get(points, target(h, mesh))));
    }
    for (const Refinement::Split_face& s : refinement.split_faces) {
      const Index h = 3 * s.face;
      faces_.emplace_back(faces[s.face], corner(h));
      if (s.has_center)
        centers_.push_back(barycenter(get(points, corner(h)), FT(s.center[0]),
                                      get(points, corner(h + 1)), FT(s.center[1]),
                                      get(points, corner(h + 2))));
    }
  }

  // Calls set_label(f, label) for the faces that were split and for the new ones.
  template <class SetLabel>
  void operator()(const SetLabel& set_label)
  {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      put(points_, target(Euler::split_edge(edges_[i], mesh_), mesh_), edge_points_[i]);
    auto center = centers_.begin();
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Refinement::Split_face& s = refinement_.split_faces[i];
      split(halfedge_from(faces_[i].second, faces_[i].first), s,
            s.has_center ? &*center++ : nullptr, set_label);
    }
  }
};

} // namespace internal
} // namespace Spectral_segmentation
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

makes the boundaries between the segments of a mesh smooth curves, by splitting the faces that the
curves run through. Each new face gets the id of the segment on its side.

The boundaries of a segmentation run along edges of the mesh, and so in zigzag. Here they move, but
by a few edges at most, to where a smoothed indicator function of the segments has its jump; where
three segments meet, so do the curves. A boundary that is smooth already stays where it is. The
surface stays the same set of points up to rounding: new vertices lie on edges and in faces of the
mesh. All old vertices stay, with their points, and a face that is split becomes one of its parts.
The topology of the mesh does not change.

No segment vanishes or loses more than half of its area, and none falls into more connected
components than it had. Where a curve would do that, as across a segment of a few faces, the
boundary keeps to the edges. No new face is smaller than a thousandth of the mean area of the faces
of the mesh, unless it is part of a face smaller than a hundredth. Degenerate faces and mesh
boundaries are supported. The same input gives the same result on every run and for every data
structure that holds the same mesh.

The time is O(*n* + *b* (*i* + log *b*)) for *n* faces, *i* iterations and *b* faces within three
edges of the boundaries, and O(*n*) more for each round in which a segment has to be kept from
vanishing or falling apart; there is rarely more than one, and never more than the number of
segments and a few. The memory is O(*n*).

\tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `VertexListGraph`, with
  descriptors that `std::hash` takes, as those of \cgal's models
\tparam SegmentIdMap a model of `ReadWritePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
  type. It must take new faces, as property maps of `CGAL::Surface_mesh`, dynamic property maps and
  `boost::associative_property_map` do.
\tparam NamedParameters a sequence of named parameters, of `CGAL::parameters` or of the namespace
  `CGAL::Spectral_segmentation::parameters`

\param mesh the triangle mesh
\param segment_ids the id of the segment of each face: any numbers, as those of
  `segment_spectral_recursive()` or of another segmentation. The ids of new faces, and of faces that
  come to lie on the other side of a curve, are written here.
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{steps of smoothing. With more steps the curves are smoother and farther
      from the edges that they replace.}
    \cgalParamType{an integer}
    \cgalParamDefault{`15`}
    \cgalParamExtra{at least 0, where the curves only cut off the corners of the boundaries}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `mesh`}
    \cgalParamType{a model of `ReadWritePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a point type of
      `geom_traits` as value type. It must take new vertices.}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class with the functors `Compute_x_3`, `Compute_y_3`, `Compute_z_3` and
      `Construct_barycenter_3` of `Kernel`, the functions `compute_x_3_object()` etc., and the type
      `FT`. Where a point comes to lie on its edge is computed with `double`.}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of faces that were split

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, or
  `number_of_iterations` is negative

If an exception is thrown, the mesh and the ids were not changed, unless the mesh or a property map
throws while it grows.
*/
template <class TriangleMesh, class SegmentIdMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t refine_segment_boundaries(TriangleMesh& mesh, SegmentIdMap segment_ids,
                                      const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  const auto& pack = internal::cgal_refinement_pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename GetGeomTraits<TriangleMesh, Pack>::type Geom_traits;
  typedef typename GetVertexPointMap<TriangleMesh, Pack>::type Vertex_point_map;

  const auto iterations =
    choose_parameter(get_parameter(pack, internal_np::number_of_iterations), 15);
  static_assert(Spectral_segmentation::internal_np::is_count<std::decay_t<decltype(iterations)> >
                  ::value, "number_of_iterations takes an integer");
  if (iterations < decltype(iterations)(0))
    throw std::invalid_argument("refine_segment_boundaries: number_of_iterations must be at least "
                                "0");
  Vertex_point_map points = choose_parameter(get_parameter(pack, internal_np::vertex_point),
                                             get_property_map(CGAL::vertex_point, mesh));
  const Geom_traits traits =
    choose_parameter<Geom_traits>(get_parameter(pack, internal_np::geom_traits));

  const std::vector<face_descriptor> faces_of_mesh(faces(mesh).begin(), faces(mesh).end());
  internal::Triangles triangles = internal::read_triangle_mesh(
    mesh, faces_of_mesh, points, traits, "refine_segment_boundaries");
  internal::normalize(triangles.points);
  std::vector<internal::Index> labels;
  const auto ids = internal::read_segments(faces_of_mesh, segment_ids, labels);

  const internal::Face_graph graph =
    internal::face_graph(internal::Execution::SEQUENTIAL, std::move(triangles));
  const internal::Refinement refinement = internal::Boundary_refinement(graph, labels, ids.size())(
    static_cast<std::size_t>(iterations));
  internal::Mesh_refiner<TriangleMesh, Vertex_point_map, Geom_traits> refine(
    mesh, points, traits, refinement, faces_of_mesh, graph.corners);

  const auto set_label = [&](face_descriptor f, internal::Index label)
  { put(segment_ids, f, ids[label]); };
  refine(set_label);
  for (const auto& [f, label] : refinement.other_labels)
    set_label(faces_of_mesh[f], label);
  return refinement.split_faces.size();
}

} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_REFINE_SEGMENT_BOUNDARIES_H
