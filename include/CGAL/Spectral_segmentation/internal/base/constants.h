// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_CONSTANTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_CONSTANTS_H

#include <cstddef>

namespace CGAL::Spectral_segmentation::internal {

// The constants on which, besides `Options`, the factors of cuts and therefore the fit of
// `Calibrated_part_salience` depend. They were chosen by trials on a prototype of the method. If
// one of them changes, the salience has to be fitted again (benchmark/fit_part_salience).
namespace constants {

// The radius of the neighborhood of a cut, in which factors are measured and minimum cuts are
// searched, relative to the square root of the area of the smaller side.
constexpr double neighborhood_radius = 0.35;

// The constant that is added to convexity defects before their ratio is taken. Defects well below
// it, relative to the square root of the area of the mesh, make no difference.
constexpr double smallest_convexity_defect = 0.005;

// The largest value of the factor `expansion_behind_cut`.
constexpr double largest_expansion = 4;

// The cost of an edge of the strongest concavity for a minimum cut, relative to a flat edge.
constexpr double cost_of_concave_edge = 0.05;

// The second proposal of an order differs from the first by this fraction of the smaller area.
constexpr double distance_of_proposals = 0.25;

// Two proposals are alike if the faces on which they differ are less than so many percent of the
// smallest side.
constexpr std::size_t percent_of_alike_proposals = 15;

// Proposals are taken while Q has at most this many times the area of the rest, because other
// orders start at the other end.
constexpr double largest_ratio_to_rest = 3;

// The curvature is averaged over a radius of at most the root of this number of mean face areas,
// about 9 faces, because the bands around the cuts of a coarsened mesh are not wider.
constexpr double largest_number_of_averaged_faces = 80;

} // namespace constants
} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_CONSTANTS_H
