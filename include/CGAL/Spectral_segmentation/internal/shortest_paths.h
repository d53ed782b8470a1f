// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHORTEST_PATHS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHORTEST_PATHS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The three weightings of Section 3: geodesic, angle and combined.
typedef float Face_dual_graph::Halfedge::* Weighting;

// Distances of all faces of a connected part from `source`, by BGL's Dijkstra in O(n log n): the
// reference for `Bucket_search`.
struct Dijkstra_search
{
  std::vector<double> operator()(const Face_dual_graph& graph, Index source,
                                 Weighting weighting) const
  {
    std::vector<double> distance(graph.number_of_faces());
    const boost::typed_identity_property_map<Index> index;
    const auto weight = [&graph, weighting](Index h) -> double
    { return graph.halfedges[h].*weighting; };
    boost::dijkstra_shortest_paths(
      graph, source,
      boost::weight_map(boost::make_function_property_map<Index, double>(weight))
        .distance_map(boost::make_iterator_property_map(distance.begin(), index))
        .vertex_index_map(index));
    return distance;
  }
};

// The same, as sums on a grid are exact, with buckets of the width of a mean weight in place of the
// heap, which costs more than all else: the faces of the nearest bucket are visited in any order,
// and again when their distance shrinks, until none does. A circle of buckets is enough, since no
// weight reaches around it.
struct Bucket_search
{
  std::vector<double> operator()(const Face_dual_graph& graph, Index source,
                                 Weighting weighting) const
  {
    typedef std::vector<std::pair<Index, double> > Bucket; // faces with their distance
    double sum = 0, largest = 0;
    for (const Face_dual_graph::Halfedge& h : graph.halfedges) {
      sum += h.*weighting;
      largest = (std::max)(largest, double(h.*weighting));
    }
    const double buckets_per_distance =
      sum > 0 ? static_cast<double>(graph.halfedges.size()) / sum : 0;
    std::vector<Bucket> circle(static_cast<std::size_t>(largest * buckets_per_distance) + 3);
    const auto bucket_at = [&](double d) -> Bucket&
    { return circle[static_cast<Index>(d * buckets_per_distance) % circle.size()]; };

    std::vector<double> distance(graph.number_of_faces(), std::numeric_limits<double>::infinity());
    distance[source] = 0;
    circle[0].push_back({source, 0});
    Bucket visited;
    std::size_t number_of_waiting = 1;
    for (std::size_t current = 0; number_of_waiting > 0; ++current)
      for (Bucket& nearest = circle[current % circle.size()]; !nearest.empty();) {
        visited.clear();
        visited.swap(nearest);
        number_of_waiting -= visited.size();
        for (const auto& [f, d] : visited) {
          if (distance[f] < d)
            continue;
          for (Index h = 3 * f; h < 3 * f + 3; ++h) {
            const Index g = graph.halfedges[h].neighbor;
            const double d_g = d + graph.halfedges[h].*weighting;
            if (d_g < distance[g]) {
              distance[g] = d_g;
              bucket_at(d_g).push_back({g, d_g});
              ++number_of_waiting;
            }
          }
        }
      }
    return distance;
  }
};

template <class Search = Bucket_search>
std::vector<double> shortest_paths(const Face_dual_graph& graph, Index source, Weighting weighting)
{ return Search()(graph, source, weighting); }

// The half-edge of each face over which its shortest path to `source` begins; `null_index` for the
// source. Of several the one to the nearest neighbor, then to the first, so that it does not depend
// on the search which path is taken.
inline std::vector<Index> first_steps(const Face_dual_graph& graph, Index source,
                                      Weighting weighting, const std::vector<double>& distance)
{
  std::vector<Index> step(graph.number_of_faces(), null_index);
  std::vector<Index> reached;
  reached.reserve(step.size());
  for (Index f = 0; f < step.size(); ++f) {
    std::pair<double, Index> best(distance[f], 0); // distance and number of the neighbor
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = graph.halfedges[h].neighbor;
      if (distance[g] + graph.halfedges[h].*weighting == distance[f] &&
          std::make_pair(distance[g], g) < best) {
        best = {distance[g], g};
        step[f] = h;
      }
    }
    if (step[f] != null_index || f == source)
      reached.push_back(f);
  }
  // The others are at distance 0 from a face that is reached.
  for (std::size_t i = 0; reached.size() < step.size(); ++i)
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
      const Index g = graph.halfedges[h].neighbor;
      if (step[g] == null_index && g != source && graph.halfedges[h].*weighting == 0) {
        step[g] = graph.opposite(h);
        reached.push_back(g);
      }
    }
  return step;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHORTEST_PATHS_H
