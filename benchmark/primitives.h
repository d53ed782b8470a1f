// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PRIMITIVES_H
#define SEGMENTATION_BENCHMARK_PRIMITIVES_H

#include "princeton_benchmark.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// The solids of which mechanical parts are composed, along the z axis, triangulated as CAD programs
// do it: as few triangles as there can be, however long they are. Faces are oriented outwards.
namespace segmentation_benchmark {

// Distances from the z axis with heights.
typedef std::vector<std::pair<double, double> > Profile;

// The vertices of a horizontal cut through a solid; a single one is an end on the axis.
typedef std::vector<Mesh::Vertex_index> Ring;

inline Ring add_ring(Mesh& mesh, const std::vector<Eigen::Vector2d>& polygon, double z)
{
  Ring ring;
  for (const Eigen::Vector2d& p : polygon)
    ring.push_back(mesh.add_vertex(Mesh::Point(p.x(), p.y(), z)));
  return ring;
}

inline void add_side(Mesh& mesh, const Ring& lower, const Ring& upper)
{
  const std::size_t n = (std::max)(lower.size(), upper.size());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (lower.size() > 1)
      mesh.add_face(lower[i], lower[next], upper[next % upper.size()]);
    if (upper.size() > 1)
      mesh.add_face(lower[i % lower.size()], upper[next], upper[i]);
  }
}

// All triangles from one vertex.
inline void add_caps(Mesh& mesh, const Ring& bottom, const Ring& top)
{
  for (std::size_t i = 2; i < bottom.size(); ++i)
    mesh.add_face(bottom[0], bottom[i], bottom[i - 1]);
  for (std::size_t i = 2; i < top.size(); ++i)
    mesh.add_face(top[0], top[i - 1], top[i]);
}

inline std::vector<Eigen::Vector2d> regular_polygon(double radius, std::size_t n)
{
  if (radius == 0)
    return {Eigen::Vector2d::Zero()};
  std::vector<Eigen::Vector2d> polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

// From the bottom to the top, with n sides.
inline Mesh revolved(const Profile& profile, std::size_t n)
{
  Mesh mesh;
  std::vector<Ring> rings;
  for (const auto& [radius, z] : profile)
    rings.push_back(add_ring(mesh, regular_polygon(radius, n), z));
  for (std::size_t i = 1; i < rings.size(); ++i)
    add_side(mesh, rings[i - 1], rings[i]);
  add_caps(mesh, rings.front(), rings.back());
  return mesh;
}

// With its center at the origin.
inline Mesh box(double width, double depth, double height)
{
  const double x = width / 2, y = depth / 2;
  const std::vector<Eigen::Vector2d> polygon = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  Mesh mesh;
  const Ring bottom = add_ring(mesh, polygon, -height / 2);
  const Ring top = add_ring(mesh, polygon, height / 2);
  add_side(mesh, bottom, top);
  add_caps(mesh, bottom, top);
  return mesh;
}

// From height z0 to z1. A prism has few sides, a cone the radius 0 at an end.
inline Mesh frustum(double radius_at_z0, double radius_at_z1, double z0, double z1, std::size_t n)
{ return revolved({{radius_at_z0, z0}, {radius_at_z1, z1}}, n); }

// Around the origin, with n sides and half as many rings.
inline Mesh uv_sphere(double radius, std::size_t n)
{
  const std::size_t half = n / 2;
  Profile profile = {{0, -radius}};
  for (std::size_t i = 1; i < half; ++i) {
    const double angle = CGAL_PI * static_cast<double>(i) / static_cast<double>(half);
    profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  profile.emplace_back(0, radius);
  return revolved(profile, n);
}

// Around the origin, with n times m squares cut in two.
inline Mesh torus(double radius, double tube_radius, std::size_t n, std::size_t m)
{
  Mesh mesh;
  std::vector<Ring> rings;
  for (const Eigen::Vector2d& p : regular_polygon(tube_radius, m))
    rings.push_back(add_ring(mesh, regular_polygon(radius + p.x(), n), p.y()));
  for (std::size_t i = 0; i < m; ++i)
    add_side(mesh, rings[i], rings[(i + 1) % m]);
  return mesh;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PRIMITIVES_H
