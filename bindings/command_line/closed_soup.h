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

// Gives the corners of polygons the points of their triangles, whose borders are joined.
inline void join_borders(const Input& input, Polygon_soup& soup)
{
  mesh_file::Polygon_triangulation triangulate(input.soup.points);
  std::vector<Index> joined(input.soup.points.size()); // of the corners of a polygon
  std::vector<Triangle> given;                         // the triangles before borders were joined
  for (std::size_t i = 0, t = 0; i < soup.number_of_polygons(); ++i) {
    for (Index v : input.soup.polygon(i))
      joined[v] = v;
    given.clear();
    triangulate(input.soup.polygon(i), given);
    for (const Triangle& g : given) {
      for (std::size_t k = 0; k < 3; ++k)
        joined[g[k]] = input.triangles[t][k];
      ++t;
    }
    for (std::size_t c = soup.first_corner[i]; c < soup.first_corner[i + 1]; ++c)
      soup.corners[c] = joined[soup.corners[c]];
  }
}

// Returns the polygons, and after them the triangles that close their segments; and the segment of
// each. Borders of the input are joined. Further properties of new points and triangles are 0; new
// triangles have no material.
inline std::pair<Polygon_soup, std::vector<Index> > closed_soup(const Input& input,
                                                                std::vector<Index> segment)
{
  Polygon_soup soup = input.soup;
  join_borders(input, soup);
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
  if (!soup.material_of_polygon.empty())
    soup.material_of_polygon.resize(soup.number_of_polygons(), mesh_file::null_index);
  return {std::move(soup), std::move(segment)};
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_CLOSED_SOUP_H
