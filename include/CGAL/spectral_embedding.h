// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_EMBEDDING_H
#define CGAL_SPECTRAL_EMBEDDING_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/read/read_options.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
namespace Spectral_segmentation {
namespace internal {

template <class Pack>
using has_only_embedding_tags =
  internal_np::has_only<Pack, internal_np::vertex_point_t, internal_np::geom_traits_t,
                        internal_np::sample_faces_t, internal_np::options_t,
                        internal_np::distance_weights_t,
                        internal_np::number_of_reference_faces_t>;

// Returns the dual graph of a mesh with the distances of adjacent faces.
inline Surface weighted_face_graph(Surface graph, const Options& o)
{
  normalize(graph.points);
  set_areas(Execution::SEQUENTIAL, graph);
  set_face_distances(Execution::SEQUENTIAL, graph, graph.points,
                     face_normals(Execution::SEQUENTIAL, graph, graph.points),
                     distance_weights(o, constants_of(o.method)));
  return graph;
}

// Returns the two samples of Section 4.
inline std::vector<Index> two_sample_faces(const Surface& graph, const Options& o)
{
  const Sample_faces samples = sample_faces(
    Execution::SEQUENTIAL,
    shape_contexts(graph, farthest_face_from_center(Execution::SEQUENTIAL, graph),
                   o.number_of_reference_faces, [] {}));
  return {samples.s, samples.t};
}

// Returns the indices of the samples that the caller gave.
template <class Face>
std::vector<Index> sample_indices(const std::vector<Face>& samples, const std::vector<Face>& faces)
{
  std::vector<Index> result;
  for (const Face& sample : samples) {
    const auto place = std::find(faces.begin(), faces.end(), sample);
    const Index index = static_cast<Index>(place - faces.begin());
    if (place == faces.end() || std::find(result.begin(), result.end(), index) != result.end())
      throw std::invalid_argument("spectral_embedding: the sample faces must be different faces of "
                                  "the mesh");
    result.push_back(index);
  }
  if (result.size() < 2)
    throw std::invalid_argument("spectral_embedding: there must be at least two sample faces");
  return result;
}

inline void check_embedding_input(const Surface& graph)
{
  if (graph.number_of_faces() < 2 || connected_components(graph).number != 1)
    throw std::invalid_argument("spectral_embedding: the mesh must be connected and have at least "
                                "two faces: embed each connected component by itself");
}

} // namespace internal
} // namespace Spectral_segmentation
/// \endcond

/*!
\ingroup PkgSpectralSegmentationRef

computes the spectral embedding of the faces of a triangle mesh, and writes the coordinate of each
face.

This is the line on which `segment_spectral_recursive()` searches for the best cut of a part
(Sections 5.1 to 5.3 of Zhang and Liu 2005). The affinity of two faces is
exp(-*d* / &sigma;<sup>2</sup>), where *d* is their distance in the dual graph by the combined
weights of Section 3 and &sigma; the mean of the distances from the samples. The eigenvectors of the
normalized affinity matrix are extrapolated from the rows of a few sample faces by Nystrom's method
\cgalCite{FBCM04}; with all faces as samples they are exact. The coordinate is the ratio of the
second eigenvector to the first. Faces of one part of the shape have similar coordinates, and the
coordinate changes fast where the surface is concave.

With two samples the coordinates have the order of the search, up to rounding. The search
itself does not need the eigenvectors, because the ratio grows with the distance from the first
sample minus the distance from the second.

The time is O(*m n* log *n*) for *n* faces and *m* samples, and O(*k n* log *n*) more for *k*
reference faces if the samples are not given; the memory is O(*m n*).

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam FaceCoordinateMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a floating point type as
  value type
\tparam NamedParameters a sequence of named parameters

\param mesh the triangle mesh, which must be connected and have at least two faces
\param coordinates the coordinate of each face is written here: a number without unit; the first
  sample does not lie above the last one
\param np those below, and `vertex_point_map` and `geom_traits` of `segment_spectral_recursive()`

\cgalNamedParamsBegin
  \cgalParamNBegin{sample_faces}
    \cgalParamDescription{the faces whose distances from all others are computed}
    \cgalParamType{a `std::vector` of `boost::graph_traits<TriangleMesh>::%face_descriptor`}
    \cgalParamDefault{the two faces that sampling by shape context chooses (Section 4)}
    \cgalParamExtra{two or more different faces}
  \cgalParamNEnd
  \cgalParamNBegin{options}
    \cgalParamDescription{the weights of the distances (Section 3), the radius at which curvature is
      measured, and the number of reference faces (Section 4); other fields are not used}
    \cgalParamType{`CGAL::Spectral_segmentation::Options`}
    \cgalParamDefault{`Options::zhang_liu_2005()`}
  \cgalParamNEnd
  \cgalParamNBegin{distance_weights}
    \cgalParamDescription{the weights of the distances alone, see `segment_spectral_recursive()`}
    \cgalParamType{three numbers}
    \cgalParamDefault{`0.01, 1, 0.1`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_reference_faces}
    \cgalParamDescription{the dimension *k* of the context vector of a face (Section 4); used only
      if there are no `sample_faces`}
    \cgalParamType{an integer}
    \cgalParamDefault{`10`}
    \cgalParamExtra{at least 1}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the sample faces that were used

\throws std::invalid_argument if a face is not a triangle, a coordinate is not finite, the mesh is
  not connected or has a single face, the samples are fewer than two or not different faces of the
  mesh, or a number is out of its range. No coordinate was written then.
*/
template <class TriangleMesh, class FaceCoordinateMap,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>
spectral_embedding(const TriangleMesh& mesh, FaceCoordinateMap coordinates,
                   const NamedParameters& np = NamedParameters())
{
  namespace internal = Spectral_segmentation::internal;
  namespace tags = Spectral_segmentation::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  const auto& pack = internal::checked_pack<internal::has_only_embedding_tags>(np);
  typedef std::decay_t<decltype(pack)> Pack;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor Face;

  Spectral_segmentation::Options o =
    choose_parameter(get_parameter(pack, tags::options),
                     Spectral_segmentation::Options::zhang_liu_2005());
  internal::read_distance_weights(pack, o);
  internal::read_values(pack, o);
  check(o);

  const std::vector<Face> faces = internal::numbered_faces(mesh, pack, "spectral_embedding");
  const internal::Surface graph = internal::weighted_face_graph(
    internal::read_mesh_with_parameters(mesh, faces, pack, "spectral_embedding"), o);
  internal::check_embedding_input(graph);
  std::vector<internal::Index> samples;
  if constexpr (internal::is_given<Pack, tags::sample_faces_t>)
    samples = internal::sample_indices<Face>(get_parameter(pack, tags::sample_faces), faces);
  else
    samples = internal::two_sample_faces(graph, o);

  const Eigen::VectorXd z =
    internal::spectral_coordinates(internal::face_eigenpairs(graph, samples), samples);
  typedef typename boost::property_traits<FaceCoordinateMap>::value_type Coordinate;
  for (std::size_t f = 0; f < faces.size(); ++f)
    put(coordinates, faces[f], static_cast<Coordinate>(z[static_cast<Eigen::Index>(f)]));
  std::vector<Face> result;
  for (internal::Index sample : samples)
    result.push_back(faces[sample]);
  return result;
}

} // namespace CGAL

#endif // CGAL_SPECTRAL_EMBEDDING_H
