// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Face_index Face;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Face, int>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);

  std::vector<std::size_t> sizes(n);
  for (Face f : faces(mesh))
    ++sizes[segment_ids[f]];
  const std::size_t largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();

  // Only the segment with the most faces is cut again, into up to four, by less salient cuts.
  const CGAL::Face_filtered_graph<Mesh> region(mesh, largest, segment_ids);
  auto region_ids = mesh.add_property_map<Face, int>("f:segment_of_region").first;
  const std::size_t m = CGAL::segment_spectral_recursive(
    region, region_ids, params::salience_threshold(0.1).maximum_number_of_segments(4));
  std::cout << n << " segments; segment " << largest << " is cut in " << m << " again" << std::endl;

  // One of the new segments keeps the id, the others get ids behind those of the first run.
  for (Face f : faces(region))
    if (region_ids[f] > 0)
      segment_ids[f] = n - 1 + region_ids[f];
  mesh.remove_property_map(region_ids);
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
