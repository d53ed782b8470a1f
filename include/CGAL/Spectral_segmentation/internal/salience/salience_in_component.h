// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_SALIENCE_IN_COMPONENT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_SALIENCE_IN_COMPONENT_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <cmath>

namespace CGAL::Spectral_segmentation::internal {

// Returns the salience of a cut inside of a component with a share of the area. Who put a model
// together of components has already separated most of what is separate. Therefore the logit is
// lowered by 48 (0.9 - share), unless the component is nearly the whole, as a body with eyes and
// teeth. The more features count than the shape, the less this counts. A salience that is no
// probability stays.
inline double salience_in_component(double salience, double share,
                                    const Salience_factors& factors)
{
  if (!(salience > 0 && salience < 1) || share >= 0.9)
    return salience;
  const double penalty = 48 * (0.9 - share) * (1 - Feature_logit::fading(factors.feature_weight));
  const double odds = salience / (1 - salience) * std::exp(-penalty);
  return odds / (1 + odds);
}

// The share of the area from which a component is a part by default.
constexpr double share_at_threshold = 0.01;

// Returns the salience of the boundary of a component with a share of the area. It rises from 0 to
// 1, through the default threshold. `logit` is what else speaks for the boundary.
inline double salience_of_component(double share, double logit)
{
  const double odds =
    default_probability_threshold / (1 - default_probability_threshold) * std::exp(logit);
  return odds * share / (odds * share + share_at_threshold);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_SALIENCE_IN_COMPONENT_H
