// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_REFINED_INPUT_H
#define SEGMENT_MESH_REFINED_INPUT_H

#include "read_input.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace segment_mesh {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// A manifold mesh of the triangles, the i-th of which becomes the i-th face.
inline Mesh mesh_of(const Input& input)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Mesh::Point> points;
  for (const Point& p : input.soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<Triangle> triangles = input.triangles;
  PMP::orient_polygon_soup(points, triangles);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  if (mesh.number_of_faces() != triangles.size())
    throw Failure(Status::MESH, "the faces of the input cannot be joined to a mesh, whose "
                                "boundaries could be refined");
  return mesh;
}

typedef std::pair<Input, std::vector<Index> > Labeled_input;

// The triangles after their boundaries were refined, and the segment of each.
inline Labeled_input refined_input(const Input& input,
                                   const std::vector<Index>& segment_of_triangle)
{
  Mesh mesh = mesh_of(input);
  const auto segment_ids = mesh.add_property_map<Mesh::Face_index, Index>("f:segment").first;
  for (Mesh::Face_index f : mesh.faces())
    segment_ids[f] = segment_of_triangle[f];
  CGAL::refine_segment_boundaries(mesh, segment_ids);

  Scene scene;
  Polygon_soup& soup = scene.soup;
  std::vector<Index> segment;
  for (Mesh::Vertex_index v : mesh.vertices())
    soup.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (Mesh::Face_index f : mesh.faces()) {
    for (Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      soup.corners.push_back(v);
    soup.end_polygon();
    segment.push_back(segment_ids[f]);
  }
  return {triangulated(std::move(scene)), std::move(segment)};
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_REFINED_INPUT_H
