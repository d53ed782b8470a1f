// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_OPTIONS_H

#include <CGAL/Spectral_segmentation/internal/Options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::Spectral_segmentation::internal {

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
  if constexpr (is_given<NamedParameters, Tag>)
    value = static_cast<Value>(CGAL::parameters::get_parameter(np, tag));
}

template <class Tag, class NamedParameters>
void read_count(const NamedParameters& np, Tag tag, const char* name, std::size_t smallest,
                const char* range, std::size_t& value)
{
  if constexpr (is_given<NamedParameters, Tag>) {
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
  if constexpr (is_given<NamedParameters, Tag>) {
    const auto model = CGAL::parameters::get_parameter(np, Tag());
    o.salience_threshold = default_probability_threshold;
    if constexpr (std::is_same<std::decay_t<decltype(model)>, Weighted_part_salience>::value) {
      require(model.alpha >= 0 && model.beta >= 0 && model.gamma >= 0 &&
              std::abs(model.alpha + model.beta + model.gamma - 1) < 1e-6,
              "salience_weights", "not negative and sum to 1");
      o.salience_threshold = default_salience_threshold;
    }
    o.part_salience = model;
  }
}

template <class NamedParameters>
void read_distance_weights(const NamedParameters& np, Options& o)
{
  typedef internal_np::distance_weights_t Tag;
  if constexpr (is_given<NamedParameters, Tag>) {
    const auto [delta, concave, convex] = CGAL::parameters::get_parameter(np, Tag());
    require(delta >= 0 && delta <= 1, "the first of distance_weights", "in [0, 1]");
    require(concave >= 0 && std::isfinite(concave) && convex >= 0 && std::isfinite(convex),
            "the second and third of distance_weights", "finite and not negative");
    o.geodesic_weight = delta;
    o.concave_angle_weight = concave;
    o.convex_angle_weight = convex;
  }
}

// Throws `std::invalid_argument` for a value out of its range.
template <class NamedParameters>
Options read_options(const NamedParameters& np)
{
  namespace tags = internal_np;
  Options o = is_given<NamedParameters, tags::zhang_liu_2005_t> ? zhang_liu_2005_options()
                                                                : calibrated_options();
  static_assert(!(is_given<NamedParameters, tags::zhang_liu_2005_t> &&
                  (is_given<NamedParameters, tags::edge_is_constrained_t> ||
                   is_given<NamedParameters, tags::edge_is_uncuttable_map_t> ||
                   is_given<NamedParameters, tags::face_seed_map_t>)),
                "edge_is_constrained_map, edge_is_uncuttable_map and face_seed_map do not go with "
                "zhang_liu_2005");
  read_part_salience(np, o);
  read_distance_weights(np, o);
  read_count(np, tags::maximum_number_of_segments, "maximum_number_of_segments", 1, "at least 1",
             o.maximum_number_of_segments);
  static_assert(!(is_given<NamedParameters, tags::number_of_segments_t> &&
                  (is_given<NamedParameters, tags::maximum_number_of_segments_t> ||
                   is_given<NamedParameters, tags::salience_threshold_t>)),
                "number_of_segments goes neither with maximum_number_of_segments nor with "
                "salience_threshold");
  if constexpr (is_given<NamedParameters, tags::number_of_segments_t>) {
    read_count(np, tags::number_of_segments, "number_of_segments", 1, "at least 1",
               o.maximum_number_of_segments);
    o.is_number_exact = true;
    o.salience_threshold = -std::numeric_limits<double>::infinity();
  }
  read_parameter(np, tags::components_apart, o.components_apart);
  require(o.components_apart || o.method == Method::CALIBRATED, "components_apart",
          "true with zhang_liu_2005()");
  read_parameter(np, tags::minimum_segment_size, o.minimum_segment_size);
  require(o.minimum_segment_size >= 0 && o.minimum_segment_size <= 0.5, "minimum_segment_size",
          "in [0, 0.5]");
  read_parameter(np, tags::salience_threshold, o.salience_threshold);
  require(!std::isnan(o.salience_threshold), "salience_threshold", "a number");
  read_count(np, tags::number_of_reference_faces, "number_of_reference_faces", 1, "at least 1",
             o.number_of_reference_faces);
  read_count(np, tags::number_of_searched_faces, "number_of_searched_faces", 0, "at least 0",
             o.number_of_searched_faces);
  read_count(np, tags::number_of_smoothing_iterations, "number_of_smoothing_iterations", 0,
             "at least 0", o.number_of_smoothing_iterations);
  read_parameter(np, tags::boundary_smoothing, o.boundary_smoothing);
  if constexpr (is_given<NamedParameters, tags::random_seed_t>) {
    const auto seed = CGAL::parameters::get_parameter(np, CGAL::internal_np::random_seed);
    static_assert(tags::is_count<std::decay_t<decltype(seed)> >::value,
                  "random_seed takes an integer");
    o.random_seed = static_cast<std::uint64_t>(seed);
  }
  return o;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_READ_OPTIONS_H
