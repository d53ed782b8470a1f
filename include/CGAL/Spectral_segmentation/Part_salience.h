// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
#define CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>
#include <CGAL/Spectral_segmentation/internal/salience/calibrated_boundary_network.h>

#include <cmath>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The salience of a part as the weighted sum of its factors (Zhang and Liu 2005, Equation 3).
/// \cgalModels{PartSalience}
struct Weighted_part_salience
{
  double alpha = 0.1; ///< weight of `Salience_factors::size`
  double beta = 0.6;  ///< weight of `Salience_factors::cut_strength`
  double gamma = 0.3; ///< weight of `Salience_factors::protrusiveness`

  /// the weighted sum; in [0, 1] unless the protrusiveness is negative
  double operator()(const Salience_factors& f) const
  {
    return alpha * f.size + beta * f.cut_strength + gamma * f.protrusiveness;
  }
};

/// \ingroup PkgSpectralSegmentationRef
/// The probability that a person would cut here. It is fitted to the human segmentations of the odd
/// half of the Princeton Segmentation Benchmark (Chen, Golovinskiy, Funkhouser 2009).
///
/// The search chooses among candidate cuts by a logistic function of eight factors. A candidate is
/// better
/// - if its part is a large fraction of the mesh,
/// - if the cut is concave, and more concave than the surface around it,
/// - if the base is small relative to the part that is cut off,
/// - if both sides are closer to convex than their union, and
/// - if the rest widens behind the cut.
///
/// Merging decides which boundaries stay. It uses a small network of all factors: a linear function
/// of the standardized factors and six hyperbolic tangents of linear functions. The table has the
/// mean change of the logit if a factor grows by one standard deviation, which
/// benchmark/fit_part_salience prints.
///
/// Factor | Change
/// -------|------:
/// `cut_strength` | +1.03
/// `concavity_around_cut` | -0.53
/// `relative_convexity_gain` | +0.52
/// `log_relative_part_area` | +0.36
/// `protrusiveness` | +0.35
/// `expansion_behind_cut` | +0.34
/// `flatness_behind_cut` | +0.30
/// `lower_quartile_of_concavity` | -0.25
/// `number_of_common_neighbors` | -0.25
/// `roundness` | +0.23
/// `convexity_gain` | +0.20
/// `expansion_before_cut` | +0.13
/// `concavity_near_cut` | +0.03
/// `size` | +0.02
///
/// \cgalModels{PartSalience}
struct Calibrated_part_salience
{
  /// \name Coefficients for Candidates
  /// The constant and the coefficients of the factors of the same names, in the logit of the
  /// probability.
  /// @{

  // benchmark/fit_part_salience BENCH_DIR --kind candidates --coarse-faces 0 --passes 1 prints such
  // values. These are of commit 912f4d6, from 126626 cuts of 190 meshes and without random numbers.
  double constant = -5.292;
  double log_relative_part_area = 0.343;
  double size = -1.366;
  double cut_strength = 4.151;
  double concavity_near_cut = -4.589;
  double protrusiveness = 2.383;
  double convexity_gain = 11.546;
  double relative_convexity_gain = 1.041;
  double expansion_behind_cut = 1.348;

  /// @}

#ifndef DOXYGEN_RUNNING
  internal::Boundary_network boundary_network = internal::calibrated_boundary_network;
#endif

#ifndef DOXYGEN_RUNNING
  internal::Feature_logit feature_logit; // of cuts of faces that have features
#endif

  /// the probability, in [0, 1]
  double operator()(const Salience_factors& f) const
  {
    const double logit_of_shape =
      f.is_boundary
        ? boundary_network.logit(f)
        : constant + log_relative_part_area * f.log_relative_part_area + size * f.size +
            cut_strength * f.cut_strength + concavity_near_cut * f.concavity_near_cut +
            protrusiveness * f.protrusiveness + convexity_gain * f.convexity_gain +
            relative_convexity_gain * f.relative_convexity_gain +
            expansion_behind_cut * f.expansion_behind_cut;
    return 1 / (1 + std::exp(-feature_logit(logit_of_shape, f)));
  }
};

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for a `Weighted_part_salience`. It is
/// the multiple of 0.02 that, as one value for all meshes, gives the smallest Rand error on the odd
/// half of the Princeton benchmark.
constexpr double default_salience_threshold = 0.54;

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for any other part salience.
///
/// Between 0.36 and 0.50 the Rand errors of the odd half of the Princeton benchmark and of posed
/// bodies hardly depend on it. With 0.48 shapes without parts, such as tubes and tori, stay whole.
/// It is below 1/2 because a superfluous cut costs less than a missing one.
constexpr double default_probability_threshold = 0.48;

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
