// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Segmented_mesh/segment_boundaries.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

// Returns the length of the marked edges.
template <class EdgeIsConstrainedMap>
double length(const Mesh& mesh, EdgeIsConstrainedMap is_seam)
{
  double result = 0;
  for (Mesh::Edge_index e : edges(mesh))
    if (get(is_seam, e))
      result += PMP::edge_length(halfedge(e, mesh), mesh);
  return result;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  CGAL::mark_segment_boundaries(mesh, segment_ids, is_seam);
  std::cout << "before: " << n << " segments, length of seams " << length(mesh, is_seam) << '\n';

  // Seams stay where they are; so those that are too long for the remeshing are split before.
  const double edge_length = std::sqrt(PMP::area(mesh) / double(num_faces(mesh)));
  std::vector<Mesh::Edge_index> seams;
  for (Mesh::Edge_index e : edges(mesh))
    if (is_seam[e])
      seams.push_back(e);
  PMP::split_long_edges(seams, edge_length, mesh,
                        CGAL::parameters::edge_is_constrained_map(is_seam));
  PMP::isotropic_remeshing(
    faces(mesh), edge_length, mesh,
    CGAL::parameters::edge_is_constrained_map(is_seam).protect_constraints(true));
  mesh.collect_garbage();

  // The faces are new: segments are now the connected components between seams.
  const std::size_t m = PMP::connected_components(
    mesh, segment_ids, CGAL::parameters::edge_is_constrained_map(is_seam));
  std::cout << "after: " << m << " segments, length of seams " << length(mesh, is_seam)
            << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
