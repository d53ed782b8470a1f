// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_COLORED_MESH_H
#define SEGMENTATION_BENCHMARK_COLORED_MESH_H

#include "princeton_benchmark.h"

#include "../bindings/files/segment_colors.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <vector>

namespace segmentation_benchmark {

typedef Mesh::Property_map<Mesh::Face_index, int> Segment_map;

inline std::vector<std::vector<std::size_t> >
segment_neighbors(const Mesh& mesh, const Segment_map& segment, std::size_t number_of_segments)
{
  std::vector<std::vector<std::size_t> > neighbors(number_of_segments);
  for (Mesh::Edge_index e : mesh.edges()) {
    if (mesh.is_border(e))
      continue;
    const int a = segment[mesh.face(mesh.halfedge(e, 0))];
    const int b = segment[mesh.face(mesh.halfedge(e, 1))];
    if (a != b) {
      neighbors[a].push_back(b);
      neighbors[b].push_back(a);
    }
  }
  for (std::vector<std::size_t>& list : neighbors) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbors;
}

// Colors the faces; PLY has these colors as properties of the faces.
inline void color_segments(Mesh& mesh, const Segment_map& segment, std::size_t number_of_segments)
{
  const std::vector<segment_mesh::Rgb> colors =
    segment_mesh::segment_colors(segment_neighbors(mesh, segment, number_of_segments));
  const auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (Mesh::Face_index f : mesh.faces()) {
    const segment_mesh::Rgb& c = colors[segment[f]];
    color[f] = CGAL::IO::Color(c[0], c[1], c[2]);
  }
}

inline void write_ply(std::ostream& out, const Mesh& mesh)
{
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, mesh);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_COLORED_MESH_H
