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

// From values of each mesh to a verdict.
namespace segmentation_benchmark {

// `value` is a function or a pointer to a member.
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

// The mean of the differences between two values of each mesh.
struct Paired_difference
{
  double mean, standard_error;

  // Beyond chance: by more than twice the standard error.
  bool is_positive() const { return mean > 2 * standard_error; }
  bool is_negative() const { return mean < -2 * standard_error; }
};

// Compares the meshes where both values are defined; there must be at least two.
inline Paired_difference paired_difference(const std::vector<double>& a,
                                           const std::vector<double>& b)
{
  double n = 0, sum = 0, sum_of_squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!std::isnan(a[i] - b[i])) {
      ++n;
      sum += a[i] - b[i];
      sum_of_squares += (a[i] - b[i]) * (a[i] - b[i]);
    }
  const double mean = sum / n;
  const double variance = (std::max)(0., sum_of_squares - n * mean * mean) / (n - 1);
  return {mean, std::sqrt(variance / n)};
}

inline const char* verdict(bool is_reproduced)
{ return is_reproduced ? "reproduced" : "not reproduced"; }

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_EVALUATION_H
