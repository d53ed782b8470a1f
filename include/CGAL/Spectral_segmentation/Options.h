// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_OPTIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_OPTIONS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The two methods of `segment_spectral_recursive()`.
enum class Method
{
  /// the calibrated method (default): over-segmentation, the most salient cut first; then region
  /// merging
  CALIBRATED,
  /// the recursion of the paper: the largest part is cut next
  ZHANG_LIU_2005
};

/// \ingroup PkgSpectralSegmentationRef
/// Any model of the concept `PartSalience`, chosen at run time.
typedef std::function<double(const Salience_factors&)> Part_salience;

/// \ingroup PkgSpectralSegmentationRef
/// The value for no limit on the number of segments.
constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

/// \ingroup PkgSpectralSegmentationRef
/// The options of a run as a plain struct, for programs that choose them at run time. The named
/// parameter `options(o)` passes them to `segment_spectral_recursive()`.
///
/// `Options()` has the defaults of the calibrated method (default), and `Options::zhang_liu_2005()`
/// has the defaults of the method of the paper. A field with the name of a named parameter has the
/// same meaning; see `segment_spectral_recursive()`.
struct Options
{
  /// the method. The presets `Options()` and `Options::zhang_liu_2005()` set it and all other
  /// fields.
  Method method = Method::CALIBRATED;

  /// the exact number, at least 1. If it is set, `maximum_number_of_segments` and
  /// `salience_threshold` are not used.
  std::optional<std::size_t> number_of_segments;
  std::size_t maximum_number_of_segments = unlimited;        ///< at least 1
  /// not NaN; of a `Calibrated_part_salience` in [0, 1], or infinite. If it is not set, see
  /// `threshold_of()`.
  std::optional<double> salience_threshold;
  bool keep_components_separate = false;                     ///< `true` in the paper's method
  double minimum_segment_size = 0.003;                       ///< in [0, 0.5]
  double feature_weight = 0.5;                               ///< in [0, 1]
  Part_salience part_salience = Calibrated_part_salience();  ///< not empty
  std::size_t number_of_coarse_faces = 3400;               ///< with 0 the mesh itself is searched
  std::size_t number_of_searches = 5;                      ///< 1 in the paper's method
  std::size_t number_of_smoothing_iterations = 0; ///< smooths the points, at most 10^5 times

  /// \name Parameters of the Paper
  /// @{
  double geodesic_weight = 0.03;              ///< the first of `distance_weights`, in [0, 1]
  double concave_angle_weight = 1;            ///< the second, finite and not negative
  double convex_angle_weight = 0.1;           ///< the third, finite and not negative
  std::size_t number_of_reference_faces = 3;  ///< from 1 to 1000; 10 in the paper's method
  std::optional<std::uint64_t> random_seed;   ///< chooses the first reference faces at random
  /// @}

  /// returns the options of the method of the paper. The value of `minimum_segment_size`, which
  /// the paper does not have, is the package's.
  static Options zhang_liu_2005()
  {
    Options o;
    o.method = Method::ZHANG_LIU_2005;
    o.keep_components_separate = true;
    o.minimum_segment_size = 0.005;
    o.part_salience = Weighted_part_salience();
    o.number_of_coarse_faces = 0;
    o.number_of_searches = 1;
    o.geodesic_weight = 0.01;
    o.number_of_reference_faces = 10;
    return o;
  }
};

// The options that are a number or a truth value, whose named parameters have their names, as
// f(g, name, predicate of the type of the parameter, expected value, least, greatest).
#define CGAL_SPECTRAL_SEGMENTATION_OPTIONS(f, g)                                                 \
  f(g, number_of_segments, is_count, "takes an integer", 1, INFINITY)                            \
  f(g, maximum_number_of_segments, is_count, "takes an integer", 1, INFINITY)                    \
  f(g, salience_threshold, is_real, "takes a number", -INFINITY, INFINITY)                       \
  f(g, keep_components_separate, is_flag, "takes a bool", 0, 1)                                  \
  f(g, minimum_segment_size, is_real, "takes a number", 0, 0.5)                                  \
  f(g, feature_weight, is_real, "takes a number", 0, 1)                                          \
  f(g, number_of_coarse_faces, is_count, "takes an integer", 0, INFINITY)                        \
  f(g, number_of_searches, is_count, "takes an integer", 1, 100)                                 \
  f(g, number_of_smoothing_iterations, is_count, "takes an integer", 0, 100000)                  \
  f(g, number_of_reference_faces, is_count, "takes an integer", 1, 1000)

/// \ingroup PkgSpectralSegmentationRef
/// The description of an option, which `for_each_option()` passes on.
struct Option_description
{
  const char* name;      ///< of the field
  std::string_view kind; ///< "integer", "number" or "boolean"
  double least;          ///< can be `-INFINITY`
  double greatest;       ///< can be `INFINITY`

  /// describes a field.
  template <class Field>
  static constexpr Option_description of(const Field&, const char* name, double least,
                                         double greatest)
  {
    return {name, std::is_same<Field, bool>::value ? "boolean"
                  : std::is_same<Field, double>::value ||
                    std::is_same<Field, std::optional<double> >::value ? "number" : "integer",
            least, greatest};
  }

  /// throws `std::invalid_argument` if a value is out of the range. The message names the option
  /// and its range.
  void check(double value) const
  {
    if (value >= least && value <= greatest) // false for NaN
      return;
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "segment_spectral_recursive: " << name << " must be ";
    if (kind == "integer")
      out << (value < least ? "at least " : "at most ") << (value < least ? least : greatest);
    else if (std::isinf(least))
      out << "a number";
    else
      out << "in [" << least << ", " << greatest << "]";
    throw std::invalid_argument(out.str());
  }

  /// sets the field to a value of any type of number, after `check()`.
  template <class Field, class Value>
  void set(Field& field, Value value) const
  {
    check(static_cast<double>(value));
    field = static_cast<Field>(value);
  }
};

/// \ingroup PkgSpectralSegmentationRef
/// calls `visit(description, o.field)` for each field that is a number or a truth value, so that a
/// program can read or write all options without a list of their names. `random_seed` and the
/// weights of distances are left out.
/// \tparam Options_ `Options` or `const Options`
template <class Options_, class Visit>
void for_each_option(Options_& o, const Visit& visit)
{
#define CGAL_SPECTRAL_SEGMENTATION_VISIT(visit, name, predicate, what, least, greatest) \
  visit(Option_description::of(o.name, #name, least, greatest), o.name);
  CGAL_SPECTRAL_SEGMENTATION_OPTIONS(CGAL_SPECTRAL_SEGMENTATION_VISIT, visit)
#undef CGAL_SPECTRAL_SEGMENTATION_VISIT
}

/// \ingroup PkgSpectralSegmentationRef
/// throws `std::invalid_argument` if a value is out of its range. The message names the option and
/// its range. `segment_spectral_recursive()` calls this function.
inline void check(const Options& o)
{
  const auto require = [](bool condition, const char* option, const char* range) {
    if (!condition)
      throw std::invalid_argument(std::string("segment_spectral_recursive: ") + option +
                                  " must be " + range);
  };
  const auto is_weight = [](double w) { return w >= 0 && std::isfinite(w); };
  for_each_option(o, [](const Option_description& option, const auto& value) {
    if constexpr (std::is_arithmetic<std::decay_t<decltype(value)> >::value)
      option.check(static_cast<double>(value));
    else if (value)
      option.check(static_cast<double>(*value));
  });
  require(o.keep_components_separate || o.method == Method::CALIBRATED, "keep_components_separate",
          "true with zhang_liu_2005()");
  require(o.number_of_searches == 1 || o.method == Method::CALIBRATED, "number_of_searches",
          "1 with zhang_liu_2005()");
  require(static_cast<bool>(o.part_salience), "part_salience", "a function");
  if (const auto* w = o.part_salience.target<Weighted_part_salience>())
    require(w->alpha >= 0 && w->beta >= 0 && w->gamma >= 0 &&
              std::abs(w->alpha + w->beta + w->gamma - 1) < 1e-6,
            "salience_weights", "not negative and sum to 1");
  if (o.part_salience.target<Calibrated_part_salience>() && o.salience_threshold)
    require(std::isinf(*o.salience_threshold) ||
              (*o.salience_threshold >= 0 && *o.salience_threshold <= 1),
            "salience_threshold", "in [0, 1], because it is a probability, or infinite");
  require(o.geodesic_weight >= 0 && o.geodesic_weight <= 1, "the first of distance_weights",
          "in [0, 1]");
  require(is_weight(o.concave_angle_weight) && is_weight(o.convex_angle_weight),
          "the second and third of distance_weights", "finite and not negative");
}

/// \ingroup PkgSpectralSegmentationRef
/// returns the salience from which a run makes cuts. For an exact number this is `-infinity`. If no
/// threshold is set, it is `default_salience_threshold` for a `Weighted_part_salience`, and
/// `default_probability_threshold` for any other part salience.
inline double threshold_of(const Options& o)
{
  if (o.number_of_segments)
    return -std::numeric_limits<double>::infinity();
  const bool is_weighted = o.part_salience.target<Weighted_part_salience>() != nullptr;
  return o.salience_threshold.value_or(is_weighted ? default_salience_threshold
                                                   : default_probability_threshold);
}

/// \cond SKIP_IN_MANUAL
namespace internal {

// Returns the largest number of segments.
inline std::size_t maximum_number(const Options& o)
{ return o.number_of_segments.value_or(o.maximum_number_of_segments); }

// Returns whether `default_number_of_parts` ends the recursion of the paper.
inline bool has_default_end(const Options& o)
{
  return o.method == Method::ZHANG_LIU_2005 && maximum_number(o) == unlimited &&
         !o.salience_threshold;
}

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_OPTIONS_H
