// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>

#include <boost/graph/connected_components.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The component of each face, numbered in the order of their first faces.
inline std::vector<Index> connected_components(const Face_dual_graph& graph, std::size_t& number)
{
  std::vector<Index> component(graph.number_of_faces());
  const boost::typed_identity_property_map<Index> index;
  number = graph.number_of_faces() == 0 ? 0 :
    boost::connected_components(graph, boost::make_iterator_property_map(component.begin(), index),
                                boost::vertex_index_map(index));
  return component;
}

inline std::vector<double> component_areas(const Face_dual_graph& graph,
                                           const std::vector<Index>& component, std::size_t number)
{
  std::vector<double> areas(number, 0);
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    areas[component[f]] += graph.areas[f];
  return areas;
}

// Compact copies of the pieces of a graph. `piece` has the number of the piece of each face. Faces
// keep their order; edges between two pieces become border.
template <class Number>
std::vector<Face_dual_graph> split(const Face_dual_graph& graph, const std::vector<Number>& piece,
                                   std::size_t number_of_pieces)
{
  std::vector<Face_dual_graph> result(number_of_pieces);
  std::vector<Index> number_of_face(graph.number_of_faces());
  std::vector<std::vector<Index> > faces(number_of_pieces);
  for (Index f = 0; f < graph.number_of_faces(); ++f) {
    number_of_face[f] = static_cast<Index>(faces[piece[f]].size());
    faces[piece[f]].push_back(f);
  }

  // A vertex lies in several pieces: its number is valid in the piece that was last to meet it.
  std::vector<Index> number_of_vertex(graph.points.size());
  std::vector<std::size_t> last_piece(graph.points.size(), number_of_pieces);
  for (std::size_t p = 0; p < number_of_pieces; ++p) {
    Face_dual_graph& part = result[p];
    part.unit = graph.unit;
    part.corners.reserve(faces[p].size());
    part.areas.reserve(faces[p].size());
    part.halfedges.reserve(3 * faces[p].size());
    for (Index f : faces[p]) {
      for (Index v : graph.corners[f])
        if (last_piece[v] != p) {
          last_piece[v] = p;
          number_of_vertex[v] = static_cast<Index>(part.points.size());
          part.points.push_back(graph.points[v]);
        }
      const std::array<Index, 3>& c = graph.corners[f];
      part.corners.push_back({number_of_vertex[c[0]], number_of_vertex[c[1]],
                              number_of_vertex[c[2]]});
      part.areas.push_back(graph.areas[f]);
      if (!graph.thickness.empty())
        part.thickness.push_back(graph.thickness[f]);
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        Face_dual_graph::Halfedge halfedge = graph.halfedges[h];
        const Index g = halfedge.neighbor;
        halfedge.neighbor = number_of_face[piece[g] == piece[f] ? g : f];
        part.halfedges.push_back(halfedge);
      }
    }
  }
  return result;
}

inline std::vector<Neighbors> neighbors(const Face_dual_graph& graph)
{
  std::vector<Neighbors> result(graph.number_of_faces());
  for (Index h = 0; h < graph.halfedges.size(); ++h)
    result[h / 3][h % 3] = graph.halfedges[h].neighbor;
  return result;
}

inline double total_area(const Face_dual_graph& graph)
{ return std::accumulate(graph.areas.begin(), graph.areas.end(), 0.); }

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H
