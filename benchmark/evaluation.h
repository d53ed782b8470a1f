// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_EVALUATION_H
#define SEGMENTATION_BENCHMARK_EVALUATION_H

#include "segmentation_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

// Means over the meshes, and their uncertainty.
namespace segmentation_benchmark {

// Returns a value of each element. `value` is a function or a pointer to a member.
template <class Range, class Value>
std::vector<double> values_of(const Range& range, const Value& value)
{
  std::vector<double> result;
  for (const auto& element : range)
    result.push_back(std::invoke(value, element));
  return result;
}

// Returns the mean of the defined values.
inline double mean_of(const std::vector<double>& values)
{
  Mean mean;
  for (double value : values)
    mean.add(value);
  return mean();
}

// The mean of values of each mesh, as an estimate of that of all meshes.
struct Estimated_mean
{
  double mean, standard_error;

  // Returns whether the mean is positive beyond chance: by more than twice the standard error.
  bool is_positive() const { return mean > 2 * standard_error; }
  bool is_negative() const { return mean < -2 * standard_error; }
};

// Estimates from the values that are defined. The standard error needs two of them at least.
inline Estimated_mean estimated_mean(const std::vector<double>& values)
{
  double n = 0, sum = 0, sum_of_squares = 0;
  for (double value : values)
    if (!std::isnan(value)) {
      ++n;
      sum += value;
      sum_of_squares += value * value;
    }
  const double mean = sum / n;
  const double variance = (std::max)(0., sum_of_squares - n * mean * mean) / (n - 1);
  return {mean, std::sqrt(variance / n)};
}

// The mean of the differences between two values of each mesh.
typedef Estimated_mean Paired_difference;

// Compares the meshes where both values are defined; there must be at least two.
inline Paired_difference paired_difference(const std::vector<double>& a,
                                           const std::vector<double>& b)
{
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i)
    differences.push_back(a[i] - b[i]);
  return estimated_mean(differences);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_EVALUATION_H
