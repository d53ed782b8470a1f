// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_TRIANGLE_GEOMETRY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_TRIANGLE_GEOMETRY_H

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Spectral_segmentation::internal {

typedef std::array<Vector, 3> Triangle;

inline double squared_distance_to_segment(const Vector& point, const Vector& source,
                                          const Vector& target)
{
  const Vector v = target - source, p = point - source;
  const double squared = v.squared_norm();
  const double share = squared > 0 ? std::clamp(p.dot(v) / squared, 0., 1.) : 0;
  return (p - share * v).squared_norm();
}

// Accepts degenerate triangles.
inline double squared_distance_to_triangle(const Vector& point, const Triangle& t)
{
  const Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
  bool is_beside = normal.is_zero();
  double result = 0;
  for (int i = 0; i < 3 && !is_beside; ++i)
    is_beside = normal.dot((t[(i + 1) % 3] - t[i]).cross(point - t[i])) < 0;
  if (!is_beside) {
    const double height = normal.dot(point - t[0]);
    return height * height / normal.squared_norm();
  }
  result = squared_distance_to_segment(point, t[0], t[1]);
  result = (std::min)(result, squared_distance_to_segment(point, t[1], t[2]));
  return (std::min)(result, squared_distance_to_segment(point, t[2], t[0]));
}

// Calls f(piece, fraction of the area) for pieces of a triangle. Bisection of longest edges makes
// the pieces, none of which has an edge longer than a bound.
template <class Function>
void for_each_piece(const Triangle& triangle, double bound, const Function& f, double share = 1)
{
  int longest = 0;
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    const double of_edge = (triangle[(i + 1) % 3] - triangle[i]).squared_norm();
    if (of_edge > squared) {
      squared = of_edge;
      longest = i;
    }
  }
  if (!(squared > bound * bound)) {
    f(triangle, share);
    return;
  }
  const Vector &p = triangle[longest], &q = triangle[(longest + 1) % 3];
  const Vector &r = triangle[(longest + 2) % 3], middle = (p + q) / 2;
  for_each_piece({p, middle, r}, bound, f, share / 2);
  for_each_piece({middle, q, r}, bound, f, share / 2);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_TRIANGLE_GEOMETRY_H
