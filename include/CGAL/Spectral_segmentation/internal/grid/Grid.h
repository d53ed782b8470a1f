// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_H

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A regular grid whose cells have edges of length 1. The index of a node is also the index of the
// cell whose corner of smallest coordinates is the node.
class Grid
{
  Vector origin_;
  Index size_[3];                // the number of nodes along each axis, the first two powers of 2
  unsigned shift_[3] = {0, 0, 0}; // the position of each coordinate in the bits of a node

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
  // Makes a grid around a box, with at least `margin` cells beside it on each side.
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

  // Returns the number of nodes that such a grid would have.
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

  // Returns the cell that holds a point, which is not outside of the grid.
  Index cell(const Vector& p) const
  {
    const Vector q = p - origin_;
    return static_cast<Index>(q.x()) + (static_cast<Index>(q.y()) << shift_[1]) +
           (static_cast<Index>(q.z()) << shift_[2]);
  }

  // Returns the corners of a cell.
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

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_H
