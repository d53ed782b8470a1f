// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MOMENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MOMENTS_H

#include <CGAL/Spectral_segmentation/internal/base/Symmetric_matrix.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spectral_segmentation::internal {

// The integrals of 1, p and p p^T over the points p of a set of faces. They add up.
struct Moments
{
  double area = 0;
  Vector first;
  Symmetric_matrix second;

  void add(double area_of_face, const std::array<Vector, 3>& corners)
  {
    Vector sum;
    Symmetric_matrix squares;
    for (const Vector& p : corners) {
      sum += p;
      squares += Symmetric_matrix::square(p);
    }
    area += area_of_face;
    first += area_of_face / 3 * sum;
    second += area_of_face / 12 * (squares + Symmetric_matrix::square(sum));
  }

  void add(const Surface& surface, Index f)
  {
    const Corners& c = surface.corners[f];
    add(surface.areas[f], {surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]});
  }

  Moments& operator+=(const Moments& other)
  {
    area += other.area;
    first += other.first;
    second += other.second;
    return *this;
  }

  Vector centroid() const { return first / area; }

  // Returns the standard deviations of the points along the principal axes, in ascending order.
  std::array<double, 3> deviations() const
  {
    const Eigen_solver variances(second / area - Symmetric_matrix::square(centroid()));
    std::array<double, 3> result;
    for (int i = 0; i < 3; ++i)
      result[static_cast<std::size_t>(i)] = std::sqrt((std::max)(variances.eigenvalue(i), 0.));
    return result;
  }
};

// The size and the extents of a set of faces, which do not change if it is moved or mirrored.
struct Shape
{
  double area = 0;
  std::array<double, 3> deviations = {0, 0, 0}; // along the principal axes

  // Returns whether two sizes are equal up to a tolerance that is measured.
  static bool are_near(double x, double y)
  { return std::abs(x - y) <= 0.15 * (std::max)(x, y); }
};

// Returns whether two shapes may be of copies or mirror images. Flat shapes have a thickness of
// rounding errors below the one given.
inline bool are_congruent(const Shape& a, const Shape& b, double thickness)
{
  bool result = Shape::are_near(a.area, b.area);
  for (std::size_t i = 0; i < 3; ++i)
    result = result && Shape::are_near(a.deviations[i] + thickness, b.deviations[i] + thickness);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MOMENTS_H
