// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
#define CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The three factors of the salience of a part *Q* that is cut from a part *M*
/// (Hoffman and Singh 1997; Zhang and Liu 2005, Section 6).
/// *Q* is the one of the two sides that has the smaller area.
struct Salience_factors
{
  /// *V<sub>s</sub>* = Area(*Q*) / Area(*M*), in [0, 1/2].
  double size = 0;

  /// *V<sub>c</sub>*, in [0, 1]: the mean, over the edges of the cut, of the equalized angle
  /// distance at concave edges and 0 at others, divided by the largest equalized angle distance
  /// in *M*.
  double cut_strength = 0;

  /// *V<sub>p</sub>* = 1 - 4 sqrt(&lambda;<sub>1</sub> &lambda;<sub>2</sub>) / Area(*Q*), at most 1
  /// and not bounded from below; the &lambda; are the two largest eigenvalues of the covariance
  /// matrix of the vertices along the cut.
  double protrusiveness = 0;
};

/// \ingroup PkgSpectralSegmentationRef
/// The salience of a part as the weighted sum of its factors (Zhang and Liu 2005, Equation 3).
struct Weighted_part_salience
{
  double alpha = 0.1; ///< weight of `Salience_factors::size`
  double beta = 0.6;  ///< weight of `Salience_factors::cut_strength`
  double gamma = 0.3; ///< weight of `Salience_factors::protrusiveness`

  double operator()(const Salience_factors& f) const
  {
    return alpha * f.size + beta * f.cut_strength + gamma * f.protrusiveness;
  }
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_PART_SALIENCE_H
