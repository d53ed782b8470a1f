// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_VECTOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_VECTOR_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A point or a vector. With Eigen's vectors, whose sums and products are each a separate template,
// a program that includes the engine took a fifth longer to compile, and ran no faster.
class Vector
{
  double c_[3] = {0, 0, 0};

public:
  Vector() = default;
  Vector(double x, double y, double z) : c_{x, y, z} {}

  double x() const { return c_[0]; }
  double y() const { return c_[1]; }
  double z() const { return c_[2]; }
  double operator[](int i) const { return c_[i]; }
  double& operator[](int i) { return c_[i]; }

  friend Vector operator+(const Vector& v, const Vector& w)
  { return {v.x() + w.x(), v.y() + w.y(), v.z() + w.z()}; }
  friend Vector operator-(const Vector& v, const Vector& w)
  { return {v.x() - w.x(), v.y() - w.y(), v.z() - w.z()}; }
  friend Vector operator*(double s, const Vector& v) { return {s * v.x(), s * v.y(), s * v.z()}; }
  friend Vector operator*(const Vector& v, double s) { return s * v; }
  friend Vector operator/(const Vector& v, double s) { return {v.x() / s, v.y() / s, v.z() / s}; }
  Vector operator-() const { return {-x(), -y(), -z()}; }
  Vector& operator+=(const Vector& v) { return *this = *this + v; }
  Vector& operator-=(const Vector& v) { return *this = *this - v; }

  // Compares lexicographically.
  friend bool operator<(const Vector& v, const Vector& w)
  { return std::lexicographical_compare(v.c_, v.c_ + 3, w.c_, w.c_ + 3); }
  friend bool operator==(const Vector& v, const Vector& w)
  { return v.x() == w.x() && v.y() == w.y() && v.z() == w.z(); }
  bool is_zero() const { return *this == Vector(); }
  bool is_finite() const { return std::isfinite(x()) && std::isfinite(y()) && std::isfinite(z()); }

  double dot(const Vector& v) const { return x() * v.x() + y() * v.y() + z() * v.z(); }
  double squared_norm() const { return dot(*this); }
  double norm() const { return std::sqrt(squared_norm()); }
  double largest_coordinate() const { return (std::max)((std::max)(x(), y()), z()); }

  Vector cross(const Vector& v) const
  {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }

  // Returns the unit vector, or the vector itself if its square is 0, even by underflow.
  Vector normalized() const
  {
    const double squared = squared_norm();
    return squared > 0 ? *this / std::sqrt(squared) : *this;
  }

  // Returns the unit vector even if the vector's own square would underflow or overflow.
  Vector stably_normalized() const
  {
    const double scale = (std::max)((std::max)(std::abs(x()), std::abs(y())), std::abs(z()));
    const double squared = (*this / scale).squared_norm();
    return squared > 0 ? *this / (std::sqrt(squared) * scale) : *this;
  }
};

// Returns a point whose coordinates are rounded to quanta, symmetrically in sign. Midpoints between
// quanta, which are frequent, stay clear of where the last bit of a coordinate decides.
inline Vector quantized(const Vector& p)
{
  const auto of_coordinate = [](double x)
  { return std::copysign(std::floor(std::abs(x) / quantum + 0.25) * quantum, x); };
  return Vector(of_coordinate(p.x()), of_coordinate(p.y()), of_coordinate(p.z()));
}

// Returns a point whose coordinates are rounded to multiples of `step`.
inline Vector rounded(const Vector& p, double step)
{
  return Vector(std::round(p.x() / step), std::round(p.y() / step), std::round(p.z() / step)) *
         step;
}

// The corners of smallest and of largest coordinates of the box around some points.
struct Bounding_box
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Vector smallest{infinity, infinity, infinity};
  Vector largest{-infinity, -infinity, -infinity};

  explicit Bounding_box(const std::vector<Vector>& points)
  {
    for (const Vector& p : points)
      add(p);
  }

  void add(const Vector& p)
  {
    for (int i = 0; i < 3; ++i) {
      smallest[i] = (std::min)(smallest[i], p[i]);
      largest[i] = (std::max)(largest[i], p[i]);
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_VECTOR_H
