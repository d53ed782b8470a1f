// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_WRITE_MESHES_H
#define SEGMENT_MESH_WRITE_MESHES_H

#include "Output_files.h"
#include "read_mesh.h"
#include "segment_colors.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace segment_mesh {

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
  const std::vector<Rgb> colors =
    segment_colors(segment_neighbors(mesh, segment, number_of_segments));
  const auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (Mesh::Face_index f : mesh.faces()) {
    const Rgb& c = colors[segment[f]];
    color[f] = CGAL::IO::Color(c[0], c[1], c[2]);
  }
}

inline void write_ply(std::ostream& out, const Mesh& mesh)
{
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, mesh);
}

// One mesh a segment, in the files segment_000.ply, segment_001.ply ...
inline void write_segments(Output_files& files, const std::filesystem::path& directory,
                           const Mesh& mesh, const Segment_map& segment,
                           std::size_t number_of_segments)
{
  files.make_directory(directory);
  std::vector<std::vector<Mesh::Face_index> > faces(number_of_segments);
  for (Mesh::Face_index f : mesh.faces())
    faces[segment[f]].push_back(f);

  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> number_of_vertex(mesh.number_of_vertices(), none);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Soup part;
    std::vector<Mesh::Vertex_index> vertices;
    for (Mesh::Face_index f : faces[i]) {
      part.polygons.emplace_back();
      for (Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
        if (number_of_vertex[v] == none) {
          number_of_vertex[v] = vertices.size();
          vertices.push_back(v);
          part.points.push_back(mesh.point(v));
        }
        part.polygons.back().push_back(number_of_vertex[v]);
      }
    }
    for (Mesh::Vertex_index v : vertices)
      number_of_vertex[v] = none;

    std::string number = std::to_string(i);
    number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
    files.write(directory / ("segment_" + number + ".ply"), [&](std::ostream& out) {
      CGAL::IO::set_binary_mode(out);
      CGAL::IO::write_PLY(out, part.points, part.polygons);
    });
  }
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_WRITE_MESHES_H
