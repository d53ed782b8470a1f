// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_SHORTEST_PATHS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_SHORTEST_PATHS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/base/arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The three weightings of Section 3: geodesic, angle and combined.
typedef float Edge_weights::* Weighting;

// A step from a face to a neighbor, and the angle distance between the two.
struct Arc
{
  Index neighbor;
  float weight;
  float angle;
};

// A connected part with one weighting: what a search reads, and no more, side by side in memory.
class Weighted_graph
{
  const Surface& graph_;
  std::vector<Arc> arcs_; // of each half-edge
  double sum_ = 0, largest_ = 0;

public:
  Weighted_graph(const Surface& graph, Weighting weighting) : graph_(graph)
  {
    CGAL_precondition(graph.weights.size() == graph.number_of_halfedges());
    arcs_.reserve(graph.number_of_halfedges());
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      const float weight = graph.weights[h].*weighting;
      arcs_.push_back({graph.neighbor(h), weight, graph.weights[h].angle});
      sum_ += weight;
      largest_ = (std::max)(largest_, double(weight));
    }
  }

  const Surface& faces() const { return graph_; }
  const Arc& arc(Index h) const { return arcs_[h]; }
  double mean_weight() const { return sum_ / static_cast<double>(arcs_.size()); }
  double largest_weight() const { return largest_; }
  void prefetch_arcs(Index f) const { prefetch(&arcs_[3 * f]); }
};

// What a search finds is kept in `paths`: `start(source)`, and `reach(f, arc)`, which tells whether
// the way by f over the arc is better than what was known for the neighbor; `length(f)`;
// `prefetch_path(f)`.

// The lengths of the shortest paths, from the nearest if several sources were started from.
struct Path_lengths
{
  std::vector<double> lengths;

  explicit Path_lengths(std::size_t number_of_faces)
    : lengths(number_of_faces, std::numeric_limits<double>::infinity()) {}

  void start(Index source) { lengths[source] = 0; }
  double length(Index f) const { return lengths[f]; }
  void prefetch_path(Index f) const { prefetch(&lengths[f]); }

  bool reach(Index f, const Arc& arc)
  {
    const double length = lengths[f] + arc.weight;
    if (length >= lengths[arc.neighbor])
      return false;
    lengths[arc.neighbor] = length;
    return true;
  }
};

// The same with the sums of the angle distances along the paths. Of several shortest paths the one
// over the nearest neighbor is taken, then over the first, so that it does not depend on the search
// which one it is, unless steps have no length.
class Path_angles
{
  struct Path
  {
    double length = std::numeric_limits<double>::infinity();
    float angles = 0;
    Index previous = null_index; // face
  };

  std::vector<Path> paths_;

  bool is_nearer(Index f, Index g) const
  {
    return paths_[f].length < paths_[g].length ||
           (paths_[f].length == paths_[g].length && f < g);
  }

public:
  explicit Path_angles(std::size_t number_of_faces) : paths_(number_of_faces) {}

  void start(Index source) { paths_[source].length = 0; }
  double length(Index f) const { return paths_[f].length; }
  float angles(Index f) const { return paths_[f].angles; }
  void prefetch_path(Index f) const { prefetch(&paths_[f]); }

  bool reach(Index f, const Arc& arc)
  {
    const double length = paths_[f].length + arc.weight;
    Path& path = paths_[arc.neighbor];
    if (length > path.length)
      return false;
    if (length == path.length &&
        (arc.weight == 0 || path.previous == null_index || !is_nearer(f, path.previous)))
      return false;
    path = {length, paths_[f].angles + arc.angle, f};
    return true;
  }
};

// Adds the paths from a source to all faces: Dijkstra's search with buckets of the width of a mean
// weight in place of the heap, a quarter to a seventh of the time of BGL's on the same graph
// (benchmark/performance, shortest_path_tree; the tests compare the two). The faces of the nearest
// bucket are visited in any order, and again when they are reached on a shorter path. Sums are
// exact, so the result is that of the heap. A circle of buckets is enough, since no weight reaches
// around it. Where paths are known already, only faces that get a shorter one are visited.
template <class Paths>
void grow_paths(const Weighted_graph& graph, Index source, Paths& paths)
{
  typedef std::vector<Index> Bucket;
  const double buckets_per_length = graph.mean_weight() > 0 ? 1 / graph.mean_weight() : 0;
  // By way of a signed number, which processors have an instruction for.
  const auto bucket_of = [&](Index f) {
    return static_cast<std::size_t>(
      static_cast<std::ptrdiff_t>(paths.length(f) * buckets_per_length));
  };
  const auto buckets_of_weight =
    static_cast<std::size_t>(graph.largest_weight() * buckets_per_length);
  std::size_t size = 4; // a power of 2, for the place in the circle
  while (size < buckets_of_weight + 3)
    size *= 2;
  std::vector<Bucket> circle(size);

  paths.start(source);
  circle[0].push_back(source);
  Bucket visited;
  std::size_t number_of_waiting = 1;
  for (std::size_t current = 0; number_of_waiting > 0; ++current)
    for (Bucket& nearest = circle[current & (size - 1)]; !nearest.empty();) {
      visited.clear();
      visited.swap(nearest);
      number_of_waiting -= visited.size();
      for (std::size_t i = 0; i < visited.size(); ++i) {
        if (i + 4 < visited.size())
          for (Index h = 3 * visited[i + 4]; h < 3 * visited[i + 4] + 3; ++h)
            paths.prefetch_path(graph.arc(h).neighbor);
        const Index f = visited[i];
        if (bucket_of(f) < current) // it was reached on a better way since
          continue;
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (paths.reach(f, graph.arc(h))) {
            const Index g = graph.arc(h).neighbor;
            graph.prefetch_arcs(g);
            circle[bucket_of(g) & (size - 1)].push_back(g);
            ++number_of_waiting;
          }
      }
    }
}

// The distances of all faces from `source`.
inline std::vector<double> shortest_paths(const Weighted_graph& graph, Index source)
{
  Path_lengths paths(graph.faces().number_of_faces());
  grow_paths(graph, source, paths);
  return std::move(paths.lengths);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_SHORTEST_PATHS_H
