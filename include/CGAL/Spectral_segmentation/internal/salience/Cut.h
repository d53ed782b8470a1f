// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The side of each face: 0 for Q, of smaller area, 1 for the rest.
typedef std::vector<char> Sides;

// A two-way cut of a part.
struct Cut
{
  Sides side;
  double area[2];
  Salience_factors factors;
  double salience;
  std::vector<Index> near; // faces near the cut, where all factors are known
};

// Side 0 becomes the one of smaller area.
inline void normalize_sides(Sides& side, double (&area)[2])
{
  if (area[0] <= area[1])
    return;
  for (char& s : side)
    s = 1 - s;
  std::swap(area[0], area[1]);
}

// Saliences are compared, so what is not a number counts as the least.
template <class PartSalience>
double salience_of(const PartSalience& part_salience, const Salience_factors& factors)
{
  const double salience = part_salience(factors);
  return std::isnan(salience) ? -std::numeric_limits<double>::infinity() : salience;
}

// A cut whose factors were computed: a candidate for the best cut of a part, or the boundary of two
// regions as the cut of their union.
struct Evaluated_cut
{
  enum Kind { CANDIDATE, BOUNDARY };

  Kind kind;
  const std::vector<Index>& faces; // of the part, by their numbers in the mesh
  const Sides& side;               // of each of these faces
  const Salience_factors& factors;
};

// The radius of the neighborhood of a cut, in which factors are measured and minimum cuts are
// searched, relative to the square root of the area of the smaller side. The fit of
// `Calibrated_part_salience` depends on it.
constexpr double neighborhood_radius = 0.35;

// The half-edges along a cut on its side 0.
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

// Returns the faces on both sides within `radius` of a cut, the nearest first. Paths go from centroid
// to centroid and do not cross the cut. This is Dijkstra's search, but from all edges of the cut at
// once and up to the radius, for which BGL's has no place.
inline std::vector<Index> faces_near_cut(const Surface& part, const Sides& side,
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
      (part.points[part.source(h)] + part.points[part.target(h)]) / 2;
    for (Index f : {h / 3, part.neighbor(h)})
      relax(f, (part.centroid(f) - middle).norm());
  }
  std::vector<Index> result;
  while (!queue.empty()) {
    const auto [d, f] = queue.top();
    queue.pop();
    if (d > distance[f])
      continue;
    result.push_back(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = part.neighbor(h);
      if (d < distance[g] && side[g] == side[f])
        relax(g, d + part.weights[h].centroids);
    }
  }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_H
