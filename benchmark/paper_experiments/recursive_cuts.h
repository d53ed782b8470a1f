// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_RECURSIVE_CUTS_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_RECURSIVE_CUTS_H

#include "experiment.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

// The paper's recursion with any two-way cut: the part of the largest area is cut next, until there
// are k parts or none can be cut. `sides_of(part)` are the sides of the faces of a part, if it has
// a cut. Connected components of the mesh are parts from the start.
template <class SidesOf>
Labels recursive_cuts(const Surface& mesh, std::size_t k, const SidesOf& sides_of)
{
  std::vector<Part> parts = components(mesh);
  std::vector<double> areas; // 0 if there is no cut
  for (const Part& part : parts)
    areas.push_back(total_area(part.graph));
  while (parts.size() < k) {
    const auto largest = std::max_element(areas.begin(), areas.end());
    if (!(*largest > 0))
      break;
    Part& part = parts[static_cast<std::size_t>(largest - areas.begin())];
    const std::optional<Sides> sides = sides_of(std::as_const(part));
    *largest = 0;
    if (!sides)
      continue;
    std::vector<Surface> graphs = split(part.graph, *sides, 2);
    std::vector<Index> faces[2];
    for (std::size_t i = 0; i < part.faces.size(); ++i)
      faces[int((*sides)[i])].push_back(part.faces[i]);
    const double areas_of_sides[] = {total_area(graphs[0]), total_area(graphs[1])};
    part = {std::move(graphs[0]), std::move(faces[0])};
    *largest = areas_of_sides[0];
    parts.push_back({std::move(graphs[1]), std::move(faces[1])});
    areas.push_back(areas_of_sides[1]);
  }

  Labels labels(mesh.number_of_faces());
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (Index f : parts[i].faces)
      labels[f] = i;
  return labels;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_RECURSIVE_CUTS_H
