// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_OPTIONS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// A model of the concept `PartSalience`.
typedef std::function<double(const Salience_factors&)> Part_salience;

constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

// What the caller can choose. The defaults are the paper's, but for the minimum size, which it does
// not have, and the threshold, which it leaves to the user.
struct Options
{
  std::size_t maximum_number_of_segments = unlimited;
  double minimum_segment_size = default_minimum_segment_size(Method::ZHANG_LIU_2005);
  double salience_threshold = default_salience_threshold;
  Part_salience part_salience = Weighted_part_salience();
  double geodesic_weight = 0.01;
  double concave_angle_weight = 1;
  double convex_angle_weight = 0.1;
  double concavity_radius = 0;
  std::size_t number_of_reference_faces = 10;
  bool single_source_orderings = false;
  bool thickness_orderings = false;
  std::size_t number_of_candidates = 0;
  std::size_t number_of_refined_candidates = 0;
  std::size_t number_of_pieces = 0;
  std::size_t number_of_searched_faces = 0;
  std::size_t number_of_smoothing_iterations = 0;
  bool boundary_smoothing = false;
  std::optional<std::uint64_t> random_seed;

  bool judges_by_all_factors() const { return number_of_candidates > 0 || number_of_pieces > 0; }

  bool needs_thickness() const
  {
    return thickness_orderings ||
           (judges_by_all_factors() && !part_salience.target<Weighted_part_salience>());
  }

  // The number of faces on which the cuts of a mesh are searched: `number_of_searched_faces` for up
  // to 20 pieces, and in proportion for more. Without pieces it must not depend on the number of
  // segments, as a tree gives the labels of runs with fewer.
  std::size_t faces_to_search(std::size_t number_of_faces) const
  {
    const std::size_t pieces = number_of_pieces == 0 || maximum_number_of_segments == unlimited
      ? number_of_pieces : (std::max)(number_of_pieces, maximum_number_of_segments);
    const double number = static_cast<double>(number_of_searched_faces) *
                          (std::max)(static_cast<double>(pieces) / 20, 1.);
    return number > 0 && number < static_cast<double>(number_of_faces)
      ? static_cast<std::size_t>(number) : number_of_faces;
  }
};

inline Options calibrated_options()
{
  Options o;
  o.minimum_segment_size = default_minimum_segment_size(Method::CALIBRATED);
  o.salience_threshold = default_probability_threshold;
  o.part_salience = Calibrated_part_salience();
  o.geodesic_weight = 0.03;
  o.concavity_radius = 0.02;
  o.single_source_orderings = true;
  o.thickness_orderings = true;
  o.number_of_candidates = 14;
  o.number_of_refined_candidates = 4;
  o.number_of_pieces = 20;
  o.number_of_searched_faces = 4000;
  return o;
}

inline void require(bool condition, const char* parameter, const char* range)
{
  if (!condition)
    throw std::invalid_argument(std::string("segment_spectral_recursive: ") + parameter +
                                " must be " + range);
}

// Leaves `value` as it is where the caller did not give the parameter.
template <class Tag, class NamedParameters, class Value>
void read_parameter(const NamedParameters& np, Tag tag, Value& value)
{
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value)
    value = CGAL::parameters::get_parameter(np, tag);
}

template <class Tag, class NamedParameters>
void read_count(const NamedParameters& np, Tag tag, const char* name, std::size_t smallest,
                const char* range, std::size_t& value)
{
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto given = CGAL::parameters::get_parameter(np, tag);
    require(given >= 0 && static_cast<std::size_t>(given) >= smallest, name, range);
    value = static_cast<std::size_t>(given);
  }
}

// The threshold follows the salience.
template <class NamedParameters>
void read_part_salience(const NamedParameters& np, Options& o)
{
  typedef internal_np::part_salience_t Tag;
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value) {
    const auto model = CGAL::parameters::get_parameter(np, Tag());
    typedef std::decay_t<decltype(model)> Model;
    if constexpr (std::is_same<Model, Weighted_part_salience>::value) {
      require(model.alpha >= 0 && model.beta >= 0 && model.gamma >= 0 &&
              std::abs(model.alpha + model.beta + model.gamma - 1) < 1e-6,
              "salience_weights", "not negative and sum to 1");
      o.salience_threshold = default_salience_threshold;
    }
    else
      o.salience_threshold = default_probability_threshold;
    o.part_salience = model;
  }
}

// Throws `std::invalid_argument` for a value out of its range.
template <class NamedParameters>
Options read_options(const NamedParameters& np)
{
  namespace tags = internal_np;
  Method method = Method::CALIBRATED;
  read_parameter(np, tags::method, method);
  Options o = method == Method::CALIBRATED ? calibrated_options() : Options();
  read_part_salience(np, o);
  read_count(np, tags::maximum_number_of_segments, "maximum_number_of_segments", 1, "at least 1",
             o.maximum_number_of_segments);
  read_parameter(np, tags::minimum_segment_size, o.minimum_segment_size);
  read_parameter(np, tags::salience_threshold, o.salience_threshold);
  read_parameter(np, tags::geodesic_weight, o.geodesic_weight);
  read_parameter(np, tags::concave_angle_weight, o.concave_angle_weight);
  read_parameter(np, tags::convex_angle_weight, o.convex_angle_weight);
  read_parameter(np, tags::concavity_radius, o.concavity_radius);
  read_count(np, tags::number_of_reference_faces, "number_of_reference_faces", 1, "at least 1",
             o.number_of_reference_faces);
  read_parameter(np, tags::single_source_orderings, o.single_source_orderings);
  read_parameter(np, tags::thickness_orderings, o.thickness_orderings);
  read_count(np, tags::number_of_candidates, "number_of_candidates", 0, "at least 0",
             o.number_of_candidates);
  read_count(np, tags::number_of_refined_candidates, "number_of_refined_candidates", 0,
             "at least 0", o.number_of_refined_candidates);
  read_count(np, tags::number_of_pieces, "number_of_pieces", 0, "0 or at least 2",
             o.number_of_pieces);
  read_count(np, tags::number_of_searched_faces, "number_of_searched_faces", 0, "at least 0",
             o.number_of_searched_faces);
  read_count(np, tags::number_of_smoothing_iterations, "number_of_smoothing_iterations", 0,
             "at least 0", o.number_of_smoothing_iterations);
  read_parameter(np, tags::boundary_smoothing, o.boundary_smoothing);
  if constexpr (!CGAL::parameters::is_default_parameter<
                  NamedParameters, CGAL::internal_np::random_seed_t>::value) {
    const auto seed = CGAL::parameters::get_parameter(np, CGAL::internal_np::random_seed);
    static_assert(tags::is_count<std::decay_t<decltype(seed)> >::value,
                  "random_seed takes an integer");
    o.random_seed = static_cast<std::uint64_t>(seed);
  }

  require(o.minimum_segment_size >= 0 && o.minimum_segment_size <= 0.5, "minimum_segment_size",
          "in [0, 0.5]");
  require(!std::isnan(o.salience_threshold), "salience_threshold", "a number");
  require(o.geodesic_weight >= 0 && o.geodesic_weight <= 1, "geodesic_weight", "in [0, 1]");
  require(o.concave_angle_weight >= 0 && std::isfinite(o.concave_angle_weight),
          "concave_angle_weight", "finite and not negative");
  require(o.convex_angle_weight >= 0 && std::isfinite(o.convex_angle_weight),
          "convex_angle_weight", "finite and not negative");
  require(o.concavity_radius >= 0 && o.concavity_radius <= 1, "concavity_radius", "in [0, 1]");
  require(o.number_of_pieces != 1, "number_of_pieces", "0 or at least 2");
  return o;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_OPTIONS_H
