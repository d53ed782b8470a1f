// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
#define CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/base/Boundary_network.h>
#include <CGAL/Spectral_segmentation/internal/base/calibrated_networks.h>

#include <cmath>
#include <cstddef>

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
  { return alpha * f.size + beta * f.cut_strength + gamma * f.protrusiveness; }
};

/// \ingroup PkgSpectralSegmentationRef
/// The probability that a person would cut here. It is fitted to the human segmentations of the odd
/// half of the Princeton Segmentation Benchmark (Chen, Golovinskiy, Funkhouser 2009), and to bodies
/// and animals with known parts.
///
/// The search chooses among candidate cuts by a logistic function of eight factors. A candidate is
/// better
/// - if its part is a large fraction of the mesh,
/// - if the cut is concave, and more concave than the surface around it,
/// - if the base is small relative to the part that is cut off,
/// - if both sides are closer to convex than their union, and
/// - if the rest widens behind the cut.
///
/// Merging makes the hierarchy of cuts by a network of all factors but `number_of_other_neighbors`,
/// and a second network of all factors gives its cuts their saliences. Both are a linear function
/// of the standardized inputs, and hyperbolic tangents of linear functions. The second network also
/// has the input ln *S*, where *S* is the fraction of the area of the mesh that the smaller side
/// has. It is fitted to what a cut costs: each cut is weighted by the Rand error and by the human
/// parts that it adds or removes. Therefore a missing head weighs more than a missing finger, and a
/// superfluous scrap counts, too. The more reliable the features of faces are, the more the first
/// network replaces it. Its output is calibrated: of the cuts with a salience of 0.7, seven of ten
/// people make the mean one. The table has the mean change of its logit if an input grows by one
/// standard deviation, which benchmark/fit_part_salience.py prints.
///
/// A function of the caller that calls this one gives the order of merging, too, so that its
/// hierarchy may differ.
///
/// Input | Change
/// ------|------:
/// `flatness_behind_cut` | +0.69
/// `convexity_gain` | +0.52
/// `expansion_before_cut` | +0.42
/// `cut_strength` | +0.41
/// `concavity_around_cut` | -0.41
/// `log_relative_part_area` | +0.31
/// `number_of_other_neighbors` | -0.24
/// ln *S* | +0.21
/// `size` | -0.20
/// `concavity_near_cut` | +0.15
/// `protrusiveness` | +0.13
/// `expansion_behind_cut` | +0.12
/// `roundness` | +0.12
/// `relative_convexity_gain` | +0.11
/// `number_of_common_neighbors` | -0.03
/// `lower_quartile_of_concavity` | 0.00
///
/// \cgalModels{PartSalience}
struct Calibrated_part_salience
{
  /// \name Coefficients for Candidates
  /// The constant and the coefficients of the factors of the same names, in the logit of the
  /// probability.
  /// @{

  // They are fitted to how many people make a cut, at 126626 candidates on 190 meshes. With a
  // network of all factors in their place, the error of the best choice in a hierarchy is 4 %
  // higher on the odd half and 15 % higher on animals, and a run takes a quarter longer.
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
  internal::Boundary_network<16, 12> boundary_network = internal::calibrated_boundary_network;
  internal::Boundary_network<14, 4> merging_network = internal::merging_network;
  internal::Feature_logit feature_logit; // the term of the features

  // Returns the logit of a boundary by its shape. As far as features are reliable, it is that of
  // the network of merging, to which the numbers of `feature_logit` are fitted.
  double logit_of_boundary(const Salience_factors& f) const
  {
    const double reliability = feature_logit.reliability(f);
    const double logit = boundary_network.logit(f);
    return logit + reliability * (merging_network.logit(f) - logit);
  }

  // Returns the salience in whose order boundaries are merged.
  double in_merging(const Salience_factors& f) const
  { return 1 / (1 + std::exp(-feature_logit(merging_network.logit(f), f))); }
#endif

  /// the probability, in [0, 1]
  double operator()(const Salience_factors& f) const
  {
    const double logit_of_shape =
      f.is_boundary
        ? logit_of_boundary(f)
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
/// The largest number of parts of a connected mesh with `zhang_liu_2005()`, if neither a number of
/// segments nor a `salience_threshold` is given: 11 cuts. Two components of equal area are cut 22
/// times, and so on; if the areas are the fractions f of the whole, 11 cuts are made for each of
/// 1 / &sum; f<sup>2</sup> components, rounded.
constexpr std::size_t default_number_of_parts = 12;

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for any other part salience.
///
/// It is a little above the probability at which a cut neither pays nor costs, 0.39. That
/// probability is below 1/2 because a superfluous cut costs less than a missing one.
constexpr double default_probability_threshold = 0.40;

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
