// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_WRITE_MESHES_H
#define SEGMENT_MESH_WRITE_MESHES_H

#include "Output_files.h"
#include "mesh_file/Segmented_mesh.h"
#include "mesh_file/write_ply.h"
#include "read_input.h"
#include "segment_colors.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace segment_mesh {

// For each segment those that it touches; some that touch nowhere but beside a third may be missing.
inline std::vector<std::vector<std::size_t> >
segment_neighbors(const Input& input, const std::vector<Index>& segment_of_triangle,
                  std::size_t number_of_segments)
{
  std::vector<std::vector<std::size_t> > neighbors(number_of_segments);
  std::vector<Index> first_segment(input.soup.points.size(), mesh_file::null_index); // at each point
  for (std::size_t t = 0; t < input.triangles.size(); ++t)
    for (Index v : input.triangles[t]) {
      const Index b = segment_of_triangle[t];
      if (first_segment[v] == mesh_file::null_index)
        first_segment[v] = b;
      const Index a = first_segment[v];
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

// One mesh a segment, in the files segment_000.ply, segment_001.ply ...
inline void write_segments(Output_files& files, const std::filesystem::path& directory,
                           const mesh_file::Segmented_mesh& mesh)
{
  files.start_segments(directory);
  mesh_file::Segment_extraction extract(mesh);
  for (std::size_t s = 0; s < extract.number_of_segments(); ++s) {
    const Polygon_soup part = extract(s);
    const std::vector<Index> segment(part.number_of_polygons(), static_cast<Index>(s));
    files.write_segment(s, ".ply", [&](std::ostream& out)
                        { mesh_file::write_ply(out, {part, segment, mesh.colors}); });
  }
}

// One a line.
inline void write_labels(std::ostream& out, const std::vector<Index>& labels)
{
  std::string lines;
  for (Index label : labels) {
    lines += std::to_string(label);
    lines += '\n';
  }
  out << lines;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_WRITE_MESHES_H
