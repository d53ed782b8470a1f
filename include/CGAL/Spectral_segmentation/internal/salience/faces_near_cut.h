// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_FACES_NEAR_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_FACES_NEAR_CUT_H

#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

struct Face_at_distance
{
  Index face;
  double distance; // from the cut, from centroid to centroid
};

// The half-edges along a cut on its side 0.
inline std::vector<Index> halfedges_of_cut(const Face_graph& part, const Sides& side)
{
  std::vector<Index> result;
  for (Index f = 0; f < part.number_of_faces(); ++f)
    if (side[f] == 0)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (side[part.neighbors[h]] != 0)
          result.push_back(h);
  return result;
}

// The faces on both sides within `radius` of a cut, nearest first. Paths do not cross the cut.
// Dijkstra's search, but from all edges of the cut at once and up to the radius, for which BGL's
// has no place.
inline std::vector<Face_at_distance> faces_near_cut(const Face_graph& part, const Sides& side,
                                                    const std::vector<Index>& cut, double radius)
{
  typedef std::pair<double, Index> Entry;
  std::vector<double> distance(part.number_of_faces(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  const auto relax = [&](Index f, double d) {
    if (d < distance[f] && d <= radius) {
      distance[f] = d;
      queue.push({d, f});
    }
  };
  for (Index h : cut) {
    const Vector middle =
      (part.points[part.source_vertex(h)] + part.points[part.target_vertex(h)]) / 2;
    for (Index f : {h / 3, part.neighbors[h]})
      relax(f, (part.centroid(f) - middle).norm());
  }
  std::vector<Face_at_distance> result;
  while (!queue.empty()) {
    const auto [d, f] = queue.top();
    queue.pop();
    if (d > distance[f])
      continue;
    result.push_back({f, d});
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = part.neighbors[h];
      if (d < distance[g] && side[g] == side[f])
        relax(g, d + part.weights[h].centroids);
    }
  }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_FACES_NEAR_CUT_H
