// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_FACE_GROUPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_FACE_GROUPS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the group of each vertex, whose faces are of one group; 0 if there are no groups.
inline std::vector<Index> groups_of_vertices(const Surface& surface)
{
  std::vector<Index> result(surface.points.size(), 0);
  for (Index f = 0; f < surface.groups.size(); ++f)
    for (Index v : surface.corners[f])
      result[v] = surface.groups[f];
  return result;
}

// Gives each part its own vertices, by copies. A part is a set of faces, which has a number.
template <class PartOfFace>
void separate_vertices(Surface& surface, const PartOfFace& part_of_face)
{
  start_at_smallest_vertices(surface); // so that copies get the same indices in soups and meshes
  std::vector<Index> part(surface.points.size(), null_index); // the part that keeps the vertex
  std::map<std::pair<Index, Index>, Index> copies;            // of a vertex, for another part
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (Index& v : surface.corners[f]) {
      const Index p = part_of_face[f];
      if (part[v] == null_index)
        part[v] = p;
      if (part[v] == p)
        continue;
      const auto [copy, is_new] =
        copies.emplace(std::make_pair(v, p), static_cast<Index>(surface.points.size()));
      if (is_new)
        surface.points.push_back(Vector(surface.points[v]));
      v = copy->second;
    }
  start_at_smallest_vertices(surface);
}

// Separates the groups of faces: each gets its own vertices, and edges between groups become
// borders.
inline void separate_groups(Surface& surface)
{
  if (surface.groups.empty())
    return;
  separate_vertices(surface, surface.groups);
  for (Index h = 0; h < surface.opposite.size(); ++h)
    if (const Index o = surface.opposite[h]; surface.groups[h / 3] != surface.groups[o / 3]) {
      surface.opposite[h] = h;
      surface.opposite[o] = o;
    }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_FACE_GROUPS_H
