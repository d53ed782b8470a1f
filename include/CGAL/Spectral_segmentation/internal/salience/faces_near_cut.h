// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_FACES_NEAR_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_FACES_NEAR_CUT_H

#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/distances/shortest_paths.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

struct Face_at_distance
{
  Index face;
  double distance; // from the cut, from centroid to centroid
};

// Returns the halfedges along a cut on its side 0.
inline std::vector<Index> halfedges_of_cut(const Surface& part, const Sides& side)
{
  std::vector<Index> result;
  for (Index f = 0; f < part.number_of_faces(); ++f)
    if (side[f] == 0)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (side[part.neighbor(h)] != 0)
          result.push_back(h);
  return result;
}

// Collects the faces that Dijkstra examines, and ends the search beyond a radius.
class Near_face_visitor : public boost::dijkstra_visitor<>
{
  const std::vector<double>* distance_;
  double radius_;
  std::vector<Face_at_distance>* faces_;

public:
  struct Radius_reached {};

  Near_face_visitor(const std::vector<double>& distance, double radius,
                    std::vector<Face_at_distance>& faces)
    : distance_(&distance), radius_(radius), faces_(&faces) {}

  void examine_vertex(Index f, const Surface&) const
  {
    if ((*distance_)[f] > radius_)
      throw Radius_reached();
    faces_->push_back({f, (*distance_)[f]});
  }
};

// Returns the faces on both sides within `radius` of a cut, nearest first, then by their indices.
// Paths do not cross the cut. They start at the middles of its edges.
inline std::vector<Face_at_distance> faces_near_cut(const Surface& part, const Sides& side,
                                                    const std::vector<Index>& cut, double radius)
{
  std::vector<double> distance(part.number_of_faces(), infinite_distance);
  std::vector<Index> sources;
  for (Index h : cut) {
    const Vector middle =
      (part.points[part.source_vertex(h)] + part.points[part.target_vertex(h)]) / 2;
    for (Index f : {h / 3, part.neighbor(h)}) {
      if (distance[f] == infinite_distance)
        sources.push_back(f);
      distance[f] = (std::min)(distance[f], (part.centroid(f) - middle).norm());
    }
  }
  const auto step = [&](Index h) -> double {
    return side[h / 3] == side[part.neighbor(h)] ? part.weights[h].centroids : infinite_distance;
  };
  std::vector<Face_at_distance> result;
  try {
    run_dijkstra(part, sources, step, distance, Near_face_visitor(distance, radius, result));
  }
  catch (const Near_face_visitor::Radius_reached&) {}
  std::sort(result.begin(), result.end(), [](const Face_at_distance& a, const Face_at_distance& b)
    { return a.distance < b.distance || (a.distance == b.distance && a.face < b.face); });
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_FACES_NEAR_CUT_H
