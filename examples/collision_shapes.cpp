// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

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

  Mesh shapes;
  for (const std::vector<Point>& points_of_segment : points) {
    Mesh hull;
    CGAL::convex_hull_3(points_of_segment.begin(), points_of_segment.end(), hull);
    CGAL::copy_face_graph(hull, shapes);
  }

  Mesh hull_of_mesh;
  CGAL::convex_hull_3(mesh.points().begin(), mesh.points().end(), hull_of_mesh);
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::cout << n << " convex shapes with " << num_faces(shapes) << " faces in place of "
            << num_faces(mesh) << "; they take "
            << 100 * PMP::volume(shapes) / PMP::volume(hull_of_mesh)
            << " % of the space of one shape around all" << std::endl;
  return CGAL::IO::write_polygon_mesh("collision_shapes.ply", shapes) ? EXIT_SUCCESS : EXIT_FAILURE;
}
