// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename =
    argc > 1 ? argv[1] : CGAL::data_file_path("meshes/double-torus-example.off");

  // Reads OFF, OBJ, PLY, STL and more as a polygon soup, joins equal points, drops polygons that
  // occur twice, makes neighbors agree in orientation, and duplicates vertices and edges where the
  // surface is not a manifold.
  Mesh mesh;
  if (!PMP::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const std::size_t number_of_polygons = num_faces(mesh);

  PMP::triangulate_faces(mesh);

  // The limbs of an inside-out mesh would be taken for pits.
  if (CGAL::is_closed(mesh))
    PMP::orient(mesh);

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  std::cout << number_of_polygons << " polygons, " << num_faces(mesh) << " triangles, " << n
            << " segments" << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
