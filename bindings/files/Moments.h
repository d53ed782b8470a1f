// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_MOMENTS_H
#define SEGMENT_MESH_MESH_FILE_MOMENTS_H

#include "Polygon_soup.h"
#include "Polygon_triangulation.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <vector>

namespace mesh_file {

// The integrals of 1, x and x x^T over the inside of a closed mesh, relative to its first corner.
class Moments
{
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double volume_ = 0;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second_ = Eigen::Matrix3d::Zero();

public:
  // Sums over the tetrahedra between the first corner and the triangles.
  Moments(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
  {
    const auto vector = [&](Index v)
    { return Eigen::Vector3d(points[v][0], points[v][1], points[v][2]); };
    if (!triangles.empty())
      origin_ = vector(triangles[0][0]);
    for (const Triangle& t : triangles) {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k)
        corners.col(k) = vector(t[static_cast<std::size_t>(k)]) - origin_;
      const double det = corners.determinant();
      const Eigen::Vector3d sum = corners.rowwise().sum();
      volume_ += det / 6;
      first_ += det / 24 * sum;
      second_ += det / 120 * (corners * corners.transpose() + sum * sum.transpose());
    }
  }

  double volume() const { return volume_; }
  Eigen::Vector3d center() const { return origin_ + first_ / volume_; }

  // Returns the inertia tensor around the center, for the density 1.
  Eigen::Matrix3d inertia() const
  {
    const Eigen::Matrix3d s = second_ - first_ * first_.transpose() / volume_;
    return s.trace() * Eigen::Matrix3d::Identity() - s;
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_MOMENTS_H
