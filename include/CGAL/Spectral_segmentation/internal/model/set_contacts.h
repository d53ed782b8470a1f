// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SET_CONTACTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SET_CONTACTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Face_tree.h>
#include <CGAL/Spectral_segmentation/internal/surface/Longest_edge_bisection.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A regular grid whose cells have edges of length 1. The index of a node is also the index of the
// cell whose corner of smallest coordinates is the node.
class Grid
{
  Vector origin_;
  Index size_[3];                // the number of nodes along each axis, the first two powers of 2
  unsigned shift_[3] = {0, 0, 0}; // the position of each coordinate in the bits of a node

public:
  // Makes a grid around a box, with at least one cell beside it on each side.
  explicit Grid(const Bounding_box& box)
  {
    for (int i = 0; i < 3; ++i) {
      origin_[i] = std::floor(box.smallest[i]) - 1;
      double size = std::ceil(box.largest[i]) - origin_[i] + 2;
      if (i < 2)
        size = std::exp2(std::ceil(std::log2(size)));
      size_[i] = static_cast<Index>(size);
      if (i > 0)
        shift_[i] = shift_[i - 1] + static_cast<unsigned>(std::ilogb(size_[i - 1]));
    }
  }

  Index number_of_nodes() const { return size_[2] << shift_[2]; }
  Index stride(int axis) const { return Index(1) << shift_[axis]; }
  Index size(int axis) const { return size_[axis]; }

  Index coordinate(Index node, int axis) const
  { return axis == 2 ? node >> shift_[2] : node >> shift_[axis] & (size_[axis] - 1); }

  Vector point(Index node) const
  { return origin_ + Vector(coordinate(node, 0), coordinate(node, 1), coordinate(node, 2)); }

  // Returns the cell of a point, which is inside the grid.
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

// Progress callback with a number of short steps; may throw to cancel.
typedef std::function<void(std::size_t)> Step_counter;

// Finds the nearest of some points for each node of a grid by a closest point transform (Danielsson
// 1980): points are offered to nodes near them, and a node that accepts a point offers it to its
// neighbors.
class Nearest_points
{
  const Grid& grid_;
  const std::vector<Vector>& points_;
  const Step_counter& count_steps_;
  std::vector<Index> point_;           // one per node
  std::vector<float> squared_distance_;
  std::vector<Index> improved_;        // the nodes that accepted a point

public:
  Nearest_points(const Grid& grid, const std::vector<Vector>& points,
                 const Step_counter& count_steps)
    : grid_(grid), points_(points), count_steps_(count_steps),
      point_(grid.number_of_nodes(), null_index),
      squared_distance_(grid.number_of_nodes(), (std::numeric_limits<float>::max)()) {}

  void offer(Index node, Index i)
  {
    const float d = static_cast<float>((points_[i] - grid_.point(node)).squared_norm());
    if (d < squared_distance_[node]) {
      count_steps_(1);
      squared_distance_[node] = d;
      point_[node] = i;
      improved_.push_back(node);
    }
  }

  void propagate()
  {
    for (std::vector<Index> nodes; !improved_.empty();) {
      nodes.clear();
      nodes.swap(improved_);
      for (Index node : nodes) {
        const Index i = point_[node];
        grid_.for_each_neighbor(node, [&](Index neighbor) {
          if (point_[neighbor] != i)
            offer(neighbor, i);
        });
      }
    }
  }

  Index operator[](Index node) const { return point_[node]; }
};

// The contact of two sets of faces. Lengths are measured in cells of a grid of at most a hundred
// cells along the longest side of the bounding box.
struct Set_contact
{
  Index sets[2]; // the smaller first
  double squared_gap;
  std::size_t area; // the area nearer than 1.5 cells, in faces of cells
};

// Returns the number of cells along the longest side of the bounding box. Coarse meshes get a
// coarse grid. Cells are larger if unusually large faces or many needles would be cut into more
// than a million pieces. Faces without set do not count.
inline double number_of_cells(const Surface& mesh, const std::vector<Index>& set_of_face,
                              double extent)
{
  constexpr double largest_number_of_pieces = 1e6;
  std::vector<double> longest = longest_edges_of_faces(Execution::SEQUENTIAL, mesh);
  for (Index f = 0; f < longest.size(); ++f)
    if (set_of_face[f] == null_index)
      longest[f] = 0;
  double result = (std::min)(100., 4 * std::sqrt(static_cast<double>(mesh.number_of_faces())));
  while (result > 1 &&
         number_of_added_faces(mesh, longest, extent / result) > largest_number_of_pieces)
    result *= 0.8;
  return result;
}

// Returns the contacts of neighboring sets, the smallest gap first. They connect all sets. Faces
// with the set null_index are left out.
inline std::vector<Set_contact> set_contacts(
  const Surface& mesh, const std::vector<Index>& set_of_face,
  const Step_counter& count_steps = [](std::size_t) {})
{
  Bounding_box box({});
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (set_of_face[f] != null_index)
      for (Index v : mesh.corners[f])
        box.add(mesh.points[v]);
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double scale = extent > 0 ? number_of_cells(mesh, set_of_face, extent) / extent : 0;
  std::vector<Vector> points; // one per piece
  std::vector<Index> set;     // one per piece
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    if (set_of_face[f] == null_index)
      continue;
    const Corners& c = mesh.corners[f];
    const std::size_t first = points.size();
    for_each_piece({scale * mesh.points[c[0]], scale * mesh.points[c[1]],
                    scale * mesh.points[c[2]]}, 1, [&](const Triangle& piece, double) {
      points.push_back((piece[0] + piece[1] + piece[2]) / 3);
      set.push_back(set_of_face[f]);
    });
    count_steps(points.size() - first);
  }
  const Grid grid((Bounding_box(points)));
  Nearest_points nearest(grid, points, count_steps);
  for (Index i = 0; i < points.size(); ++i) {
    for (Index node : grid.corners(grid.cell(points[i])))
      nearest.offer(node, i);
    count_steps(1);
  }
  nearest.propagate();

  std::vector<Set_contact> gaps;
  const auto add_gap = [&](Index i, Index j, bool is_face) {
    count_steps(1);
    if (set[i] == set[j])
      return;
    constexpr double largest_squared_gap = 1.5 * 1.5;
    const double d = quantized((points[i] - points[j]).squared_norm());
    gaps.push_back({{(std::min)(set[i], set[j]), (std::max)(set[i], set[j])}, d,
                    is_face && d <= largest_squared_gap ? std::size_t(1) : 0});
  };
  // Adds the gaps of pieces that are nearest to no node, because of other pieces in their cell.
  for (Index i = 0; i < points.size(); ++i)
    add_gap(i, nearest[grid.cell(points[i])], false);
  for (Index node = 0; node < grid.number_of_nodes(); ++node)
    grid.for_each_neighbor(node, [&](Index neighbor) {
      if (node < neighbor)
        add_gap(nearest[node], nearest[neighbor], true);
    });
  const auto key = [](const Set_contact& c) { return std::tie(c.sets[0], c.sets[1]); };
  std::sort(gaps.begin(), gaps.end(), [&](const Set_contact& a, const Set_contact& b) {
    count_steps(1);
    return key(a) < key(b);
  });
  std::vector<Set_contact> result;
  for (const Set_contact& gap : gaps)
    if (result.empty() || key(result.back()) != key(gap))
      result.push_back(gap);
    else {
      result.back().squared_gap = (std::min)(result.back().squared_gap, gap.squared_gap);
      result.back().area += gap.area;
    }
  std::sort(result.begin(), result.end(), [&](const Set_contact& a, const Set_contact& b) {
    count_steps(1);
    return std::tie(a.squared_gap, a.sets[0], a.sets[1]) <
           std::tie(b.squared_gap, b.sets[0], b.sets[1]);
  });
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SET_CONTACTS_H
