// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_H

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>
#include <CGAL/Spectral_segmentation/internal/base/arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A regular grid whose cells have edges of length 1. A node is also the number of the cell of which
// it is the corner of smallest coordinates.
class Grid
{
  Vector origin_;
  Index size_[3];                // the number of nodes along each axis, the first two powers of 2
  unsigned shift_[3] = {0, 0, 0}; // of the bits of a node that are its coordinates

  static std::array<double, 3> sizes(const Bounding_box& box, int margin)
  {
    std::array<double, 3> result;
    for (int i = 0; i < 3; ++i) {
      result[i] = std::ceil(box.largest[i]) - std::floor(box.smallest[i]) + 2 * margin + 1;
      if (i < 2)
        result[i] = std::exp2(std::ceil(std::log2(result[i])));
    }
    return result;
  }

public:
  // Around a box, with at least so many cells beside it on each side.
  Grid(const Bounding_box& box, int margin)
  {
    const std::array<double, 3> size = sizes(box, margin);
    for (int i = 0; i < 3; ++i) {
      origin_[i] = std::floor(box.smallest[i]) - margin;
      size_[i] = static_cast<Index>(size[i]);
      if (i > 0)
        shift_[i] = shift_[i - 1] + static_cast<unsigned>(std::ilogb(size[i - 1]));
    }
  }

  // What it would have.
  static double number_of_nodes(const Bounding_box& box, int margin)
  {
    const std::array<double, 3> size = sizes(box, margin);
    return size[0] * size[1] * size[2];
  }

  Index number_of_nodes() const { return size_[2] << shift_[2]; }
  Index stride(int axis) const { return Index(1) << shift_[axis]; }
  Index size(int axis) const { return size_[axis]; }

  Index coordinate(Index node, int axis) const
  { return axis == 2 ? node >> shift_[2] : node >> shift_[axis] & (size_[axis] - 1); }

  Vector point(Index node) const
  {
    return origin_ + Vector(coordinate(node, 0), coordinate(node, 1), coordinate(node, 2));
  }

  // The cell that holds a point, which is not outside of the grid.
  Index cell(const Vector& p) const
  {
    const Vector q = p - origin_;
    return static_cast<Index>(q.x()) + (static_cast<Index>(q.y()) << shift_[1]) +
           (static_cast<Index>(q.z()) << shift_[2]);
  }

  // The corners of a cell.
  std::array<Index, 8> corners(Index cell) const
  {
    std::array<Index, 8> result;
    for (Index i = 0; i < 8; ++i)
      result[i] = cell + (i & 1) + ((i >> 1 & 1) << shift_[1]) + ((i >> 2) << shift_[2]);
    return result;
  }

  // Calls f with each neighbor of a node.
  template <class Function>
  void for_each_neighbor(Index node, const Function& f) const
  {
    for (int axis = 0; axis < 3; ++axis) {
      const Index i = coordinate(node, axis);
      if (i > 0)
        f(node - stride(axis));
      if (i + 1 < size_[axis])
        f(node + stride(axis));
    }
  }
};

// For each node of a grid the nearest of some elements. Elements are offered to nodes near them; a
// node that has one offers it to its neighbors, as far as a predicate says of a node and a squared
// distance (a closest point transform by propagation, Danielsson 1980).
template <class SquaredDistance, class Reaches>
class Nearest_elements
{
  const Grid& grid_;
  const SquaredDistance squared_distance_of_; // of an element and a point
  const Reaches reaches_;
  std::vector<Index> element_;         // of each node
  std::vector<float> squared_distance_;
  std::vector<Index> improved_;        // nodes

public:
  Nearest_elements(const Grid& grid, const SquaredDistance& squared_distance,
                   const Reaches& reaches)
    : grid_(grid), squared_distance_of_(squared_distance), reaches_(reaches),
      element_(grid.number_of_nodes(), null_index),
      squared_distance_(grid.number_of_nodes(), (std::numeric_limits<float>::max)()) {}

  void offer(Index node, Index element)
  {
    const float d = static_cast<float>(squared_distance_of_(element, grid_.point(node)));
    if (d < squared_distance_[node] && reaches_(node, d)) {
      squared_distance_[node] = d;
      element_[node] = element;
      improved_.push_back(node);
    }
  }

  void propagate()
  {
    for (std::vector<Index> nodes; !improved_.empty();) {
      nodes.clear();
      nodes.swap(improved_);
      for (Index node : nodes) {
        const Index element = element_[node];
        grid_.for_each_neighbor(node, [&](Index neighbor) {
          if (element_[neighbor] != element)
            offer(neighbor, element);
        });
      }
    }
  }

  Index element(Index node) const { return element_[node]; } // null_index if none is near
  const std::vector<Index>& elements() const { return element_; }           // of all nodes
  float squared_distance(Index node) const { return squared_distance_[node]; }
};

typedef std::array<Vector, 3> Triangle;

inline double squared_distance_to_segment(const Vector& point, const Vector& source,
                                          const Vector& target)
{
  const Vector v = target - source, p = point - source;
  const double squared = v.squared_norm();
  const double share = squared > 0 ? std::clamp(p.dot(v) / squared, 0., 1.) : 0;
  return (p - share * v).squared_norm();
}

// The triangle may be degenerate.
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

// Calls f(piece, share of the area) for pieces of a triangle without an edge longer than a bound,
// made by bisection of longest edges.
template <class Function>
void for_each_piece(const Triangle& triangle, double bound, const Function& f, double share = 1)
{
  int longest = 0;
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    const double of_edge = (triangle[(i + 1) % 3] - triangle[i]).squared_norm();
    if (of_edge > squared) {
      squared = of_edge;
      longest = i;
    }
  }
  if (!(squared > bound * bound)) {
    f(triangle, share);
    return;
  }
  const Vector &p = triangle[longest], &q = triangle[(longest + 1) % 3];
  const Vector &r = triangle[(longest + 2) % 3], middle = (p + q) / 2;
  for_each_piece({p, middle, r}, bound, f, share / 2);
  for_each_piece({middle, q, r}, bound, f, share / 2);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_H
