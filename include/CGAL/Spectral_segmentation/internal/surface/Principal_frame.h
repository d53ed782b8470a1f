// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_PRINCIPAL_FRAME_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_PRINCIPAL_FRAME_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/base/Symmetric_matrix.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>

namespace CGAL::Spectral_segmentation::internal {

// A coordinate frame that moves with the mesh: its center and its principal axes. The first two
// axes point to the sides on which the points are spread farther; the third makes the frame
// right-handed.
class Principal_frame
{
  Vector center_;
  Vector axes_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

public:
  Principal_frame(Execution execution, const Surface& mesh)
  {
    const double area = total_area(mesh);
    if (!(area > 0))
      return;
    center_ = center_of(execution, mesh, area);
    const Symmetric_matrix covariance =
      mean_over_surface<Symmetric_matrix>(execution, mesh, area, [&](const Vector& p)
        { return Symmetric_matrix::square(p - center_); });
    Eigen_solver(covariance).set_eigenvectors(axes_[0], axes_[1]);
    const Vector skewness =
      mean_over_surface<Vector>(execution, mesh, area, [&](const Vector& p) {
        const Vector q = point(p);
        return Vector(q.x() * q.x() * q.x(), q.y() * q.y() * q.y(), q.z() * q.z() * q.z());
      });
    for (int i = 0; i < 2; ++i)
      if (skewness[i] < 0)
        axes_[i] = -axes_[i];
    axes_[2] = axes_[0].cross(axes_[1]);
  }

  Vector point(const Vector& p) const { return vector(p - center_); }
  Vector vector(const Vector& v) const
  { return {axes_[0].dot(v), axes_[1].dot(v), axes_[2].dot(v)}; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_PRINCIPAL_FRAME_H
