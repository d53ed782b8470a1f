// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_GAPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_GAPS_H

#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The gap between two sets of faces, as wide as between the nearest pieces of them on a grid.
struct Gap
{
  double squared_width;
  Index sets[2]; // the smaller number first
};

// Returns gaps that form a minimum spanning tree of the sets, the narrowest first. The grid has at
// most a hundred cells along the mesh, and few for few faces.
inline std::vector<Gap> narrowest_gaps(const Surface& mesh, const std::vector<Index>& set_of_face,
                                       std::size_t number_of_sets)
{
  if (number_of_sets < 2)
    return {};
  const double number_of_cells =
    (std::min)(100., 4 * std::sqrt(static_cast<double>(mesh.number_of_faces())));
  const Bounding_box box(mesh.points);
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double scale = extent > 0 ? number_of_cells / extent : 0;
  std::vector<Vector> points; // of pieces
  std::vector<Index> set;     // of each piece
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

  std::vector<Gap> gaps;
  const auto add_gap = [&](Index i, Index j) {
    if (set[i] != set[j])
      gaps.push_back({quantized(squared_distance(i, points[j])),
                      {(std::min)(set[i], set[j]), (std::max)(set[i], set[j])}});
  };
  // Pieces in one cell that are nearest to no node
  for (Index i = 0; i < points.size(); ++i)
    add_gap(i, nearest.element(grid.cell(points[i])));
  for (Index node = 0; node < grid.number_of_nodes(); ++node)
    grid.for_each_neighbor(node, [&](Index neighbor) {
      if (node < neighbor)
        add_gap(nearest.element(node), nearest.element(neighbor));
    });
  std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
    return std::tie(a.squared_width, a.sets[0], a.sets[1]) <
           std::tie(b.squared_width, b.sets[0], b.sets[1]);
  });
  Joined_sets joined(number_of_sets);
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(), [&](const Gap& gap)
                            { return !joined.join(gap.sets[0], gap.sets[1]); }), gaps.end());
  CGAL_postcondition(gaps.size() + 1 == number_of_sets);
  return gaps;
}

// Merges what nothing joins, the nearest first, with an infinite salience, so that it comes apart at
// every threshold.
inline void merge_over_gaps(const Surface& mesh, Dendrogram& d)
{
  std::vector<Index> leaf_in(d.number_of_leaves()); // of each set: one of its leaves
  std::iota(leaf_in.begin(), leaf_in.end(), Index(0));
  const Components sets = replay(d, leaf_in, [](std::size_t, Index a, Index) { return a; });
  if (sets.number < 2)
    return;
  std::vector<Index> set_of_face;
  for (Index leaf : d.leaf)
    set_of_face.push_back(sets[leaf]);
  const std::vector<Index> set = number_by_first_faces(set_of_face);
  for (const Gap& gap : narrowest_gaps(mesh, set_of_face, sets.number)) {
    d.merges.emplace_back();
    d.merges.back().salience = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k)
      d.merges.back().leaves[k] = leaf_in[set[gap.sets[k]]];
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_GAPS_H
