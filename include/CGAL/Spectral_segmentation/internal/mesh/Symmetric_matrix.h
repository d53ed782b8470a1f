// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_SYMMETRIC_MATRIX_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_SYMMETRIC_MATRIX_H

#include <CGAL/Spectral_segmentation/internal/mesh/Vector.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace CGAL::Spectral_segmentation::internal {

// A symmetric matrix of three rows, or six moments of points.
struct Symmetric_matrix
{
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  // v times its transpose.
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

  Vector row(int i) const
  { return i == 0 ? Vector(xx, xy, zx) : i == 1 ? Vector(xy, yy, yz) : Vector(zx, yz, zz); }
  Vector operator*(const Vector& v) const { return {row(0).dot(v), row(1).dot(v), row(2).dot(v)}; }

  // The inverse times the determinant.
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

  // Eigenvalues ascend.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(int options) const
  {
    Eigen::Matrix3d m;
    m << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(m, options);
    return solver;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_SYMMETRIC_MATRIX_H
