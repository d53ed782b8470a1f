// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_OPTIONS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

namespace CGAL::Spectral_segmentation::internal {

enum class Execution { SEQUENTIAL, PARALLEL }; // on one thread; on all that TBB has

enum class Method
{
  ZHANG_LIU_2005, // the recursion of the paper: the largest part is cut next
  CALIBRATED      // over-segmentation, the most salient cut first; then region merging
};

// A model of the concept `PartSalience`.
typedef std::function<double(const Salience_factors&)> Part_salience;

constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

// What a run can be told. The first group has named parameters; the second is what a method is made
// of, which experiments change. The defaults are the paper's, but for the minimum size, which it
// does not have, and the threshold, which it leaves to the user.
struct Options
{
  std::size_t maximum_number_of_segments = unlimited;
  bool is_number_exact = false;    // the maximum number is the number, whatever the saliences
  bool components_apart = true;    // components of the mesh have no part in common
  double minimum_segment_size = 0.005;
  double salience_threshold = default_salience_threshold;
  Part_salience part_salience = Weighted_part_salience();
  double geodesic_weight = 0.01;
  double concave_angle_weight = 1;
  double convex_angle_weight = 0.1;
  std::size_t number_of_reference_faces = 10;
  std::size_t number_of_searched_faces = 0;
  std::size_t number_of_smoothing_iterations = 0;
  bool boundary_smoothing = false;
  std::optional<std::uint64_t> random_seed;

  Method method = Method::ZHANG_LIU_2005;
  double concavity_radius = 0;
  bool refinement = false; // faces are bisected that are larger than the searched ones shall be
  bool single_source_orders = false;
  std::size_t number_of_candidates = 0;
  std::size_t number_of_refined_candidates = 0;
  std::size_t number_of_regions = 0;

  // The number of regions of the over-segmentation of a connected mesh. What an exact number needs
  // beyond 200 are cuts without a search.
  std::size_t regions() const
  {
    if (maximum_number_of_segments == unlimited)
      return number_of_regions;
    const std::size_t most = is_number_exact ? 10 * number_of_regions : unlimited;
    return (std::max)(number_of_regions, (std::min)(maximum_number_of_segments, most));
  }

  // The number of faces on which the cuts of a mesh are searched: `number_of_searched_faces`, and
  // in proportion if more regions are needed than by default. In the paper's recursion it must not
  // depend on the number of segments, as a hierarchy gives the labels of runs with fewer.
  std::size_t faces_to_search(std::size_t number_of_faces) const
  {
    const double growth = method == Method::CALIBRATED
      ? static_cast<double>(regions()) / static_cast<double>(number_of_regions) : 1;
    const double number = static_cast<double>(number_of_searched_faces) * growth;
    return number > 0 && number < static_cast<double>(number_of_faces)
      ? static_cast<std::size_t>(number) : number_of_faces;
  }
};

inline Options zhang_liu_2005_options() { return Options(); }

// The numbers that the calibrated salience was fitted with: it has to be fitted again
// (benchmark/fit_part_salience) if one of them is changed. What each gains is on the manual's page
// of figures.
inline Options calibrated_options()
{
  Options o;
  o.method = Method::CALIBRATED;
  o.minimum_segment_size = 0.003;
  o.salience_threshold = default_probability_threshold;
  o.part_salience = Calibrated_part_salience();
  o.geodesic_weight = 0.03;
  o.concavity_radius = 0.02;
  o.single_source_orders = true;
  o.number_of_candidates = 14;
  o.number_of_refined_candidates = 4;
  o.number_of_regions = 20;
  o.number_of_searched_faces = 4000;
  o.refinement = true;
  o.components_apart = false;
  return o;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_OPTIONS_H
