// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Colors the faces of a mesh by their place on the line on which the first cut is searched.

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spectral_embedding.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Face_index Face;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto coordinate = mesh.add_property_map<Face, double>("f:coordinate").first;
  const std::vector<Face> samples = CGAL::spectral_embedding(mesh, coordinate);
  std::cout << "samples: faces " << samples[0] << " and " << samples[1] << std::endl;

  // Colors go from blue to red by rank, because the search uses only the order of the coordinates.
  std::vector<Face> line(mesh.faces().begin(), mesh.faces().end());
  std::sort(line.begin(), line.end(),
            [&](Face f, Face g) { return coordinate[f] < coordinate[g]; });
  auto color = mesh.add_property_map<Face, CGAL::IO::Color>("f:color").first;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto red = static_cast<unsigned char>(255 * i / line.size());
    color[line[i]] = CGAL::IO::Color(red, 80, 255 - red);
  }
  std::ofstream out("embedding.ply", std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, mesh);
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
