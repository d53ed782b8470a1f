// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_FACE_FEATURES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_FACE_FEATURES_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the weight of informative features, in [0, 1].
inline double weight_of_features(double feature_weight)
{ return (std::min)(2 * feature_weight, 1.); }

// The feature vectors of the faces of a surface, in units of their standard deviation on the mesh.
struct Face_features
{
  std::size_t dimension = 0; // 0: there are no features, or all are equal
  std::vector<float> values; // one vector per face
  double unit = 1;           // the standard deviation, in the caller's unit

  bool empty() const { return dimension == 0; }
  const float* operator[](std::size_t f) const { return &values[f * dimension]; }

  double squared_distance(std::size_t f, std::size_t g) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < dimension; ++i) {
      const double difference = double((*this)[f][i]) - (*this)[g][i];
      sum += difference * difference;
    }
    return sum;
  }
};

// The area-weighted mean features of sets of faces, which may be joined.
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

  // Returns the fraction of the variance of all faces, which is 1, that the sets explain.
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

// The area-weighted variance of the features of faces on both sides of a cut.
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

  // Returns the explained fraction of the variance, which is clamped below to a hundredth of the
  // variance of the mesh, so that rounding noise is not amplified.
  double explained_fraction() const
  {
    double variance = squares_;
    for (std::size_t i = 0; i < features_.dimension; ++i) {
      const double sum = sums_[0][i] + sums_[1][i];
      variance -= area() > 0 ? sum * sum / area() : 0;
    }
    const double least = 0.01 * area();
    return least > 0 ? (std::min)(explained() / (std::max)(variance, least), 1.) : 0;
  }
};

// Sets the feature factors of a cut, except their weight and their reliability.
inline void set_feature_factors(const Feature_variance& sides, const Feature_variance& near_cut,
                                double area_of_mesh, Salience_factors& factors)
{
  factors.feature_step = std::sqrt(near_cut.squared_step());
  factors.explained_variance_near_cut = near_cut.explained_fraction();
  factors.explained_variance = sides.explained_fraction();
  factors.explained_variance_of_mesh = sides.explained() / area_of_mesh;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_FACE_FEATURES_H
