// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_STL_H
#define SEGMENT_MESH_MESH_FILE_WRITE_STL_H

#include "Segmented_soup.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace mesh_file {

// Returns a normal of length 1, or 0 if the triangle has no area.
inline std::array<float, 3> unit_normal(const std::array<std::array<float, 3>, 3>& triangle)
{
  Point u, v, normal;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = static_cast<double>(triangle[1][k]) - triangle[0][k];
    v[k] = static_cast<double>(triangle[2][k]) - triangle[0][k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    normal[k] = u[l] * v[m] - u[m] * v[l];
  }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  std::array<float, 3> result{0, 0, 0};
  for (std::size_t k = 0; k < 3 && length > 0; ++k)
    result[k] = static_cast<float>(normal[k] / length);
  return result;
}

// Writes the triangles of a mesh in binary STL, which has neither segments nor colors. Throws if
// the coordinates are too large for it.
inline void write_stl(std::ostream& out, const Segmented_soup& mesh)
{
  const std::vector<Triangle> triangles = triangles_of(mesh.soup);
  Block_output block(out);
  std::string header = "binary STL";
  header.resize(80);
  block.text(header);
  block.binary(static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& t : triangles) {
    std::array<std::array<float, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = float_point(mesh.soup.points[t[i]], "STL");
    block.binary(unit_normal(corners));
    for (const std::array<float, 3>& c : corners)
      block.binary(c);
    block.binary(std::uint16_t(0));
  }
  block.flush();
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_STL_H
