// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_PLANES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_PLANES_H

#include <CGAL/Spectral_segmentation/internal/base/Symmetric_matrix.h>

namespace CGAL::Spectral_segmentation::internal {

// A sum of squared distances to planes, weighted by the squared lengths of their normals.
class Planes
{
  Symmetric_matrix matrix_;
  Vector right_;

public:
  // Adds the plane through a point.
  void add(const Vector& normal, const Vector& at)
  {
    matrix_ += Symmetric_matrix::square(normal);
    right_ += normal.dot(at) * normal;
  }

  // Returns the step from a point to the nearest point. The regularization, relative to the trace,
  // keeps it short along planes that are parallel. NaN without planes.
  Vector step_from(const Vector& point, double regularization) const
  {
    const double share = regularization * matrix_.trace() + 1e-300;
    const Symmetric_matrix matrix = matrix_ + Symmetric_matrix{share, share, share};
    return matrix.inverse() * (right_ - matrix_ * point);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_PLANES_H
