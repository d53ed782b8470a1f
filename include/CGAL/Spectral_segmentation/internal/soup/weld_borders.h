// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SOUP_WELD_BORDERS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SOUP_WELD_BORDERS_H

#include <CGAL/Spectral_segmentation/internal/soup/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/face_groups.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns a representative for each vertex. Vertices of one group on the border that are nearer to
// each other than `width` have the same; others, up to a few widths apart, may have.
inline std::vector<Index> welded_vertices(const Surface& surface, double width)
{
  typedef std::array<std::int64_t, 4> Cell; // the last coordinate is the group
  const std::vector<Index> group = groups_of_vertices(surface);
  std::vector<char> is_on_border(surface.points.size(), 0);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_border(h))
      is_on_border[surface.source_vertex(h)] = is_on_border[surface.target_vertex(h)] = 1;
  std::vector<std::pair<Cell, Index> > vertices;
  Face_components sets(surface.points.size()); // of vertices
  for (Index v = 0; v < surface.points.size(); ++v) {
    sets.add(v);
    const Vector& p = surface.points[v];
    if (is_on_border[v])
      vertices.push_back({{std::llround(p.x() / width), std::llround(p.y() / width),
                           std::llround(p.z() / width), group[v]}, v});
  }
  std::sort(vertices.begin(), vertices.end());
  for (const auto& [c, v] : vertices)
    for (int i = 0; i < 14; ++i) { // half of the cells around, and its own
      const Cell near = {c[0] + i / 9 - 1, c[1] + i / 3 % 3 - 1, c[2] + i % 3 - 1, c[3]};
      const auto found = std::lower_bound(vertices.begin(), vertices.end(),
                                          std::make_pair(near, Index(0)));
      if (found != vertices.end() && found->first == near)
        sets.join(v, found->second);
    }
  std::vector<Index> result;
  for (Index v = 0; v < surface.points.size(); ++v)
    result.push_back(sets.representative(v));
  return result;
}

// Connects faces whose border edges meet, as the patches of a model that nobody welded: they are
// one surface, and where a patch ends, nothing ends. Points count as equal if they are nearer than
// 10^-4 of the diagonal of the bounding box. The faces of the surface keep their order.
inline void weld_borders(Surface& surface)
{
  const Bounding_box box(surface.points);
  const double width = 1e-4 * (box.largest - box.smallest).norm();
  if (!(width > 0))
    return;
  const std::vector<Index> vertex = welded_vertices(surface, width);
  std::vector<char> is_kept(vertex.size(), 0); // because a face would lose a corner
  for (const auto& [a, b, c] : surface.corners)
    if (vertex[a] == vertex[b] || vertex[b] == vertex[c] || vertex[c] == vertex[a])
      is_kept[a] = is_kept[b] = is_kept[c] = 1;
  bool is_changed = false;
  for (Corners& corners : surface.corners)
    for (Index& v : corners)
      if (!is_kept[v] && vertex[v] != v) {
        v = vertex[v];
        is_changed = true;
      }
  if (!is_changed)
    return;
  connect_triangles(surface);
  surface.components = connected_components(surface);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SOUP_WELD_BORDERS_H
