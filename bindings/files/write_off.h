// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_OFF_H
#define SEGMENT_MESH_MESH_FILE_WRITE_OFF_H

#include "Segmented_soup.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace mesh_file {

// Writes a mesh in OFF, the polygons in their order, each with its color.
inline void write_off(std::ostream& out, const Segmented_soup& mesh)
{
  const Polygon_soup& soup = mesh.soup;
  const Used_points used(soup);
  Block_output block(out);
  block.text("OFF\n" + std::to_string(used.size) + " " +
             std::to_string(soup.number_of_polygons()) + " 0\n");
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (used.number[v] != null_index) {
      block.decimal(soup.points[v], soup.coordinate_type);
      block.text("\n");
    }
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i) {
    block.decimal(soup.polygon(i).size());
    for (Index v : soup.polygon(i)) {
      block.text(" ");
      block.decimal(used.number[v]);
    }
    for (std::uint8_t c : mesh.colors[mesh.segment[i]]) {
      block.text(" ");
      block.decimal(c);
    }
    block.text("\n");
  }
  block.flush();
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_OFF_H
