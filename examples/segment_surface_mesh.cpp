// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh))
    return EXIT_FAILURE;
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  std::cout << CGAL::segment_spectral_recursive(mesh, segment_ids) << " segments" << std::endl;

  // Viewers know the property of this name. Hues that differ by the golden angle are unlike.
  auto colors = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (Mesh::Face_index f : mesh.faces())
    colors[f].set_hsv(std::fmod(137.508 * segment_ids[f], 360), 60, 95);
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
