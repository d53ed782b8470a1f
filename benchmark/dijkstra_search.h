// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_DIJKSTRA_SEARCH_H
#define SEGMENTATION_BENCHMARK_DIJKSTRA_SEARCH_H

#include <CGAL/Spectral_segmentation/internal/bipartition/shortest_paths.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

// The shortest paths by BGL's Dijkstra, in O(n log n): what the library's search is compared with,
// by tests in its results and by benchmarks in its time.
namespace segmentation_benchmark {

// Tells `paths` of the faces in the order of their distances from the source.
template <class Paths>
class Dijkstra_path_visitor : public boost::dijkstra_visitor<>
{
  typedef CGAL::Spectral_segmentation::internal::Weighted_graph Weighted_graph;
  typedef CGAL::Spectral_segmentation::internal::Index Index;

  const Weighted_graph* graph_;
  Paths* paths_;

public:
  Dijkstra_path_visitor(const Weighted_graph& graph, Paths& paths)
    : graph_(&graph), paths_(&paths) {}

  void examine_vertex(Index f, const CGAL::Spectral_segmentation::internal::Face_graph&) const
  {
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      paths_->reach(f, graph_->arc(h));
  }
};

// The twin of the library's `grow_paths()`.
template <class Paths>
void grow_paths_by_dijkstra(const CGAL::Spectral_segmentation::internal::Weighted_graph& graph,
                            CGAL::Spectral_segmentation::internal::Index source, Paths& paths)
{
  typedef CGAL::Spectral_segmentation::internal::Index Index;
  paths.start(source);
  std::vector<double> distance(graph.faces().number_of_faces());
  const boost::typed_identity_property_map<Index> index;
  const auto weight = [&graph](Index h) -> double { return graph.arc(h).weight; };
  boost::dijkstra_shortest_paths(
    graph.faces(), source,
    boost::weight_map(boost::make_function_property_map<Index, double>(weight))
      .distance_map(boost::make_iterator_property_map(distance.begin(), index))
      .vertex_index_map(index)
      .visitor(Dijkstra_path_visitor<Paths>(graph, paths)));
}

// The twin of the library's `shortest_paths()`.
inline std::vector<double>
shortest_paths_by_dijkstra(const CGAL::Spectral_segmentation::internal::Weighted_graph& graph,
                           CGAL::Spectral_segmentation::internal::Index source)
{
  CGAL::Spectral_segmentation::internal::Path_lengths paths(graph.faces().number_of_faces());
  grow_paths_by_dijkstra(graph, source, paths);
  return std::move(paths.lengths);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_DIJKSTRA_SEARCH_H
