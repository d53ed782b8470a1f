// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_SURFACE_NETS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_SURFACE_NETS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/soup/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Values at the nodes of a grid, negative inside a solid that does not reach the border.
typedef std::vector<float> Grid_function;

// Adds nodes to the solid until two of its cells around an edge or a node always share a face or
// are connected by cells that do. Its boundary is then a 2-manifold (well-composed sets, Latecki
// 1997).
class Well_composed_solid
{
  const Grid& grid_;
  Grid_function& values_;
  std::vector<Index> added_;

  bool is_inside(Index node) const { return values_[node] < 0; }

  // Adds the node that is the least outside.
  void add_one_of(std::initializer_list<Index> nodes)
  {
    const Index node = *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b)
                                         { return values_[a] < values_[b]; });
    values_[node] = -std::numeric_limits<float>::min();
    added_.push_back(node);
  }

  void repair_square(Index a, Index b, Index c, Index d) // given in circular order
  {
    if (is_inside(a) && is_inside(c) && !is_inside(b) && !is_inside(d))
      add_one_of({b, d});
    if (is_inside(b) && is_inside(d) && !is_inside(a) && !is_inside(c))
      add_one_of({a, c});
  }

  void repair(Index cell)
  {
    const std::array<Index, 8> c = grid_.corners(cell);
    int number = 0;
    for (Index node : c)
      number += is_inside(node);
    if (number < 2 || number > 6)
      return;
    for (int axis = 0; axis < 3; ++axis) {
      const Index u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
      for (Index w : {Index(0), Index(1) << axis})
        repair_square(c[w], c[w + u], c[w + u + v], c[w + v]);
    }
    for (Index i = 0; i < 4; ++i) { // a diagonal of the cell
      int inside = 0;
      for (Index node : c)
        inside += is_inside(node);
      if (is_inside(c[i]) != is_inside(c[7 - i]))
        continue;
      if (inside == 2 && is_inside(c[i]))
        add_one_of({c[i ^ 1], c[i ^ 2], c[i ^ 4]});
      else if (inside == 6 && !is_inside(c[i]))
        add_one_of({c[i], c[7 - i]});
    }
  }

  // Calls f with the cells around a node.
  template <class Function>
  void for_each_cell(Index node, const Function& f) const
  {
    for (Index i = 0; i < 8; ++i)
      f(node - (i & 1) * grid_.stride(0) - (i >> 1 & 1) * grid_.stride(1) -
        (i >> 2) * grid_.stride(2));
  }

public:
  Well_composed_solid(const Grid& grid, Grid_function& values) : grid_(grid), values_(values) {}

  void operator()()
  {
    for (Index node = 0; node < values_.size(); ++node)
      if (is_inside(node))
        for_each_cell(node, [this](Index cell) { repair(cell); });
    while (!added_.empty()) {
      const Index node = added_.back();
      added_.pop_back();
      for_each_cell(node, [this](Index cell) { repair(cell); });
    }
  }
};

// Makes the boundary of a solid: a vertex in each cell that it crosses, at the mean of the
// crossings of the cell's edges, and a quadrangle across each edge of the grid that it crosses
// (Gibson 1998). Quadrangles are split along their shorter diagonal.
class Surface_nets
{
  const Grid& grid_;
  const Grid_function& values_;
  std::vector<Index> vertex_; // one per cell
  Surface result_;

  bool is_crossed(Index a, Index b) const { return (values_[a] < 0) != (values_[b] < 0); }

  Index vertex(Index cell)
  {
    if (vertex_[cell] != null_index)
      return vertex_[cell];
    const std::array<Index, 8> c = grid_.corners(cell);
    Vector sum;
    int number = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (Index i = 0; i < 8; ++i) {
        const Index j = i | Index(1) << axis;
        if (i == j || !is_crossed(c[i], c[j]))
          continue;
        const double a = values_[c[i]], b = values_[c[j]];
        sum += grid_.point(c[i]) + a / (a - b) * (grid_.point(c[j]) - grid_.point(c[i]));
        ++number;
      }
    vertex_[cell] = static_cast<Index>(result_.points.size());
    result_.points.push_back(sum / number);
    return vertex_[cell];
  }

  void add_quadrangle(const std::array<Index, 4>& cells)
  {
    const Index v[4] = {vertex(cells[0]), vertex(cells[1]), vertex(cells[2]), vertex(cells[3])};
    const std::vector<Vector>& p = result_.points;
    const int first =
      quantized((p[v[2]] - p[v[0]]).squared_norm()) <= quantized((p[v[3]] - p[v[1]]).squared_norm())
        ? 0 : 1;
    result_.corners.push_back({v[first], v[first + 1], v[first + 2]});
    result_.corners.push_back({v[first], v[first + 2], v[(first + 3) % 4]});
  }

public:
  Surface_nets(const Grid& grid, const Grid_function& values)
    : grid_(grid), values_(values), vertex_(values.size(), null_index) {}

  Surface operator()()
  {
    for (Index node = 0; node < values_.size(); ++node)
      for (int axis = 0; axis < 3; ++axis) {
        if (grid_.coordinate(node, axis) + 1 == grid_.size(axis))
          continue;
        if (!is_crossed(node, node + grid_.stride(axis)))
          continue;
        const Index u = grid_.stride((axis + 1) % 3), v = grid_.stride((axis + 2) % 3);
        std::array<Index, 4> cells = {node - u - v, node - v, node, node - u};
        if (!(values_[node] < 0)) // they go around to the left as seen from outside
          std::swap(cells[1], cells[3]);
        add_quadrangle(cells);
      }
    Triangle_connection connection(result_);
    connection();
    return std::move(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_SURFACE_NETS_H
