// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>
#include <CGAL/Segmented_mesh/split_into_segments.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  CGAL::segment_spectral_recursive(mesh, segment_ids);
  CGAL::refine_segment_boundaries(mesh, segment_ids); // smooth seams, not along the edges

  std::vector<Mesh> parts;
  CGAL::split_into_segments(mesh, segment_ids, parts,
                            CGAL::parameters::close_parts(true));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::cout << "part " << i << ": volume " << PMP::volume(parts[i]) << std::endl;
    if (!CGAL::IO::write_polygon_mesh("part_" + std::to_string(i) + ".off", parts[i],
                                      CGAL::parameters::stream_precision(17)))
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
