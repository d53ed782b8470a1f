// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_FACE_TREE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_FACE_TREE_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef std::array<Vector, 3> Triangle;

inline double squared_distance_to_segment(const Vector& point, const Vector& source,
                                          const Vector& target)
{
  const Vector v = target - source, p = point - source;
  const double squared = v.squared_norm();
  const double fraction = squared > 0 ? std::clamp(p.dot(v) / squared, 0., 1.) : 0;
  return (p - fraction * v).squared_norm();
}

// Accepts degenerate triangles.
inline double squared_distance_to_triangle(const Vector& point, const Triangle& t)
{
  const Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
  bool is_beside = normal.is_zero();
  double result = 0;
  for (int i = 0; i < 3 && !is_beside; ++i)
    is_beside = normal.dot((t[(i + 1) % 3] - t[i]).cross(point - t[i])) < 0;
  if (!is_beside) {
    const double height = normal.dot(point - t[0]);
    return height * height / normal.squared_norm();
  }
  result = squared_distance_to_segment(point, t[0], t[1]);
  result = (std::min)(result, squared_distance_to_segment(point, t[1], t[2]));
  return (std::min)(result, squared_distance_to_segment(point, t[2], t[0]));
}

// Calls f(piece, fraction of the area) for the pieces of a triangle. Longest-edge bisection makes
// the pieces, whose edges are not longer than a bound.
template <class Function>
void for_each_piece(const Triangle& triangle, double bound, const Function& f, double fraction = 1)
{
  int longest = 0;
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    const double squared_length = (triangle[(i + 1) % 3] - triangle[i]).squared_norm();
    if (squared_length > squared) {
      squared = squared_length;
      longest = i;
    }
  }
  if (!(squared > bound * bound)) {
    f(triangle, fraction);
    return;
  }
  const Vector &p = triangle[longest], &q = triangle[(longest + 1) % 3];
  const Vector &r = triangle[(longest + 2) % 3], middle = (p + q) / 2;
  for_each_piece({p, middle, r}, bound, f, fraction / 2);
  for_each_piece({middle, q, r}, bound, f, fraction / 2);
}

inline std::vector<Triangle> triangles_of(const Surface& surface)
{
  std::vector<Triangle> result;
  result.reserve(surface.number_of_faces());
  for (const Corners& c : surface.corners)
    result.push_back({surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]});
  return result;
}

// Returns the normal of a triangle; its length is twice the area.
inline Vector triangle_normal(const Triangle& t)
{ return (t[1] - t[0]).cross(t[2] - t[0]); }

inline double squared_longest_edge(const Triangle& t)
{
  return (std::max)({(t[1] - t[0]).squared_norm(), (t[2] - t[1]).squared_norm(),
                     (t[0] - t[2]).squared_norm()});
}

// Finds the nearest of some triangles, which lie in [-1, 1]^3, by a tree of bounding boxes. Ties go
// to the first triangle, while CGAL's AABB tree finds any of them, and its distances differ between
// versions in the last bits. Triangles that face away are penalized.
class Face_tree
{
  static constexpr std::size_t largest_leaf = 4;
  // Squared distances are rounded to multiples of it, so that rounding errors break no ties.
  static constexpr double quantum_of_squares = 1. / (1ll << 48);

  struct Search
  {
    Vector point, normal;
    double squared_backward; // added to the squared distances of triangles that face away
    double smallest = std::numeric_limits<double>::infinity();
    Index nearest = null_index;
  };

  const std::vector<Triangle>& triangles_;
  std::vector<Vector> normals_;
  std::vector<Index> order_;         // the triangles; each node is a range
  std::vector<Bounding_box> boxes_;  // one per node; the children of node i are 2i + 1 and 2i + 2

  static std::size_t middle(std::size_t first, std::size_t end)
  { return first + (end - first) / 2; }

  Bounding_box box(std::size_t first, std::size_t end) const
  {
    std::vector<Vector> corners;
    for (std::size_t i = first; i < end; ++i)
      corners.insert(corners.end(), triangles_[order_[i]].begin(), triangles_[order_[i]].end());
    return Bounding_box(corners);
  }

  void build(std::size_t node, std::size_t first, std::size_t end)
  {
    const Bounding_box box = this->box(first, end);
    boxes_.resize((std::max)(boxes_.size(), node + 1), box);
    boxes_[node] = box;
    if (end - first <= largest_leaf)
      return;
    const Vector size = box.largest - box.smallest;
    int axis = 0;
    for (int i : {1, 2})
      axis = size[i] > size[axis] ? i : axis;
    const auto key = [&](Index f) {
      const Triangle& t = triangles_[f];
      return std::make_pair(t[0][axis] + t[1][axis] + t[2][axis], f);
    };
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle(first, end)), at(end),
                     [&](Index f, Index g) { return key(f) < key(g); });
    build(2 * node + 1, first, middle(first, end));
    build(2 * node + 2, middle(first, end), end);
  }

  double squared_distance_to_box(std::size_t node, const Vector& p) const
  {
    Vector v;
    for (int i = 0; i < 3; ++i)
      v[i] = (std::max)({boxes_[node].smallest[i] - p[i], 0., p[i] - boxes_[node].largest[i]});
    return v.squared_norm();
  }

  void search(Search& s, std::size_t node, std::size_t first, std::size_t end) const
  {
    if (end - first <= largest_leaf) {
      for (std::size_t i = first; i < end; ++i) {
        const Index f = order_[i];
        double squared = squared_distance_to_triangle(s.point, triangles_[f]);
        if (normals_[f].dot(s.normal) < 0)
          squared += s.squared_backward;
        squared = std::round(squared / quantum_of_squares) * quantum_of_squares;
        if (std::make_pair(squared, f) < std::make_pair(s.smallest, s.nearest)) {
          s.smallest = squared;
          s.nearest = f;
        }
      }
      return;
    }
    const double distances[2] = {squared_distance_to_box(2 * node + 1, s.point),
                                 squared_distance_to_box(2 * node + 2, s.point)};
    const std::size_t nearer = distances[1] < distances[0];
    for (std::size_t child : {nearer, 1 - nearer})
      if (distances[child] <= s.smallest + quantum_of_squares) {
        if (child == 0)
          search(s, 2 * node + 1, first, middle(first, end));
        else
          search(s, 2 * node + 2, middle(first, end), end);
      }
  }

public:
  explicit Face_tree(const std::vector<Triangle>& triangles)
    : triangles_(triangles), order_(first_indices(triangles.size()))
  {
    for (const Triangle& t : triangles)
      normals_.push_back(triangle_normal(t).normalized());
    build(0, 0, order_.size());
  }

  Index nearest(const Vector& point, const Vector& normal, double squared_backward) const
  {
    Search s{point, normal, squared_backward};
    search(s, 0, 0, order_.size());
    return s.nearest;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_FACE_TREE_H
