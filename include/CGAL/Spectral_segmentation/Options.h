// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_OPTIONS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The two methods of `segment_spectral_recursive()`.
enum class Method
{
  CALIBRATED,    ///< the default: over-segmentation, then merging by calibrated salience
  ZHANG_LIU_2005 ///< the recursion of the paper: the largest part is cut next
};

/// \ingroup PkgSpectralSegmentationRef
/// Any model of the concept `PartSalience`.
typedef std::function<double(const Salience_factors&)> Part_salience;

/// \ingroup PkgSpectralSegmentationRef
/// No limit on the number of segments.
constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

/// \ingroup PkgSpectralSegmentationRef
/// The options of a run as a plain struct, for programs that choose them at run time:
/// `parameters::options(o)` hands them to `segment_spectral_recursive()`.
///
/// The defaults are those of the default method; `zhang_liu_2005()` returns those of the paper.
/// Fields with the name of a named parameter mean what it does, see `segment_spectral_recursive()`.
struct Options
{
  /// the method to which the other options belong
  Method method = Method::CALIBRATED;

  std::optional<std::size_t> number_of_segments;             ///< exact; at least 1 if set
  std::size_t maximum_number_of_segments = unlimited;        ///< at least 1
  double salience_threshold = default_probability_threshold; ///< not used with an exact number
  bool components_apart = false;                             ///< `true` in the paper's method
  double minimum_segment_size = 0.003;                       ///< in [0, 0.5]
  Part_salience part_salience = Calibrated_part_salience();  ///< not empty
  std::size_t number_of_searched_faces = 4000;               ///< 0: the mesh itself is searched
  std::size_t number_of_smoothing_iterations = 0;            ///< of the points
  bool boundary_smoothing = false;                           ///< of the labels

  /// \name The Paper's
  /// @{
  double geodesic_weight = 0.03;              ///< the first of `distance_weights`; in [0, 1]
  double concave_angle_weight = 1;            ///< the second; finite and not negative
  double convex_angle_weight = 0.1;           ///< the third; finite and not negative
  std::size_t number_of_reference_faces = 10; ///< at least 1
  std::optional<std::uint64_t> random_seed;   ///< of the first reference faces
  /// @}

  /// \name For Experiments
  /// What the default method is made of, beside the paper's. The coefficients of
  /// `Calibrated_part_salience` were fitted with these values; the section \ref
  /// Spectral_segmentation_ablation has what each of them gains.
  /// @{
  double concavity_radius = 0.02; ///< of bending, by the root of the area; 0: dihedral angles
  bool bisection = true;          ///< of faces that are larger than those searched shall be
  bool single_source_orders = true;             ///< search along distances from single faces too
  std::size_t number_of_candidates = 14;        ///< cuts of a part whose factors are all computed
  std::size_t number_of_refined_candidates = 4; ///< of these, moved to minimum cuts near them
  std::size_t number_of_regions = 20;           ///< of the over-segmentation; at least 1
  /// @}

  /// the options of the paper, but for `minimum_segment_size`, which it does not have, and
  /// `salience_threshold`, which it leaves to the user
  static Options zhang_liu_2005()
  {
    Options o;
    o.method = Method::ZHANG_LIU_2005;
    o.salience_threshold = default_salience_threshold;
    o.components_apart = true;
    o.minimum_segment_size = 0.005;
    o.part_salience = Weighted_part_salience();
    o.number_of_searched_faces = 0;
    o.geodesic_weight = 0.01;
    o.concavity_radius = 0;
    o.bisection = false;
    o.single_source_orders = false;
    return o;
  }

  /// throws `std::invalid_argument` with a sentence that names the option if a value is out of its
  /// range; `segment_spectral_recursive()` calls it
  void check() const
  {
    const auto require = [](bool condition, const char* option, const char* range) {
      if (!condition)
        throw std::invalid_argument(std::string("segment_spectral_recursive: ") + option +
                                    " must be " + range);
    };
    const auto is_weight = [](double w) { return w >= 0 && std::isfinite(w); };
    require(!number_of_segments || *number_of_segments >= 1, "number_of_segments", "at least 1");
    require(maximum_number_of_segments >= 1, "maximum_number_of_segments", "at least 1");
    require(!std::isnan(salience_threshold), "salience_threshold", "a number");
    require(components_apart || method == Method::CALIBRATED, "components_apart",
            "true with zhang_liu_2005()");
    require(minimum_segment_size >= 0 && minimum_segment_size <= 0.5, "minimum_segment_size",
            "in [0, 0.5]");
    require(static_cast<bool>(part_salience), "part_salience", "a function");
    if (const auto* w = part_salience.target<Weighted_part_salience>())
      require(w->alpha >= 0 && w->beta >= 0 && w->gamma >= 0 &&
              std::abs(w->alpha + w->beta + w->gamma - 1) < 1e-6,
              "salience_weights", "not negative and sum to 1");
    require(geodesic_weight >= 0 && geodesic_weight <= 1, "the first of distance_weights",
            "in [0, 1]");
    require(is_weight(concave_angle_weight) && is_weight(convex_angle_weight),
            "the second and third of distance_weights", "finite and not negative");
    require(number_of_reference_faces >= 1, "number_of_reference_faces", "at least 1");
    require(is_weight(concavity_radius), "concavity_radius", "finite and not negative");
    require(number_of_regions >= 1, "number_of_regions", "at least 1");
  }

  /// \cond SKIP_IN_MANUAL

  std::size_t maximum() const { return number_of_segments.value_or(maximum_number_of_segments); }

  // An exact number is reached whatever the saliences.
  double threshold() const
  {
    return number_of_segments ? -std::numeric_limits<double>::infinity() : salience_threshold;
  }

  // The number of regions of the over-segmentation of a connected mesh. Beyond 200 regions an exact
  // number is reached by halving, without search.
  std::size_t regions() const
  {
    if (maximum() == unlimited)
      return number_of_regions;
    const std::size_t most = number_of_segments ? 10 * number_of_regions : unlimited;
    return (std::max)(number_of_regions, (std::min)(maximum(), most));
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

  /// \endcond
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_OPTIONS_H
