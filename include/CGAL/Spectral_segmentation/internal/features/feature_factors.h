// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_FACTORS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_FACTORS_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/features/Face_features.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The variance of the features of faces on both sides of a cut, by area.
class Feature_variance
{
  const Face_features& features_;
  std::vector<double> sums_[2];
  double areas_[2] = {0, 0};
  double squares_ = 0;

  double area() const { return areas_[0] + areas_[1]; }

public:
  explicit Feature_variance(const Face_features& features)
    : features_(features), sums_{std::vector<double>(features.dimension, 0),
                                 std::vector<double>(features.dimension, 0)} {}

  void add(Index face, double area, int side)
  {
    const float* x = features_[face];
    double square = 0;
    for (std::size_t i = 0; i < features_.dimension; ++i) {
      sums_[side][i] += area * x[i];
      square += double(x[i]) * x[i];
    }
    squares_ += area * square;
    areas_[side] += area;
  }

  // Returns the squared distance of the means of both sides.
  double squared_step() const
  {
    if (!(areas_[0] > 0) || !(areas_[1] > 0))
      return 0;
    double result = 0;
    for (std::size_t i = 0; i < features_.dimension; ++i) {
      const double difference = sums_[0][i] / areas_[0] - sums_[1][i] / areas_[1];
      result += difference * difference;
    }
    return result;
  }

  // Returns the variance that the cut explains, times the area.
  double explained() const
  { return area() > 0 ? areas_[0] * areas_[1] / area() * squared_step() : 0; }

  // Returns the same relative to the whole variance, which is taken to be a hundredth of that of
  // the mesh at least, so that differences of nothing count for nothing.
  double explained_share() const
  {
    double whole = squares_;
    for (std::size_t i = 0; i < features_.dimension; ++i) {
      const double sum = sums_[0][i] + sums_[1][i];
      whole -= area() > 0 ? sum * sum / area() : 0;
    }
    const double least = 0.01 * area();
    return least > 0 ? (std::min)(explained() / (std::max)(whole, least), 1.) : 0;
  }
};

// Sets the factors of features of a cut, but for their weight and their reliability.
inline void set_feature_factors(const Feature_variance& sides, const Feature_variance& near_cut,
                                double area_of_mesh, Salience_factors& factors)
{
  factors.feature_step = std::sqrt(near_cut.squared_step());
  factors.explained_variance_near_cut = near_cut.explained_share();
  factors.explained_variance = sides.explained_share();
  factors.explained_variance_of_mesh = sides.explained() / area_of_mesh;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FEATURE_FACTORS_H
