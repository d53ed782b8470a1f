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

// Triangles with the segment of each.
struct Labeled_triangles
{
  std::vector<Corners> triangles;
  std::vector<Index> segments;

  bool empty() const { return triangles.empty(); }

  void add(const Corners& t, Index segment)
  {
    triangles.push_back(t);
    segments.push_back(segment);
  }

  void add(const std::vector<Corners>& more, Index segment)
  {
    triangles.insert(triangles.end(), more.begin(), more.end());
    segments.resize(triangles.size(), segment);
  }
};

// The triangles of a cap, with the segments on their other side.
typedef Labeled_triangles Cap;

// Loops of the border of a segment that get a cap in common.
struct Opening
{
  Index segment; // `null_index` for the surface, whose border consists of the edges of its holes
  const Border& border;
  std::vector<Loop> loops;
  std::set<Vertex_pair> edges; // of the loops

  Opening(Index s, const Border& b, const std::vector<Loop>& l) : segment(s), border(b), loops(l)
  {
    for (const Loop& loop : l)
      for (std::size_t i = 0; i < loop.size(); ++i)
        edges.insert(vertex_pair(loop[i], loop[(i + 1) % loop.size()]));
  }

  // Returns whether no two loops have a vertex in common.
  bool has_disjoint_loops() const
  {
    std::set<Index> vertices;
    for (const Loop& loop : loops)
      vertices.insert(loop.begin(), loop.end());
    return vertices.size() == edges.size();
  }
};

// How caps with several neighbors may be cut into sectors, besides around a point in the middle.
enum class Sectors { FLAT, FLAT_OR_WITH_CHORDS, NONE };

// Holds the segments of a surface with their caps so far, and checks further caps. The largest
// coordinate is about 1, so that no volume overflows.
class Segmented_solid
{
  double unit_; // a power of 2, so that division by it is exact
  std::size_t number_of_given_points_;
  std::vector<Vector> points_;
  std::vector<std::vector<Corners> > triangles_; // one list per segment, with its caps
  Segment_borders borders_;
  std::vector<char> is_closed_; // one per segment
  Triangle_tree tree_;
  std::multiset<Vertex_pair> taken_; // edges of triangles and caps, which no cap may repeat
  double orientation_ = 1;           // -1 if the surface is inside out
  Labeled_triangles caps_;
  Sectors sectors_ = Sectors::FLAT;
  bool all_caps_are_free_ = true; // whether each intersects nothing

  // The segments and the normals of the triangles at each vertex of a border, or of a cap.
  std::unordered_map<Index, std::vector<std::pair<Index, Vector> > > normals_;

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

  void add_triangle(Index segment, const Corners& t)
  {
    caps_.add(t, segment);
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

  // Returns whether triangles leave the border of a segment to the inside of the solid. A hole of
  // the surface has no inside.
  bool lead_inwards(const std::vector<Corners>& triangles, const Opening& opening) const
  {
    if (opening.segment == null_index)
      return true;
    for (const Corners& t : triangles)
      for (int i = 0; i < 3; ++i) {
        const Index v = t[i], w = t[(i + 1) % 3];
        const auto edge = opening.border.find(vertex_pair(v, w));
        if (edge == opening.border.end())
          continue;
        const Index other = borders_.segment_at(v, w, opening.segment);
        if (!leads_inwards({v, w, t[(i + 2) % 3]}, edge->second.apex,
                           borders_.border(other).at(edge->first).apex))
          return false;
      }
    return true;
  }

public:
  // `segment` holds the segment of each triangle, from 0 to n - 1.
  Segmented_solid(const std::vector<Vector>& points, const std::vector<Corners>& triangles,
                  const std::vector<Index>& segment, std::size_t n)
    : unit_(unit_of(points)), number_of_given_points_(points.size()),
      points_(divided(points, unit_)), triangles_(triangles_of_segments(triangles, segment, n)),
      borders_(triangles_), is_closed_(n, 0), tree_(points_, triangles)
  {
    // Edges between other vertices cannot be edges of a cap.
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

  // Points are numbered from those of the caller on, and divided by the unit.
  const std::vector<Vector>& points() const { return points_; }
  double unit() const { return unit_; }

  // Returns the triangles of each segment with its caps.
  const std::vector<std::vector<Corners> >& triangles() const { return triangles_; }

  const Segment_borders& borders() const { return borders_; }

  // Turns the triangles of closed segments around if the surface is inside out.
  void turn_outward()
  {
    for (std::vector<Corners>& triangles : triangles_)
      for (Corners& t : triangles)
        if (orientation_ < 0)
          std::swap(t[1], t[2]);
  }

  void set_sectors(Sectors sectors) { sectors_ = sectors; }
  Sectors sectors() const { return sectors_; }
  bool all_caps_are_free() const { return all_caps_are_free_; }

  const Labeled_triangles& caps() const { return caps_; } // all triangles that were added

  // Returns the points that were added, in the unit of the caller.
  std::vector<Vector> new_points() const
  {
    std::vector<Vector> result;
    for (std::size_t v = number_of_given_points_; v < points_.size(); ++v)
      result.push_back(points_[v] * unit_);
    return result;
  }

  Index add_point(const Vector& p)
  {
    points_.push_back(p);
    return static_cast<Index>(points_.size() - 1);
  }

  // Removes points that were added last.
  void resize_points(std::size_t number) { points_.resize(number); }

  // Returns the direction from a vertex that leads into the solid, by the normals of its triangles.
  Vector inward(const std::vector<Vector>& normals) const
  { return -orientation_ * most_visible_normal(normals); }

  // Returns a direction at a vertex of a border that leads into the solid that is left, which
  // consists of the segments that are not closed yet.
  Vector inward(Index v) const
  {
    std::vector<Vector> normals;
    for (const auto& [segment, n] : normals_.at(v))
      if (!is_closed_[segment])
        normals.push_back(n);
    return inward(normals);
  }

  // Returns whether a triangle has another edge than an edge of the loops that is already taken.
  bool take_an_edge_twice(const std::vector<Corners>& triangles, const Opening& opening) const
  {
    for (const Corners& t : triangles)
      for (int i = 0; i < 3; ++i) {
        const Vertex_pair edge = vertex_pair(t[i], t[(i + 1) % 3]);
        if (taken_.count(edge) > 0 && opening.edges.count(edge) == 0)
          return true;
      }
    return false;
  }

  // Returns whether triangles intersect neither each other nor the surface and its caps.
  bool are_free(const std::vector<Corners>& triangles)
  {
    return std::none_of(triangles.begin(), triangles.end(), [this](const Corners& t)
                        { return is_degenerate(points_, t) || tree_.intersects(t); }) &&
           !do_self_intersect(points_, triangles);
  }

  // Returns whether triangles may close an opening, or be a part of its cap.
  bool fit(const std::vector<Corners>& triangles, const Opening& opening)
  {
    return !take_an_edge_twice(triangles, opening) && lead_inwards(triangles, opening) &&
           are_free(triangles);
  }

  // Reserves the space and the edges of a cap, so that other caps avoid them.
  void reserve(const Cap& cap)
  {
    tree_.insert(cap.triangles);
    for (const Corners& t : cap.triangles)
      for (int i = 0; i < 3; ++i)
        taken_.insert(vertex_pair(t[i], t[(i + 1) % 3]));
    tree_.update();
  }

  // Reverts reserve() for the last caps, whose triangles are not degenerate.
  void release(const std::vector<Cap>& caps)
  {
    for (const Cap& cap : caps) {
      tree_.remove_last(cap.triangles.size());
      for (const Corners& t : cap.triangles)
        for (int i = 0; i < 3; ++i)
          taken_.erase(taken_.find(vertex_pair(t[i], t[(i + 1) % 3])));
    }
  }

  // Adds a cap to the segments on both of its sides.
  void add(const Cap& cap, Index segment)
  {
    for (std::size_t i = 0; i < cap.triangles.size(); ++i) {
      const Corners& t = cap.triangles[i];
      if (segment != null_index)
        add_triangle(segment, t);
      add_triangle(cap.segments[i], segment == null_index ? t : Corners{t[0], t[2], t[1]});
    }
  }

  void set_has_forced_caps() { all_caps_are_free_ = false; }
  void set_closed(Index segment) { is_closed_[segment] = 1; }

  // Finds whether the closed surface is inside out. The volume is summed around a point of the
  // surface, because far from it the terms would cancel each other.
  void set_orientation()
  {
    double volume = 0;
    const Vector* origin = nullptr;
    for (const std::vector<Corners>& triangles : triangles_)
      for (const Corners& t : triangles) {
        origin = origin ? origin : &points_[t[0]];
        volume += tetrahedron_volume(*origin, points_[t[0]], points_[t[1]], points_[t[2]]);
      }
    orientation_ = volume < 0 ? -1 : 1;
  }

  // Returns the segments in ascending order of their areas.
  std::vector<Index> order() const
  {
    std::vector<double> area(triangles_.size(), 0);
    for (std::size_t s = 0; s < area.size(); ++s)
      for (const Corners& t : triangles_[s])
        area[s] += normal(points_, t).norm();
    std::vector<Index> result = first_indices(area.size());
    std::stable_sort(result.begin(), result.end(),
                     [&area](Index a, Index b) { return area[a] < area[b]; });
    return result;
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENTED_SOLID_H
