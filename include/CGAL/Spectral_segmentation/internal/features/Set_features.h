// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_SET_FEATURES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_SET_FEATURES_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/features/Face_features.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The mean features of sets of faces, by area, which may be joined.
class Set_features
{
  std::size_t dimension_ = 0; // 0: there are no features
  std::vector<double> sums_;  // one vector per set
  std::vector<double> areas_;

public:
  Set_features() = default;

  // Takes the features of faces, and the area and the set of each.
  Set_features(const Face_features& features, const std::vector<double>& areas,
               const std::vector<Index>& set, std::size_t number_of_sets)
    : dimension_(features.dimension), sums_(number_of_sets * dimension_, 0),
      areas_(number_of_sets, 0)
  {
    for (std::size_t f = 0; f < set.size(); ++f) {
      areas_[set[f]] += areas[f];
      for (std::size_t i = 0; i < dimension_; ++i)
        sums_[set[f] * dimension_ + i] += areas[f] * features[f][i];
    }
  }

  bool empty() const { return dimension_ == 0; }

  void join(Index from, Index into)
  {
    for (std::size_t i = 0; i < dimension_; ++i)
      sums_[into * dimension_ + i] += sums_[from * dimension_ + i];
    if (!empty())
      areas_[into] += areas_[from];
  }

  double distance(Index a, Index b) const
  {
    if (!(areas_[a] > 0) || !(areas_[b] > 0))
      return 0;
    double sum = 0;
    for (std::size_t i = 0; i < dimension_; ++i) {
      const double difference =
        sums_[a * dimension_ + i] / areas_[a] - sums_[b * dimension_ + i] / areas_[b];
      sum += difference * difference;
    }
    return std::sqrt(sum);
  }

  // Returns the share of the variance of all faces, which is 1, that the sets explain.
  double explained_variance() const
  {
    double area = 0, squares = 0;
    for (std::size_t s = 0; s < areas_.size(); ++s) {
      area += areas_[s];
      for (std::size_t i = 0; i < dimension_ && areas_[s] > 0; ++i)
        squares += sums_[s * dimension_ + i] * sums_[s * dimension_ + i] / areas_[s];
    }
    return area > 0 ? squares / area : 0;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_SET_FEATURES_H
