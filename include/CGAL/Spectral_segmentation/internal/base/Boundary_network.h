// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_BOUNDARY_NETWORK_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_BOUNDARY_NETWORK_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/base/Face_features.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spectral_segmentation::internal {

// Computes the logit of the probability that people cut along a boundary: a linear function of the
// standardized inputs, and hyperbolic tangents of linear functions. The inputs are the named
// factors, or the first of them, and the logarithm of the fraction of the area of the mesh that the
// smaller side has.
template <std::size_t number_of_inputs, std::size_t number_of_units>
struct Boundary_network
{
  typedef std::array<double, number_of_inputs> Inputs;

  struct Unit
  {
    double constant;
    Inputs weights;
    double output;
  };

  static constexpr double largest_deviation = 4; // outliers are clamped to this

  Inputs means, deviations;
  double constant;
  Inputs weights;
  std::array<Unit, number_of_units> units;

  // Returns the standardized inputs.
  Inputs inputs(const Salience_factors& factors) const
  {
    Inputs result;
    for (std::size_t i = 0; i < result.size(); ++i) {
      const double x = i < named_factors.size()
        ? factors.*named_factors[i].value
        : std::log(factors.size) + factors.log_relative_part_area;
      result[i] = std::clamp((x - means[i]) / deviations[i], -largest_deviation,
                             largest_deviation);
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

// Combines the shape and the features at a cut. Uninformative features, such as noise, have no
// weight at the default feature weight, 1/2. The numbers are fitted to human segmentations with
// synthetic features. A later change of the default threshold shifted the constant of boundaries.
struct Feature_logit
{
  // candidates
  double first_step = 0.15, last_step = 0.25; // the weight of features grows between these
  double candidate = 4.3;

  // boundaries
  double first_reliability = 0.2, last_reliability = 0.4;
  double shape = 0.75;
  double constant = -3.43;
  double feature_step = -1.7;
  double explained_variance_near_cut = 3.95;
  double explained_variance = 1.75;
  double explained_variance_of_mesh = 7.7;

  // components
  double equal_components = -0.75, different_components = 1.7;

  static double ramp(double x, double first, double last)
  { return (std::min)((std::max)((x - first) / (last - first), 0.), 1.); }

  // Returns the discount on the weight of the shape, in [0, 1].
  static double shape_discount(double feature_weight)
  { return (std::max)(2 * feature_weight - 1, 0.); }

  // Returns the weighted reliability of the features, in [0, 1]; 0 without features.
  double reliability(const Salience_factors& f) const
  {
    return weight_of_features(f.feature_weight) *
           ramp(f.feature_reliability, first_reliability, last_reliability);
  }

  // Returns the term that the distance of the mean features of two components adds to the logit of
  // their boundary, if all components together explain this fraction of the variance.
  double component_term(double distance, double explained_variance, double feature_weight) const
  {
    return weight_of_features(feature_weight) * ramp(explained_variance, 0.3, 0.6) *
           (equal_components +
            (different_components - equal_components) * ramp(distance, 0.1, 0.5));
  }

  // Returns the logit of a cut, given the logit of its shape. Up to the feature weight 1/2, the
  // weight of the features grows. Beyond it, the weight of the shape falls to a hundredth, and the
  // weight of unreliable features grows.
  double operator()(double logit_of_shape, const Salience_factors& f) const
  {
    if (!(f.feature_weight > 0))
      return logit_of_shape;
    const double weight = weight_of_features(f.feature_weight);
    const double discount = shape_discount(f.feature_weight), shape_left = 1 - 0.99 * discount;
    const double mesh_correlation = std::sqrt(f.explained_variance_of_mesh);
    if (!f.is_boundary) {
      const double step = f.feature_step * std::sqrt(f.explained_variance);
      return shape_left * logit_of_shape +
             weight * ramp(step, first_step, last_step) * candidate * mesh_correlation;
    }
    const double reliable = reliability(f), trust = reliable + discount * (1 - reliable);
    return (1 - (1 - shape) * reliable) * shape_left * logit_of_shape +
           trust * (constant + feature_step * f.feature_step +
                    explained_variance_near_cut * std::sqrt(f.explained_variance_near_cut) +
                    explained_variance * std::sqrt(f.explained_variance) +
                    explained_variance_of_mesh * mesh_correlation);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_BOUNDARY_NETWORK_H
