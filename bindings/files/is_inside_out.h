// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_IS_INSIDE_OUT_H
#define SEGMENT_MESH_MESH_FILE_IS_INSIDE_OUT_H

#include "Polygon_soup.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mesh_file {

// Returns a number that tells an edge from others: equal for both directions, but for the sign.
inline std::uint64_t number_of_edge(Index source, Index target)
{
  std::uint64_t x = source < target ? std::uint64_t(source) << 32 | target
                                    : std::uint64_t(target) << 32 | source;
  for (int i = 0; i < 2; ++i) { // the bits are mixed as by MurmurHash3
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccd;
  }
  x ^= x >> 33;
  return source < target ? x : 0 - x;
}

// Returns whether a surface is closed, all its triangles have the same orientation, and they point
// inwards: in sum, each edge is passed as often in one direction as in the other, and the volume is
// negative. Points and triangles have elements [0], [1] and [2].
template <class Points, class Triangles>
bool is_inside_out(const Points& points, const Triangles& triangles)
{
  if (triangles.empty())
    return false;
  std::uint64_t edges = 0;
  double volume = 0, size = 0;
  const auto& origin = points[triangles[0][0]];
  for (const auto& t : triangles) {
    double p[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
      edges += number_of_edge(static_cast<Index>(t[i]), static_cast<Index>(t[(i + 1) % 3]));
      const auto& corner = points[t[i]];
      for (std::size_t k = 0; k < 3; ++k)
        p[i][k] = corner[k] - origin[k];
    }
    const double terms[6] = {p[0][0] * p[1][1] * p[2][2], p[0][1] * p[1][2] * p[2][0],
                             p[0][2] * p[1][0] * p[2][1], -p[0][2] * p[1][1] * p[2][0],
                             -p[0][0] * p[1][2] * p[2][1], -p[0][1] * p[1][0] * p[2][2]};
    for (double term : terms) {
      volume += term;
      size += std::abs(term);
    }
  }
  return edges == 0 && volume < -1e-9 * size; // not by rounding, as that of a flat surface
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_IS_INSIDE_OUT_H
