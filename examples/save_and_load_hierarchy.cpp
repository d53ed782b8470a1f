// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spectral_segmentation/IO/hierarchy.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Spectral_segmentation::Segmentation_hierarchy Segmentation_hierarchy;
namespace params = CGAL::parameters;

// Runs on a mesh, and saves the hierarchy.
int save(const std::string& filename)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  Segmentation_hierarchy hierarchy;
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  const std::size_t n =
    CGAL::segment_spectral_recursive(mesh, segment_ids, params::hierarchy(hierarchy));
  std::ofstream out("hierarchy.txt");
  write_hierarchy(out, hierarchy);
  std::cout << n << " segments, up to " << hierarchy.number_of_segments() << std::endl;
  return EXIT_SUCCESS;
}

// Writes the labels for another number of segments, without the mesh.
int load(std::size_t wanted)
{
  std::ifstream in("hierarchy.txt");
  const Segmentation_hierarchy hierarchy = CGAL::Spectral_segmentation::read_hierarchy(in);
  std::ofstream out("segments.txt");
  const std::vector<std::size_t> nodes = hierarchy.nodes(wanted);
  for (std::size_t label : hierarchy.labels(nodes))
    out << label << '\n';
  std::cout << nodes.size() << " segments are written" << std::endl;
  return EXIT_SUCCESS;
}

// Saves if the argument is the name of a mesh, and loads if it is a number.
int main(int argc, char* argv[])
{
  const std::string argument = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  try {
    const bool is_number = argument.find_first_not_of("0123456789") == std::string::npos;
    return is_number ? load(std::stoul(argument)) : save(argument);
  }
  catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
