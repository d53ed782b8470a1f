// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENT_SPECTRAL_RECURSIVE_H
#define CGAL_SEGMENT_SPECTRAL_RECURSIVE_H

// These headers, below Spectral_segmentation/internal/, hold the sections of the paper:
//
//   2    overview, queue of parts        search/recursion.h
//   2    smoothing before                weights/face_distances.h
//   2    smoothing after                 ../Segmented_mesh/segment_boundaries.h
//   2    BESTCUT (Figure 2)              search/best_cut.h
//   3    distances of adjacent faces     weights/face_distances.h
//   3    distances of all faces          weights/shortest_paths.h, by BGL's Dijkstra
//   4    sampling by shape context       search/face_orders.h
//   5.2  spectral order of the faces     search/face_orders.h
//   5.3  line search                     search/line_search.h
//   6    salience of a part              salience/Patch.h, Part_salience.h
//
// The calibrated method adds to the paper: over-segmentation and merging (search/region_merging.h),
// more cuts to choose from (search/cut_proposals.h), more factors to judge them by
// (salience/Cut_evaluator.h), curvature at the scale of the shape (weights/curvature_angles.h), and
// the search on a coarse mesh (levels/). engine.h separates these headers from the templates here
// and in read/.

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/parameters.h>
#include <CGAL/Spectral_segmentation/version.h>

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/read/read_constraints.h>
#include <CGAL/Spectral_segmentation/internal/read/read_features.h>
#include <CGAL/Spectral_segmentation/internal/read/read_options.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>

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

// Passes the calls of the engine on to the visitor of the caller, whose functions are not virtual.
template <class Visitor>
class Visitor_control : public Run_control
{
  Visitor& visitor_;

public:
  explicit Visitor_control(Visitor& visitor) : visitor_(visitor) {}

  void before_stage(Stage stage, std::size_t part) override { visitor_.before_stage(stage, part); }
  void after_stage(Stage stage, std::size_t part) override { visitor_.after_stage(stage, part); }
  void before_part(std::size_t part, std::size_t n) override { visitor_.before_part(part, n); }
  void after_part(std::size_t part) override { visitor_.after_part(part); }
  void after_cut(std::size_t part, const Salience_factors& factors, double salience,
                 std::size_t number_of_segments) override
  { visitor_.after_cut(part, factors, salience, number_of_segments); }
  void progress(double fraction) override { visitor_.progress(fraction); }
  bool go_further() override { return visitor_.go_further(); }
};

// Runs the engine, and writes the labels of `faces` and the hierarchy of the caller. Returns the
// number of segments. `faces[i]` is the face of the i-th triangle.
template <class ConcurrencyTag, class Face, class SegmentIdMap, class CGALNamedParameters>
std::size_t segment_and_write(Surface triangles, const std::vector<Face>& faces,
                              SegmentIdMap segment_ids, const Options& options,
                              const Constraints& constraints, const CGALNamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter_reference;
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif

  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::visitor_t, CGALNamedParameters, Segmentation_visitor>::reference Visitor;
  static_assert(internal_np::is_visitor<std::decay_t<Visitor> >::value,
                "visitor takes a class derived from Segmentation_visitor that redefines one of its "
                "functions; is a name misspelt?");
  Segmentation_visitor no_visitor;
  Visitor visitor =
    choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), no_visitor);
  Visitor_control<std::remove_reference_t<Visitor> > control(visitor);

  Segmentation_hierarchy hierarchy = segmentation_hierarchy(
    std::move(triangles), options, is_parallel ? Execution::PARALLEL : Execution::SEQUENTIAL,
    control, constraints, read_features(faces, np));
  const std::size_t number_of_segments =
    write_labels(faces, hierarchy.labels(hierarchy.nodes()), segment_ids);

  if constexpr (is_given<CGALNamedParameters, internal_np::hierarchy_t>)
    get_parameter_reference(np, internal_np::hierarchy) = std::move(hierarchy);
  return number_of_segments;
}

} // namespace internal
} // namespace Spectral_segmentation
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

cuts a triangle mesh into the parts that a person would name, and writes the id of its segment for
each face.

The segment ids are contiguous and start at 0. Segments are numbered by their face of smallest
index. The index of a face is its position in `faces(mesh)`, or its value in the `face_index_map` if
one is given. The same input gives the same ids on every run, with any number of threads (unless a
visitor stops the run), and for every data structure that holds the same mesh.

Every segment of a connected mesh is connected. Degenerate faces, boundaries and several connected
components are supported; components that touch may belong to the same part. A segment of a hollow
body has faces of both walls, which are connected within each wall. A component whose faces point
inward has the parts that it has turned around, if it is closed or has small holes. The mesh is not
changed.

There are two methods, both by recursive and visually salient spectral cuts. The <b>calibrated
method (default)</b> cuts where people cut: its salience of a cut is the probability that a person
would cut there. It over-segments the mesh into 20 regions, then merges neighbors, the least salient
boundary first, up to the threshold. It extends the method of the paper, described next: it measures
curvature at the scale of the shape, searches along more orders of the faces, and moves the best
cuts to the minimum cut near them. A mesh of many faces is coarsened for the search, and the cuts
are projected back. The section \ref Spectral_segmentation_beyond has the details.

`zhang_liu_2005()` selects the method of Hao Zhang and Rong Liu, <em>Mesh Segmentation via Recursive
and Visually Salient Spectral Cuts</em>, Vision, Modeling, and Visualization 2005. The faces are
nodes of the dual graph of the mesh, in which the two faces at a concave edge are far apart. In each
part the method finds two sample faces by shape context and orders the faces by a spectral embedding
with respect to these samples. It takes the cut along this order that has the most salient
part. Both sides are parts again. The largest part is cut next, until no part has a cut whose
salience reaches the threshold. The section \ref Spectral_segmentation_method has the details;
the numbers of sections and equations below refer to the paper.

The time is O(*n* log *n*) in the number *n* of faces, for reading and coarsening, plus a search on
at most 3400 faces, five times by default. The memory is O(*n*). The section
\ref Spectral_segmentation_complexity has the bounds of each step.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  `CGAL::Parallel_if_available_tag`, the default. Parallelism needs TBB. The target
  `Spectral_segmentation::compiled` links it if it is found; without this target, link
  `CGAL::TBB_support`.
\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`, whose descriptors
  `std::hash` accepts, like those in \cgal's models. Several threads may segment
  the same mesh at the same time, except a `Face_filtered_graph`, which fills its indices when they
  are first requested.
\tparam SegmentIdMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer type as value
  type
\tparam NamedParameters a sequence of named parameters

\param mesh the triangle mesh
\param segment_ids receives the id of the segment of each face
\param np an optional sequence of named parameters among the ones listed below. It starts with a
  parameter of the package, as in `CGAL::parameters::number_of_segments(5).vertex_point_map(m)`. The
  form `CGAL::parameters::vertex_point_map(m).number_of_segments(5)` does not compile, because a
  sequence that starts with a parameter of \cgal has no others as members. If there is such a
  sequence `s`, write `CGAL::parameters::combine(s, CGAL::parameters::number_of_segments(5))`.

<b>Everyday parameters.</b> All named parameters are optional.
\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_segments}
    \cgalParamDescription{the exact number of segments, whatever the saliences and the
      `minimum_segment_size`. Components that do not touch are joined last, the nearest first. If
      the search finds too few cuts, the largest segment is halved.}
    \cgalParamType{an integer}
    \cgalParamDefault{none; the threshold ends the run}
    \cgalParamExtra{from 1 to the number of faces. If components are kept separate, the smallest
      value is the number of components; otherwise duplicate faces count once. Not
      together with `maximum_number_of_segments` or `salience_threshold`. For a number above 20 the
      calibrated method (default) searches as many regions, up to 200, on a proportionally finer
      coarse mesh.}
  \cgalParamNEnd
  \cgalParamNBegin{keep_components_separate}
    \cgalParamDescription{whether each connected component of the mesh is a part from the start. By
      default components whose borders meet edge to edge are one surface, a component with less than
      a hundredth of the area belongs to the part with which it has the most contact, and the second
      wall of a hollow body has the segments of the outer wall. Any other component is a part, or is
      cut further if it has parts of its own. The section \ref Spectral_segmentation_components has
      the details.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`, or `true` with `zhang_liu_2005()`, which supports no other value}
  \cgalParamNEnd
  \cgalParamNBegin{face_group_map}
    \cgalParamDescription{the group of each face, such as an object or a material of a file. Groups
      are treated like connected components: no cut is needed between them. A group of several
      connected components is several components.}
    \cgalParamType{a model of `ReadablePropertyMap` from `face_descriptor` to an integer type}
    \cgalParamDefault{none: all faces are in one group}
  \cgalParamNEnd
  \cgalParamNBegin{face_feature_map}
    \cgalParamDescription{<em>Experimental.</em> Per-face features: a vector, such as a color, a
      stress or the output of a neural network, or a label, such as a guess of the part. Cuts where
      the features change are preferred to others. Noise has hardly any effect on average
      at the default weight, but may change a mesh whose cuts are near the threshold.}
    \cgalParamType{a model of `ReadablePropertyMap` from `face_descriptor` to an integer type for
      labels, a floating point type, or a range of numbers, of the same length for all faces}
    \cgalParamDefault{none: only the shape is used}
    \cgalParamExtra{Neither the unit of the numbers nor an offset common to all faces matters.
      Features are averaged around each vertex of the coarse mesh; vectors longer than 16 are
      reduced to the 16 directions of largest variance. Not with `zhang_liu_2005()`. The section
      \ref Spectral_segmentation_features has the details.}
  \cgalParamNEnd
  \cgalParamNBegin{feature_weight}
    \cgalParamDescription{<em>Experimental.</em> The weight of the features. With 0 they are not
      used. Their effect grows up to 1/2; above, the effect of the shape decreases: with 1 it only
      breaks ties between cuts that the features do not distinguish, and uninformative features are
      used, too.}
    \cgalParamType{a number}
    \cgalParamDefault{`0.5`, fitted to human segmentations}
    \cgalParamExtra{in [0, 1]}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_segments}
    \cgalParamDescription{an upper bound on the number of segments. It is exceeded only if
      components are kept separate and there are more components.}
    \cgalParamType{an integer}
    \cgalParamDefault{`std::numeric_limits<std::size_t>::max()`, which is no limit; the threshold
      ends the run. With `zhang_liu_2005()`, unless a `salience_threshold` is given,
      `default_number_of_parts`, `12`, for a connected mesh}
    \cgalParamExtra{at least 1. For a number above 20 the calibrated method (default) makes as many
      regions, on a proportionally finer coarse mesh.}
  \cgalParamNEnd
  \cgalParamNBegin{salience_threshold}
    \cgalParamDescription{the smallest salience of a cut. Cuts below it are not made (Section 2), or
      are undone by merging. A higher value gives fewer segments.}
    \cgalParamType{a number}
    \cgalParamDefault{`default_probability_threshold`, `0.4`; for a `Weighted_part_salience`, as
      with `zhang_liu_2005()`, `default_salience_threshold`, `0.54`. Lower values cut flat parts
      along their noise; higher values miss limbs with a shallow seam.}
    \cgalParamExtra{not NaN; with the default salience, a probability, in [0, 1] or infinite.
      `-infinity` accepts every cut, for use with `maximum_number_of_segments`.}
  \cgalParamNEnd
  \cgalParamNBegin{hierarchy}
    \cgalParamDescription{receives all cuts with their salience}
    \cgalParamType{`CGAL::Spectral_segmentation::Segmentation_hierarchy&`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{receives the progress of the run and may stop it}
    \cgalParamType{a class derived from `CGAL::Spectral_segmentation::Segmentation_visitor`, or
      `std::reference_wrapper` of one to be read afterwards}
    \cgalParamDefault{`CGAL::Spectral_segmentation::Segmentation_visitor`, which does nothing}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a custom index for each face, from 0 to the number of faces - 1. Segments
      are numbered by these indices. With `zhang_liu_2005()`, equal faces are ordered by a search of
      the mesh that begins at the face of index 0.}
    \cgalParamType{a model of `ReadablePropertyMap` from `face_descriptor` to an integer type}
    \cgalParamDefault{the position of the face in `faces(mesh)`, which is safe for every mesh, even
      with removed faces or without ids}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of the mesh}
    \cgalParamType{a model of `ReadablePropertyMap` from `vertex_descriptor` to a point type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{a geometric traits class. Coordinates are rounded to `double`.}
    \cgalParamType{a class with `Compute_x_3`, `Compute_y_3` and `Compute_z_3` of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>Constraints.</b> They hold for the segments and for all nodes of the hierarchy. If the cuts of
the method violate them, it makes further cuts and merges across its cuts; the other segments stay
the same. `zhang_liu_2005()` does not support constraints. The example
`segment_with_constraints.cpp` uses all three.
\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{whether an edge must separate two segments. A single edge inside the
      surface makes a closed boundary through it. Border edges are ignored.}
    \cgalParamType{a model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{none: no edge must separate segments}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_uncuttable_map}
    \cgalParamDescription{whether the two faces at an edge must belong to the same segment. Border
      edges are ignored.}
    \cgalParamType{the same type as for `edge_is_constrained_map`}
    \cgalParamDefault{none: every edge may be cut}
  \cgalParamNEnd
  \cgalParamNBegin{face_seed_map}
    \cgalParamDescription{the seeds of faces. Faces with the same seed belong to the same segment;
      faces with different seeds belong to different segments. A negative value is no seed.}
    \cgalParamType{a model of `ReadablePropertyMap` from `face_descriptor` to a signed integer type}
    \cgalParamDefault{none: no face has a seed}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>Parameters for experts.</b>
\cgalNamedParamsBegin
  \cgalParamNBegin{minimum_segment_size}
    \cgalParamDescription{the smallest area of a segment, as a fraction of the area of the mesh. A
      whole component of the mesh may be smaller, and so may parts that constraints or a
      `number_of_segments` need. With `zhang_liu_2005()` the areas are those of the mesh that is
      searched. The factors of the salience are unreliable for a few faces; the paper has no such
      limit.}
    \cgalParamType{a number}
    \cgalParamDefault{`0.003`, or `0.005` with `zhang_liu_2005()`. A finger of a human figure is
      larger than this; a pit in its skin is smaller.}
    \cgalParamExtra{in [0, 0.5]; 0 with `zhang_liu_2005()` gives exactly the method of the paper}
  \cgalParamNEnd
  \cgalParamNBegin{part_salience}
    \cgalParamDescription{<em>Experimental.</em> Computes the salience of a cut (Section 6)}
    \cgalParamType{a model of the concept `PartSalience`}
    \cgalParamDefault{`Calibrated_part_salience()`, or `Weighted_part_salience()` with
      `zhang_liu_2005()`}
    \cgalParamExtra{A custom salience needs a `salience_threshold` on its scale. With
      `zhang_liu_2005()` the salience is called at each step of a line, and the factors beyond the
      paper are 0.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_coarse_faces}
    \cgalParamDescription{the number of faces of the coarse mesh on which cuts are searched, as far
      as the topology allows it. The cuts are carried back by minimum cuts. Therefore neither the
      time of the search nor the result depends much on the triangles. With 0 the mesh itself is
      searched.}
    \cgalParamType{an integer}
    \cgalParamDefault{`3400`, or `0` with `zhang_liu_2005()`}
    \cgalParamExtra{at least 0. No more than the number of faces of the mesh plus 1000 are searched.
      A convex mesh that has at most `number_of_coarse_faces` faces is one part without a search,
      unless `number_of_segments` or constraints are given. In the calibrated method (default) the
      number grows in proportion if more than 20 segments are requested. The factors and saliences
      of cuts refer to the mesh that is searched.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_searches}
    \cgalParamDescription{the number of coarse meshes that are searched, each independently. The
      cuts are those of the search whose segments above the default threshold agree best with those
      of the others; above the given threshold with a custom salience}
    \cgalParamType{an integer}
    \cgalParamDefault{`5`, or `1` with `zhang_liu_2005()`, which permits no other number}
    \cgalParamExtra{from 1 to 100. One search takes a third of the time, and is less reliable.}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>The paper's parameters.</b>
\cgalNamedParamsBegin
  \cgalParamNBegin{zhang_liu_2005}
    \cgalParamDescription{selects the method of the paper and its defaults; takes no argument}
    \cgalParamDefault{not given: the calibrated method (default)}
  \cgalParamNEnd
  \cgalParamNBegin{options}
    \cgalParamDescription{the values of all options at once, for programs that choose them at run
      time. Other parameters in the pack override the values given here.}
    \cgalParamType{`CGAL::Spectral_segmentation::Options`}
    \cgalParamDefault{`Options()`, the calibrated method (default)}
    \cgalParamExtra{not together with `zhang_liu_2005()`: use `Options::zhang_liu_2005()`}
  \cgalParamNEnd
  \cgalParamNBegin{salience_weights}
    \cgalParamDescription{the weights &alpha;, &beta;, &gamma; of the size, the cut strength and the
      protrusiveness in the salience of a part (Section 6, Equation 3). It is short for
      `part_salience(Weighted_part_salience{alpha, beta, gamma})`; the last of these two parameters
      in a pack counts.}
    \cgalParamType{three numbers}
    \cgalParamDefault{`0.1, 0.6, 0.3` in a `Weighted_part_salience`, which the authors found to work
      generally well. The weight of the size must stay small; otherwise halves of a body win over
      its limbs.}
    \cgalParamExtra{not negative, with sum 1}
  \cgalParamNEnd
  \cgalParamNBegin{distance_weights}
    \cgalParamDescription{the weight &delta; of the geodesic distance in the distance of adjacent
      faces, in which the angle distance has the weight 1 - &delta; (Section 3, Equation 1); then
      the factors &eta; of the angle distance 1 - cos &theta; at concave and at convex edges. Only
      the ratio of these two factors matters.}
    \cgalParamType{three numbers}
    \cgalParamDefault{`0.03, 1, 0.1`, or `0.01, 1, 0.1` with `zhang_liu_2005()`: angles decide, and
      the geodesic distance decides on flat surfaces. By the minima rule people cut along concave
      creases.}
    \cgalParamExtra{the first in [0, 1], the others finite and not negative}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_reference_faces}
    \cgalParamDescription{the dimension *k* of the context vector of a face (Section 4)}
    \cgalParamType{an integer}
    \cgalParamDefault{`3`, or `10` with `zhang_liu_2005()`; the result depends little on it, the
      time is linear in it}
    \cgalParamExtra{from 1 to 1000}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_smoothing_iterations}
    \cgalParamDescription{the steps of Laplacian smoothing on a copy of the points. Face distances
      are computed from the smoothed points (Section 2), and so is the coarse mesh if cuts are
      searched on one.}
    \cgalParamType{an integer}
    \cgalParamDefault{`0`; a few steps help on noisy scans}
    \cgalParamExtra{from 0 to 100000}
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
  `face_index_map` is not one to one onto its range, a number is out of its range, constraints
  contradict each other, the number of segments does not allow all constraints to be satisfied, or
  features have different lengths or are not finite
\throws std::overflow_error if there are more segments than the value type of `segment_ids` can
  count

If the function, the visitor or the part salience throws an exception, no id has been written.
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
  const auto& pack =
    internal::checked_pack<Spectral_segmentation::internal_np::has_only_known_tags>(np);
  typedef std::decay_t<decltype(pack)> Pack;

  const Spectral_segmentation::Options options = internal::read_options(pack);
  const auto faces = internal::numbered_faces(mesh, pack);
  internal::Surface triangles = internal::read_mesh_with_parameters(mesh, faces, pack);
  internal::Constraints constraints;
  if constexpr (internal::has_edge_constraints<Pack>)
    internal::read_edge_constraints(mesh, faces, pack, constraints);
  internal::read_seeds(faces, pack, constraints);
  triangles.groups = internal::read_groups(faces, pack);
  return internal::segment_and_write<ConcurrencyTag>(std::move(triangles), faces, segment_ids,
                                                     options, constraints, pack);
}

/*!
\ingroup PkgSpectralSegmentationRef

segments a range of triangles, which need not be a mesh, and writes the id of its segment for each
triangle.

First the function makes a surface of the triangles. Two triangles alone at an edge are neighbors.
If an edge has more triangles, the pairs that are oriented alike and bend the least become
neighbors. Then connected triangles are oriented alike. They keep their orientation if they agree.
Otherwise they are oriented outwards if their surface is closed, and like most of their area if it
is not. Triangles that have a point in common, but are not connected by neighbors at it, meet there
like triangles with different points at the same place. These stay different, like the vertices of a
mesh. For the triangles of a mesh the ids are the same as with the function for meshes.

\tparam ConcurrencyTag the tag, as above
\tparam PointRange a range of points, each with the coordinates `p[0]`, `p[1]` and `p[2]`, such as
  `CGAL::Point_3` and `std::array<double, 3>`
\tparam TriangleRange a range of ranges of three integers, such as `std::array<int, 3>`
\tparam SegmentIdMap a model of `WritablePropertyMap` with `std::size_t` as key type and an integer
  type as value type
\tparam NamedParameters a sequence of named parameters, as above

\param points the points
\param triangles the indices of the three corner points of each triangle
\param segment_ids receives the id of the segment of each triangle; the key is the position of the
  triangle
\param np an optional sequence of the named parameters above, except `vertex_point_map`,
  `face_index_map` and `geom_traits`. The key of a `face_seed_map`, `face_group_map` or
  `face_feature_map` is the position of a triangle. The key of an `edge_is_constrained_map` or
  `edge_is_uncuttable_map` is a `std::pair<std::size_t, std::size_t>` with the indices of the two
  points, the smaller first. The constraint holds for any two triangles at the edge, neighbors or
  not.

\return the number of segments; 0 if there is no triangle

\throws std::invalid_argument if a triangle does not have three corners, a corner is not the index
  of a point, a coordinate of a corner is not finite, a number is out of its range, constraints
  contradict each other, the number of segments does not allow all constraints to be satisfied, or
  features have different lengths or are not finite
\throws std::overflow_error if there are more segments than the value type of `segment_ids` can
  count

If the function, the visitor or the part salience throws an exception, no id has been written.
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
  const auto& pack =
    internal::checked_pack<Spectral_segmentation::internal_np::has_only_known_tags>(np);
  typedef std::decay_t<decltype(pack)> Pack;
  static_assert(!internal::is_given<Pack, internal_np::vertex_point_t> &&
                !internal::is_given<Pack, internal_np::face_index_t> &&
                !internal::is_given<Pack, internal_np::geom_traits_t>,
                "vertex_point_map, face_index_map and geom_traits apply to meshes, not to triangle "
                "soups");

  const Spectral_segmentation::Options options = internal::read_options(pack);
  internal::Surface soup = internal::read_triangle_soup(points, triangles);
  std::vector<std::size_t> faces(soup.corners.size());
  std::iota(faces.begin(), faces.end(), std::size_t(0));
  soup.groups = internal::read_groups(faces, pack);
  internal::Constraints constraints;
  if constexpr (internal::has_edge_constraints<Pack>)
    internal::read_edge_constraints(soup.corners, pack, constraints);
  internal::connect(soup);
  internal::read_seeds(faces, pack, constraints);
  return internal::segment_and_write<ConcurrencyTag>(std::move(soup), faces, segment_ids, options,
                                                     constraints, pack);
}

} // namespace CGAL

#endif // CGAL_SEGMENT_SPECTRAL_RECURSIVE_H
