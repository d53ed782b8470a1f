// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns the triangles inside a polygon and outside its holes, the further polygons. Their corners
// are indices of the points of all polygons, counterclockwise. There are none if edges of the
// polygons meet.
inline std::vector<Corners>
planar_triangulation(const std::vector<std::vector<Exact_predicates::Point_2> >& polygons)
{
  typedef CGAL::Triangulation_vertex_base_with_info_2<Index, Exact_predicates> Vertex_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Exact_predicates> Constrained_face_base;
  typedef CGAL::Triangulation_face_base_with_info_2<int, Exact_predicates, Constrained_face_base>
    Face_base;
  typedef CGAL::Constrained_Delaunay_triangulation_2<
    Exact_predicates, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
    CGAL::No_constraint_intersection_tag> Triangulation;

  Triangulation triangulation;
  std::vector<std::vector<typename Triangulation::Vertex_handle> > corners;
  Index number_of_points = 0;
  for (const auto& polygon : polygons) {
    corners.emplace_back();
    for (const auto& p : polygon) {
      corners.back().push_back(triangulation.insert(p));
      corners.back().back()->info() = number_of_points++;
    }
  }
  if (triangulation.number_of_vertices() != number_of_points || triangulation.dimension() < 2)
    return {};
  try {
    for (const auto& c : corners)
      for (std::size_t i = 0; i < c.size(); ++i)
        triangulation.insert_constraint(c[i], c[(i + 1) % c.size()]);
  }
  catch (const typename Triangulation::Intersection_of_constraints_exception&) {
    return {};
  }

  // Finds how many edges of polygons separate each face from the infinite face.
  for (auto f : triangulation.all_face_handles())
    f->info() = -1;
  std::deque<std::pair<typename Triangulation::Face_handle, int> > front;
  front.emplace_back(triangulation.infinite_face(), 0);
  while (!front.empty()) {
    const auto [f, level] = front.front();
    front.pop_front();
    if (f->info() >= 0)
      continue;
    f->info() = level;
    for (int k = 0; k < 3; ++k)
      if (f->is_constrained(k))
        front.emplace_back(f->neighbor(k), level + 1);
      else
        front.emplace_front(f->neighbor(k), level);
  }
  std::vector<Corners> result;
  for (auto f : triangulation.finite_face_handles())
    if (f->info() % 2 == 1) {
      Corners t{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.push_back(t);
    }
  return result;
}

// Returns the triangulation of the projection of a loop and its holes to the plane through the
// middle of the loop; none if a point is farther from the plane than a tenth of the diagonal of
// their bounding box, or edges of the projection meet. CGAL's triangulate_hole_polyline() has this
// option too, for one loop, but it aborts on some loops.
inline std::vector<Corners> flat_triangulation(const std::vector<std::vector<Vector> >& loops)
{
  std::vector<Vector> points;
  for (const std::vector<Vector>& loop : loops)
    points.insert(points.end(), loop.begin(), loop.end());
  normalize(points);
  const Bounding_box box(points);
  const double distance = 0.1 * (box.largest - box.smallest).norm();
  const std::size_t n = loops[0].size();
  Vector middle, z;
  for (std::size_t i = 0; i < n; ++i)
    middle += points[i] / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i)
    z += (points[i] - middle).cross(points[(i + 1) % n] - middle);
  z = z.normalized();
  if (z.is_zero())
    return {};
  const Vector axis = std::abs(z.x()) < 0.5 ? Vector(1, 0, 0) : Vector(0, 1, 0);
  const Vector x = (axis - axis.dot(z) * z).normalized(), y = z.cross(x);
  std::vector<std::vector<Exact_predicates::Point_2> > polygons;
  auto next = points.begin();
  for (const std::vector<Vector>& loop : loops) {
    polygons.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector p = *next++ - middle;
      if (!(std::abs(p.dot(z)) <= distance))
        return {};
      polygons.back().emplace_back(p.dot(x), p.dot(y));
    }
  }
  std::vector<Corners> result = planar_triangulation(polygons);
  if (result.size() != points.size() + 2 * loops.size() - 4)
    result.clear();
  return result;
}

// Returns a triangulation of a loop of points, whose triangles hold indices of the loop, in its
// direction. It is Delaunay in the plane of the loop if the loop is nearly flat, otherwise a
// surface with little curvature and area. It is empty if CGAL finds none, or would take minutes.
inline std::vector<Corners> triangulated_loop(std::vector<Vector> loop)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (loop.size() == 3)
    return {{0, 1, 2}};
  std::vector<Corners> result = flat_triangulation({loop});
  if (!result.empty())
    return result;
  normalize(loop);
  const Bounding_box box(loop);
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  if (length > 50 * (box.largest - box.smallest).norm())
    return {}; // it fills space, where CGAL's search among tetrahedra is slow
  std::vector<Exact_predicates::Point_3> points;
  for (const Vector& p : loop)
    points.push_back(exact_point(p));
  std::vector<CGAL::Triple<int, int, int> > triangles;
  PMP::triangulate_hole_polyline(points, std::back_inserter(triangles),
                                 CGAL::parameters::use_2d_constrained_delaunay_triangulation(false)
                                   .do_not_use_cubic_algorithm(true));
  if (triangles.size() + 2 == loop.size())
    for (const auto& t : triangles) {
      result.push_back({Index(t.first), Index(t.second), Index(t.third)});
      std::sort(result.back().begin(), result.back().end());
    }
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGULATED_LOOP_H
