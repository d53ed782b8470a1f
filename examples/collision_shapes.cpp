// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);

  std::vector<std::vector<Point> > points(n);
  for (Mesh::Face_index f : faces(mesh))
    for (Mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
      points[segment_ids[f]].push_back(mesh.point(v));

  double volume = 0;
  std::size_t number_of_shapes = 0, number_of_faces = 0;
  for (const std::vector<Point>& points_of_segment : points) {
    Mesh hull;
    CGAL::convex_hull_3(points_of_segment.begin(), points_of_segment.end(), hull);
    if (!CGAL::is_closed(hull) || !CGAL::is_triangle_mesh(hull) || PMP::volume(hull) <= 0)
      continue; // simulators reject flat shapes
    if (!CGAL::IO::write_STL("hull_" + std::to_string(number_of_shapes++) + ".stl", hull))
      return EXIT_FAILURE;
    volume += PMP::volume(hull);
    number_of_faces += num_faces(hull);
  }

  Mesh hull_of_mesh;
  CGAL::convex_hull_3(mesh.points().begin(), mesh.points().end(), hull_of_mesh);
  std::cout << number_of_shapes << " convex shapes with " << number_of_faces
            << " faces in place of " << num_faces(mesh) << "; they take "
            << 100 * volume / PMP::volume(hull_of_mesh)
            << " % of the space of one shape around all" << std::endl;
  return EXIT_SUCCESS;
}
