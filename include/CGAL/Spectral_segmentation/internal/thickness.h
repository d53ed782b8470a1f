// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_THICKNESS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_THICKNESS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/shape_scale_angles.h>

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
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// How thick the body is under a face: one ray a face, straight inwards, in place of the cone of the
// shape diameter function (Shapira, Shamir, Cohen-Or 2008); diffusion then joins the rays of
// neighboring faces to one.

// The radius of the disk over which rays are joined, relative to the square root of the area.
constexpr double thickness_radius = 0.02;

// The distance from the centroid of each face, against its normal, to the face on the other side of
// the body; 0 where there is none. The vertices are at `points`, the normals of the faces are those
// there.
template <class ConcurrencyTag>
std::vector<double> opposite_distances(const Face_dual_graph& mesh,
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
    const std::array<Index, 3>& c = mesh.corners[f];
    const Kernel::Triangle_3 t(point(points[c[0]]), point(points[c[1]]), point(points[c[2]]));
    if (!t.is_degenerate()) {
      triangles.push_back(t);
      face.push_back(f);
    }
  }
  Tree tree(triangles.cbegin(), triangles.cend());
  tree.build();

  std::vector<double> distances(mesh.number_of_faces(), 0);
  for_each_index<ConcurrencyTag>(distances.size(), [&](std::size_t f) {
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
// and smoothed over a disk of `radius` times this length. Far from any ray that found an opposite
// face it is the mean over those that did, and 0 if none did.
template <class ConcurrencyTag>
std::vector<float> thickness(const Face_dual_graph& mesh, const std::vector<Vector>& points,
                             const std::vector<Vector>& normals, double radius)
{
  const std::vector<double> distances = opposite_distances<ConcurrencyTag>(mesh, points, normals);
  const double unit = std::sqrt(total_area(mesh));
  std::vector<Eigen::Array2d> sums(distances.size(), Eigen::Array2d::Zero()); // value, weight
  for (Index f = 0; f < sums.size(); ++f)
    if (distances[f] > 0)
      sums[f] = mesh.areas[f] * Eigen::Array2d(std::log(distances[f] / unit), 1);
  diffuse(mesh, (std::max)(number_of_diffusion_steps(mesh, radius), std::size_t(3)), sums);
  const Eigen::Array2d all = std::accumulate(sums.begin(), sums.end(), Eigen::Array2d(0, 0));
  std::vector<float> result(sums.size(), all[1] > 0 ? static_cast<float>(all[0] / all[1]) : 0);
  for (Index f = 0; f < sums.size(); ++f)
    if (sums[f][1] > 0)
      result[f] = static_cast<float>(sums[f][0] / sums[f][1]);
  return result;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_THICKNESS_H
