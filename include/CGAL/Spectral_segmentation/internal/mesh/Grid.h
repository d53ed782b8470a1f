// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_GRID_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_GRID_H

#include <CGAL/Spectral_segmentation/internal/mesh/Vector.h>
#include <CGAL/Spectral_segmentation/internal/utility/Index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A regular grid whose cells have edges of length 1. A node is also the number of the cell of which
// it is the corner of smallest coordinates.
class Grid
{
  Vector origin_;
  Index size_[3];   // the number of nodes along each axis
  Index stride_[3]; // from a node to the next one along each axis

public:
  // Around a box, with so many cells beside it on each side.
  Grid(const Bounding_box& box, int margin)
  {
    Index stride = 1;
    for (int i = 0; i < 3; ++i) {
      origin_[i] = std::floor(box.smallest[i]) - margin;
      size_[i] = static_cast<Index>(std::ceil(box.largest[i]) - origin_[i]) + margin + 1;
      stride_[i] = stride;
      stride *= size_[i];
    }
  }

  static double number_of_nodes(const Bounding_box& box, int margin)
  {
    double result = 1;
    for (int i = 0; i < 3; ++i)
      result *= std::ceil(box.largest[i]) - std::floor(box.smallest[i]) + 2 * margin + 1;
    return result;
  }

  Index number_of_nodes() const { return size_[2] * stride_[2]; }
  Index stride(int axis) const { return stride_[axis]; }
  Index size(int axis) const { return size_[axis]; }
  Index coordinate(Index node, int axis) const { return node / stride_[axis] % size_[axis]; }

  Vector point(Index node) const
  {
    return origin_ + Vector(coordinate(node, 0), coordinate(node, 1), coordinate(node, 2));
  }

  // The cell that holds a point, which is not outside of the grid.
  Index cell(const Vector& p) const
  {
    const Vector q = p - origin_;
    return static_cast<Index>(q.x()) + stride_[1] * static_cast<Index>(q.y()) +
           stride_[2] * static_cast<Index>(q.z());
  }

  // The corners of a cell.
  std::array<Index, 8> corners(Index cell) const
  {
    std::array<Index, 8> result;
    for (Index i = 0; i < 8; ++i)
      result[i] = cell + (i & 1) * stride_[0] + (i >> 1 & 1) * stride_[1] + (i >> 2) * stride_[2];
    return result;
  }

  // Calls f with each neighbor of a node.
  template <class Function>
  void for_each_neighbor(Index node, const Function& f) const
  {
    for (int axis = 0; axis < 3; ++axis) {
      const Index i = coordinate(node, axis);
      if (i > 0)
        f(node - stride_[axis]);
      if (i + 1 < size_[axis])
        f(node + stride_[axis]);
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_GRID_H
