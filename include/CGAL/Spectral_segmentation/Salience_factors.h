// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SALIENCE_FACTORS_H
#define CGAL_SPECTRAL_SEGMENTATION_SALIENCE_FACTORS_H

#include <array>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// Experimental: the factors of a cut of a part *M* into two sides: the three factors of the paper
/// (Hoffman and Singh 1997; Zhang and Liu 2005, Section 6), and twelve more. *Q* is the side of
/// smaller area.
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

  /// \name Factors of Boundaries
  /// Two regions that may be merged have a common boundary, which is a cut of their union. These
  /// factors are 0 for all other cuts.
  /// @{

  /// whether the cut is the boundary of two regions that may be merged, and no candidate of the
  /// search
  bool is_boundary = false;

  /// the ratio of the standard deviations of the boundary along its second and its first principal
  /// axis, in [0, 1]: 1 for a circle, 0 for a straight line
  double roundness = 0;

  /// the length of the mean normal of the rest within the distance *r* of the boundary, in [0, 1]:
  /// 1 if the rest is flat there
  double flatness_behind_cut = 0;

  /// the same mean as `concavity_near_cut`, within the distance 2 *r*
  double concavity_around_cut = 0;

  /// the equalized angle distance that three quarters of the length of the boundary reach, in
  /// [0, 1]; 0 at edges that are not concave
  double lower_quartile_of_concavity = 0;

  /// the same as `expansion_behind_cut`, of *Q* and within the distance 2 *r*
  double expansion_before_cut = 0;

  /// how many other regions touch both; it changes while regions are merged
  double number_of_common_neighbors = 0;

  /// how many regions touch *Q* or the rest, whichever fewer touch, without each other: 0 if either
  /// is the end of a limb, more if limbs hang on both; it changes while regions are merged
  double number_of_other_neighbors = 0;

  /// @}

  /// \name Factors of Features
  /// They are 0 without a `face_feature_map`. Features are divided by their standard deviation on
  /// the mesh. The variance that a cut explains is the mean, by area, of the squared distance of
  /// the mean features of a side from those of both.
  /// @{

  /// the named parameter, in [0, 1]; 0 if there are no features
  double feature_weight = 0;

  /// the distance of the mean features of both sides within the distance *r* of the cut
  double feature_step = 0;

  /// the variance of the features within the distance *r* of the cut that it explains, in [0, 1]
  double explained_variance_near_cut = 0;

  /// the variance of the features of *M* that the cut explains, in [0, 1]
  double explained_variance = 0;

  /// the same relative to the variance of the features of the mesh, in [0, 1]
  double explained_variance_of_mesh = 0;

  /// for boundaries: how well features distinguish the parts of the mesh. It is the root of the
  /// mean, over all boundaries of the over-segmentation, of the squared `feature_step` times the
  /// fraction of the variance that the boundary explains;
  /// about 0.1 for noise, 0.2 for a smooth field and 0.6 for the parts of a person with noise.
  double feature_reliability = 0;

  /// @}
};

struct Named_factor
{
  const char* name;
  double Salience_factors::*value;
};

// All factors that are numbers.
constexpr std::array<Named_factor, 15> named_factors = {{
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
  {"number_of_common_neighbors", &Salience_factors::number_of_common_neighbors},
  {"number_of_other_neighbors", &Salience_factors::number_of_other_neighbors}}};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SALIENCE_FACTORS_H
