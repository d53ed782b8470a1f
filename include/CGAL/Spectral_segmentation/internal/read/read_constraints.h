// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_CONSTRAINTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_CONSTRAINTS_H

#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/read/read_options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

template <class CGALNamedParameters>
constexpr bool has_edge_constraints =
  is_given<CGALNamedParameters, internal_np::edge_is_constrained_t> ||
  is_given<CGALNamedParameters, internal_np::edge_is_uncuttable_map_t>;

// Returns whether the caller gave a map. A static_assert reports a map with other keys.
template <class Key, class Tag, class CGALNamedParameters>
constexpr bool has_map()
{
  if constexpr (is_given<CGALNamedParameters, Tag>) {
    typedef std::decay_t<decltype(CGAL::parameters::get_parameter(
      std::declval<const CGALNamedParameters&>(), Tag()))> Map;
    constexpr bool result = is_key_of<Key, typename boost::property_traits<Map>::key_type>::value;
    static_assert(result, "the keys of face_seed_map, face_group_map and face_feature_map must be "
                          "the faces of the mesh, or the positions of triangles; those of "
                          "edge_is_constrained_map and edge_is_uncuttable_map its edges, or pairs "
                          "of positions of points");
    return result;
  }
  else {
    return false;
  }
}

// Returns the value of an edge map; `false` if the caller gave none.
template <class Tag, class CGALNamedParameters, class EdgeDescriptor>
bool edge_value(const CGALNamedParameters& np, Tag tag, const EdgeDescriptor& e)
{
  if constexpr (has_map<EdgeDescriptor, Tag, CGALNamedParameters>())
    return static_cast<bool>(get(CGAL::parameters::get_parameter(np, tag), e));
  else
    return false;
}

// Adds the constraint on an edge between two faces. Throws `std::invalid_argument` if both maps
// have the edge.
template <class CGALNamedParameters, class EdgeDescriptor>
void add_edge_constraint(const CGALNamedParameters& np, const EdgeDescriptor& e, Index f, Index g,
                         Constraints& constraints)
{
  const bool is_seam = edge_value(np, CGAL::internal_np::edge_is_constrained, e);
  const bool is_uncuttable = edge_value(np, internal_np::edge_is_uncuttable_map, e);
  if (is_seam && is_uncuttable)
    throw std::invalid_argument(
      "segment_spectral_recursive: the edge between the faces " + std::to_string(f) + " and " +
      std::to_string(g) + " is in both edge_is_constrained_map and edge_is_uncuttable_map");
  if (is_seam)
    constraints.cannot_link.push_back({f, g});
  if (is_uncuttable)
    constraints.must_link.push_back({f, g});
}

// Reads the constraints on edges of a mesh. Ignores border edges, including edges to faces outside
// of a filtered mesh.
template <class TriangleMesh, class FaceDescriptor, class CGALNamedParameters>
void read_edge_constraints(const TriangleMesh& mesh, const std::vector<FaceDescriptor>& faces,
                           const CGALNamedParameters& np, Constraints& constraints)
{
  const Descriptor_numbers<TriangleMesh, boost::face_index_t, FaceDescriptor>
    face_number(mesh, faces);
  for (Index f = 0; f < faces.size(); ++f)
    for (const auto& h : CGAL::halfedges_around_face(halfedge(faces[f], mesh), mesh)) {
      const FaceDescriptor across = face(opposite(h, mesh), mesh);
      if (across == boost::graph_traits<TriangleMesh>::null_face())
        continue;
      const Index g = face_number(across);
      if (g != null_index && f < g)
        add_edge_constraint(np, edge(h, mesh), f, g, constraints);
    }
}

// Reads the constraints on edges of triangles with these corners. An edge is given by its two
// corners, the smaller first, and joins or separates all its triangles.
template <class CGALNamedParameters>
void read_edge_constraints(const std::vector<Corners>& corners, const CGALNamedParameters& np,
                           Constraints& constraints)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Index> > faces_at;
  for (Index f = 0; f < corners.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [v, w] = std::minmax(corners[f][i], corners[f][(i + 1) % 3]);
      const std::pair<std::size_t, std::size_t> edge(v, w);
      if (!edge_value(np, CGAL::internal_np::edge_is_constrained, edge) &&
          !edge_value(np, internal_np::edge_is_uncuttable_map, edge))
        continue;
      std::vector<Index>& faces = faces_at[edge];
      if (faces.empty() || faces.back() != f) // a degenerate triangle may have it twice
        faces.push_back(f);
    }
  for (const auto& [edge, faces] : faces_at)
    for (std::size_t j = 1; j < faces.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        add_edge_constraint(np, edge, faces[i], faces[j], constraints);
  for (std::vector<Face_pair>* pairs : {&constraints.cannot_link, &constraints.must_link})
    std::sort(pairs->begin(), pairs->end());
}

// Reads the seeds of faces, or of the positions of triangles.
template <class FaceDescriptor, class CGALNamedParameters>
void read_seeds(const std::vector<FaceDescriptor>& faces, const CGALNamedParameters& np,
                Constraints& constraints)
{
  if constexpr (has_map<FaceDescriptor, internal_np::face_seed_map_t, CGALNamedParameters>()) {
    using boost::get; // finds the overload for pointers
    const auto map = CGAL::parameters::get_parameter(np, internal_np::face_seed_map);
    for (Index f = 0; f < faces.size(); ++f) {
      const std::int64_t seed = get(map, faces[f]);
      if (seed >= 0)
        constraints.seeds.emplace_back(f, seed);
    }
  }
}

// Reads the groups of faces, or of the positions of triangles, that are kept separate like
// components. Returns none if there is a single group.
template <class FaceDescriptor, class CGALNamedParameters>
std::vector<Index> read_groups(const std::vector<FaceDescriptor>& faces,
                               const CGALNamedParameters& np)
{
  std::vector<Index> result;
  if constexpr (has_map<FaceDescriptor, internal_np::face_group_map_t, CGALNamedParameters>()) {
    using boost::get; // finds the overload for pointers
    const auto map = CGAL::parameters::get_parameter(np, internal_np::face_group_map);
    typedef typename boost::property_traits<std::decay_t<decltype(map)> >::value_type Group;
    std::map<Group, Index> number;
    for (const FaceDescriptor& f : faces)
      result.push_back(number.try_emplace(get(map, f), static_cast<Index>(number.size()))
                         .first->second);
    if (number.size() == 1)
      result.clear();
  }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_CONSTRAINTS_H
