// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

inline double length(const std::vector<Vector>& loop)
{
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return result;
}

// Returns a vector that is normal to a loop: the sum of the normals of its triangles at a point.
inline Vector normal(const std::vector<Vector>& loop, const Vector& around)
{
  Vector result;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result += (loop[i] - around).cross(loop[(i + 1) % loop.size()] - around);
  return result;
}

// Returns the triangles between the corners of a polygon, which are given by places in ascending
// order; none if edges of the polygon meet.
inline std::vector<Corners>
planar_triangulation(const std::vector<Exact_predicates::Point_2>& polygon)
{
  typedef CGAL::Triangulation_vertex_base_with_info_2<Index, Exact_predicates> Vertex_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Exact_predicates> Constrained_face_base;
  typedef CGAL::Triangulation_face_base_with_info_2<bool, Exact_predicates, Constrained_face_base>
    Face_base;
  typedef CGAL::Constrained_Delaunay_triangulation_2<
    Exact_predicates, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
    CGAL::No_constraint_intersection_tag> Triangulation;

  Triangulation triangulation;
  std::vector<typename Triangulation::Vertex_handle> corners;
  for (const auto& p : polygon) {
    corners.push_back(triangulation.insert(p));
    corners.back()->info() = static_cast<Index>(corners.size() - 1);
  }
  if (triangulation.number_of_vertices() != polygon.size() || triangulation.dimension() < 2)
    return {};
  try {
    for (std::size_t i = 0; i < corners.size(); ++i)
      triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }
  catch (const typename Triangulation::Intersection_of_constraints_exception&) {
    return {};
  }

  // Finds the faces outside: those that are connected to the infinite face.
  for (auto f : triangulation.all_face_handles())
    f->info() = false;
  std::vector<typename Triangulation::Face_handle> outside(1, triangulation.infinite_face());
  outside[0]->info() = true;
  for (std::size_t i = 0; i < outside.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto f = outside[i]->neighbor(k);
      if (!f->info() && !outside[i]->is_constrained(k)) {
        f->info() = true;
        outside.push_back(f);
      }
    }
  std::vector<Corners> result;
  for (auto f : triangulation.finite_face_handles())
    if (!f->info()) {
      result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
      std::sort(result.back().begin(), result.back().end());
    }
  return result;
}

// Returns the triangulation of the projection of a loop to the plane through its middle; none if
// the loop is farther than a distance from the plane, or edges of the projection meet. CGAL's
// triangulate_hole_polyline() has this option too, but it ends the program for some loops.
inline std::vector<Corners> flat_triangulation(const std::vector<Vector>& loop, double distance)
{
  Vector middle;
  for (const Vector& p : loop)
    middle += p / static_cast<double>(loop.size());
  const Vector z = normal(loop, middle).normalized();
  if (z.is_zero())
    return {};
  const Vector axis = std::abs(z.x()) < 0.5 ? Vector(1, 0, 0) : Vector(0, 1, 0);
  const Vector x = (axis - axis.dot(z) * z).normalized(), y = z.cross(x);
  std::vector<Exact_predicates::Point_2> polygon;
  for (const Vector& p : loop) {
    if (!(std::abs((p - middle).dot(z)) <= distance))
      return {};
    polygon.emplace_back((p - middle).dot(x), (p - middle).dot(y));
  }
  return planar_triangulation(polygon);
}

// Returns a triangulation of a loop of points, whose triangles are given by places in the loop, in
// its direction. It is Delaunay in the plane of the loop if the loop is nearly flat, else a surface
// that bends little and has a small area. It is empty if CGAL finds none, or would take minutes.
inline std::vector<Corners> triangulated_loop(std::vector<Vector> loop)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (loop.size() == 3)
    return {{0, 1, 2}};
  normalize(loop);
  const Bounding_box box(loop);
  const double diagonal = (box.largest - box.smallest).norm();
  std::vector<Corners> result = flat_triangulation(loop, 0.1 * diagonal);
  if (result.size() + 2 == loop.size())
    return result;
  if (length(loop) > 50 * diagonal)
    return {}; // it fills space, where CGAL's search among tetrahedra is slow
  std::vector<Exact_predicates::Point_3> points;
  for (const Vector& p : loop)
    points.push_back(exact_point(p));
  std::vector<CGAL::Triple<int, int, int> > triangles;
  PMP::triangulate_hole_polyline(points, std::back_inserter(triangles),
                                 CGAL::parameters::use_2d_constrained_delaunay_triangulation(false)
                                   .do_not_use_cubic_algorithm(true));
  result.clear();
  if (triangles.size() + 2 == loop.size())
    for (const auto& t : triangles) {
      result.push_back({Index(t.first), Index(t.second), Index(t.third)});
      std::sort(result.back().begin(), result.back().end());
    }
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
