// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHAPE_SCALE_ANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHAPE_SCALE_ANGLES_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Bending of the surface at the scale of the shape in place of that of the triangulation.

// Steps of the diffusion over the dual graph whose kernel has a given radius in units of the mean
// distance between faces; bounded, as are the time and the gain.
inline std::size_t number_of_diffusion_steps(const Face_dual_graph& mesh, double relative_radius)
{
  const double steps =
    0.75 * relative_radius * relative_radius * static_cast<double>(mesh.number_of_faces());
  return static_cast<std::size_t>(std::lround((std::min)((std::max)(steps, 1.), 60.)));
}

// Each face gives a fifth of its value over each of its three edges, in each step.
template <class Value>
void diffuse(const Face_dual_graph& mesh, std::size_t number_of_steps, std::vector<Value>& values)
{
  std::vector<Value> next(values.size());
  for (; number_of_steps > 0; --number_of_steps) {
    for (Index f = 0; f < values.size(); ++f)
      next[f] = 0.4 * values[f] + 0.2 * (values[mesh.halfedges[3 * f].neighbor] +
                                         values[mesh.halfedges[3 * f + 1].neighbor] +
                                         values[mesh.halfedges[3 * f + 2].neighbor]);
    values.swap(next);
  }
}

// For each half-edge the angle by which the surface bends over a way of twice the radius across the
// edge, negative where it is concave: the curvature tensor of Cohen-Steiner and Morvan (2003),
// averaged over a disk of about this radius by diffusion. `radius` is relative to the square root
// of the area of the mesh.
inline std::vector<double> shape_scale_angles(const Face_dual_graph& mesh,
                                              const std::vector<Vector>& points,
                                              const std::vector<Vector>& normals, double radius)
{
  const auto edge_vector = [&](Index h) -> Vector
  { return points[mesh.target_vertex(h)] - points[mesh.source_vertex(h)]; };

  std::vector<double> areas = mesh.areas;
  std::vector<Eigen::Matrix3d> tensors(mesh.number_of_faces(), Eigen::Matrix3d::Zero());
  for (Index f = 0; f < tensors.size(); ++f)
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Vector edge = edge_vector(h);
      const double length = edge.norm();
      if (mesh.is_border(h) || length == 0)
        continue;
      const Vector& other = normals[mesh.halfedges[h].neighbor];
      const double angle =
        std::atan2(normals[f].cross(other).dot(edge) / length, normals[f].dot(other));
      tensors[f] += angle / (2 * length) * edge * edge.transpose();
    }
  diffuse(mesh, number_of_diffusion_steps(mesh, radius), areas);
  diffuse(mesh, number_of_diffusion_steps(mesh, radius), tensors);

  const double way = 2 * radius * std::sqrt(total_area(mesh));
  std::vector<double> angles(mesh.halfedges.size(), 0);
  for (Index h = 0; h < angles.size(); ++h) {
    const Index f = h / 3, g = mesh.halfedges[h].neighbor;
    const Vector edge = edge_vector(h);
    const double squared_length = edge.squaredNorm();
    if (mesh.is_border(h) || squared_length == 0 || areas[f] + areas[g] == 0)
      continue;
    const double curvature =
      edge.dot((tensors[f] + tensors[g]) * edge) / (squared_length * (areas[f] + areas[g]));
    const double angle = way * curvature;
    if (std::abs(angle) > 1e-6) // below, which is rounding, the surface is flat
      angles[h] = (std::min)((std::max)(angle, -CGAL_PI), CGAL_PI);
  }
  return angles;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SHAPE_SCALE_ANGLES_H
