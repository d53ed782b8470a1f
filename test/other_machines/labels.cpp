// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// labels FILE.off
// Prints the labels of each face by the default method and by the method of the paper, one face a
// line. scripts/check_machines.sh builds it for other machines and compares the output.

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Labels;
namespace parameters = CGAL::Spectral_segmentation::parameters;

int main(int argc, char* argv[])
try {
  std::ifstream in(argc == 2 ? argv[1] : "");
  Mesh mesh;
  if (!CGAL::IO::read_OFF(in, mesh)) {
    std::cerr << "usage: labels FILE.off, of a triangle mesh" << std::endl;
    return EXIT_FAILURE;
  }
  Labels by_default = mesh.add_property_map<Mesh::Face_index, std::size_t>("by_default").first;
  Labels of_paper = mesh.add_property_map<Mesh::Face_index, std::size_t>("of_paper").first;
  CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(mesh, by_default);
  CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(mesh, of_paper,
                                                         parameters::zhang_liu_2005());
  for (Mesh::Face_index f : faces(mesh))
    std::cout << by_default[f] << ' ' << of_paper[f] << '\n';
  return EXIT_SUCCESS;
}
catch (const std::exception& e) {
  std::cerr << "labels: " << e.what() << std::endl;
  return EXIT_FAILURE;
}
