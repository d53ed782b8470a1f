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
// quanta, which are frequent, are rounded regardless of the last bit of a coordinate.
inline Vector quantized(const Vector& p)
{
  const auto round_coordinate = [](double x)
  { return std::copysign(std::floor(std::abs(x) / quantum + 0.25) * quantum, x); };
  return Vector(round_coordinate(p.x()), round_coordinate(p.y()), round_coordinate(p.z()));
}

// Returns a point whose coordinates are rounded to multiples of `step`.
inline Vector rounded(const Vector& p, double step)
{
  return Vector(std::round(p.x() / step), std::round(p.y() / step), std::round(p.z() / step)) *
         step;
}

// The corners with the smallest and the largest coordinates of the bounding box of some points.
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

// A symmetric 3x3 matrix, or six moments of points.
struct Symmetric_matrix
{
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  // Returns v times its transpose.
  static Symmetric_matrix square(const Vector& v)
  {
    return {v.x() * v.x(), v.y() * v.y(), v.z() * v.z(),
            v.x() * v.y(), v.y() * v.z(), v.z() * v.x()};
  }

  friend Symmetric_matrix operator*(double s, const Symmetric_matrix& m)
  { return {s * m.xx, s * m.yy, s * m.zz, s * m.xy, s * m.yz, s * m.zx}; }
  friend Symmetric_matrix operator/(const Symmetric_matrix& m, double s)
  { return {m.xx / s, m.yy / s, m.zz / s, m.xy / s, m.yz / s, m.zx / s}; }
  friend Symmetric_matrix operator+(const Symmetric_matrix& m, const Symmetric_matrix& n)
  {
    return {m.xx + n.xx, m.yy + n.yy, m.zz + n.zz, m.xy + n.xy, m.yz + n.yz, m.zx + n.zx};
  }
  friend Symmetric_matrix operator-(const Symmetric_matrix& m, const Symmetric_matrix& n)
  {
    return {m.xx - n.xx, m.yy - n.yy, m.zz - n.zz, m.xy - n.xy, m.yz - n.yz, m.zx - n.zx};
  }
  Symmetric_matrix& operator+=(const Symmetric_matrix& m) { return *this = *this + m; }
  Symmetric_matrix& operator-=(const Symmetric_matrix& m) { return *this = *this - m; }

  double trace() const { return xx + (yy + zz); }
  Vector row(int i) const
  { return i == 0 ? Vector(xx, xy, zx) : i == 1 ? Vector(xy, yy, yz) : Vector(zx, yz, zz); }
  Vector operator*(const Vector& v) const { return {row(0).dot(v), row(1).dot(v), row(2).dot(v)}; }

  // Returns the inverse times the determinant.
  Symmetric_matrix adjugate() const
  {
    return {yy * zz - yz * yz, zz * xx - zx * zx, xx * yy - xy * xy,
            yz * zx - xy * zz, zx * xy - yz * xx, xy * yz - zx * yy};
  }

  Symmetric_matrix inverse() const
  {
    const Symmetric_matrix a = adjugate();
    return 1 / a.row(0).dot(row(0)) * a;
  }

  Symmetric_matrix without(double eigenvalue) const
  { return *this - Symmetric_matrix{eigenvalue, eigenvalue, eigenvalue}; }

  double largest_coefficient() const
  {
    return (std::max)({std::abs(xx), std::abs(yy), std::abs(zz),
                       std::abs(xy), std::abs(yz), std::abs(zx)});
  }
};

// Computes eigenvalues and eigenvectors in closed form, with the steps and roundings of Eigen's
// computeDirect(). With Eigen's function a program that includes the engine took 5 % longer to
// compile.
class Eigen_decomposition
{
  double shift_, scale_;
  Symmetric_matrix matrix_; // has trace 0 and coefficients up to 1
  double roots_[3];         // its eigenvalues in ascending order

  // Returns the unit vector that a matrix of rank 2 maps to 0; `other` becomes orthogonal to it.
  static Vector kernel(const Symmetric_matrix& m, Vector& other)
  {
    const double diagonal[3] = {std::abs(m.xx), std::abs(m.yy), std::abs(m.zz)};
    const int i = static_cast<int>(std::max_element(diagonal, diagonal + 3) - diagonal);
    other = m.row(i);
    const Vector v = other.cross(m.row((i + 1) % 3)), w = other.cross(m.row((i + 2) % 3));
    const Vector& longer = v.squared_norm() > w.squared_norm() ? v : w;
    return longer / longer.norm();
  }

public:
  explicit Eigen_decomposition(const Symmetric_matrix& given)
    : shift_(given.trace() / 3), scale_(given.without(shift_).largest_coefficient()),
      matrix_(given.without(shift_))
  {
    if (scale_ > 0)
      matrix_ = matrix_ / scale_;
    // Computes the roots of x^3 - c2 x^2 + c1 x - c0.
    const auto& [xx, yy, zz, xy, yz, zx] = matrix_;
    const double third = 1. / 3;
    const double c0 = xx * yy * zz + 2 * xy * zx * yz - xx * yz * yz - yy * zx * zx - zz * xy * xy;
    const double c1 = xx * yy - xy * xy + xx * zz - zx * zx + yy * zz - yz * yz;
    const double c2 = xx + yy + zz, mean = c2 * third;
    const double a = (std::max)((c2 * mean - c1) * third, 0.);
    const double b = 0.5 * (c0 + mean * (2 * mean * mean - c1));
    const double radius = std::sqrt(a);
    const double angle = std::atan2(std::sqrt((std::max)(a * a * a - b * b, 0.)), b) * third;
    const double x = std::cos(angle), y = std::sqrt(3.) * std::sin(angle);
    roots_[0] = mean - radius * (x + y);
    roots_[1] = mean - radius * (x - y);
    roots_[2] = mean + 2 * radius * x;
  }

  double eigenvalue(int i) const { return roots_[i] * scale_ + shift_; } // the i-th smallest
  double largest_eigenvalue() const { return eigenvalue(2); }

  // Sets the unit eigenvectors of the smallest and of the middle eigenvalue.
  void set_eigenvectors(Vector& smallest, Vector& middle) const
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    smallest = {1, 0, 0};
    middle = {0, 1, 0};
    if (roots_[2] - roots_[0] <= epsilon)
      return;
    // The eigenvector whose eigenvalue is farther from the middle one is computed first.
    const double from_largest = roots_[2] - roots_[1], from_smallest = roots_[1] - roots_[0];
    const int k = from_largest > from_smallest ? 2 : 0, l = 2 - k;
    Vector vectors[3], unused;
    vectors[k] = kernel(matrix_.without(roots_[k]), vectors[l]);
    if ((std::min)(from_largest, from_smallest) <=
        2 * epsilon * (std::max)(from_largest, from_smallest))
      vectors[l] = (vectors[l] - vectors[k].dot(vectors[l]) * vectors[l]).normalized();
    else
      vectors[l] = kernel(matrix_.without(roots_[l]), unused);
    smallest = vectors[0];
    middle = vectors[2].cross(vectors[0]).normalized();
  }
};

// Returns the product of the two largest eigenvalues of a covariance matrix. It is the largest
// eigenvalue of the adjugate. Found as one root, it is accurate even if the second one vanishes.
inline double product_of_largest_eigenvalues(const Symmetric_matrix& covariance)
{ return (std::max)(Eigen_decomposition(covariance.adjugate()).largest_eigenvalue(), 0.); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_VECTOR_H
