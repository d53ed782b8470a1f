// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_SET_CONTACTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_SET_CONTACTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid.h>
#include <CGAL/Spectral_segmentation/internal/grid/Nearest_elements.h>
#include <CGAL/Spectral_segmentation/internal/surface/number_of_added_faces.h>
#include <CGAL/Spectral_segmentation/internal/grid/triangle_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The contact of two sets of faces. Lengths are measured in cells of a grid of at most a hundred
// cells along the longest side of the bounding box.
struct Set_contact
{
  Index sets[2]; // the smaller first
  double squared_gap;
  std::size_t area; // where the sets are nearer than 1.5 cells, in faces of cells
};

// Returns how many cells there are along the longest side of the bounding box. Few faces get few
// cells. Cells are larger if faces would be cut into more than a million pieces: large faces, of
// which there are few in a usual mesh, or many needles.
inline double number_of_cells(const Surface& mesh, double extent)
{
  constexpr double largest_number_of_pieces = 1e6;
  const std::vector<double> longest = longest_edges_of_faces(Execution::SEQUENTIAL, mesh);
  double result = (std::min)(100., 4 * std::sqrt(static_cast<double>(mesh.number_of_faces())));
  while (result > 1 &&
         number_of_added_faces(mesh, longest, extent / result) > largest_number_of_pieces)
    result *= 0.8;
  return result;
}

// Receives numbers of short steps that were made, and may throw.
typedef std::function<void(std::size_t)> Step_counter;

// Returns the contacts of sets that are neighbors, the smallest gap first. They connect all sets.
inline std::vector<Set_contact> set_contacts(
  const Surface& mesh, const std::vector<Index>& set_of_face,
  const Step_counter& count_steps = [](std::size_t) {})
{
  Bounding_box box(mesh.points);
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double scale = extent > 0 ? number_of_cells(mesh, extent) / extent : 0;
  std::vector<Vector> points; // one per piece
  std::vector<Index> set;     // one per piece
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    const Corners& c = mesh.corners[f];
    const std::size_t first = points.size();
    for_each_piece({scale * mesh.points[c[0]], scale * mesh.points[c[1]],
                    scale * mesh.points[c[2]]}, 1, [&](const Triangle& piece, double) {
      points.push_back((piece[0] + piece[1] + piece[2]) / 3);
      set.push_back(set_of_face[f]);
    });
    count_steps(points.size() - first);
  }
  const Grid grid(Bounding_box(points), 1);
  const auto squared_distance = [&](Index i, const Vector& p)
  { return (points[i] - p).squared_norm(); };
  const auto reaches = [&](Index, float) {
    count_steps(1);
    return true;
  };
  Nearest_elements<decltype(squared_distance), decltype(reaches)>
    nearest(grid, squared_distance, reaches);
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
    const double d = quantized(squared_distance(i, points[j]));
    gaps.push_back({{(std::min)(set[i], set[j]), (std::max)(set[i], set[j])}, d,
                    is_face && d <= largest_squared_gap ? std::size_t(1) : 0});
  };
  // Adds the gaps of pieces that are nearest to no node, because they share their cell.
  for (Index i = 0; i < points.size(); ++i)
    add_gap(i, nearest.element(grid.cell(points[i])), false);
  for (Index node = 0; node < grid.number_of_nodes(); ++node)
    grid.for_each_neighbor(node, [&](Index neighbor) {
      if (node < neighbor)
        add_gap(nearest.element(node), nearest.element(neighbor), true);
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_SET_CONTACTS_H
