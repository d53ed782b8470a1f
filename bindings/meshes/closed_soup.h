// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_CLOSED_SOUP_H
#define SEGMENT_MESH_CLOSED_SOUP_H

#include "read_input.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Segmented_mesh/close_segments.h>
#include <CGAL/Surface_mesh.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
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

typedef std::vector<CGAL::Segmented_mesh::Closed_segment<Index> > Closed_segments;

struct Closed_soup
{
  Polygon_soup soup;
  std::vector<Index> segment; // one per polygon
  Closed_segments segments;
};

inline std::size_t number_of_solids(const Closed_soup& closed)
{
  return static_cast<std::size_t>(std::count_if(closed.segments.begin(), closed.segments.end(),
                                                [](const auto& s) { return s.is_solid(); }));
}

// Returns the volumes of the segments that are solids, and NaN for all others.
inline std::vector<double> volumes_of_solids(const Closed_segments& segments,
                                             std::size_t number_of_segments)
{
  std::vector<double> result(number_of_segments, std::numeric_limits<double>::quiet_NaN());
  for (const auto& s : segments)
    if (s.is_solid())
      result[s.id] = s.volume;
  return result;
}

// Returns the polygons, and after them the triangles that close their segments. Borders of the
// input are joined. Further properties of new points and triangles are 0;
// new triangles have no material.
inline Closed_soup closed_soup(const Input& input, std::vector<Index> segment)
{
  Polygon_soup soup = input.soup;
  join_borders(input, soup);
  std::vector<Triangle> triangles = input.triangles;
  std::vector<Index> segment_of_triangle;
  for (Index polygon : input.polygon_of_triangle)
    segment_of_triangle.push_back(segment[polygon]);
  const std::size_t first_cap = triangles.size();
  Closed_segments closed_segments =
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
  return {std::move(soup), std::move(segment), std::move(closed_segments)};
}

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

// Returns the triangles as a mesh, in their order. Points are doubled where it is no manifold.
inline Mesh mesh_of(const Input& input)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Mesh::Point> points;
  for (const Point& p : input.soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<Triangle> triangles = input.triangles;
  for (Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == t[(k + 1) % 3] || t[k] == t[(k + 2) % 3]) {
        const Mesh::Point p = points[t[k]];
        t[k] = static_cast<Index>(points.size());
        points.push_back(p);
      }
  if (!PMP::is_polygon_soup_a_polygon_mesh(triangles))
    PMP::orient_polygon_soup(points, triangles);
  Mesh result;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, result);
  return result;
}

// Returns the number of pairs of triangles that intersect outside their common corners, without
// pairs that meet where the surface is not a manifold. Stops after reading 1000 points per
// triangle, which bounds the time if very many boxes overlap.
inline std::size_t number_of_intersecting_pairs(const Input& input)
{
  const Mesh mesh = mesh_of(input);
  struct Enough {};
  std::size_t points_left = 1000 * mesh.number_of_faces();
  const auto point_of = boost::make_function_property_map<Mesh::Vertex_index, const Mesh::Point&>(
    [&](Mesh::Vertex_index v) -> const Mesh::Point& {
      if (points_left-- == 0)
        throw Enough();
      return mesh.point(v);
    });
  std::size_t result = 0;
  const auto count = [&](const auto& pair) { // of one face if it is degenerate
    bool is_counted = pair.first != pair.second;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(pair.first)))
      for (Mesh::Vertex_index w : mesh.vertices_around_face(mesh.halfedge(pair.second)))
        is_counted &= v == w || mesh.point(v) != mesh.point(w); // a point that was repeated
    result += is_counted;
  };
  try {
    CGAL::Polygon_mesh_processing::self_intersections(
      mesh, boost::make_function_output_iterator(count),
      CGAL::parameters::vertex_point_map(point_of));
  }
  catch (const Enough&) {
  }
  return result;
}

// Returns what holds for each closed segment.
inline nlohmann::ordered_json closed_report(const Closed_segments& segments)
{
  auto result = nlohmann::ordered_json::array();
  for (const auto& s : segments)
    result.push_back({{"label", s.id},
                      {"is_solid", s.is_solid()},
                      {"is_closed", s.is_closed},
                      {"is_manifold", s.is_manifold},
                      {"is_outward_oriented", s.is_outward_oriented},
                      {"has_self_intersections", s.has_self_intersections},
                      {"volume", s.volume}});
  return result;
}

// Returns a message about the segments that bound no solid; it is empty if all do.
inline std::string closed_warning(const Closed_segments& segments)
{
  std::string list;
  std::size_t n = 0;
  for (const auto& s : segments) {
    if (s.is_solid())
      continue;
    const char* reason = !s.is_closed              ? "not closed"
                         : s.has_self_intersections ? "intersects itself"
                         : !s.is_manifold           ? "touches itself"
                                                    : "inside out";
    if (++n <= 10)
      list += (n > 1 ? ", " : "") + std::to_string(s.id) + " (" + reason + ")";
  }
  if (n == 0)
    return "";
  return std::to_string(n) + " of " + std::to_string(segments.size()) +
         (segments.size() == 1 ? " closed segment bounds" : " closed segments bound") +
         " no solid: " + list + (n > 10 ? " ..." : "") +
         (segments.size() == 1 ? "" : "; another number of --segments may give solids");
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_CLOSED_SOUP_H
