// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_TRIANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_TRIANGLES_H

#include <CGAL/Spectral_segmentation/internal/mesh/Vector.h>
#include <CGAL/Spectral_segmentation/internal/utility/Index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The vertices of a face, and the faces across its edges. The face itself stands where there is no
// neighbor. The i-th edge of a face leaves its i-th corner.
typedef std::array<Index, 3> Corners;
typedef std::array<Index, 3> Neighbors;

// The triangles of a mesh, as arrays: the input of the engine.
struct Triangles
{
  std::vector<Corners> corners;     // one per face
  std::vector<Neighbors> neighbors; // one per face; being neighbors is symmetric
  std::vector<Vector> points;       // one per vertex, finite
};

// Rotates a face to start at its smallest vertex, so that all models of a mesh give equal arrays.
inline void start_at_smallest_vertex(Corners& corners, Neighbors& neighbors)
{
  const auto first = std::min_element(corners.begin(), corners.end()) - corners.begin();
  std::rotate(corners.begin(), corners.begin() + first, corners.end());
  std::rotate(neighbors.begin(), neighbors.begin() + first, neighbors.end());
}

// Moves the points into [-1, 1]^3 and returns the length of 1 in the old unit. It is a power of
// two, so that scaling rounds nothing.
inline double normalize(std::vector<Vector>& points)
{
  const Bounding_box box(points);
  const Vector center = box.smallest / 2 + box.largest / 2;
  const double half_extent = (box.largest / 2 - box.smallest / 2).largest_coordinate();
  const double unit =
    half_extent > 0 ? std::ldexp(1., (std::min)(std::ilogb(half_extent) + 1, 1023)) : 1;
  for (Vector& p : points)
    p = (p - center) / unit;
  return unit;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_TRIANGLES_H
