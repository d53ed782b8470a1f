// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_CLOSED_SOUP_H
#define SEGMENT_MESH_CLOSED_SOUP_H

#include "read_input.h"

#include <CGAL/Segmented_mesh/close_segments.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace segment_mesh {

// The polygons, and after them the triangles that close their segments; and the segment of each.
// Further properties of new points and triangles are 0.
inline std::pair<Polygon_soup, std::vector<Index> > closed_soup(const Input& input,
                                                                std::vector<Index> segment)
{
  Polygon_soup soup = input.soup;
  std::vector<Triangle> triangles = input.triangles;
  std::vector<Index> segment_of_triangle;
  for (Index polygon : input.polygon_of_triangle)
    segment_of_triangle.push_back(segment[polygon]);
  const std::size_t first_cap = triangles.size();
  CGAL::close_segments(soup.points, triangles, segment_of_triangle);
  for (std::size_t t = first_cap; t < triangles.size(); ++t) {
    soup.corners.insert(soup.corners.end(), triangles[t].begin(), triangles[t].end());
    soup.end_polygon();
    segment.push_back(segment_of_triangle[t]);
  }
  for (mesh_file::Property& p : soup.point_properties)
    p.values.resize(soup.points.size());
  for (mesh_file::Property& p : soup.polygon_properties)
    p.values.resize(soup.number_of_polygons());
  for (std::vector<Index>* list : {&soup.texture_of_corner, &soup.normal_of_corner})
    if (!list->empty())
      list->resize(soup.corners.size(), mesh_file::null_index);
  return {std::move(soup), std::move(segment)};
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_CLOSED_SOUP_H
