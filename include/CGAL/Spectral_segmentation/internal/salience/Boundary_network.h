// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_BOUNDARY_NETWORK_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_BOUNDARY_NETWORK_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spectral_segmentation::internal {

struct Named_factor
{
  const char* name;
  double Salience_factors::*value;
};

// All factors that are numbers.
constexpr std::array<Named_factor, 14> named_factors = {{
  {"size", &Salience_factors::size},
  {"cut_strength", &Salience_factors::cut_strength},
  {"protrusiveness", &Salience_factors::protrusiveness},
  {"log_relative_part_area", &Salience_factors::log_relative_part_area},
  {"concavity_near_cut", &Salience_factors::concavity_near_cut},
  {"convexity_gain", &Salience_factors::convexity_gain},
  {"relative_convexity_gain", &Salience_factors::relative_convexity_gain},
  {"expansion_behind_cut", &Salience_factors::expansion_behind_cut},
  {"roundness", &Salience_factors::roundness},
  {"flatness_behind_cut", &Salience_factors::flatness_behind_cut},
  {"concavity_around_cut", &Salience_factors::concavity_around_cut},
  {"lower_quartile_of_concavity", &Salience_factors::lower_quartile_of_concavity},
  {"expansion_before_cut", &Salience_factors::expansion_before_cut},
  {"number_of_common_neighbors", &Salience_factors::number_of_common_neighbors}}};

// Computes the logit of the probability that people cut along a boundary: a linear function of the
// standardized factors, and hyperbolic tangents of linear functions.
struct Boundary_network
{
  typedef std::array<double, named_factors.size()> Inputs;

  struct Unit
  {
    double constant;
    Inputs weights;
    double output;
  };

  static constexpr double largest_deviation = 4; // an outlier counts as a factor there

  Inputs means, deviations;
  double constant;
  Inputs weights;
  std::array<Unit, 6> units;

  // Returns the standardized factors.
  Inputs inputs(const Salience_factors& factors) const
  {
    Inputs result;
    for (std::size_t i = 0; i < result.size(); ++i) {
      const double x = (factors.*named_factors[i].value - means[i]) / deviations[i];
      result[i] = (std::min)((std::max)(x, -largest_deviation), largest_deviation);
    }
    return result;
  }

  double logit(const Salience_factors& factors) const
  {
    const Inputs x = inputs(factors);
    const auto linear = [&](double sum, const Inputs& weights) {
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += weights[i] * x[i];
      return sum;
    };
    double result = linear(constant, weights);
    for (const Unit& unit : units)
      result += unit.output * std::tanh(linear(unit.constant, unit.weights));
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_BOUNDARY_NETWORK_H
