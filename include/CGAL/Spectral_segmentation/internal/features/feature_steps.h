// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_STEPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_STEPS_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/features/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes edges across which features change more than at most edges count as concave. A change that
// is much the same everywhere, as that of a smooth field or of noise, has no effect. A change is
// `factor` times the distance of the features of adjacent faces.
inline void add_feature_steps(const Face_features& features, double factor, double weight,
                              Surface& graph)
{
  if (features.empty())
    return;
  std::vector<float> steps(graph.number_of_halfedges(), 0);
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (!graph.is_border(h))
      steps[h] =
        static_cast<float>(factor * std::sqrt(features.squared_distance(h / 3, graph.neighbor(h))));
  std::vector<float> sorted = steps;
  const auto quartile = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 3 / 4);
  std::nth_element(sorted.begin(), quartile, sorted.end());
  const double usual_step = 1.5 * *quartile;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    const double step = (std::min)((std::max)(steps[h] - usual_step, 0.), 1.);
    float& concavity = graph.weights[h].concavity;
    concavity = static_cast<float>(
      quantized(1 - (1 - 0.75 * (std::min)(2 * weight, 1.) * step) * (1 - concavity)));
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_STEPS_H
