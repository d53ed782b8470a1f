// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_CONSTRAINTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_CONSTRAINTS_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>
#include <CGAL/Spectral_segmentation/internal/door/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The value of an edge map; `false` if the caller gave none.
template <class Tag, class CGALNamedParameters, class Edge>
bool edge_flag(const CGALNamedParameters& np, Tag tag, const Edge& e)
{
  using boost::get; // for pointers
  if constexpr (is_given<CGALNamedParameters, Tag>)
    return static_cast<bool>(get(CGAL::parameters::get_parameter(np, tag), e));
  else
    return false;
}

// Calls visit(f, g, edge) for the edges between two faces f < g, by their numbers.
template <class TriangleMesh, class FaceDescriptor, class Visit>
void for_each_inner_edge(const TriangleMesh& mesh, const std::vector<FaceDescriptor>& faces,
                         const Visit& visit)
{
  const Descriptor_numbers<TriangleMesh, boost::face_index_t, FaceDescriptor>
    face_number(mesh, faces);
  for (Index f = 0; f < faces.size(); ++f)
    for (const auto& h : CGAL::halfedges_around_face(halfedge(faces[f], mesh), mesh)) {
      const FaceDescriptor across = face(opposite(h, mesh), mesh);
      if (across == boost::graph_traits<TriangleMesh>::null_face())
        continue;
      const Index g = face_number(across);
      if (g != null_index && f < g) // not to faces outside of a filtered mesh
        visit(f, g, edge(h, mesh));
    }
}

// The same of a soup, whose edges are pairs of positions of triangles.
template <class Visit>
void for_each_inner_edge(const Surface& soup, const Visit& visit)
{
  for (Index h = 0; h < soup.number_of_halfedges(); ++h)
    if (const Index f = h / 3, g = soup.neighbor(h); f < g)
      visit(f, g, std::pair<std::size_t, std::size_t>(f, g));
}

// Reads the constraints. `for_each_edge` is one of the functions above, `faces` are the faces as the
// caller knows them. Throws `std::invalid_argument` for an edge that is in both maps.
template <class ForEachEdge, class Face, class CGALNamedParameters>
Constraints read_constraints(const ForEachEdge& for_each_edge, const std::vector<Face>& faces,
                             const CGALNamedParameters& np)
{
  Constraints result;
  if constexpr (is_given<CGALNamedParameters, internal_np::edge_is_constrained_t> ||
                is_given<CGALNamedParameters, internal_np::edge_is_uncuttable_map_t>)
    for_each_edge([&](Index f, Index g, const auto& e) {
      const bool is_seam = edge_flag(np, CGAL::internal_np::edge_is_constrained, e);
      const bool is_uncuttable = edge_flag(np, internal_np::edge_is_uncuttable_map, e);
      if (is_seam && is_uncuttable)
        throw std::invalid_argument(
          "segment_spectral_recursive: the edge between the faces " + std::to_string(f) +
          " and " + std::to_string(g) +
          " is in both edge_is_constrained_map and edge_is_uncuttable_map");
      if (is_seam)
        result.seams.push_back({f, g});
      if (is_uncuttable)
        result.uncuttable.push_back({f, g});
    });
  if constexpr (is_given<CGALNamedParameters, internal_np::face_seed_map_t>) {
    using boost::get; // for pointers
    const auto map = CGAL::parameters::get_parameter(np, internal_np::face_seed_map);
    for (Index f = 0; f < faces.size(); ++f) {
      const std::int64_t seed = get(map, faces[f]);
      if (seed >= 0)
        result.seeds.emplace_back(f, seed);
    }
  }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_CONSTRAINTS_H
