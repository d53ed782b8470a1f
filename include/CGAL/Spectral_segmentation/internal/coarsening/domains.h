// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_DOMAINS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_DOMAINS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/base/sorted_indices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns compact sets of about `faces_per_domain` faces, the faces in each cell of a grid. No set
// is empty.
inline std::vector<std::vector<Index> > domains(const std::vector<Corners>& corners,
                                                const std::vector<Vector>& points,
                                                std::size_t faces_per_domain)
{
  // A surface meets about as many cells as there are in two layers of the grid.
  const double width = std::ceil(
    std::sqrt(static_cast<double>(corners.size()) / static_cast<double>(2 * faces_per_domain)));
  const Bounding_box box(points);
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double cells_per_length = extent > 0 ? width / extent : 0;
  const Index n = static_cast<Index>(width);
  std::vector<std::vector<Index> > result(n * n * n);
  for (Index f = 0; f < corners.size(); ++f) {
    const Corners& c = corners[f];
    const Vector place =
      ((points[c[0]] + points[c[1]] + points[c[2]]) / 3 - box.smallest) * cells_per_length;
    Index cell = 0;
    for (int i = 0; i < 3; ++i)
      cell = n * cell + (std::min)(static_cast<Index>((std::max)(place[i], 0.)), n - 1);
    result[cell].push_back(f);
  }
  result.erase(std::remove_if(result.begin(), result.end(),
                              [](const std::vector<Index>& faces) { return faces.empty(); }),
               result.end());
  return result;
}

// Returns the number of faces for a unit of area if all domains share `number` faces, and no domain
// takes more faces than it has.
inline double shared_by_area(double number, const std::vector<std::vector<Index> >& faces,
                             const std::vector<double>& areas)
{
  std::vector<double> density(faces.size(), 0); // the faces per area that a domain has
  double area = 0;
  for (std::size_t d = 0; d < faces.size(); ++d)
    if (areas[d] > 0) {
      density[d] = static_cast<double>(faces[d].size()) / areas[d];
      area += areas[d];
    }
  for (Index d : sorted_indices(Execution::SEQUENTIAL, density)) {
    if (density[d] == 0)
      continue;
    if (density[d] * area >= number)
      return number / area;
    number -= static_cast<double>(faces[d].size());
    area -= areas[d];
  }
  return std::numeric_limits<double>::max();
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_DOMAINS_H
