// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_NUMBER_OF_ADDED_FACES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_NUMBER_OF_ADDED_FACES_H

#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the length of the longest edge of each face.
inline std::vector<double> longest_edges_of_faces(Execution execution, const Surface& mesh)
{
  std::vector<double> result(mesh.number_of_faces());
  for_each_index(execution, result.size(), [&](std::size_t f) {
    const Index h = static_cast<Index>(3 * f);
    result[f] = (std::max)({mesh.length(h), mesh.length(h + 1), mesh.length(h + 2)});
  });
  return result;
}

// Estimates how many faces the bisection of longest edges adds until no edge is longer than a
// bound. A face becomes an even mesh, but a needle of n bounds of length becomes three needles of
// n / 2 bounds, and so on.
inline double number_of_added_faces(const Surface& mesh,
                                    const std::vector<double>& longest_edges, double bound)
{
  double result = 0;
  for (std::size_t f = 0; f < longest_edges.size(); ++f)
    if (longest_edges[f] > bound)
      result += std::pow(longest_edges[f] / bound, std::log2(3.)) +
                4 * mesh.areas[f] / (bound * bound);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_NUMBER_OF_ADDED_FACES_H
