// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_LIMITED_HULL_H
#define SEGMENT_MESH_MESH_FILE_LIMITED_HULL_H

#include "Moments.h"
#include "convex_hull.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace mesh_file {

// The points x with normal * x <= bound. The normal has the length 1, or is a projection of one.
template <int Dimension>
struct Half_space
{
  Eigen::Matrix<double, Dimension, 1> normal;
  double bound;
};

// Returns the point with the least `cost` * x in the first `n` half-spaces and in a large cube, or
// nothing if they have no common point. Adds them one after the other, and searches the plane of
// each that does not have the least point so far (Seidel 1991).
template <int Dimension>
std::optional<Eigen::Matrix<double, Dimension, 1> >
least_point(const std::vector<Half_space<Dimension> >& half_spaces, std::size_t n,
            const Eigen::Matrix<double, Dimension, 1>& cost)
{
  const double size = 1e3, tolerance = 1e-10;
  Eigen::Matrix<double, Dimension, 1> result;
  if constexpr (Dimension == 1) {
    double low = -size, high = size, lowest = -size, highest = size; // the latter with a tolerance
    for (std::size_t i = 0; i < n; ++i) {
      const double a = half_spaces[i].normal[0], b = half_spaces[i].bound;
      if (std::abs(a) < 1e-13) {
        if (b < -tolerance)
          return {};
      } else if (a > 0) {
        high = (std::min)(high, b / a);
        highest = (std::min)(highest, (b + tolerance) / a);
      } else {
        low = (std::max)(low, b / a);
        lowest = (std::max)(lowest, (b + tolerance) / a);
      }
    }
    if (lowest > highest)
      return {};
    result[0] = std::clamp(low > high ? (low + high) / 2 : cost[0] > 0 ? low : high, lowest,
                           highest);
  } else {
    for (int k = 0; k < Dimension; ++k)
      result[k] = cost[k] > 0 ? -size : size;
    std::vector<Half_space<Dimension - 1> > in_plane;
    for (std::size_t i = 0; i < n; ++i) {
      const auto& normal = half_spaces[i].normal;
      const double bound = half_spaces[i].bound;
      if (normal.dot(result) <= bound + tolerance)
        continue;
      int k; // the coordinate that the plane determines
      if (!(normal.cwiseAbs().maxCoeff(&k) > 1e-13))
        return {};
      const auto projected = [&](const auto& v, double factor) {
        Eigen::Matrix<double, Dimension - 1, 1> p;
        for (int c = 0, d = 0; c < Dimension; ++c)
          if (c != k)
            p[d++] = v[c] - factor * normal[c];
        return p;
      };
      in_plane.clear();
      for (std::size_t j = 0; j < i; ++j) {
        const double factor = half_spaces[j].normal[k] / normal[k];
        in_plane.push_back({projected(half_spaces[j].normal, factor),
                            half_spaces[j].bound - factor * bound});
      }
      const auto p = least_point<Dimension - 1>(in_plane, i, projected(cost, cost[k] / normal[k]));
      if (!p)
        return {};
      double rest = bound;
      for (int c = 0, d = 0; c < Dimension; ++c)
        if (c != k) {
          result[c] = (*p)[d++];
          rest -= normal[c] * result[c];
        }
      result[k] = rest / normal[k];
    }
  }
  return result;
}

// Merges the points of a convex polyhedron until it has few: the two ends of an edge become one
// point, beyond the planes of their triangles and below the planes of the triangles around these.
// Then the polyhedron stays convex and contains the one before (progressive hulls, Sander et al.
// 2000). Each time the edge is taken that adds the least volume.
class Outward_simplification
{
  typedef Eigen::Vector3d Vector;
  // A point that is 0 by default, because CGAL copies points before it sets them.
  struct Mesh_point : Vector
  {
    Mesh_point() : Vector(Vector::Zero()) {}
    Mesh_point(const Vector& v) : Vector(v) {}
  };

  typedef CGAL::Surface_mesh<Mesh_point> Mesh;
  typedef Mesh::Vertex_index Vertex;
  typedef Mesh::Halfedge_index Halfedge;
  typedef Mesh::Edge_index Edge;

  struct Merge
  {
    double volume; // that it adds
    Vector point;
  };

  struct Plane
  {
    Vector area; // normal to the triangle, and twice as long as its area
    double length, bound;
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Mesh mesh_;
  std::vector<Plane> planes_; // one per face
  std::set<std::pair<double, Edge> > queue_;
  std::vector<double> volume_of_edge_; // its key in the queue; infinite if it is not there
  const double slack_;

  void set_plane(Mesh::Face_index f)
  {
    const Halfedge h = mesh_.halfedge(f);
    const Vector& a = mesh_.point(mesh_.source(h));
    const Vector area = (mesh_.point(mesh_.target(h)) - a)
                          .cross(mesh_.point(mesh_.target(mesh_.next(h))) - a);
    const double length = area.norm();
    planes_[f] = {area, length, length > 0 ? area.dot(a) / length : 0};
  }

  // Returns the point at which the ends of an edge are merged, if there is one.
  std::optional<Merge> merge(Edge e) const
  {
    std::vector<Half_space<3> > half_spaces;
    Vector cost = Vector::Zero();
    double volume = 0;
    const auto add = [&](Halfedge h, double sign, double slack) {
      const Plane& p = planes_[mesh_.face(h)];
      if (p.length > 0)
        half_spaces.push_back({sign / p.length * p.area, sign * p.bound + slack});
    };
    for (const Halfedge end : {mesh_.halfedge(e), mesh_.opposite(mesh_.halfedge(e))})
      for (const Halfedge h : mesh_.halfedges_around_target(end)) {
        if (h == end)
          continue; // the other end has this triangle, too
        const Plane& p = planes_[mesh_.face(h)];
        cost += p.area;
        volume += p.length * p.bound;
        add(h, -1, 0);
        const Halfedge beyond = mesh_.opposite(mesh_.prev(h));
        const Vertex other = mesh_.source(end);
        if (mesh_.target(mesh_.next(h)) != other && mesh_.target(mesh_.next(beyond)) != other)
          add(beyond, 1, slack_);
      }
    std::minstd_rand random; // the same each time
    for (std::size_t i = half_spaces.size(); i > 1; --i) // a random order takes linear time
      std::swap(half_spaces[i - 1], half_spaces[random() % i]);
    const auto point = least_point<3>(half_spaces, half_spaces.size(), cost);
    if (!point || point->cwiseAbs().maxCoeff() > 100)
      return {};
    for (const Half_space<3>& h : half_spaces)
      if (h.normal.dot(*point) > h.bound + 1e-9) // by rounding errors
        return {};
    return Merge{(cost.dot(*point) - volume) / 6, *point};
  }

  void remove(Edge e)
  {
    if (volume_of_edge_[e] < infinity)
      queue_.erase({volume_of_edge_[e], e});
    volume_of_edge_[e] = infinity;
  }

  void update(Edge e)
  {
    remove(e);
    if (const std::optional<Merge> m = merge(e)) {
      volume_of_edge_[e] = m->volume;
      queue_.emplace(m->volume, e);
    }
  }

public:
  // The points are about as far apart as 1. They may be merged above the planes around them by the
  // slack; then the mesh may get dents.
  Outward_simplification(const Convex_hull& hull, double slack) : slack_(slack)
  {
    for (const Point& p : hull.points)
      mesh_.add_vertex(Vector(p[0], p[1], p[2]));
    for (const Triangle& t : hull.triangles)
      mesh_.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
    planes_.resize(hull.triangles.size());
    for (const auto f : mesh_.faces())
      set_plane(f);
    volume_of_edge_.resize(mesh_.number_of_edges(), infinity);
    for (const Edge e : mesh_.edges())
      update(e);
  }

  // Returns the points when there are at most `maximum`, or no edge can be merged.
  std::vector<Point> operator()(std::size_t maximum)
  {
    while (mesh_.number_of_vertices() > maximum && !queue_.empty()) {
      const auto [volume, e] = *queue_.begin();
      const std::optional<Merge> m = merge(e);
      if (!m || !CGAL::Euler::does_satisfy_link_condition(e, mesh_)) {
        remove(e);
        continue;
      }
      if (m->volume > volume) { // the planes around it have changed
        update(e);
        continue;
      }
      const Halfedge h = mesh_.halfedge(e);
      for (const Halfedge side : {h, mesh_.opposite(h)}) // whose edges may go
        for (const Halfedge g : {side, mesh_.next(side), mesh_.prev(side)})
          remove(mesh_.edge(g));
      const Vertex v = CGAL::Euler::collapse_edge(e, mesh_);
      mesh_.point(v) = m->point;
      for (const Halfedge around : mesh_.halfedges_around_target(mesh_.halfedge(v)))
        set_plane(mesh_.face(around));
      for (const Halfedge around : mesh_.halfedges_around_target(mesh_.halfedge(v)))
        for (const Halfedge g : {around, mesh_.prev(around)})
          update(mesh_.edge(g));
    }
    std::vector<Point> result;
    for (const Vertex v : mesh_.vertices())
      result.push_back({mesh_.point(v).x(), mesh_.point(v).y(), mesh_.point(v).z()});
    return result;
  }
};

inline Eigen::Vector3d vector_of(const Point& p) { return {p[0], p[1], p[2]}; }

inline double volume(const Convex_hull& hull)
{ return Moments(hull.points, hull.triangles).volume(); }

// Returns a box around a hull if there may be 8 points, otherwise a tetrahedron: the smallest one
// with a side in the plane of a triangle, and another side parallel to one of its edges.
inline Convex_hull simple_hull(const Convex_hull& hull, std::size_t maximum)
{
  typedef Eigen::Vector3d Vector;
  double least_volume = std::numeric_limits<double>::infinity();
  std::vector<Point> corners;
  for (const Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector p = vector_of(hull.points[t[k]]);
      const Vector edge = vector_of(hull.points[t[(k + 1) % 3]]) - p;
      const Vector normal = (vector_of(hull.points[t[(k + 2) % 3]]) - p).cross(edge);
      if (!(normal.norm() > 0))
        continue;
      Eigen::Matrix3d axes; // its rows; the hull is above the plane of the triangle
      axes << normal.normalized().transpose(), edge.normalized().transpose(),
        normal.cross(edge).normalized().transpose();
      Vector low = axes * p, high = low;
      for (const Point& q : hull.points) {
        low = low.cwiseMin(axes * vector_of(q));
        high = high.cwiseMax(axes * vector_of(q));
      }
      const Vector size = high - low;
      double legs = 1; // of the shape, as multiples of the edges of the box
      if (maximum < 8)
        for (const Point& q : hull.points)
          legs = (std::max)(legs, (axes * vector_of(q) - low).cwiseQuotient(size).sum());
      const double volume = legs * legs * legs * size.prod() / (maximum < 8 ? 6 : 1);
      if (!(volume < least_volume))
        continue;
      least_volume = volume;
      corners.clear();
      for (int i = 0; i < 8; ++i) {
        const Vector step(i & 1, i >> 1 & 1, i >> 2);
        const Vector q = axes.transpose() * (low + legs * step.cwiseProduct(size));
        if (maximum >= 8 || step.sum() <= 1)
          corners.push_back({q[0], q[1], q[2]});
      }
    }
  return convex_hull(corners, 1e-3);
}

// Returns a convex polyhedron that contains a convex hull and has at most `maximum` points, at
// least 4. It is the hull itself if this has so few points.
inline Convex_hull limited_hull(const Convex_hull& hull, std::size_t maximum)
{
  typedef Eigen::Vector3d Vector;
  if (hull.points.size() <= maximum)
    return hull;
  const double extent = extent_of(hull.points);
  Vector center = Vector::Zero();
  for (const Point& p : hull.points)
    center += vector_of(p) / static_cast<double>(hull.points.size());
  const auto move = [&](Convex_hull& h, const auto& f) {
    for (Point& p : h.points) {
      const Vector v = f(vector_of(p));
      p = {v[0], v[1], v[2]};
    }
  };
  Convex_hull result = hull, simple;
  move(result, [&](const Vector& p) { return Vector((p - center) / extent); });
  for (const std::size_t number : {(std::max)(maximum, std::size_t(12)), maximum}) {
    // Planar facets with rounded coordinates may need some slack.
    for (double slack = 0; result.points.size() > number && slack < 0.1;
         slack = (std::max)(1e-8, 10 * slack))
      result = convex_hull(Outward_simplification(result, slack)(number), 1e-3);
    if (simple.points.empty())
      simple = simple_hull(result, maximum);
  }
  if (result.points.size() > maximum || volume(simple) < volume(result))
    result = simple;
  move(result, [&](const Vector& p) { return Vector(center + extent * p); });
  result.thickness = hull.thickness;

  // Enlarges it by the rounding errors.
  double factor = 1;
  for (const Triangle& t : result.triangles) {
    const Vector a = vector_of(result.points[t[0]]);
    const Vector area = (vector_of(result.points[t[1]]) - a)
                          .cross(vector_of(result.points[t[2]]) - a);
    if (area.norm() > 1e-10 * extent * extent)
      for (const Point& p : hull.points)
        factor = (std::max)(factor, area.dot(vector_of(p) - center) / area.dot(a - center));
  }
  if (factor > 1)
    move(result, [&](const Vector& p) { return Vector(center + factor * (p - center)); });
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_LIMITED_HULL_H
