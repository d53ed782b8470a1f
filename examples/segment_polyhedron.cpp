// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <unordered_map>

typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double> > Mesh;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::unordered_map<face_descriptor, std::size_t> segment_ids;
  const std::size_t n =
    CGAL::segment_spectral_recursive(mesh, boost::make_assoc_property_map(segment_ids));
  std::cout << n << " segments" << std::endl;

  std::ofstream out("segments.txt");
  for (face_descriptor f : faces(mesh))
    out << segment_ids[f] << '\n';
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
