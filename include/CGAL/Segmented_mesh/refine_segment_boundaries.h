// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_REFINE_SEGMENT_BOUNDARIES_H
#define CGAL_SEGMENTED_MESH_REFINE_SEGMENT_BOUNDARIES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/read_segments.h>
#include <CGAL/Segmented_mesh/internal/refinement/Face_splitter.h>
#include <CGAL/Segmented_mesh/internal/refinement/refined_boundaries.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
namespace Segmented_mesh {
namespace internal {

template <class Pack>
using has_only_refinement_tags =
  internal_np::has_only<Pack, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
                        CGAL::internal_np::number_of_iterations_t>;

template <class Pack>
using has_only_soup_refinement_tags =
  internal_np::has_only<Pack, CGAL::internal_np::number_of_iterations_t>;

// Returns the number of smoothing steps in a pack of named parameters.
template <class Pack>
std::size_t read_number_of_iterations(const Pack& pack)
{
  const auto iterations = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(pack, CGAL::internal_np::number_of_iterations), 15);
  static_assert(Spectral_segmentation::internal_np::is_count<std::decay_t<decltype(iterations)> >
                  ::value, "number_of_iterations takes an integer");
  if (iterations < decltype(iterations)(0) || static_cast<std::size_t>(iterations) > 100000)
    throw std::invalid_argument("refine_segment_boundaries: number_of_iterations must be from 0 to "
                                "100000");
  return static_cast<std::size_t>(iterations);
}

} // namespace internal
} // namespace Segmented_mesh
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

makes the boundaries between the segments of a mesh smooth curves, by splitting the faces that the
curves run through. Each new face gets the id of the segment on its side.

The boundaries of a segmentation run in zigzag, because they run along edges of the mesh. This
function moves them, by a few edges at most, to where a smoothed indicator function of the segments
jumps. If three segments meet, their curves meet too. A boundary that is already smooth stays where
it is, and so does a boundary in a crease that is concave by more than 40 degrees. The surface stays
the same set of points up to rounding, because new vertices lie on edges and in faces of the mesh.
All old vertices stay, with their points, and a face that is split becomes one of its parts. The
topology of the mesh does not change.

No segment vanishes or loses more than half of its area, and no segment falls into more connected
components than it had. If curves would cause this, for example around a segment of a few faces, the
boundary of the segment stays as it is. No new face is smaller than a thousandth of the mean area of
the faces of the mesh, unless it is part of a face smaller than a hundredth of that mean. Degenerate
faces and mesh boundaries are supported. The same input gives the same result on every run and for
every data structure that holds the same mesh.

The time is O(*n* + *b* *i*) for *n* faces, *i* iterations and *b* faces within three edges of the
boundaries. It is O(*n*) more each time that segments have to be kept from vanishing or falling
apart. This rarely happens more than twice, and never more often than the number of segments plus
two. The memory is O(*n*).

\tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `VertexListGraph`, whose
  descriptors `std::hash` accepts, like those in \cgal's models
\tparam SegmentIdMap a model of `ReadWritePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
  type. It must accept new faces, like property maps of `CGAL::Surface_mesh`, dynamic property
  maps and `boost::associative_property_map`.
\tparam NamedParameters a sequence of named parameters

\param mesh the triangle mesh
\param segment_ids the id of the segment of each face: any integers, from
  `segment_spectral_recursive()` or another segmentation. The function writes the ids of new faces,
  and of faces that are on the other side of a curve afterwards.
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the number of smoothing steps. With more steps the curves are smoother and
      farther from the edges that they replace.}
    \cgalParamType{an integer}
    \cgalParamDefault{`15`}
    \cgalParamExtra{from 0 to 100000; with 0 the curves only cut off the corners of the boundaries}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `mesh`}
    \cgalParamType{a model of `ReadWritePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a point type of
      `geom_traits` as value type. It must accept new vertices.}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class with the functors `Compute_x_3`, `Compute_y_3`, `Compute_z_3`,
      `Construct_barycenter_3` and `Construct_centroid_3` of `Kernel`, the functions
      `compute_x_3_object()` etc., and the type `FT`. The position of a point on its edge is
      computed with `double`.}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of faces that were split

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, or
  `number_of_iterations` is out of its range

If the function throws an exception, the mesh and the ids have not been changed, unless the mesh or
a property map throws while it grows.
*/
template <class TriangleMesh, class SegmentIdMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<
              !Segmented_mesh::internal::is_triangle_range<SegmentIdMap>::value, int> = 0
#endif
          >
std::size_t refine_segment_boundaries(TriangleMesh& mesh, SegmentIdMap segment_ids,
                                      const NamedParameters& np = NamedParameters())
{
  namespace internal = Segmented_mesh::internal;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  const auto& pack = internal::checked_pack<internal::has_only_refinement_tags>(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename GetGeomTraits<TriangleMesh, Pack>::type Geom_traits;
  typedef typename GetVertexPointMap<TriangleMesh, Pack>::type Vertex_point_map;

  const std::size_t iterations = internal::read_number_of_iterations(pack);
  Vertex_point_map points = choose_parameter(get_parameter(pack, internal_np::vertex_point),
                                             get_property_map(CGAL::vertex_point, mesh));
  const Geom_traits traits =
    choose_parameter<Geom_traits>(get_parameter(pack, internal_np::geom_traits));

  const std::vector<face_descriptor> faces_of_mesh(faces(mesh).begin(), faces(mesh).end());
  internal::Surface graph = internal::read_triangle_mesh(
    mesh, faces_of_mesh, points, traits, "refine_segment_boundaries");
  std::vector<internal::Index> labels;
  const auto ids = internal::read_segments(faces_of_mesh, segment_ids, labels);

  const internal::Refinement refinement =
    internal::refined_boundaries(graph, labels, ids.size(), iterations);
  internal::Face_splitter<TriangleMesh, Vertex_point_map, Geom_traits> split_faces(
    mesh, points, traits, refinement, faces_of_mesh, graph.corners);

  const auto set_label = [&](face_descriptor f, internal::Index label)
  { put(segment_ids, f, ids[label]); };
  split_faces(set_label);
  for (const auto& [f, label] : refinement.other_labels)
    set_label(faces_of_mesh[f], label);
  return refinement.split_faces.size();
}

namespace Segmented_mesh {

/*!
\ingroup PkgSpectralSegmentationRef

the origins of the points and triangles that `refine_segment_boundaries()` has appended. With
it, colors, texture coordinates and other values at points can be carried to the new points.
*/
struct Triangle_refinement
{
  /// A new point: the mean of the three corners of a triangle with these weights, which are 0 for
  /// corners whose edges the point is not on.
  struct Point
  {
    std::size_t triangle;
    std::array<double, 3> weights;
  };

  /// The points that were appended, in order.
  std::vector<Point> points;
  /// For each triangle that was appended, the triangle that it was a part of. The first part of a
  /// triangle replaces the triangle.
  std::vector<std::size_t> triangles;
};

} // namespace Segmented_mesh

/*!
\ingroup PkgSpectralSegmentationRef

makes the boundaries between the segments of a range of triangles smooth curves, like the function
for meshes. The neighbors of a triangle are those that `segment_spectral_recursive()` gives it. A
boundary does not cross an edge that more than two triangles have. Each part of a triangle keeps its
orientation.

\tparam PointRange a sequence container of points that can be made from three `double`, with the
  coordinates `p[0]`, `p[1]` and `p[2]`, such as `CGAL::Point_3` and `std::array<double, 3>`
\tparam TriangleRange a sequence container of ranges of three integers that can be made from them,
  such as `std::array<std::size_t, 3>` and `std::vector<std::size_t>`
\tparam SegmentIdRange a sequence container of integers
\tparam NamedParameters a sequence of named parameters

\param points the points; new points are appended
\param triangles the indices of the three corner points of each triangle; one part of a triangle
  that is split takes its place, the others are appended
\param segment_ids the id of the segment of each triangle: any integers; the ids of the appended
  triangles are appended
\param np an optional sequence of named parameters: `number_of_iterations`, as above

\return where the appended points and triangles come from

\throws std::invalid_argument if a triangle does not have three corners, a corner is not the index
  of a point, a coordinate of a corner is not finite, the number of ids is not the number of
  triangles, or `number_of_iterations` is out of its range
\throws std::overflow_error if there are more points than the type of the corners can number

If the input causes an exception, nothing has been changed.
*/
template <class PointRange, class TriangleRange, class SegmentIdRange,
          class NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<
              Segmented_mesh::internal::is_triangle_range<TriangleRange>::value, int> = 0
#endif
          >
Segmented_mesh::Triangle_refinement
refine_segment_boundaries(PointRange& points, TriangleRange& triangles,
                          SegmentIdRange& segment_ids,
                          const NamedParameters& np = NamedParameters())
{
  namespace internal = Segmented_mesh::internal;
  typedef typename TriangleRange::value_type Triangle;
  typedef internal::Element<Triangle> Corner;
  typedef std::array<double, 3> Weights;

  const auto& pack = internal::checked_pack<internal::has_only_soup_refinement_tags>(np);
  const std::size_t iterations = internal::read_number_of_iterations(pack);
  internal::Surface surface =
    internal::read_triangle_soup(points, triangles, "refine_segment_boundaries");
  std::vector<internal::Index> labels;
  const auto ids = internal::read_segments(surface.corners.size(), segment_ids, labels,
                                           "refine_segment_boundaries");
  const std::vector<internal::Corners> given = surface.corners;
  const std::vector<internal::Vector> given_points = surface.points;
  internal::connect_triangles(surface);
  const internal::Refinement refinement =
    internal::refined_boundaries(surface, labels, ids.size(), iterations);

  Segmented_mesh::Triangle_refinement result;
  std::vector<internal::Vector> new_points;
  std::vector<std::pair<internal::Index, internal::Corners> > parts; // the triangle and the corners
  std::vector<internal::Index> label_of_part;
  internal::split_triangles(surface, refinement,
    [&](internal::Index f, const Weights& weights) {
      Weights given_weights = {0, 0, 0}; // one per corner of the caller
      internal::Vector p;
      for (std::size_t i = 0; i < 3; ++i) {
        const internal::Index v = surface.corners[f][i];
        p += weights[i] * given_points[v];
        given_weights[std::find(given[f].begin(), given[f].end(), v) - given[f].begin()] +=
          weights[i];
      }
      new_points.push_back(p);
      result.points.push_back({f, given_weights});
    },
    [&](internal::Index f, internal::Corners part, internal::Index label) {
      const auto first = std::find(given[f].begin(), given[f].end(), surface.corners[f][0]);
      if (given[f][(first - given[f].begin() + 1) % 3] != surface.corners[f][1])
        std::swap(part[0], part[1]); // the surface has turned the triangle
      parts.emplace_back(f, part);
      label_of_part.push_back(label);
    });
  if (points.size() + new_points.size() >
      static_cast<std::size_t>((std::numeric_limits<Corner>::max)()))
    throw std::overflow_error("refine_segment_boundaries: the type of the corners is too small for "
                              "the number of points");

  for (const internal::Vector& p : new_points)
    points.push_back(typename PointRange::value_type{p.x(), p.y(), p.z()});
  for (const auto& [f, label] : refinement.other_labels)
    segment_ids[f] = ids[label];
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [f, c] = parts[i];
    const Triangle part{Corner(c[0]), Corner(c[1]), Corner(c[2])};
    if (i == 0 || parts[i - 1].first != f) {
      triangles[f] = part;
      segment_ids[f] = ids[label_of_part[i]];
    }
    else {
      triangles.push_back(part);
      segment_ids.push_back(ids[label_of_part[i]]);
      result.triangles.push_back(f);
    }
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_REFINE_SEGMENT_BOUNDARIES_H
