// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Spectral_segmentation::Segmentation_hierarchy Segmentation_hierarchy;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::size_t wanted = argc > 2 ? std::stoul(argv[2]) : 6;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // The search, which takes the time, is done once.
  Segmentation_hierarchy tree;
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  CGAL::segment_spectral_recursive(mesh, segment_ids, params::hierarchy(tree));

  // The two sides of each cut follow each other, the most salient cut first.
  std::cout << "segments  probability that a person makes the last cut\n";
  for (std::size_t i = tree.number_of_roots(); i < tree.number_of_nodes(); i += 2) {
    const std::size_t number_of_segments = 1 + (tree.number_of_roots() + i) / 2;
    std::cout << number_of_segments << "  " << tree.node(tree.node(i).parent).salience << '\n';
  }

  const std::size_t n = tree.write(mesh, segment_ids, tree.nodes(wanted));
  std::cout << n << " segments are written" << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
