// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENTED_SOLID_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENTED_SOLID_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/Segment_borders.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns the unit vector whose largest angle to the normals is smallest, or 0 if that is a right
// angle or more. The mean of normals often has larger angles at sharp edges, and a point that moves
// against it leaves the solid. The vector points to the point nearest to 0 in the convex hull of
// the normals, which the algorithm of Frank and Wolfe finds.
inline Vector most_visible_normal(const std::vector<Vector>& normals)
{
  Vector result;
  for (const Vector& n : normals)
    result += n / static_cast<double>(normals.size());
  for (int step = 0; step < 100 && !normals.empty(); ++step) {
    const Vector& farthest =
      *std::min_element(normals.begin(), normals.end(), [&result](const Vector& a, const Vector& b)
                        { return a.dot(result) < b.dot(result); });
    const Vector change = farthest - result;
    const double decrease = -change.dot(result), squared_length = change.dot(change);
    if (!(decrease > 1e-3 * result.dot(result)))
      break;
    result += (std::min)(1., decrease / squared_length) * change;
  }
  return result.normalized();
}

// Triangles that close segments.
struct Caps
{
  std::vector<Vector> points;     // new points, which are numbered after the others
  std::vector<Corners> triangles;
  std::vector<Index> segment;     // one per triangle
};

// A piece of a cap, with the segment on its other side.
struct Piece
{
  Index segment;
  std::vector<Corners> triangles;
};

typedef std::vector<Piece> Cap;

// Holds the segments of a surface with their caps so far, and checks further caps.
class Segmented_solid
{
  double unit_; // a power of 2, so that division by it is exact

  // Returns the unit in which the largest coordinate is about 1.
  static double unit_of(const std::vector<Vector>& points)
  {
    double largest = 0;
    for (const Vector& p : points)
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    return largest > 0 ? std::ldexp(1., std::clamp(std::ilogb(largest), -1022, 1023)) : 1;
  }

  static std::vector<Vector> divided(std::vector<Vector> points, double unit)
  {
    for (Vector& p : points)
      p = p / unit;
    return points;
  }

  static std::vector<std::vector<Corners> >
  triangles_of_segments(const std::vector<Corners>& triangles, const std::vector<Index>& segment,
                        std::size_t n)
  {
    std::vector<std::vector<Corners> > result(n);
    for (std::size_t f = 0; f < triangles.size(); ++f)
      result[segment[f]].push_back(triangles[f]);
    return result;
  }

  // Stores the normals of triangles at the borders, and the edges between vertices of borders,
  // because other edges cannot be edges of a cap.
  void take(const std::vector<Corners>& triangles, const std::vector<Index>& segment)
  {
    const std::vector<char> is_at_border = borders_.vertices(points_.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Corners& t = triangles[f];
      for (int i = 0; i < 3; ++i) {
        const Index v = t[i], w = t[(i + 1) % 3];
        if (!is_at_border[v])
          continue;
        normals_[v].emplace_back(segment[f], normal(points_, t).normalized());
        if (is_at_border[w])
          taken_.insert(vertex_pair(v, w));
      }
    }
  }

  void add_triangle(Index segment, const Corners& t)
  {
    result_.triangles.push_back(t);
    result_.segment.push_back(segment);
    triangles_[segment].push_back(t);
    borders_.add_triangle(segment, t);
    for (Index v : t)
      normals_[v].emplace_back(segment, normal(points_, t).normalized());
  }

  // Returns whether a triangle (v, w, x) of a cap leaves the border edge (v, w) to the inside of
  // the solid, or along its surface. The surface has the triangles (w, v, a) and (v, w, b) there.
  bool leads_inwards(const Corners& t, Index a, Index b) const
  {
    const auto v = exact_point(points_[t[0]]), w = exact_point(points_[t[1]]),
               x = exact_point(points_[t[2]]);
    const auto p = exact_point(points_[a]), q = exact_point(points_[b]);
    const auto outside = orientation_ > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    const bool is_convex = CGAL::orientation(w, v, p, q) == -outside;
    const bool is_before_a = CGAL::orientation(w, v, p, x) != outside,
               is_before_b = CGAL::orientation(v, w, q, x) != outside;
    return is_convex ? is_before_a && is_before_b : is_before_a || is_before_b;
  }

protected:
  std::vector<Vector> points_;  // all points, in this unit, so that no volume overflows
  std::vector<std::vector<Corners> > triangles_; // one list per segment, with its caps
  Segment_borders borders_;
  std::vector<char> is_done_; // one per segment, whether it is closed
  Triangle_tree tree_;
  std::multiset<Vertex_pair> taken_; // edges of triangles and caps, which no cap may repeat
  double orientation_ = 1;      // -1 if the surface is inside out

  // The segments and the normals of the triangles at each vertex of a border, or of a cap.
  std::unordered_map<Index, std::vector<std::pair<Index, Vector> > > normals_;
  Caps result_;

  Index add_point(const Vector& p)
  {
    points_.push_back(p);
    return static_cast<Index>(points_.size() - 1);
  }

  // Returns a direction at a vertex of a border that leads into the solid that is left, which
  // consists of the segments that are not closed yet.
  Vector inward(Index v) const
  {
    std::vector<Vector> normals;
    for (const auto& [segment, n] : normals_.at(v))
      if (!is_done_[segment])
        normals.push_back(n);
    return -orientation_ * most_visible_normal(normals);
  }

  static std::set<Vertex_pair> edges_of(const std::vector<Loop>& loops)
  {
    std::set<Vertex_pair> result;
    for (const Loop& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        result.insert(vertex_pair(loop[i], loop[(i + 1) % loop.size()]));
    return result;
  }

  // Returns whether an edge of a cap, except an edge of its loops, is already taken.
  bool takes_an_edge_twice(const Cap& cap, const std::set<Vertex_pair>& edges) const
  {
    for (const Piece& piece : cap)
      for (const Corners& t : piece.triangles)
        for (int i = 0; i < 3; ++i) {
          const Vertex_pair edge = vertex_pair(t[i], t[(i + 1) % 3]);
          if (taken_.count(edge) > 0 && edges.count(edge) == 0)
            return true;
        }
    return false;
  }

  // Returns whether a cap of a segment leaves the border of the segment to the inside of the solid.
  // A cap of the surface closes a hole, which has no inside.
  bool leads_inwards(const Cap& cap, Index segment, const Border& border) const
  {
    if (segment == null_index)
      return true;
    for (const Piece& piece : cap)
      for (const Corners& t : piece.triangles)
        for (int i = 0; i < 3; ++i) {
          const Index v = t[i], w = t[(i + 1) % 3];
          const auto edge = border.find(vertex_pair(v, w));
          if (edge == border.end())
            continue;
          const Index other = borders_.segment_at(v, w, segment);
          if (!leads_inwards({v, w, t[(i + 2) % 3]}, edge->second.apex,
                             borders_.border(other).at(edge->first).apex))
            return false;
        }
    return true;
  }

  // Returns whether a cap intersects neither itself nor the surface and its caps.
  bool is_free(const Cap& cap)
  {
    std::vector<Corners> triangles;
    for (const Piece& piece : cap)
      triangles.insert(triangles.end(), piece.triangles.begin(), piece.triangles.end());
    return std::none_of(triangles.begin(), triangles.end(), [this](const Corners& t)
                        { return is_degenerate(points_, t) || tree_.intersects(t); }) &&
           !do_self_intersect(points_, triangles);
  }

  // Reserves the triangles and edges of a cap, so that other caps avoid them.
  void take(const Cap& cap)
  {
    for (const Piece& piece : cap) {
      tree_.insert(piece.triangles);
      for (const Corners& t : piece.triangles)
        for (int i = 0; i < 3; ++i)
          taken_.insert(vertex_pair(t[i], t[(i + 1) % 3]));
    }
    tree_.update();
  }

  // Reverts take() for the last caps; before them the tree had `number_in_tree` triangles.
  void give_back(const std::vector<Cap>& caps, std::size_t number_in_tree)
  {
    tree_.resize(number_in_tree);
    for (const Cap& cap : caps)
      for (const Piece& piece : cap)
        for (const Corners& t : piece.triangles)
          for (int i = 0; i < 3; ++i)
            taken_.erase(taken_.find(vertex_pair(t[i], t[(i + 1) % 3])));
  }

  // Adds a cap to the segments on both of its sides.
  void add(const Cap& cap, Index segment)
  {
    for (const Piece& piece : cap)
      for (const Corners& t : piece.triangles) {
        if (segment != null_index)
          add_triangle(segment, t);
        add_triangle(piece.segment, segment == null_index ? t : Corners{t[0], t[2], t[1]});
      }
  }

  bool has_degenerate_triangle(Index segment) const
  {
    return std::any_of(triangles_[segment].begin(), triangles_[segment].end(),
                       [this](const Corners& t) { return is_degenerate(points_, t); });
  }

  // Returns the signed volume of the closed surface. It is summed around a point of the surface,
  // because far from it the terms would cancel each other.
  double signed_volume() const
  {
    double result = 0;
    const Vector* origin = nullptr;
    for (const std::vector<Corners>& triangles : triangles_)
      for (const Corners& t : triangles) {
        origin = origin ? origin : &points_[t[0]];
        result += tetrahedron_volume(*origin, points_[t[0]], points_[t[1]], points_[t[2]]);
      }
    return result;
  }

  // Returns the segments in ascending order of their areas.
  std::vector<Index> order() const
  {
    std::vector<double> area;
    for (const std::vector<Corners>& triangles : triangles_) {
      area.push_back(0);
      for (const Corners& t : triangles)
        area.back() += normal(points_, t).norm();
    }
    std::vector<Index> result = first_indices(area.size());
    std::stable_sort(result.begin(), result.end(),
                     [&area](Index a, Index b) { return area[a] < area[b]; });
    return result;
  }

  // `segment` holds the segment of each triangle, from 0 to n - 1.
  Segmented_solid(const std::vector<Vector>& points, const std::vector<Corners>& triangles,
                  const std::vector<Index>& segment, std::size_t n)
    : unit_(unit_of(points)),
      points_(divided(points, unit_)), triangles_(triangles_of_segments(triangles, segment, n)),
      borders_(triangles_), is_done_(n, 0), tree_(points_, triangles)
  {
    take(triangles, segment);
  }

public:
  Segmented_solid(const Segmented_solid&) = delete;
  Segmented_solid& operator=(const Segmented_solid&) = delete;

  const Caps& caps() const { return result_; }
  bool is_inside_out() const { return orientation_ < 0; }

  // Returns all points, in the unit, and the triangles of each segment with its caps.
  double unit() const { return unit_; }
  const std::vector<Vector>& points() const { return points_; }
  const std::vector<std::vector<Corners> >& triangles() const { return triangles_; }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENTED_SOLID_H
