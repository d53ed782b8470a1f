// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENT_SPECTRAL_RECURSIVE_H
#define CGAL_SEGMENT_SPECTRAL_RECURSIVE_H

// Where the sections of the paper are, below Spectral_segmentation/internal/:
//
//   2    overview, queue of parts        dendrogram/recursion.h
//   2    smoothing before and after      surface/Surface.h, door/boundary_smoothing.h
//   2    BESTCUT (Figure 2)              bipartition/best_cut.h
//   3    distances of adjacent faces     distances/face_distances.h
//   4    sampling by shape context       bipartition/shape_context_sampling.h
//   5.2  spectral order of the faces     bipartition/face_orders.h
//   5.3  line search                     bipartition/line_search.h
//   6    salience of a part              salience/Boundary_statistics.h, Part_salience.h
//
// Beyond the paper: over-segmentation and merging (dendrogram/region_merging.h), more cuts to choose
// from (bipartition/cut_proposals.h, min_cut_refinement.h) and more factors to judge them by
// (salience/Cut_evaluator.h), bending at the scale of the shape (distances/bending.h), and the search
// on a coarse surface (levels/). engine.h is the line between these and the templates here and in
// door/.

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/parameters.h>
#include <CGAL/Spectral_segmentation/version.h>

#include <CGAL/Spectral_segmentation/internal/door/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/door/read_options.h>
#include <CGAL/Spectral_segmentation/internal/door/read_surface.h>
#include <CGAL/Spectral_segmentation/internal/door/boundary_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/door/read_constraints.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
namespace Spectral_segmentation {
namespace internal {

// Runs the engine and writes the labels of `faces`, which are numbered as the triangles are, and
// the hierarchy of the caller. Returns the number of segments.
template <class ConcurrencyTag, class Face, class SegmentIdMap, class CGALNamedParameters>
std::size_t segment_and_write(Surface surface, const std::vector<Face>& faces,
                              SegmentIdMap segment_ids, const Options& options,
                              const Constraints& constraints, const CGALNamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter_reference;
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif

  Segmentation_visitor no_visitor;
  Segmentation_visitor& visitor = choose_parameter(
    get_parameter_reference(np, CGAL::internal_np::visitor), no_visitor);
  std::vector<Index> opposite;
  if (options.boundary_smoothing)
    opposite = surface.opposite;
  Segmentation_hierarchy hierarchy(
    cut_hierarchy(segment(std::move(surface), options,
                          is_parallel ? Execution::PARALLEL : Execution::SEQUENTIAL, visitor,
                          constraints)),
    options);
  std::vector<std::size_t> labels = hierarchy.labels(hierarchy.nodes());
  if (options.boundary_smoothing) {
    visitor.start_stage(Stage::BOUNDARY_SMOOTHING, Segmentation_visitor::whole_mesh);
    remove_teeth(opposite, constraints, labels);
    visitor.end_stage(Stage::BOUNDARY_SMOOTHING, Segmentation_visitor::whole_mesh);
  }
  const std::size_t number_of_segments = write_labels(faces, labels, segment_ids);

  if constexpr (is_given<CGALNamedParameters, internal_np::hierarchy_t>)
    get_parameter_reference(np, internal_np::hierarchy) = std::move(hierarchy);
  return number_of_segments;
}

} // namespace internal
} // namespace Spectral_segmentation
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

cuts a triangle mesh into the parts that a person would name, by recursive and visually salient
spectral cuts, and writes for each face the id of its segment.

The segment ids are contiguous and start at 0; segments are numbered by their face of smallest
index: its position in `faces(mesh)`, or in the `face_index_map` if one is given. Every segment of a
connected mesh is connected. The same input gives the same ids on every run, with any number of
threads (unless a visitor stops it), and for every data structure that holds the same mesh. The mesh
is not changed. Degenerate faces, boundaries and several connected components are supported:
components that touch may be of one part.

The method is built on that of Hao Zhang and Rong Liu, <em>Mesh Segmentation via Recursive and
Visually Salient Spectral Cuts</em>, Vision, Modeling, and Visualization 2005. Sections named below
are those of the paper. The faces are nodes of the dual graph of the mesh, and a concave edge puts
its two faces far apart. In a part, two sample faces are found by shape context, the faces of the
part are ordered by a spectral embedding with respect to these samples, and of all the cuts along
this order the one with the most salient part is taken. Both sides are parts again.

There are two methods. In the paper's, `zhang_liu_2005()`, the largest part is cut next, until no
part has a cut whose salience reaches a threshold. The default cuts where people cut. It measures
bending at the scale of the shape, searches along more orders of the faces, moves the best cuts to
the minimum cut near them, and takes for salience the probability that a person would cut there. It
over-segments the mesh into 20 regions, then merges neighbors, the least salient boundary first, up
to the threshold. A mesh of many faces is coarsened for the search, and the cuts are projected back.
If the mesh has several components of which some nearly touch, a closed surface that wraps them all
is searched in its place, and each face gets the side of the surface near it. Components that are
farther from each other than about a hundredth of the extent of the mesh are never of one part,
unless a number of segments asks for it. In the paper's method each component is a part from the
start.

The time is O(*n* log *n*) in the number *n* of faces, for reading and coarsening, plus a search on
at most 4000 faces by default; the memory is O(*n*). The section
\ref Spectral_segmentation_complexity has the terms.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  `CGAL::Parallel_if_available_tag`, the default. Parallelism needs TBB. The target
  `Spectral_segmentation::compiled` links it if it is found; without this target link
  `CGAL::TBB_support`.
\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`, with descriptors that
  `std::hash` takes, as those of \cgal's models. Several threads may segment one mesh at a time,
  except a `Face_filtered_graph`, which fills its indices when it is first asked for them.
\tparam SegmentIdMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
  type
\tparam NamedParameters a sequence of named parameters, of the namespace
  `CGAL::Spectral_segmentation::parameters` or of `CGAL::parameters`

\param mesh the triangle mesh
\param segment_ids the ids of the segments are written here
\param np an optional sequence of named parameters among the ones listed below

<b>Everyday parameters.</b> All named parameters are optional.
\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_segments}
    \cgalParamDescription{the number of segments, exactly, whatever the saliences and the
      `minimum_segment_size` say. What nothing joins is joined last, the nearest first. Where the
      search finds too few cuts, the largest segment is halved.}
    \cgalParamType{an integer}
    \cgalParamDefault{none; the threshold ends the run}
    \cgalParamExtra{from 1, or from the number of components if these are kept apart, to the number
      of faces, where faces with the same points count once if components are not kept apart. Not
      together with `maximum_number_of_segments` or `salience_threshold`. Above 20 the default
      method searches as many regions, up to 200, on a finer coarse mesh in proportion.}
  \cgalParamNEnd
  \cgalParamNBegin{components_apart}
    \cgalParamDescription{whether each connected component of the mesh is a part from the start. By
      default components that touch may be of one part.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`, or `true` with `zhang_liu_2005()`, which has no other}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_segments}
    \cgalParamDescription{an upper bound on the number of segments. It is exceeded only if
      components are kept apart, and there are more of them.}
    \cgalParamType{an integer}
    \cgalParamDefault{`std::numeric_limits<std::size_t>::max()`, which is no limit; the threshold
      ends the run}
    \cgalParamExtra{at least 1. With a number above 20 the default method makes as many regions, on
      a finer coarse mesh in proportion.}
  \cgalParamNEnd
  \cgalParamNBegin{salience_threshold}
    \cgalParamDescription{Cuts whose salience is below this value are not made (Section 2), or are
      undone by merging. A higher value gives fewer segments.}
    \cgalParamType{a number}
    \cgalParamDefault{`default_probability_threshold`, `0.40`, or `default_salience_threshold`,
      `0.54`, for a `Weighted_part_salience`, as with `zhang_liu_2005()`. Lower values cut flat
      parts by their noise, higher ones lose limbs with a shallow seam.}
    \cgalParamExtra{`-infinity` accepts every cut, for use with `maximum_number_of_segments`. Not a
      NaN.}
  \cgalParamNEnd
  \cgalParamNBegin{hierarchy}
    \cgalParamDescription{receives all cuts with their salience}
    \cgalParamType{`CGAL::Spectral_segmentation::Segmentation_hierarchy&`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is notified of the progress and may stop the run}
    \cgalParamType{a class derived from `CGAL::Spectral_segmentation::Segmentation_visitor`, or
      `std::reference_wrapper` of one to be read afterwards}
    \cgalParamDefault{`CGAL::Spectral_segmentation::Segmentation_visitor`, which does nothing}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `mesh`}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a point type of
      `geom_traits` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{an own index from 0 to the number of faces - 1 for each face. Segments are
      numbered, and ties between faces are broken, by these indices.}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
      type}
    \cgalParamDefault{the position of the face in `faces(mesh)`, which is safe for every mesh, also
      one with removed faces or without ids}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class with the functors `Compute_x_3`, `Compute_y_3`, `Compute_z_3` of `Kernel`
      and the functions `compute_x_3_object()` etc. Coordinates are rounded to `double`.}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>Constraints.</b> They hold for the segments and for all nodes of the hierarchy. Where the method's
own cuts do not fulfill them, it cuts further and merges across its cuts; what no constraint concerns
stays as it is. They do not go with `zhang_liu_2005()`.
\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{whether an edge must be between two segments. An edge within the surface
      makes a closed boundary that passes it. Border edges are ignored.}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{none: no edge must}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_uncuttable_map}
    \cgalParamDescription{whether the two faces at an edge must be of one segment. Border edges are
      ignored.}
    \cgalParamType{as that of `edge_is_constrained_map`}
    \cgalParamDefault{none: every edge may be cut}
  \cgalParamNEnd
  \cgalParamNBegin{face_seed_map}
    \cgalParamDescription{seeds of faces: faces with the same seed are of one segment, faces with
      different seeds are not. A negative value is no seed.}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a signed integer type as
      value type}
    \cgalParamDefault{none: no face has a seed}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>Parameters for experts.</b>
\cgalNamedParamsBegin
  \cgalParamNBegin{minimum_segment_size}
    \cgalParamDescription{the share of the area of the mesh that each side of a cut must have. The
      factors of the salience mean little for a handful of faces; the paper has no such limit.}
    \cgalParamType{a number}
    \cgalParamDefault{`0.003`, or `0.005` with `zhang_liu_2005()`. A finger of a whole figure is
      larger, a pit in its skin smaller.}
    \cgalParamExtra{in [0, 0.5]; 0 with `zhang_liu_2005()` is the paper's method to the letter}
  \cgalParamNEnd
  \cgalParamNBegin{part_salience}
    \cgalParamDescription{computes the salience of a cut (Section 6)}
    \cgalParamType{a model of the concept `PartSalience`}
    \cgalParamDefault{`Calibrated_part_salience()`, or `Weighted_part_salience()` with
      `zhang_liu_2005()`}
    \cgalParamExtra{Give `salience_threshold` with a salience of your own, on its scale. With
      `zhang_liu_2005()` it is called at each step of a line, and the factors beyond the paper are
      0.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_searched_faces}
    \cgalParamDescription{the number of faces on which cuts are searched. Faces that are larger
      than those of an even mesh with this number are bisected (not with `zhang_liu_2005()`); then
      the mesh is coarsened to this number, as far as its topology allows, by edge collapses. The
      cuts are projected back, by minimum cuts through the faces whose side is not certain. So
      neither the time of the search nor the result depends much on the triangles. With 0 the mesh
      itself is searched.}
    \cgalParamType{an integer}
    \cgalParamDefault{`4000`, at which the agreement with people is that of the mesh itself, or `0`
      with `zhang_liu_2005()`}
    \cgalParamExtra{at least 0. In the default method it grows in proportion if more than 20
      segments are asked for. Factors and salience of cuts and the `minimum_segment_size` are those
      of the mesh that is searched.}
  \cgalParamNEnd
  \cgalParamNBegin{boundary_smoothing}
    \cgalParamDescription{whether the boundaries of the segments are smoothed (Section 2): a face
      with two edges in the boundary to one other segment goes to it, until there is none. Each step
      makes the boundary shorter, and neither empties nor disconnects a segment.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`: most cuts are smooth enough, as short ones are more salient}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>The paper's parameters.</b>
\cgalNamedParamsBegin
  \cgalParamNBegin{zhang_liu_2005}
    \cgalParamDescription{the method of the paper, and its defaults; takes no argument. The weights of
      the face distances (Section 3) and the number of reference faces (Section 4) are fields of
      `CGAL::Spectral_segmentation::Options`; the weights &alpha;, &beta; and &gamma; of the salience
      (Section 6, Equation 3) are those of `Weighted_part_salience`.}
    \cgalParamDefault{not given: the default method}
  \cgalParamNEnd
  \cgalParamNBegin{options}
    \cgalParamDescription{all values at once, for programs that choose them at run time. Other
      parameters change the values given here.}
    \cgalParamType{`CGAL::Spectral_segmentation::Options`}
    \cgalParamDefault{`Options()`, the default method}
    \cgalParamExtra{not with `zhang_liu_2005()`, for which there is `Options::zhang_liu_2005()`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_smoothing_iterations}
    \cgalParamDescription{steps of Laplacian smoothing on a copy of the points, from which the face
      distances are then computed (Section 2), and the coarse mesh if cuts are searched on one}
    \cgalParamType{an integer}
    \cgalParamDefault{`0`; a few steps help on noisy scans}
    \cgalParamExtra{at least 0}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{chooses the first reference face of each part at random, as in the paper}
    \cgalParamType{an integer}
    \cgalParamDefault{none: the first reference face is the one farthest from the center of the
      part}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of segments; 0 for an empty mesh

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, the
  `face_index_map` is not one to one onto its range, a number is out of its range, constraints contradict
  each other, or the number of segments does not let all of them be fulfilled
\throws std::overflow_error if there are more segments than the value type of `segment_ids` can
  count

If an exception is thrown, by the function, the visitor or the part salience, no id was written.
*/
template <class ConcurrencyTag = Parallel_if_available_tag,
          class TriangleMesh, class SegmentIdMap,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<
              !Spectral_segmentation::internal::is_triangle_range<SegmentIdMap>::value, int> = 0
#endif
          >
std::size_t segment_spectral_recursive(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                                       const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  const auto& pack = internal::cgal_pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename GetGeomTraits<TriangleMesh, Pack>::type Geom_traits;

  const Spectral_segmentation::Options options = internal::read_options(pack);
  const auto faces = internal::numbered_faces(mesh, pack);
  internal::Surface surface = internal::read_triangle_mesh(
    mesh, faces,
    choose_parameter(get_parameter(pack, internal_np::vertex_point),
                     get_const_property_map(CGAL::vertex_point, mesh)),
    choose_parameter<Geom_traits>(get_parameter(pack, internal_np::geom_traits)));
  const internal::Constraints constraints = internal::read_constraints(
    [&](const auto& visit) { internal::for_each_inner_edge(mesh, faces, visit); }, faces, pack);
  return internal::segment_and_write<ConcurrencyTag>(std::move(surface), faces, segment_ids,
                                                     options, constraints, pack);
}

/*!
\ingroup PkgSpectralSegmentationRef

segments a range of triangles, which need not be a mesh, and writes for each the id of its segment.

First a surface is made of the triangles. Two triangles at an edge are neighbors. Of more triangles
at an edge, those become pairs of neighbors that are oriented alike and bend the least. Connected
triangles are oriented alike. They keep their orientation if they agree; otherwise they are oriented
outwards if their surface is closed, and like most of their area if not. Different points at the
same place stay different, as the vertices of a mesh do. For the triangles of a mesh the ids are
those of the function for meshes.

\tparam ConcurrencyTag as above
\tparam PointRange a range of points, each with the coordinates `p[0]`, `p[1]` and `p[2]`, such as
  `CGAL::Point_3` and `std::array<double, 3>`
\tparam TriangleRange a range of ranges of three integers, such as `std::array<int, 3>`
\tparam SegmentIdMap a model of `WritablePropertyMap` with `std::size_t` as key type and an integer
  type as value type
\tparam NamedParameters as above

\param points the points
\param triangles the corners of each triangle, as indices of points
\param segment_ids the ids of the segments are written here, for the position of each triangle
\param np an optional sequence of the named parameters above, but `vertex_point_map`,
  `face_index_map` and `geom_traits`. A `face_seed_map` has the position of a triangle as key. The
  edge maps have those of two neighbors as key, a `std::pair<std::size_t, std::size_t>`, the smaller
  one first.

\return the number of segments; 0 if there is no triangle

\throws std::invalid_argument if a triangle does not have three corners, a corner is not the index
  of a point, a coordinate of a corner is not finite, a number is out of its range, seeds
  contradict each other, or the number of segments does not let all of them be fulfilled
\throws std::overflow_error if there are more segments than the value type of `segment_ids` can
  count

If an exception is thrown, by the function, the visitor or the part salience, no id was written.
*/
template <class ConcurrencyTag = Parallel_if_available_tag,
          class PointRange, class TriangleRange, class SegmentIdMap,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<
              Spectral_segmentation::internal::is_triangle_range<TriangleRange>::value, int> = 0
#endif
          >
std::size_t segment_spectral_recursive(const PointRange& points, const TriangleRange& triangles,
                                       SegmentIdMap segment_ids,
                                       const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  const auto& pack = internal::cgal_pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  static_assert(!internal::is_given<Pack, internal_np::vertex_point_t> &&
                !internal::is_given<Pack, internal_np::face_index_t> &&
                !internal::is_given<Pack, internal_np::geom_traits_t>,
                "vertex_point_map, face_index_map and geom_traits are of meshes, not of points and "
                "triangles");

  const Spectral_segmentation::Options options = internal::read_options(pack);
  internal::Surface soup = internal::read_triangle_soup(points, triangles);
  internal::connect(soup);
  std::vector<std::size_t> faces(soup.number_of_faces());
  std::iota(faces.begin(), faces.end(), std::size_t(0));
  const internal::Constraints constraints = internal::read_constraints(
    [&](const auto& visit) { internal::for_each_inner_edge(soup, visit); }, faces, pack);
  return internal::segment_and_write<ConcurrencyTag>(std::move(soup), faces, segment_ids, options,
                                                     constraints, pack);
}

} // namespace CGAL

#endif // CGAL_SEGMENT_SPECTRAL_RECURSIVE_H
