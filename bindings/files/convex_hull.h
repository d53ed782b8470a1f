// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_CONVEX_HULL_H
#define SEGMENT_MESH_MESH_FILE_CONVEX_HULL_H

#include "Polygon_soup.h"
#include "Polygon_triangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mesh_file {

struct Convex_hull
{
  std::vector<Point> points;
  std::vector<Triangle> triangles; // oriented outward
  double thickness = 0;            // given to a flat hull; 0 for the others
};

// Returns the length of the diagonal of the bounding box of points.
inline double extent_of(const std::vector<Point>& points)
{
  Point size{};
  for (std::size_t k = 0; !points.empty() && k < 3; ++k) {
    const auto is_less = [k](const Point& p, const Point& q) { return p[k] < q[k]; };
    const auto ends = std::minmax_element(points.begin(), points.end(), is_less);
    size[k] = (*ends.second)[k] - (*ends.first)[k];
  }
  return std::hypot(size[0], size[1], size[2]);
}

// Returns the convex hull of finite points. If they lie in a plane, on a line or at one place,
// except for a 10^5th of the extent of the whole mesh, their hull gets a thickness of a 1000th of
// this extent there. The result has no points within edges and facets, and does not depend on the
// order of the points. It is empty if there are no points, or the extent is 0 or infinite.
inline Convex_hull convex_hull(std::vector<Point> points, double extent_of_mesh)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Vector_3 Vector;
  Convex_hull result;
  if (points.empty() || !(extent_of_mesh > 0) || !std::isfinite(extent_of_mesh))
    return result;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Kernel::Point_3> corners;
  std::vector<Vector> rest, axes{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
  for (const Point& p : points) {
    corners.emplace_back(p[0], p[1], p[2]);
    rest.push_back((corners.back() - corners.front()) / extent_of_mesh);
  }
  for (int dimension = 0; dimension < 3; ++dimension) {
    const auto is_shorter = [](const Vector& v, const Vector& w)
    { return v.squared_length() < w.squared_length(); };
    Vector direction = *std::max_element(rest.begin(), rest.end(), is_shorter);
    const bool is_flat = direction.squared_length() < 1e-10;
    if (is_flat)
      direction = *std::max_element(axes.begin(), axes.end(), is_shorter);
    direction = direction / std::sqrt(direction.squared_length());
    for (std::vector<Vector>* vectors : {&rest, &axes}) // what is at a right angle to `direction`
      for (Vector& v : *vectors)
        v = v - (v * direction) * direction;
    if (is_flat) {
      result.thickness = extent_of_mesh / 1000;
      const std::size_t n = corners.size();
      for (std::size_t i = 0; i < n; ++i) {
        corners.push_back(corners[i] + result.thickness / 2 * direction);
        corners[i] = corners[i] - result.thickness / 2 * direction;
      }
    }
  }
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(corners.begin(), corners.end(), hull);

  // Cuts planar facets into triangles again, between their extreme points, because those of CGAL
  // depend on addresses in memory.
  std::vector<char> is_edge(num_halfedges(hull));
  std::vector<std::size_t> number_of_edges(num_vertices(hull));
  const auto point = [&](auto h) -> const Kernel::Point_3& { return hull.point(target(h, hull)); };
  for (auto h : halfedges(hull)) {
    const auto o = opposite(h, hull);
    is_edge[h] = !CGAL::coplanar(point(h), point(o), point(next(h, hull)), point(next(o, hull)));
    number_of_edges[target(h, hull)] += is_edge[h];
  }
  const auto coordinates = [&](auto v) -> Point
  { return {hull.point(v).x(), hull.point(v).y(), hull.point(v).z()}; };
  for (auto v : vertices(hull))
    if (number_of_edges[v] > 2)
      result.points.push_back(coordinates(v));
  std::sort(result.points.begin(), result.points.end());
  std::vector<char> is_done(is_edge.size());
  for (auto h : halfedges(hull)) {
    std::vector<Index> facet; // its corners
    while (is_edge[h] && !is_done[h]) {
      is_done[h] = 1;
      if (number_of_edges[target(h, hull)] > 2)
        facet.push_back(static_cast<Index>(
          std::lower_bound(result.points.begin(), result.points.end(),
                           coordinates(target(h, hull))) - result.points.begin()));
      h = next(h, hull);
      while (!is_edge[h])
        h = next(opposite(h, hull), hull);
    }
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    for (std::size_t i = 2; i < facet.size(); ++i)
      result.triangles.push_back({facet[0], facet[i - 1], facet[i]});
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_CONVEX_HULL_H
