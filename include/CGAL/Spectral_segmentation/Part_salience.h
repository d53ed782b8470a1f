// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
#define CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H

#include <cmath>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The factors of a cut of a part *M* into two sides: the three factors of the paper (Hoffman and
/// Singh 1997; Zhang and Liu 2005, Section 6), and five more. *Q* is the side of smaller area.
struct Salience_factors
{
  /// <em>V<sub>s</sub></em> = Area(*Q*) / Area(*M*), in [0, 1/2].
  double size = 0;

  /// <em>V<sub>c</sub></em>, in [0, 1]: the mean, over the edges of the cut, of the equalized angle
  /// distance at concave edges and 0 at other edges. If the factors beyond the paper are computed,
  /// an edge counts by its length. Otherwise all edges count the same, and the mean is divided by
  /// the largest equalized angle distance in *M*.
  double cut_strength = 0;

  /// <em>V<sub>p</sub></em> = 1 - 4 sqrt(&lambda;<sub>1</sub> &lambda;<sub>2</sub>) / Area(*Q*), at
  /// most 1 and not bounded from below; the &lambda; are the two largest eigenvalues of the
  /// covariance matrix of the vertices along the cut.
  double protrusiveness = 0;

  /// \name Factors beyond the paper
  /// They are 0 in the method of the paper.
  /// *L* is the square root of the area of the mesh, and *r* = 0.35 sqrt(Area(*Q*)). The other side
  /// of the cut is called the rest. The convexity defect of a set of faces is the mean depth of its
  /// faces below its own convex hull (compare Lien and Amato 2007). *h* is the convexity defect of
  /// *M*, and *h'* is the mean, by area, of the convexity defects of *Q* and of the rest, both
  /// divided by *L*.
  /// @{

  /// ln(Area(*M*) / Area(mesh)), at most 0
  double log_relative_part_area = 0;

  /// the mean, by length, of the equalized angle distance at concave edges and 0 at other edges, in
  /// [0, 1]. It is taken over those edges of the faces within the distance *r* of the cut that are
  /// inner edges of *M*. A cut should be more concave than this mean.
  double concavity_near_cut = 0;

  /// *h* - *h'*
  double convexity_gain = 0;

  /// ln((*h* + 0.005) / (*h'* + 0.005)), for parts whose whole convexity defect is small
  double relative_convexity_gain = 0;

  /// how fast the rest widens behind the cut: its area within the distance *r* of the cut, divided
  /// by *r* and the length of the cut; about 1 on a cylinder, at most 4
  double expansion_behind_cut = 0;

  /// @}
};

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
/// The probability that a person would cut here. It is a logistic function of the factors, fitted
/// to the human segmentations of the odd half of the Princeton Segmentation Benchmark (Chen,
/// Golovinskiy, Funkhouser 2009).
///
/// A part is more likely to be cut
/// - if it is a large fraction of the mesh,
/// - if the cut is concave, and more concave than the surface around it,
/// - if the base is small relative to the part that is cut off,
/// - if both sides are closer to convex than their union, and
/// - if the rest widens behind the cut.
/// \cgalModels{PartSalience}
struct Calibrated_part_salience
{
  /// \name Coefficients
  /// The constant and the coefficients of the factors of the same names, in the logit of the
  /// probability.
  /// @{

  // benchmark/fit_part_salience BENCH_DIR --ids odd --searched-faces 0 printed these values, from
  // 126626 cuts of 190 meshes and without random numbers. The page Performance and Quality of the
  // manual has the errors.
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

  /// the probability, in [0, 1]
  double operator()(const Salience_factors& f) const
  {
    const double logit =
      constant + log_relative_part_area * f.log_relative_part_area + size * f.size +
      cut_strength * f.cut_strength + concavity_near_cut * f.concavity_near_cut +
      protrusiveness * f.protrusiveness + convexity_gain * f.convexity_gain +
      relative_convexity_gain * f.relative_convexity_gain +
      expansion_behind_cut * f.expansion_behind_cut;
    return 1 / (1 + std::exp(-logit));
  }
};

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for a `Weighted_part_salience`. It is
/// the multiple of 0.02 that, as one value for all meshes, gives the smallest Rand error on the odd
/// half of the Princeton benchmark.
constexpr double default_salience_threshold = 0.54;

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for any other part salience. It is the
/// multiple of 0.02 with the smallest Rand error on the odd half of the Princeton benchmark. It is
/// below 1/2 because a superfluous cut costs less than a missing one.
constexpr double default_probability_threshold = 0.40;

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
