// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_figures.h"

namespace test_meshes {

void add_box(Cells& cells, const Cell& low, const Cell& high)
{
  for (int x = low[0]; x < high[0]; ++x)
    for (int y = low[1]; y < high[1]; ++y)
      for (int z = low[2]; z < high[2]; ++z)
        cells.insert({x, y, z});
}

Soup boundary_of(const Cells& cells, bool is_open)
{
  Soup soup;
  std::map<Cell, std::size_t> number;
  const auto vertex = [&](const Cell& c) {
    const auto [entry, is_new] = number.emplace(c, soup.points.size());
    if (is_new)
      soup.points.emplace_back(c[0], c[1], c[2]);
    return entry->second;
  };
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int end = 0; end < 2; ++end) {
        Cell across = cell;
        across[axis] += 2 * end - 1;
        if (cells.count(across) || (is_open && across[2] < 0))
          continue;
        Cell corners[4] = {cell, cell, cell, cell};
        for (Cell& c : corners)
          c[axis] += end;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        ++corners[end == 1 ? 1 : 3][u];
        ++corners[2][u];
        ++corners[2][v];
        ++corners[end == 1 ? 3 : 1][v];
        const std::size_t a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]),
                          d = vertex(corners[3]);
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      }
  return soup;
}

const Soup& doll()
{
  static const Soup result = [] {
    Cells cells;
    add_box(cells, {0, 0, 0}, {5, 2, 5});
    add_box(cells, {0, 0, -4}, {1, 1, 0});
    add_box(cells, {4, 0, -5}, {5, 1, 0});
    add_box(cells, {-4, 0, 4}, {0, 1, 5});
    add_box(cells, {5, 0, 4}, {8, 1, 5});
    add_box(cells, {2, 0, 5}, {4, 2, 7});
    Random random(1);
    return displaced(boundary_of(cells), 0.1, random);
  }();
  return result;
}

} // namespace test_meshes
