// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_POLYGON_TRIANGULATION_H
#define SEGMENT_MESH_MESH_FILE_POLYGON_TRIANGULATION_H

#include "Polygon_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace mesh_file {

typedef std::array<Index, 3> Triangle;

// Cuts polygons into triangles with the same orientation, each edge of a polygon being one of a
// triangle. Ears are clipped in the coordinate plane in which the polygon has the largest area,
// that with the shortest new edge first: of a convex quadrilateral this is the shorter diagonal.
//
// The time is O(n log n + n r) for n corners of which r are reflex. What has no ear, such as
// corners on a line, becomes a fan, and so does the rest of a polygon that takes more than 2000 n
// steps.
class Polygon_triangulation
{
  // A corner of what is left, and its neighbors there.
  struct Corner
  {
    double x, y;
    Index previous, next;
    bool is_left;
  };

  // The length of the new edge, the corner that is clipped, and the neighbors that it had then.
  typedef std::tuple<double, Index, Index, Index> Ear;

  const std::vector<Point>& points_;
  std::vector<Corner> corners_;
  std::vector<Index> reflex_; // sorted by x
  std::priority_queue<Ear, std::vector<Ear>, std::greater<Ear> > ears_;
  double steps_; // tests of a corner against an ear

  double most_steps() const { return 2000. * static_cast<double>(corners_.size()); }

  // Returns twice the area of a triangle, positive if c is on the left of the line from a to b.
  static double area(const Corner& a, const Corner& b, const Corner& c)
  { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

  // Returns the points relative to the first one, in the unit of the largest difference, so that
  // nothing overflows.
  std::vector<Point> local_points(const Polygon& polygon) const
  {
    std::vector<Point> result;
    double unit = 0;
    for (Index v : polygon) {
      result.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        result.back()[k] = points_[v][k] / 2 - points_[polygon[0]][k] / 2;
        unit = (std::max)(unit, std::abs(result.back()[k]));
      }
    }
    if (unit > 0)
      for (Point& p : result)
        for (double& c : p)
          c /= unit;
    return result;
  }

  // Returns twice the area vector of a polygon, by Newell's formula.
  static Point normal(const std::vector<Point>& points)
  {
    Point result{0, 0, 0};
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        result[k] += (points[j][l] - points[i][l]) * (points[j][m] + points[i][m]);
      }
    return result;
  }

  // Projects the polygon so that its area is positive. Returns false if it has no area.
  bool set_corners(const Polygon& polygon)
  {
    const std::vector<Point> points = local_points(polygon);
    const Point n = normal(points);
    std::size_t k = 0;
    for (std::size_t l = 1; l < 3; ++l)
      if (std::abs(n[l]) > std::abs(n[k]))
        k = l;
    const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
    const double sign = n[k] < 0 ? -1 : 1;
    const Index size = static_cast<Index>(points.size());
    corners_.clear();
    for (Index i = 0; i < size; ++i)
      corners_.push_back({sign * points[i][x], points[i][y], (i + size - 1) % size, (i + 1) % size,
                          true});
    return n[k] != 0;
  }

  double area_at(Index i) const
  {
    const Corner& c = corners_[i];
    return area(corners_[c.previous], c, corners_[c.next]);
  }

  // Returns whether p is inside the triangle or on its border, but at none of its corners.
  static bool contains(const Corner& a, const Corner& b, const Corner& c, const Corner& p)
  {
    const auto is_at = [&](const Corner& q) { return p.x == q.x && p.y == q.y; };
    return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0 && !is_at(a) &&
           !is_at(b) && !is_at(c);
  }

  void add_if_ear(Index i)
  {
    const Corner& b = corners_[i];
    const Corner& a = corners_[b.previous];
    const Corner& c = corners_[b.next];
    if (!(area(a, b, c) > 0))
      return;
    const auto [smallest, largest] = std::minmax({a.x, b.x, c.x});
    auto r = std::lower_bound(reflex_.begin(), reflex_.end(), smallest,
                              [this](Index i, double x) { return corners_[i].x < x; });
    for (; r != reflex_.end() && corners_[*r].x <= largest; ++r, ++steps_)
      if (corners_[*r].is_left && contains(a, b, c, corners_[*r]))
        return;
    ears_.emplace(std::hypot(c.x - a.x, c.y - a.y), i, b.previous, b.next);
  }

  void remove(Index i)
  {
    Corner& c = corners_[i];
    c.is_left = false;
    corners_[c.previous].next = c.next;
    corners_[c.next].previous = c.previous;
  }

  // Removes from the reflex corners those that were clipped or became convex: they lie in no ear.
  void remove_convex_from_reflex()
  {
    reflex_.erase(std::remove_if(reflex_.begin(), reflex_.end(), [this](Index i)
                                 { return !corners_[i].is_left || area_at(i) > 0; }),
                  reflex_.end());
  }

  static void add(Index a, Index b, Index c, std::vector<Triangle>& result)
  {
    if (a != b && b != c && c != a)
      result.push_back({a, b, c});
  }

  // Clips ears, and returns a corner of the rest.
  Index clip(const Polygon& polygon, std::vector<Triangle>& result)
  {
    std::size_t left = polygon.size(), until_cleaned = left / 2;
    Index some = 0;
    while (left > 3 && !ears_.empty() && steps_ < most_steps()) {
      const auto [length, i, a, c] = ears_.top();
      ears_.pop();
      if (!corners_[i].is_left || corners_[i].previous != a || corners_[i].next != c)
        continue;
      add(polygon[a], polygon[i], polygon[c], result);
      remove(i);
      some = a;
      if (--left == until_cleaned) {
        remove_convex_from_reflex();
        until_cleaned = left / 2;
      }
      add_if_ear(a);
      add_if_ear(c);
    }
    return some;
  }

public:
  explicit Polygon_triangulation(const std::vector<Point>& points) : points_(points) {}

  // Appends the triangles of a polygon: two fewer than it has corners, if these are all different.
  // Triangles that have a corner twice are left out.
  void operator()(const Polygon& polygon, std::vector<Triangle>& result)
  {
    if (polygon.size() < 3)
      return;
    if (polygon.size() == 3) {
      add(polygon[0], polygon[1], polygon[2], result);
      return;
    }
    ears_ = {};
    reflex_.clear();
    steps_ = 0;
    if (set_corners(polygon)) {
      for (Index i = 0; i < corners_.size(); ++i)
        if (!(area_at(i) > 0))
          reflex_.push_back(i);
      std::sort(reflex_.begin(), reflex_.end(), [this](Index i, Index j)
                { return corners_[i].x < corners_[j].x; });
      for (Index i = 0; i < corners_.size() && steps_ < most_steps(); ++i)
        add_if_ear(i);
    }
    const Index first = clip(polygon, result);
    for (Index i = corners_[first].next; corners_[i].next != first; i = corners_[i].next)
      add(polygon[first], polygon[i], polygon[corners_[i].next], result);
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_POLYGON_TRIANGULATION_H
