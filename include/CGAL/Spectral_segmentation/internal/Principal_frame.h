// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PRINCIPAL_FRAME_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PRINCIPAL_FRAME_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// A frame of coordinates that moves with the mesh: its center and its principal axes, the first two
// to the sides on which the points are spread farther, the third so that they are right-handed.
class Principal_frame
{
  Vector center_ = Vector::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity(); // the rows

public:
  explicit Principal_frame(const Face_dual_graph& mesh)
  {
    const double area = total_area(mesh);
    if (!(area > 0))
      return;
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      center_ += mesh.areas[f] / area * mesh.centroid(f);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      const Vector p = mesh.centroid(f) - center_;
      covariance += mesh.areas[f] / area * p * p.transpose();
    }
    axes_ = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().transpose();
    Vector skewness = Vector::Zero();
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      const Vector p = vector(mesh.centroid(f) - center_);
      skewness += mesh.areas[f] / area * p.cwiseProduct(p).cwiseProduct(p);
    }
    for (int i = 0; i < 2; ++i)
      if (skewness[i] < 0)
        axes_.row(i) *= -1;
    axes_.row(2) = axes_.row(0).cross(axes_.row(1));
  }

  Vector point(const Vector& p) const { return vector(p - center_); }
  Vector vector(const Vector& v) const { return axes_ * v; }
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PRINCIPAL_FRAME_H
