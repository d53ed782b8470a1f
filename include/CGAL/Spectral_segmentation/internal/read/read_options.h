// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_OPTIONS_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstdint>
#include <type_traits>

namespace CGAL::Spectral_segmentation::internal {

// Sets the options that are a number or a truth value to those that the caller gave.
template <class NamedParameters>
void read_values(const NamedParameters& np, Options& o)
{
#define CGAL_SPECTRAL_SEGMENTATION_READ(np, name, predicate, what, least, greatest)  \
  if constexpr (is_given<NamedParameters, internal_np::name##_t>)                    \
    Option_description::of(o.name, #name, least, greatest)                           \
      .set(o.name, CGAL::parameters::get_parameter(np, internal_np::name));
  CGAL_SPECTRAL_SEGMENTATION_OPTIONS(CGAL_SPECTRAL_SEGMENTATION_READ, np)
#undef CGAL_SPECTRAL_SEGMENTATION_READ
}

template <class NamedParameters>
void read_distance_weights(const NamedParameters& np, Options& o)
{
  typedef internal_np::distance_weights_t Tag;
  if constexpr (is_given<NamedParameters, Tag>) {
    const auto [delta, concave, convex] = CGAL::parameters::get_parameter(np, Tag());
    o.geodesic_weight = delta;
    o.concave_angle_weight = concave;
    o.convex_angle_weight = convex;
  }
}

// Returns the options of the preset, or the options that the caller gave, before the other
// parameters change them.
template <class NamedParameters>
Options preset_options(const NamedParameters& np)
{
  namespace tags = internal_np;
  constexpr bool uses_paper_method = is_given<NamedParameters, tags::zhang_liu_2005_t>;
  constexpr bool has_options = is_given<NamedParameters, tags::options_t>;
  static_assert(!(uses_paper_method && has_options),
                "options does not go with zhang_liu_2005: use Options::zhang_liu_2005()");
  static_assert(!(uses_paper_method && (is_given<NamedParameters, tags::edge_is_constrained_t> ||
                                        is_given<NamedParameters, tags::edge_is_uncuttable_map_t> ||
                                        is_given<NamedParameters, tags::face_seed_map_t> ||
                                        is_given<NamedParameters, tags::face_feature_map_t>)),
                "edge_is_constrained_map, edge_is_uncuttable_map, face_seed_map and "
                "face_feature_map do not go with zhang_liu_2005");
  if constexpr (has_options)
    return CGAL::parameters::get_parameter(np, tags::options);
  else
    return uses_paper_method ? Options::zhang_liu_2005() : Options();
}

// Reads the options. Throws `std::invalid_argument` for a value out of range.
template <class NamedParameters>
Options read_options(const NamedParameters& np)
{
  namespace tags = internal_np;
  static_assert(!(is_given<NamedParameters, tags::number_of_segments_t> &&
                  (is_given<NamedParameters, tags::maximum_number_of_segments_t> ||
                   is_given<NamedParameters, tags::salience_threshold_t>)),
                "number_of_segments goes neither with maximum_number_of_segments nor with "
                "salience_threshold");
  Options o = preset_options(np);
  if constexpr (is_given<NamedParameters, tags::part_salience_t>)
    o.part_salience = CGAL::parameters::get_parameter(np, tags::part_salience);
  read_distance_weights(np, o);
  read_values(np, o);
  if constexpr (is_given<NamedParameters, tags::random_seed_t>) {
    const auto seed = CGAL::parameters::get_parameter(np, CGAL::internal_np::random_seed);
    static_assert(tags::is_count<std::decay_t<decltype(seed)> >::value,
                  "random_seed takes an integer");
    o.random_seed = static_cast<std::uint64_t>(seed);
  }
  check(o);
  return o;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_OPTIONS_H
