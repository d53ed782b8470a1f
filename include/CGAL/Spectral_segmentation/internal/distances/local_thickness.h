// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_THICKNESS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_THICKNESS_H

#include <CGAL/Spectral_segmentation/internal/distances/Heat_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/utility/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/mesh/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/utility/constants.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// How thick the body is under a face: one ray a face, straight inwards, in place of the cone of the
// shape diameter function (Shapira, Shamir, Cohen-Or 2008); diffusion then joins the rays of
// neighboring faces to one.

// The distance from the centroid of each face, against its normal, to the face on the other side of
// the body; 0 where there is none. The vertices are at `points`, the normals of the faces are those
// there.
inline std::vector<double> ray_thickness(Execution execution, const Face_graph& mesh,
                                       const std::vector<Vector>& points,
                                       const std::vector<Vector>& normals)
{
  typedef Simple_cartesian<double> Kernel;
  typedef std::vector<Kernel::Triangle_3>::const_iterator Triangle;
#if CGAL_VERSION_NR >= 1060000000
  typedef AABB_tree<AABB_traits_3<Kernel, AABB_triangle_primitive_3<Kernel, Triangle> > > Tree;
#else
  typedef AABB_tree<AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Triangle> > > Tree;
#endif
  const auto point = [](const Vector& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };

  std::vector<Kernel::Triangle_3> triangles; // CGAL does not intersect degenerate ones
  std::vector<Index> face;
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    const Corners& c = mesh.corners[f];
    const Kernel::Triangle_3 t(point(points[c[0]]), point(points[c[1]]), point(points[c[2]]));
    if (!t.is_degenerate()) {
      triangles.push_back(t);
      face.push_back(f);
    }
  }
  Tree tree(triangles.cbegin(), triangles.cend());
  tree.build();

  std::vector<double> distances(mesh.number_of_faces(), 0);
  for_each_index(execution, distances.size(), [&](std::size_t f) {
    if (normals[f].isZero(0))
      return;
    const Vector center = mesh.centroid(static_cast<Index>(f), points);
    const Kernel::Ray_3 ray(point(center),
                            Kernel::Vector_3(-normals[f].x(), -normals[f].y(), -normals[f].z()));
    const auto face_of = [&](Triangle t) { return face[t - triangles.cbegin()]; };
    const auto hit =
      tree.first_intersected_primitive(ray, [&](Triangle t) { return face_of(t) == f; });
    if (!hit)
      return;
    // A ray that leaves through a face that looks back at it was not inside of the body.
    const Index g = face_of(*hit);
    const double slope = -normals[f].dot(normals[g]);
    if (slope > 0)
      distances[f] =
        (std::max)((points[mesh.corners[g][0]] - center).dot(normals[g]) / slope, 0.);
  });
  return distances;
}

// The logarithm of the thickness at each face, relative to the square root of the area of the mesh
// and averaged over `radius` times this length. Where hardly any ray nearby found an opposite face
// it is the mean over those that did, and 0 if none did.
inline std::vector<float> local_thickness(Execution execution, const Face_graph& mesh, const std::vector<Vector>& points,
                             const std::vector<Vector>& normals, double radius)
{
  const std::vector<double> distances = ray_thickness(execution, mesh, points, normals);
  const Eigen::Index n = static_cast<Eigen::Index>(distances.size());
  const double unit = std::sqrt(total_area(mesh));
  std::vector<Eigen::VectorXd> amounts(2, Eigen::VectorXd::Zero(n));
  Eigen::VectorXd &weight = amounts[0], &excess = amounts[1];
  for (Eigen::Index f = 0; f < n; ++f)
    if (distances[f] > 0) {
      weight[f] = mesh.areas[f];
      excess[f] = mesh.areas[f] * std::log(distances[f] / unit);
    }
  if (!(weight.sum() > 0))
    return std::vector<float>(distances.size(), 0);

  const double mean = excess.sum() / weight.sum();
  excess -= mean * weight;
  const Heat_smoothing smoothing(execution, mesh, points, radius);
  for_each_index(execution, 2, [&](std::size_t i) { amounts[i] = smoothing(amounts[i]); });
  std::vector<float> result;
  for (Eigen::Index f = 0; f < n; ++f)
    result.push_back(static_cast<float>(weight[f] > 0.01 ? mean + excess[f] / weight[f] : mean));
  return result;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DISTANCES_LOCAL_THICKNESS_H
