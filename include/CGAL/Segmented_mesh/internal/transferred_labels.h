// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_TRANSFERRED_LABELS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_TRANSFERRED_LABELS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/surface/Face_tree.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns whether the i-th faces of both surfaces are the same face for each i: they have the same
// vertices, whose points may have moved, or the same points. Equal vertices mean nothing if no two
// faces are adjacent, because every such surface may have them.
inline bool have_equal_faces(const Surface& a, const Surface& b)
{
  if (a.number_of_faces() != b.number_of_faces())
    return false;
  Index h = 0;
  while (h < a.number_of_halfedges() && a.is_border(h))
    ++h;
  if (h < a.number_of_halfedges() && a.corners == b.corners && a.opposite == b.opposite)
    return true;
  std::vector<Triangle> triangles_a = triangles_of(a), triangles_b = triangles_of(b);
  for (std::vector<Triangle>* triangles : {&triangles_a, &triangles_b})
    for (Triangle& t : *triangles)
      std::sort(t.begin(), t.end());
  return triangles_a == triangles_b;
}

// Moves the triangles of two surfaces into [-1, 1]^3.
inline void normalize_together(std::vector<Triangle>& a, std::vector<Triangle>& b)
{
  std::vector<Vector> points;
  for (const std::vector<Triangle>* triangles : {&a, &b})
    for (const Triangle& t : *triangles)
      points.insert(points.end(), t.begin(), t.end());
  normalize(points);
  auto p = points.begin();
  for (std::vector<Triangle>* triangles : {&a, &b})
    for (Triangle& t : *triangles)
      for (Vector& corner : t)
        corner = *p++;
}

// Gives small pieces that have come off their segments to the segments around them. `source` holds
// the face of `from` from which each face of `to` has its label. Two pieces of `to` belong to one
// segment if most of their areas are from the same connected set of faces with one label.
inline void remove_islands(const Surface& from, const std::vector<Index>& from_labels,
                           const Surface& to, const std::vector<Index>& source,
                           const std::vector<double>& areas, std::vector<Index>& labels)
{
  constexpr double largest_island = 0.1; // relative to the largest piece of the segment
  const Components segments = connected_components(from, from_labels);
  const Components pieces = connected_components(to, labels);
  std::vector<double> area_of_piece(pieces.number, 0);
  std::vector<std::map<Index, double> > areas_from(pieces.number); // keys: segments
  for (Index f = 0; f < labels.size(); ++f) {
    area_of_piece[pieces[f]] += areas[f];
    areas_from[pieces[f]][segments[source[f]]] += areas[f];
  }
  std::vector<Index> segment_of_piece;
  std::vector<double> largest_area(segments.number, 0);
  for (std::size_t i = 0; i < pieces.number; ++i) {
    segment_of_piece.push_back(
      std::max_element(areas_from[i].begin(), areas_from[i].end(), [](const auto& a, const auto& b)
                         { return a.second < b.second; })->first);
    double& largest = largest_area[segment_of_piece[i]];
    largest = (std::max)(largest, area_of_piece[i]);
  }

  std::vector<char> is_in_island(labels.size());
  std::vector<Index> reached;
  for (Index f = 0; f < labels.size(); ++f) {
    is_in_island[f] = area_of_piece[pieces[f]] <
                      largest_island * largest_area[segment_of_piece[pieces[f]]];
    if (!is_in_island[f])
      reached.push_back(f);
  }
  for (std::size_t i = 0; i < reached.size(); ++i) // an island without a neighbor keeps its label
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
      const Index f = to.neighbor(h);
      if (is_in_island[f]) {
        is_in_island[f] = false;
        labels[f] = labels[reached[i]];
        reached.push_back(f);
      }
    }
}

// Returns a label for each face of `to`: the label of the face of `from` that is nearest to its
// centroid. A face of `from` that faces away counts as farther by the length of an edge, so that
// the sides of a thin sheet are distinguished; in a fold it may still be the right one.
inline std::vector<Index> transferred_labels(const Surface& from,
                                             const std::vector<Index>& from_labels,
                                             const Surface& to)
{
  if (have_equal_faces(from, to))
    return from_labels;
  std::vector<Triangle> from_triangles = triangles_of(from), to_triangles = triangles_of(to);
  normalize_together(from_triangles, to_triangles);
  double mean_square = 0; // mean squared longest edge of the faces of `from`
  for (const Triangle& t : from_triangles)
    mean_square += squared_longest_edge(t) / static_cast<double>(from_triangles.size());

  const Face_tree tree(from_triangles);
  std::vector<Index> source, labels;
  std::vector<double> areas;
  for (const Triangle& t : to_triangles) {
    const Vector normal = triangle_normal(t);
    source.push_back(tree.nearest((t[0] + t[1] + t[2]) / 3, normal,
                                  mean_square + squared_longest_edge(t)));
    labels.push_back(from_labels[source.back()]);
    areas.push_back(normal.norm() / 2);
  }
  remove_islands(from, from_labels, to, source, areas, labels);
  return labels;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_TRANSFERRED_LABELS_H
