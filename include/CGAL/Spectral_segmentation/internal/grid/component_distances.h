// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_COMPONENT_DISTANCES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_COMPONENT_DISTANCES_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid.h>
#include <CGAL/Spectral_segmentation/internal/grid/Nearest_elements.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/grid/triangle_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the pairs of sets of faces that a minimum spanning tree of the sets joins, the nearest
// first. Distances are measured between pieces of faces, on a grid of at most a hundred cells along
// the mesh.
inline std::vector<std::pair<Index, Index> >
nearest_sets_of_faces(const Surface& mesh, const std::vector<Index>& set_of_face,
                      std::size_t number_of_sets)
{
  // The cells are counted along the longest side of the bounding box. Few faces get few cells.
  const double number_of_cells =
    (std::min)(100., 4 * std::sqrt(static_cast<double>(mesh.number_of_faces())));
  std::vector<std::pair<Index, Index> > result;
  if (number_of_sets < 2)
    return result;
  Bounding_box box(mesh.points);
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double scale = extent > 0 ? number_of_cells / extent : 0;
  std::vector<Vector> points; // one per piece
  std::vector<Index> set;     // one per piece
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    const Corners& c = mesh.corners[f];
    for_each_piece({scale * mesh.points[c[0]], scale * mesh.points[c[1]],
                    scale * mesh.points[c[2]]}, 1, [&](const Triangle& piece, double) {
      points.push_back((piece[0] + piece[1] + piece[2]) / 3);
      set.push_back(set_of_face[f]);
    });
  }
  const Grid grid(Bounding_box(points), 1);
  const auto squared_distance = [&](Index i, const Vector& p)
  { return (points[i] - p).squared_norm(); };
  const auto reaches = [](Index, float) { return true; };
  Nearest_elements<decltype(squared_distance), decltype(reaches)>
    nearest(grid, squared_distance, reaches);
  for (Index i = 0; i < points.size(); ++i)
    for (Index node : grid.corners(grid.cell(points[i])))
      nearest.offer(node, i);
  nearest.propagate();

  struct Gap
  {
    double squared_distance;
    Index sets[2];
  };
  std::vector<Gap> gaps;
  const auto add_gap = [&](Index i, Index j) {
    if (set[i] != set[j])
      gaps.push_back({quantized(squared_distance(i, points[j])),
                      {(std::min)(set[i], set[j]), (std::max)(set[i], set[j])}});
  };
  // Adds the gaps of pieces that are nearest to no node, because they share their cell.
  for (Index i = 0; i < points.size(); ++i)
    add_gap(i, nearest.element(grid.cell(points[i])));
  for (Index node = 0; node < grid.number_of_nodes(); ++node)
    grid.for_each_neighbor(node, [&](Index neighbor) {
      if (node < neighbor)
        add_gap(nearest.element(node), nearest.element(neighbor));
    });
  std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
    return std::tie(a.squared_distance, a.sets[0], a.sets[1]) <
           std::tie(b.squared_distance, b.sets[0], b.sets[1]);
  });
  Face_components joined(number_of_sets);
  for (Index i = 0; i < number_of_sets; ++i)
    joined.add(i);
  for (const Gap& gap : gaps)
    if (joined.representative(gap.sets[0]) != joined.representative(gap.sets[1])) {
      joined.join(gap.sets[0], gap.sets[1]);
      result.emplace_back(gap.sets[0], gap.sets[1]);
    }
  CGAL_postcondition(result.size() + 1 == number_of_sets);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_COMPONENT_DISTANCES_H
