// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_OPTIONS_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::Spectral_segmentation::internal {

// Leaves `value` as it is where the caller did not give the parameter.
template <class Tag, class NamedParameters, class Value>
void read_parameter(const NamedParameters& np, Tag tag, Value& value)
{
  if constexpr (is_given<NamedParameters, Tag>)
    value = CGAL::parameters::get_parameter(np, tag);
}

template <class Tag, class NamedParameters, class Count>
void read_count(const NamedParameters& np, Tag tag, const char* name, Count& value)
{
  if constexpr (is_given<NamedParameters, Tag>) {
    const auto given = CGAL::parameters::get_parameter(np, tag);
    if (given < 0)
      throw std::invalid_argument(std::string("segment_spectral_recursive: ") + name +
                                  " must not be negative");
    value = static_cast<std::size_t>(given);
  }
}

// The threshold follows the salience.
template <class NamedParameters>
void read_part_salience(const NamedParameters& np, Options& o)
{
  typedef internal_np::part_salience_t Tag;
  if constexpr (is_given<NamedParameters, Tag>) {
    const auto model = CGAL::parameters::get_parameter(np, Tag());
    o.part_salience = model;
    o.salience_threshold =
      std::is_same<std::decay_t<decltype(model)>, Weighted_part_salience>::value
        ? default_salience_threshold : default_probability_threshold;
  }
}

// Throws `std::invalid_argument` for a value out of its range.
template <class NamedParameters>
Options read_options(const NamedParameters& np)
{
  namespace tags = internal_np;
  constexpr bool is_of_paper = is_given<NamedParameters, tags::zhang_liu_2005_t>;
  static_assert(!(is_of_paper && is_given<NamedParameters, tags::options_t>),
                "options and zhang_liu_2005 do not go together: give "
                "Options::zhang_liu_2005() as options");
  static_assert(!(is_of_paper && has_constraints<NamedParameters>),
                "edge_is_constrained_map, edge_is_uncuttable_map and face_seed_map do not go with "
                "zhang_liu_2005");
  static_assert(!(is_given<NamedParameters, tags::number_of_segments_t> &&
                  (is_given<NamedParameters, tags::maximum_number_of_segments_t> ||
                   is_given<NamedParameters, tags::salience_threshold_t>)),
                "number_of_segments goes neither with maximum_number_of_segments nor with "
                "salience_threshold");
  Options o = is_of_paper ? Options::zhang_liu_2005() : Options();
  read_parameter(np, tags::options, o);
  read_part_salience(np, o);
  read_count(np, tags::number_of_segments, "number_of_segments", o.number_of_segments);
  read_count(np, tags::maximum_number_of_segments, "maximum_number_of_segments",
             o.maximum_number_of_segments);
  read_parameter(np, tags::components_apart, o.components_apart);
  read_parameter(np, tags::minimum_segment_size, o.minimum_segment_size);
  read_parameter(np, tags::salience_threshold, o.salience_threshold);
  read_count(np, tags::number_of_searched_faces, "number_of_searched_faces",
             o.number_of_searched_faces);
  read_count(np, tags::number_of_smoothing_iterations, "number_of_smoothing_iterations",
             o.number_of_smoothing_iterations);
  read_parameter(np, tags::boundary_smoothing, o.boundary_smoothing);
  if constexpr (is_given<NamedParameters, tags::random_seed_t>) {
    const auto seed = CGAL::parameters::get_parameter(np, CGAL::internal_np::random_seed);
    static_assert(tags::is_count<std::decay_t<decltype(seed)> >::value,
                  "random_seed takes an integer");
    o.random_seed = static_cast<std::uint64_t>(seed);
  }
  o.check();
  return o;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_OPTIONS_H
