// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHORTEST_PATHS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHORTEST_PATHS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The three weightings of Section 3: geodesic, angle and combined.
typedef float Face_dual_graph::Halfedge::* Weighting;

// Distances of all faces of a connected part from `source`, by BGL's Dijkstra in O(n log n).
// `on_relaxed(h)` is called when the way over half-edge h is the shortest so far to its neighbor;
// by then the way to its own face is final.
template <class OnRelaxed>
std::vector<double> shortest_paths(const Face_dual_graph& graph, Index source, Weighting weighting,
                                   const OnRelaxed& on_relaxed)
{
  struct Visitor : boost::default_dijkstra_visitor
  {
    const OnRelaxed* on_relaxed;
    void edge_relaxed(Index h, const Face_dual_graph&) const { (*on_relaxed)(h); }
  };
  Visitor visitor;
  visitor.on_relaxed = &on_relaxed;

  std::vector<double> distance(graph.number_of_faces());
  const boost::typed_identity_property_map<Index> index;
  const auto weight = [&graph, weighting](Index h) -> double
  { return graph.halfedges[h].*weighting; };
  boost::dijkstra_shortest_paths(
    graph, source,
    boost::weight_map(boost::make_function_property_map<Index, double>(weight))
      .distance_map(boost::make_iterator_property_map(distance.begin(), index))
      .vertex_index_map(index)
      .visitor(visitor));
  return distance;
}

inline std::vector<double> shortest_paths(const Face_dual_graph& graph, Index source,
                                          Weighting weighting)
{ return shortest_paths(graph, source, weighting, [](Index) {}); }

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHORTEST_PATHS_H
