// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENT_SPECTRAL_RECURSIVE_H
#define CGAL_SEGMENT_SPECTRAL_RECURSIVE_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/parameters.h>
#include <CGAL/Spectral_segmentation/version.h>

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Monitor.h>
#include <CGAL/Spectral_segmentation/internal/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/cut_and_merge.h>
#include <CGAL/Spectral_segmentation/internal/cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/initialization.h>
#include <CGAL/Spectral_segmentation/internal/mesh_numbering.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/order_of_locality.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/read_triangles.h>
#include <CGAL/Spectral_segmentation/internal/recursion.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSpectralSegmentationRef

cuts a triangle mesh into the parts that a person would name, by recursive and visually salient
spectral cuts, and writes for each face the id of its segment.

The method is built on that of Hao Zhang and Rong Liu, <em>Mesh Segmentation via Recursive and
Visually Salient Spectral Cuts</em>, Vision, Modeling, and Visualization 2005. Sections named below
are those of the paper. The faces are nodes of the dual graph of the mesh, and a concave edge puts
its two faces far apart. In a part, two sample faces are found by shape context, the faces of the
part are ordered by a spectral embedding with respect to these samples, and of all the cuts along
this order the one with the most salient part is taken. Both sides are parts again. Each connected
component of the mesh is a part of its own from the start.

In the paper the largest part is cut next, until no part has a cut whose salience reaches a
threshold: this is `zhang_liu_2005()`. The default, `Method::CALIBRATED`, cuts where people cut: it
also measures bending at the scale of the shape, searches along more orders of the faces, moves the
best cuts to the minimum cut near them, and judges cuts by a salience that is the probability that
a person would cut there. It first cuts the mesh into small pieces, then merges neighbors again, the
least salient boundary first, up to the threshold. A mesh of many faces is simplified for the
search, and the cuts are carried over to it. Each of these differences is a named parameter;
`method` sets the defaults of them all.

The segment ids are contiguous and start at 0; segments are numbered by their face of smallest
index: its position in `faces(mesh)`, or in the `face_index_map` if one is given. Every segment is
connected. The same input gives the same ids on every run, with any number of threads (unless a
visitor stops it), and for every data structure that holds the same mesh.

The run takes O(*n* log *n*) time and O(*n*) memory to read a mesh of *n* faces and to simplify it
to the *m* faces that are searched; O(*k p m* log *m*) time and O(*k m*) memory to search *p* parts
with *k* reference faces; and O(*n* + *c b*) time to carry *c* cuts over to the mesh, of which *b*
faces are near a cut, or count as such if `number_of_pieces` is 0: then *b* is *n*. Without
simplification *m* is *n*, and nothing is carried over. To average bending and thickness over *m*
faces, and bending over *b*, takes a direct solver O(*m*<sup>1.5</sup> + *b*<sup>1.5</sup>) time and
O(*m* log *m* + *b* log *b*) memory besides. The bounds leave out the shortest paths where a few
edges are far longer than all others, and the minimum cuts: their worst cases are worse, but in
practice they take hardly more than linear time. The mesh is not changed.
Faces without area, borders, and any number of connected components are welcome.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  `CGAL::Parallel_if_available_tag`, the default. Parallelism needs TBB, and the target
  `CGAL::TBB_support` of CMake.
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

\cgalNamedParamsBegin
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
  \cgalParamNBegin{method}
    \cgalParamDescription{the method, which is the defaults of all other parameters;
      `zhang_liu_2005()` is short for `method(Method::ZHANG_LIU_2005)`. Where two defaults are given
      below, the first is that of `CALIBRATED`, the second that of `ZHANG_LIU_2005`.}
    \cgalParamType{`CGAL::Spectral_segmentation::Method`}
    \cgalParamDefault{`CALIBRATED`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_segments}
    \cgalParamDescription{the largest number of segments, but a mesh with more connected components
      has one for each. The paper's recursion ends there; among pieces it is where merging ends.}
    \cgalParamType{an integer}
    \cgalParamDefault{`std::numeric_limits<std::size_t>::max()`, which is no limit; the threshold
      ends the run}
    \cgalParamExtra{at least 1. See `number_of_pieces` for numbers above that one.}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_segment_size}
    \cgalParamDescription{the share of the area of the mesh that each side of a cut must have. The
      factors of the salience mean little for a handful of faces; the paper has no such limit.}
    \cgalParamType{a number}
    \cgalParamDefault{`default_minimum_segment_size(method)`: `0.003`, `0.005`. A finger of a whole
      figure is larger, a pit in its skin smaller.}
    \cgalParamExtra{in [0, 0.5]; 0 with `zhang_liu_2005()` is the paper's method to the letter}
  \cgalParamNEnd
  \cgalParamNBegin{part_salience}
    \cgalParamDescription{judges the cuts (Section 6)}
    \cgalParamType{a model of the concept `PartSalience`}
    \cgalParamDefault{`Calibrated_part_salience()`, `Weighted_part_salience()`}
    \cgalParamExtra{Give `salience_threshold` with a salience of your own, on its scale. With
      `number_of_candidates(0)` it is called at each step of each line, and the factors beyond the
      paper are 0 there; the boundaries of pieces are always judged by all factors.}
  \cgalParamNEnd
  \cgalParamNBegin{salience_weights}
    \cgalParamDescription{the weights &alpha;, &beta;, &gamma; of the size, the cut strength and the
      protrusiveness in the salience of a part (Section 6, Equation 3); short for
      `part_salience(Weighted_part_salience{alpha, beta, gamma})`, of which the last in a pack
      counts}
    \cgalParamType{three numbers}
    \cgalParamDefault{`0.1, 0.6, 0.3` in a `Weighted_part_salience`, found by the authors to work
      generally well: the size must stay small, or halves of a body win over its limbs}
    \cgalParamExtra{not negative, with sum 1}
  \cgalParamNEnd
  \cgalParamNBegin{salience_threshold}
    \cgalParamDescription{Cuts whose salience is below this value are not made (Section 2), or
      undone by merging.}
    \cgalParamType{a number}
    \cgalParamDefault{`default_salience_threshold`, `0.54`, for a `Weighted_part_salience`: lower
      values leave the noise of flat regions in the result, higher ones lose limbs with a shallow
      seam. Else `default_probability_threshold`, `0.42`.}
    \cgalParamExtra{`-infinity` accepts every cut, for use with `maximum_number_of_segments`. Not a
      NaN.}
  \cgalParamNEnd
  \cgalParamNBegin{geodesic_weight}
    \cgalParamDescription{the weight &delta; of the geodesic distance in the distance of
      adjacent faces; 1 - &delta; is that of the angle distance (Section 3, Equation 1)}
    \cgalParamType{a number}
    \cgalParamDefault{`0.03`, `0.01`: angles decide, and geodesic distance where there are none}
    \cgalParamExtra{in [0, 1]}
  \cgalParamNEnd
  \cgalParamNBegin{concave_angle_weight}
    \cgalParamDescription{the factor &eta; of the angle distance 1 - cos &theta; at concave
      edges (Section 3)}
    \cgalParamType{a number}
    \cgalParamDefault{`1`; only its ratio to `convex_angle_weight` matters}
    \cgalParamExtra{finite, not negative}
  \cgalParamNEnd
  \cgalParamNBegin{convex_angle_weight}
    \cgalParamDescription{the same at convex edges}
    \cgalParamType{a number}
    \cgalParamDefault{`0.1`: by the minima rule people cut along concave creases}
    \cgalParamExtra{finite, not negative}
  \cgalParamNEnd
  \cgalParamNBegin{concavity_radius}
    \cgalParamDescription{the radius over which the bending of the surface is averaged, as the root
      of the mean squared distance of the averaging kernel, relative to the square root of the area
      of the mesh. The angle distance of two faces is that of the bending across their edge in place
      of their dihedral angle, ranked by length of edge, so that it hardly depends on the
      triangulation. The radius ends at 9 times the root of the mean area of the faces, as wide as
      the bands in which cuts of a simplified mesh are carried over.}
    \cgalParamType{a number}
    \cgalParamDefault{`0.02`, about the width of a crease between two limbs; `0`, which is dihedral
      angles}
    \cgalParamExtra{in [0, 1]}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_reference_faces}
    \cgalParamDescription{the dimension *k* of the context vector of a face (Section 4)}
    \cgalParamType{an integer}
    \cgalParamDefault{`10`; the result depends little on it, the time is linear in it}
    \cgalParamExtra{at least 1}
  \cgalParamNEnd
  \cgalParamNBegin{single_source_orderings}
    \cgalParamDescription{whether cuts are also searched along the orders of the faces by distance
      from each sample and each reference face: such an order grows a single limb where the spectral
      one, from one sample to the other, sees several at once}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`, `false`}
  \cgalParamNEnd
  \cgalParamNBegin{thickness_orderings}
    \cgalParamDescription{whether cuts are also searched along the orders of the faces by the
      thickness of the body under them, from the thinnest and from the thickest. The thickness is
      measured once, by a ray for each face, O(*n* log *n*) on most meshes.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`, `false`}
    \cgalParamExtra{It is also measured if all factors of cuts are asked for by a part salience
      other than `Weighted_part_salience`, which does not read it.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_candidates}
    \cgalParamDescription{how many cuts of a part are judged by all factors of the salience. They
      are found by the salience of the paper, and as cuts that are cheap in length and convexity,
      along the first three quarters of each line; hence the spectral order is searched from both
      its ends. With 0 every step of every line is judged by the factors of the paper, and the best
      step of each line is a cut.}
    \cgalParamType{an integer}
    \cgalParamDefault{`14`, `0`}
    \cgalParamExtra{at least 0}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_refined_candidates}
    \cgalParamDescription{how many of the most salient cuts of a part are moved to the minimum cut
      within a distance of 0.35 sqrt(*area of the smaller side*) around them, and judged again; an
      edge costs its length, and little if it is concave}
    \cgalParamType{an integer}
    \cgalParamDefault{`4`, `0`}
    \cgalParamExtra{at least 0}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_pieces}
    \cgalParamDescription{the number of pieces into which a connected mesh is cut, the most salient
      cut first, before neighbors are merged again, the least salient boundary first; one more for
      each further component. With 0 nothing is merged: the paper's recursion cuts the largest part
      next.}
    \cgalParamType{an integer}
    \cgalParamDefault{`20`, `0`}
    \cgalParamExtra{0 or at least 2. If the `maximum_number_of_segments` is larger than the number
      of pieces there are as many pieces as that, so that the threshold `-infinity` gives so many
      segments; then labels depend on the maximum also where they have fewer segments. A
      `Segment_tree` has all merges in reverse, whatever the threshold.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_searched_faces}
    \cgalParamDescription{the number of faces on which cuts are searched. A mesh with more faces is
      simplified to so many, as far as its topology allows, by edge collapses, and the cuts are
      carried over to it, by minimum cuts through the faces that are on neither side of the
      simplified mesh for sure. So the time of the search does not grow with the mesh. With 0 the
      mesh itself is searched.}
    \cgalParamType{an integer}
    \cgalParamDefault{`4000`, at which the agreement with people is that of the mesh itself; `0`}
    \cgalParamExtra{at least 0. If there are pieces, and more than 20 of them or of segments are
      asked for by `number_of_pieces` or `maximum_number_of_segments`, it grows in proportion.
      Factors and salience of cuts and the `minimum_segment_size` are those of the mesh that is
      searched. The visitor is not asked whether to go further during simplification and transfer.}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{chooses the first reference face of each part at random, as in the paper}
    \cgalParamType{an integer}
    \cgalParamDefault{none: the first reference face is the one farthest from the center of the
      part}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_smoothing_iterations}
    \cgalParamDescription{steps of Laplacian smoothing on a copy of the points, from which the face
      distances and the thickness are then computed (Section 2), and the simplified mesh if cuts are
      searched on one}
    \cgalParamType{an integer}
    \cgalParamDefault{`0`; a few steps help on noisy scans}
    \cgalParamExtra{at least 0}
  \cgalParamNEnd
  \cgalParamNBegin{boundary_smoothing}
    \cgalParamDescription{whether the boundaries of the segments are smoothed by a morphological
      opening of each segment with a ball of two steps over faces (Section 2). It moves a boundary
      by a few faces at the most, and neither empties nor disconnects a segment.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`: most cuts are smooth enough, as short ones are more salient}
  \cgalParamNEnd
  \cgalParamNBegin{segment_tree}
    \cgalParamDescription{receives all cuts with their salience}
    \cgalParamType{`CGAL::Spectral_segmentation::Segment_tree&`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{hears of the progress and may stop the run}
    \cgalParamType{a class derived from `CGAL::Spectral_segmentation::Segmentation_visitor`, or
      `std::reference_wrapper` of one to be read afterwards}
    \cgalParamDefault{`CGAL::Spectral_segmentation::Segmentation_visitor`, which does nothing}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of segments; 0 for an empty mesh

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, the
  `face_index_map` is not one to one onto its range, or a number is out of its range
\throws std::overflow_error if there are more segments than the value type of `segment_ids` can
  count

If an exception is thrown, by the function, the visitor or the part salience, no id was written.
*/
template <class ConcurrencyTag = Parallel_if_available_tag,
          class TriangleMesh, class SegmentIdMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t segment_spectral_recursive(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                                       const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  namespace tags = Spectral_segmentation::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  using Spectral_segmentation::Segment_tree;
  using Spectral_segmentation::Segmentation_visitor;
  using Spectral_segmentation::Stage;

#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!internal::is_parallel<ConcurrencyTag>,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif

  const auto& pack = internal::cgal_pack(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename GetGeomTraits<TriangleMesh, Pack>::type Geom_traits;
  typedef typename internal_np::Lookup_named_param_def<
    CGAL::internal_np::visitor_t, Pack, Segmentation_visitor>::reference Visitor_reference;

  const internal::Options options = internal::read_options(pack);
  const auto faces = internal::numbered_faces(mesh, pack);
  Segmentation_visitor no_visitor;
  Visitor_reference visitor =
    choose_parameter(get_parameter_reference(pack, CGAL::internal_np::visitor), no_visitor);
  typedef internal::Monitor<std::remove_reference_t<Visitor_reference> > Monitor;
  Monitor monitor(visitor);

  Segment_tree tree;
  internal::call_isolated([&] {
    std::vector<internal::Index> order;
    internal::Initial_mesh initial = monitor.stage(
      Stage::INITIALIZATION, Segmentation_visitor::whole_mesh, [&] {
        internal::Triangles triangles = internal::read_triangles(
          mesh, faces,
          choose_parameter(get_parameter(pack, CGAL::internal_np::vertex_point),
                           get_const_property_map(CGAL::vertex_point, mesh)),
          choose_parameter<Geom_traits>(get_parameter(pack, CGAL::internal_np::geom_traits)));
        order = internal::order_of_locality(triangles.neighbors);
        triangles = internal::in_order(std::move(triangles), order);
        return internal::initialize<ConcurrencyTag>(std::move(triangles), options,
                                                    [&] { return monitor.go_further(); });
      });
    const bool is_simplified = !initial.simplified.empty();
    std::vector<internal::Neighbors> neighbors;
    if (options.boundary_smoothing)
      neighbors = internal::neighbors(initial.graph);
    internal::Face_dual_graph searched =
      is_simplified ? initial.searched() : std::move(initial.graph);
    tree = options.number_of_pieces > 0
      ? internal::cut_and_merge<ConcurrencyTag>(std::move(searched), options, monitor)
      : internal::Recursion<ConcurrencyTag, Monitor>(std::move(searched), options, monitor)();
    if (is_simplified)
      tree = monitor.stage(Stage::TRANSFER, Segmentation_visitor::whole_mesh, [&]
        { return internal::transfer_cuts<ConcurrencyTag>(std::move(tree), initial, options); });
    internal::number_faces(tree, order, neighbors);
  });

  const std::vector<std::size_t> labels = options.boundary_smoothing
    ? monitor.stage(Stage::BOUNDARY_SMOOTHING, Segmentation_visitor::whole_mesh,
                    [&] { return tree.labels(); })
    : tree.labels();
  const std::size_t number_of_segments = internal::write_labels(faces, labels, segment_ids);

  if constexpr (!CGAL::parameters::is_default_parameter<Pack, tags::segment_tree_t>::value)
    get_parameter_reference(pack, tags::segment_tree) = std::move(tree);
  return number_of_segments;
}

} // namespace CGAL

#endif // CGAL_SEGMENT_SPECTRAL_RECURSIVE_H
