// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_NAMED_FACTORS_H
#define SEGMENT_MESH_NAMED_FACTORS_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>

namespace segment_mesh {

using CGAL::Spectral_segmentation::Salience_factors;

struct Named_factor
{
  const char* name;
  double Salience_factors::*value;
};

// The factors that are numbers.
constexpr Named_factor named_factors[] = {
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
  {"number_of_common_neighbors", &Salience_factors::number_of_common_neighbors}};

} // namespace segment_mesh

#endif // SEGMENT_MESH_NAMED_FACTORS_H
