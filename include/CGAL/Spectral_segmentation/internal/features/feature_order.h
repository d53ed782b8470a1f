// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_ORDER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_ORDER_H

#include <CGAL/Spectral_segmentation/internal/base/sorted_indices.h>
#include <CGAL/Spectral_segmentation/internal/features/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/features/principal_subspace.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the faces of a part ordered along the direction of largest variance of their features.
// `faces` are their indices in the mesh.
inline std::vector<Index> feature_order(Execution execution, const Face_features& features,
                                        const std::vector<double>& areas,
                                        const std::vector<Index>& faces)
{
  const std::size_t d = features.dimension;
  std::vector<double> mean(d, 0);
  double area = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    area += areas[f];
    for (std::size_t i = 0; i < d; ++i)
      mean[i] += areas[f] * features[faces[f]][i];
  }
  Row_matrix rows(faces.size(), d);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < d; ++i)
      rows[f][i] = features[faces[f]][i] - (area > 0 ? mean[i] / area : 0);
  Row_matrix covariance = weighted_transposed_product(rows, areas, rows);
  std::size_t longest = 0;
  for (std::size_t i = 1; i < d; ++i)
    if (covariance[i][i] > covariance[longest][longest])
      longest = i;
  Row_matrix direction(d, 1);
  for (std::size_t i = 0; i < d; ++i)
    direction[i][0] = covariance[i][longest];
  for (int i = 0; i < 20; ++i) {
    orthonormalize(direction);
    direction = product(covariance, direction);
  }
  orthonormalize(direction);
  return sorted_indices(execution, product(rows, direction).values);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_ORDER_H
