// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

typedef OpenMesh::TriMesh_ArrayKernelT<> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, filename))
    return EXIT_FAILURE;

  std::vector<std::size_t> segment_ids(mesh.n_faces());
  const std::size_t n = CGAL::segment_spectral_recursive(
    mesh, boost::make_iterator_property_map(segment_ids.begin(), get(CGAL::face_index, mesh)));
  std::cout << n << " segments" << std::endl;

  std::mt19937 random;
  std::vector<Mesh::Color> colors;
  for (std::size_t i = 0; i < n; ++i)
    colors.emplace_back(random() % 256, random() % 256, random() % 256);
  mesh.request_face_colors();
  for (Mesh::FaceHandle f : mesh.faces())
    mesh.set_color(f, colors[segment_ids[f.idx()]]);
  return OpenMesh::IO::write_mesh(mesh, "segments.ply", OpenMesh::IO::Options::FaceColor)
    ? EXIT_SUCCESS : EXIT_FAILURE;
}
