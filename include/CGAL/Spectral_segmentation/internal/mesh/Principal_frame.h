// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_PRINCIPAL_FRAME_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_PRINCIPAL_FRAME_H

#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/mesh/surface_integrals.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace CGAL::Spectral_segmentation::internal {

// A frame of coordinates that moves with the mesh: its center and its principal axes, the first two
// to the sides on which the points are spread farther, the third so that they are right-handed.
class Principal_frame
{
  Vector center_ = Vector::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity(); // the rows

public:
  Principal_frame(Execution execution, const Face_graph& mesh)
  {
    const double area = total_area(mesh);
    if (!(area > 0))
      return;
    center_ = center_of(execution, mesh, area);
    const Eigen::Matrix3d covariance =
      mean_over_surface<Eigen::Matrix3d>(execution, mesh, area, [&](const Vector& p)
        { return ((p - center_) * (p - center_).transpose()).eval(); });
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(covariance);
    axes_ = solver.eigenvectors().transpose();
    const Vector skewness =
      mean_over_surface<Vector>(execution, mesh, area, [&](const Vector& p)
        { return point(p).array().cube().matrix().eval(); });
    for (int i = 0; i < 2; ++i)
      if (skewness[i] < 0)
        axes_.row(i) *= -1;
    axes_.row(2) = axes_.row(0).cross(axes_.row(1));
  }

  Vector point(const Vector& p) const { return vector(p - center_); }
  Vector vector(const Vector& v) const { return axes_ * v; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_PRINCIPAL_FRAME_H
