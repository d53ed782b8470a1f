// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_CURVATURE_ANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_CURVATURE_ANGLES_H

#include <CGAL/Spectral_segmentation/internal/distances/Heat_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Curvature of the surface at the scale of the shape instead of the scale of the triangulation.

// The tensor product of a vector with itself, as a vector: symmetric tensors have the same inner
// product as such vectors.
typedef std::array<double, 6> Symmetric_tensor;

inline Symmetric_tensor squared(const Vector& v)
{
  const double root = std::sqrt(2.);
  return {v.x() * v.x(), v.y() * v.y(), v.z() * v.z(),
          root * (v.x() * v.y()), root * (v.y() * v.z()), root * (v.z() * v.x())};
}

// Returns for each halfedge the angle by which the surface bends over a path of twice the radius
// across the edge, which is negative where the surface is concave. It is found from the curvature
// tensor of Cohen-Steiner and Morvan (2003), averaged over the radius by diffusion. `radius` is
// relative to the square root of the area of the mesh.
inline std::vector<double> curvature_angles(Execution execution, const Surface& mesh,
                                       const std::vector<Vector>& points,
                                       const std::vector<Vector>& normals, double radius)
{
  const auto edge_vector = [&](Index h) -> Vector
  { return points[mesh.target_vertex(h)] - points[mesh.source_vertex(h)]; };

  std::vector<double> angles(mesh.opposite.size(), 0);
  if (!(total_area(mesh) > 0))
    return angles;
  std::array<Eigen::VectorXd, 6> tensors; // one number per face
  for (Eigen::VectorXd& t : tensors)
    t.setZero(static_cast<Eigen::Index>(mesh.number_of_faces()));
  for_each_index(execution, mesh.number_of_faces(), [&](std::size_t i) {
    const Index f = static_cast<Index>(i);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = mesh.neighbor(h);
      const Vector edge = edge_vector(h);
      const double length = edge.norm();
      const double area = mesh.areas[f] + mesh.areas[g];
      if (mesh.is_border(h) || length == 0 || area == 0)
        continue;
      const double angle =
        std::atan2(normals[f].cross(normals[g]).dot(edge) / length, normals[f].dot(normals[g]));
      // The density is split by area; else a sliver beside a sharp edge would have nearly all of
      // it.
      const double density = angle * mesh.areas[f] / area / length;
      const Symmetric_tensor tensor = squared(edge);
      for (std::size_t k = 0; k < 6; ++k)
        tensors[k][f] += density * tensor[k];
    }
  });
  const Heat_smoothing smoothing(execution, mesh, points, radius);
  for_each_index(execution, 6, [&](std::size_t k) { tensors[k] = smoothing(tensors[k]); });

  const double way = 2 * smoothing.radius();
  for_each_index(execution, angles.size(), [&](std::size_t i) {
    const Index h = static_cast<Index>(i), f = h / 3, g = mesh.neighbor(h);
    const Vector edge = edge_vector(h);
    const double area = mesh.areas[f] + mesh.areas[g];
    const double squared_length = edge.squared_norm();
    if (mesh.is_border(h) || squared_length == 0 || area == 0)
      return;
    const Symmetric_tensor across = squared(edge);
    double sums[2] = {0, 0}; // each of every other term
    for (std::size_t k : {4, 5, 2, 3, 0, 1})
      sums[k % 2] +=
        (mesh.areas[f] * tensors[k][f] + mesh.areas[g] * tensors[k][g]) / area * across[k];
    const double curvature = (sums[0] + sums[1]) / squared_length;
    const double angle = way * curvature;
    if (std::abs(angle) > 1e-6) // a smaller angle is rounding, and the surface is flat
      angles[h] = (std::min)((std::max)(angle, -CGAL_PI), CGAL_PI);
  });
  return angles;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_CURVATURE_ANGLES_H
