// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_OTHER_SEARCHES_H
#define SEGMENTATION_BENCHMARK_OTHER_SEARCHES_H

#include "paper_graph.h"
#include "princeton_benchmark.h"

#include <CGAL/boost/graph/Dual.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

// Searches of the faces of a mesh to compare with those of the library.
namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::null_index;

// Touches the graph and no more: the numbers of steps from the source.
inline std::vector<Index> breadth_first_search(const Face_graph& graph, Index source)
{
  std::vector<Index> steps(graph.number_of_faces(), null_index);
  std::vector<Index> reached = {source};
  reached.reserve(steps.size());
  steps[source] = 0;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
      const Index g = graph.neighbors[h];
      if (steps[g] == null_index) {
        steps[g] = steps[reached[i]] + 1;
        reached.push_back(g);
      }
    }
  return steps;
}

// The distances of `graph` by the edges of its mesh, which is closed.
inline std::vector<double> weights_of_edges(const Mesh& mesh, const Face_graph& graph)
{
  std::vector<double> weights;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Index f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    Index h = 3 * f;
    while (graph.neighbors[h] != g)
      ++h;
    weights.push_back(graph.weights[h].combined);
  }
  return weights;
}

// Computes distances in the way of a user of CGAL and BGL; the mesh is closed.
inline std::vector<double> dijkstra_on_dual(const Mesh& mesh, const std::vector<double>& weights,
                                            Mesh::Face_index source)
{
  std::vector<double> distance(mesh.number_of_faces());
  const auto index = get(CGAL::face_index, mesh);
  boost::dijkstra_shortest_paths(
    CGAL::Dual<Mesh>(mesh), source,
    boost::weight_map(boost::make_function_property_map<Mesh::Edge_index, double>(
                        [&weights](Mesh::Edge_index e) { return weights[e]; }))
      .distance_map(boost::make_iterator_property_map(distance.begin(), index))
      .vertex_index_map(index));
  return distance;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_OTHER_SEARCHES_H
