// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SIZED_MESH_H
#define SEGMENTATION_BENCHMARK_SIZED_MESH_H

#include "princeton_benchmark.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <utility>

namespace segmentation_benchmark {

inline void collapse_edges(Mesh& mesh, std::size_t number_of_faces)
{
  if (mesh.number_of_faces() <= number_of_faces)
    return;
  CGAL::Surface_mesh_simplification::edge_collapse(
    mesh, [number_of_faces](const auto&, const auto& profile, std::size_t, std::size_t)
    { return profile.surface_mesh().number_of_faces() <= number_of_faces; });
  mesh.collect_garbage();
}

// Returns the shape of a mesh in about so many faces. For more faces than the mesh has, edges are
// collapsed until a quarter, a sixteenth and so on of this number is left; then Loop subdivision
// makes four faces of each.
inline Mesh with_size(Mesh mesh, std::size_t number_of_faces)
{
  unsigned int number_of_subdivisions = 0;
  for (; number_of_faces > mesh.number_of_faces(); number_of_faces /= 4)
    ++number_of_subdivisions;
  collapse_edges(mesh, number_of_faces);
  CGAL::Subdivision_method_3::Loop_subdivision(
    mesh, CGAL::parameters::number_of_iterations(number_of_subdivisions));
  return mesh;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SIZED_MESH_H
