// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Segmented_mesh/segment_boundaries.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  std::cout << CGAL::segment_spectral_recursive(mesh, segment_ids) << " segments" << std::endl;

  // All is well but one boundary: the two faces at it get the same seed, and so belong together.
  // The other boundaries must stay.
  auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  auto seeds = mesh.add_property_map<Mesh::Face_index, int>("f:seed", -1).first;
  CGAL::mark_segment_boundaries(mesh, segment_ids, is_seam);
  const auto boundaries = CGAL::segment_boundaries(mesh, segment_ids);
  if (!boundaries.empty()) {
    const auto unwanted = boundaries.front();
    seeds[mesh.face(unwanted.halfedges.front())] = 0;
    seeds[mesh.face(mesh.opposite(unwanted.halfedges.front()))] = 0;
    for (const auto& b : boundaries)
      if (b.segments == unwanted.segments)
        for (Mesh::Halfedge_index h : b.halfedges)
          is_seam[mesh.edge(h)] = false;
  }
  std::cout << CGAL::segment_spectral_recursive(
    mesh, segment_ids, params::face_seed_map(seeds).edge_is_constrained_map(is_seam))
            << " segments with constraints" << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
