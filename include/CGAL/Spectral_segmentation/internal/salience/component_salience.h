// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_COMPONENT_SALIENCE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_COMPONENT_SALIENCE_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Spectral_segmentation::internal {

// The share of the area from which a component is a part by default.
constexpr double share_at_threshold = 0.01;

// Returns the salience of the boundary of a component with a share of the area. It rises from 0 to
// 1, through the default threshold. `logit` is added to its logit.
inline double salience_of_component(double share, double logit)
{
  const double odds =
    default_probability_threshold / (1 - default_probability_threshold) * std::exp(logit);
  return odds * share / (odds * share + share_at_threshold);
}

// Returns the logit of a probability, which is kept away from 0 and 1.
inline double clamped_logit(double probability)
{
  const double p = std::clamp(probability, 1e-6, 1 - 1e-6);
  return std::log(p / (1 - p));
}

// Returns the evidence that a cut gives for parts in its component: what its logit exceeds that of
// the default threshold by.
inline double evidence_of_cut(double salience)
{ return (std::max)(clamped_logit(salience) - clamped_logit(default_probability_threshold), 0.); }

// Returns the evidence of all its cuts that a component needs to be cut, in a model of an effective
// number of components. Who puts a model together of many components has separated most of what is
// separate. A body has many cuts that are each likely, a board one or two that are barely so. The
// constants were chosen on furniture, and on animals beside other objects.
inline double required_evidence(double effective_number_of_components)
{ return (std::min)(2.5 * (effective_number_of_components - 1), 6.); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_COMPONENT_SALIENCE_H
