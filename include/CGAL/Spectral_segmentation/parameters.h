// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_H
#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

class Segmentation_hierarchy;

/// \cond SKIP_IN_MANUAL

// These tables name all parameters. Those with one value are f(name, tag, predicate of the value's
// type, expected value).
#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL(f)                                         \
  f(vertex_point_map, vertex_point_t, is_property_map, "takes a property map")                  \
  f(face_index_map, face_index_t, is_property_map, "takes a property map")                      \
  f(edge_is_constrained_map, edge_is_constrained_t, is_property_map, "takes a property map")    \
  f(geom_traits, geom_traits_t, has_coordinates, "takes a class with the functor Compute_x_3")  \
  f(random_seed, random_seed_t, is_count, "takes an integer")                                   \
  f(visitor, visitor_t, is_visitor,                                                             \
    "takes a class derived from Segmentation_visitor that redefines one of its functions, or "  \
    "std::ref to one; is a name misspelt?")

#define CGAL_SPECTRAL_SEGMENTATION_PARAMETER_OF_OPTION(f, name, predicate, what, least, greatest) \
  f(name, name##_t, predicate, what)

// clang-format off
#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(f)                                                 \
  CGAL_SPECTRAL_SEGMENTATION_OPTIONS(CGAL_SPECTRAL_SEGMENTATION_PARAMETER_OF_OPTION, f)          \
  f(options, options_t, is_options, "takes a CGAL::Spectral_segmentation::Options")              \
  f(part_salience, part_salience_t, is_part_salience,                                            \
    "takes a class that is called with Salience_factors, while const, and returns a number")     \
  f(edge_is_uncuttable_map, edge_is_uncuttable_map_t, is_property_map, "takes a property map")   \
  f(face_seed_map, face_seed_map_t, is_seed_map,                                                 \
    "takes a property map with values of a signed integer type")                                 \
  f(face_group_map, face_group_map_t, is_group_map,                                              \
    "takes a property map with values of an integer type")                                       \
  f(face_feature_map, face_feature_map_t, is_feature_map,                                        \
    "takes a property map whose values are numbers or ranges of numbers")
// clang-format on

// The parameters of the functions that take a segmentation: first CGAL's, then the package's.
#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL_FOR_RESULTS(f)                             \
  f(number_of_iterations, number_of_iterations_t, is_count, "takes an integer")

#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(f)                                      \
  f(close_parts, close_parts_t, is_flag, "takes a bool")                                         \
  f(sample_faces, sample_faces_t, is_vector, "takes a std::vector of faces")

// The parameters without a value or with three values, and those that receive a result, as f(name).
#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_OTHER_VALUES(f)                                 \
  f(zhang_liu_2005) f(salience_weights) f(distance_weights)

#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_BY_REFERENCE(f) f(hierarchy) f(faces_of_parts)

namespace internal_np {

using CGAL::internal_np::vertex_point_t;
using CGAL::internal_np::face_index_t;
using CGAL::internal_np::edge_is_constrained_t;
using CGAL::internal_np::geom_traits_t;
using CGAL::internal_np::random_seed_t;
using CGAL::internal_np::visitor_t;
using CGAL::internal_np::number_of_iterations_t;

#define CGAL_SPECTRAL_SEGMENTATION_TAG(name, ...) enum name##_t { name };
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(CGAL_SPECTRAL_SEGMENTATION_TAG)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(CGAL_SPECTRAL_SEGMENTATION_TAG)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_OTHER_VALUES(CGAL_SPECTRAL_SEGMENTATION_TAG)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_BY_REFERENCE(CGAL_SPECTRAL_SEGMENTATION_TAG)
#undef CGAL_SPECTRAL_SEGMENTATION_TAG

template <class T>
using is_flag = std::is_same<T, bool>;

template <class T>
using is_count = std::bool_constant<std::is_integral<T>::value && !is_flag<T>::value>;

template <class T>
using is_real = std::bool_constant<std::is_arithmetic<T>::value && !is_flag<T>::value>;

template <class T>
using is_options = std::is_same<T, Options>;

template <class T>
struct is_vector : std::false_type {};

template <class T>
struct is_vector<std::vector<T> > : std::true_type {};

// Returns 0 for anything but a number: a static_assert has reported it, so no second error is
// needed.
template <class T>
constexpr double to_double(T value)
{
  if constexpr (is_real<T>::value)
    return static_cast<double>(value);
  else
    return 0;
}

template <class T, class = void>
struct is_part_salience : std::false_type {};

template <class T>
struct is_part_salience<
  T, std::void_t<std::invoke_result_t<const T&, const Salience_factors&> > >
  : is_real<std::decay_t<std::invoke_result_t<const T&, const Salience_factors&> > > {};

template <class V> using before_stage_of = decltype(&V::before_stage);
template <class V> using after_stage_of = decltype(&V::after_stage);
template <class V> using before_part_of = decltype(&V::before_part);
template <class V> using after_part_of = decltype(&V::after_part);
template <class V> using after_cut_of = decltype(&V::after_cut);
template <class V> using progress_of = decltype(&V::progress);
template <class V> using go_further_of = decltype(&V::go_further);

// Detects whether a visitor has its own function. An overloaded one has no single address.
template <template <class> class Function, class Visitor, class = void>
struct redefines : std::true_type {};

template <template <class> class Function, class Visitor>
struct redefines<Function, Visitor, std::void_t<Function<Visitor> > >
  : std::bool_constant<!std::is_same<Function<Visitor>, Function<Segmentation_visitor> >::value> {};

template <class Visitor, template <class> class... Functions>
using redefines_one_of = std::bool_constant<(redefines<Functions, Visitor>::value || ...)>;

template <class T>
struct is_visitor
  : std::bool_constant<std::is_same<T, Segmentation_visitor>::value ||
                       (std::is_base_of<Segmentation_visitor, T>::value &&
                        redefines_one_of<T, before_stage_of, after_stage_of, before_part_of,
                                         after_part_of, after_cut_of, progress_of,
                                         go_further_of>::value)> {};

template <class T>
struct is_visitor<std::reference_wrapper<T> > : is_visitor<std::remove_const_t<T> > {};

template <class T, class = void>
struct is_property_map : std::false_type {};

template <class T>
struct is_property_map<T, std::void_t<typename boost::property_traits<T>::value_type> >
  : std::true_type {};

template <class T, class = void>
struct is_group_map : std::false_type {};

template <class T>
struct is_group_map<T, std::void_t<typename boost::property_traits<T>::value_type> >
  : is_count<typename boost::property_traits<T>::value_type> {};

template <class T, class = void>
struct is_seed_map : std::false_type {};

template <class T>
struct is_seed_map<T, std::void_t<typename boost::property_traits<T>::value_type> >
  : std::bool_constant<is_group_map<T>::value &&
                       std::is_signed<typename boost::property_traits<T>::value_type>::value> {};

template <class T, class = void>
struct is_feature : is_real<T> {};

template <class T>
struct is_feature<T, std::void_t<decltype(*std::begin(std::declval<const T&>()))> >
  : is_real<std::decay_t<decltype(*std::begin(std::declval<const T&>()))> > {};

template <class T, class = void>
struct is_feature_map : std::false_type {};

template <class T>
struct is_feature_map<T, std::void_t<typename boost::property_traits<T>::value_type> >
  : is_feature<typename boost::property_traits<T>::value_type> {};

template <class T, class = void>
struct has_coordinates : std::false_type {};

template <class T>
struct has_coordinates<T, std::void_t<decltype(std::declval<const T&>().compute_x_3_object())> >
  : std::true_type {};

template <class Tag, class... Tags>
using is_one_of = std::bool_constant<(std::is_same<Tag, Tags>::value || ...)>;

template <class Pack, class... Tags>
struct has_only : std::false_type {};

template <class... Tags>
struct has_only<CGAL::internal_np::No_property, Tags...> : std::true_type {};

// Rejects tags that a function does not read. CGAL's own functions ignore them silently.
template <class T, class Tag, class Base, class... Tags>
struct has_only<CGAL::Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<is_one_of<Tag, CGAL::internal_np::all_default_t, Tags...>::value &&
                       has_only<Base, Tags...>::value> {};

template <class Pack>
using has_only_face_index_map = has_only<Pack, face_index_t>;

#define CGAL_SPECTRAL_SEGMENTATION_TAG(name, tag, predicate, what) tag,
template <class Pack>
using has_only_known_tags = has_only<Pack,
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL(CGAL_SPECTRAL_SEGMENTATION_TAG)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(CGAL_SPECTRAL_SEGMENTATION_TAG)
  zhang_liu_2005_t, distance_weights_t, hierarchy_t>;
#undef CGAL_SPECTRAL_SEGMENTATION_TAG

} // namespace internal_np

/// \endcond

/// \ingroup PkgSpectralSegmentationRef
/// A pack of named parameters. It holds a CGAL pack, and offers the names that the functions of
/// this package read, both the package's and CGAL's, to be chained in any order.
///
/// The functions that the package adds to the namespace `CGAL::parameters` make packs. See
/// `segment_spectral_recursive()` for the meaning of each name.
template <class CGALNamedParameters = CGAL::parameters::Default_named_parameters>
class Named_parameters
{
  CGALNamedParameters np_;

  template <class> friend class Named_parameters;

  template <class Tag, class T>
  auto with(const T& value) const
  {
    typedef CGAL::Named_function_parameters<T, Tag, CGALNamedParameters> Pack;
    return Named_parameters<Pack>(Pack(value, np_));
  }

public:
  /// a pack with the parameters of a pack of CGAL
  explicit Named_parameters(const CGALNamedParameters& np = CGALNamedParameters()) : np_(np) {}

  /// the same parameters as a pack of CGAL, for CGAL's own functions
  const CGALNamedParameters& cgal_parameters() const { return np_; }

  /// a pack with the parameters of this pack and of another, which may be CGAL's
  template <class T, class Tag, class Base>
  auto combine(const CGAL::Named_function_parameters<T, Tag, Base>& np) const
  {
    if constexpr (std::is_same<Base, CGAL::internal_np::No_property>::value)
      return with<Tag>(np.v);
    else
      return combine(static_cast<const Base&>(np)).template with<Tag>(np.v);
  }

  template <class Other>
  auto combine(const Named_parameters<Other>& np) const { return combine(np.np_); }

  /// \name Parameters
  /// Each function returns a pack that has its parameter and the parameters of this pack. If a
  /// parameter is given twice, the last value counts. An argument of a wrong type is an error at
  /// compile time. For a value out of its range, the function that is called with the pack throws
  /// an exception.
  /// @{

#define CGAL_SPECTRAL_SEGMENTATION_MEMBER(name, tag, predicate, what)               \
  template <class T>                                                                \
  auto name(const T& value) const                                                   \
  {                                                                                 \
    static_assert(internal_np::predicate<T>::value, #name " " what);                \
    if constexpr (internal_np::predicate<T>::value) /* else no second error */      \
      return with<internal_np::tag>(value);                                         \
    else                                                                            \
      return *this;                                                                 \
  }

  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL(CGAL_SPECTRAL_SEGMENTATION_MEMBER)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(CGAL_SPECTRAL_SEGMENTATION_MEMBER)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL_FOR_RESULTS(CGAL_SPECTRAL_SEGMENTATION_MEMBER)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(CGAL_SPECTRAL_SEGMENTATION_MEMBER)
#undef CGAL_SPECTRAL_SEGMENTATION_MEMBER

  /// selects the method of the paper
  auto zhang_liu_2005() const { return with<internal_np::zhang_liu_2005_t>(true); }

  /// is short for `part_salience(Weighted_part_salience{alpha, beta, gamma})`
  template <class Number1, class Number2, class Number3>
  auto salience_weights(Number1 alpha, Number2 beta, Number3 gamma) const
  {
    static_assert(internal_np::is_real<Number1>::value && internal_np::is_real<Number2>::value &&
                  internal_np::is_real<Number3>::value,
                  "salience_weights takes three numbers: alpha, beta, gamma");
    return part_salience(Weighted_part_salience{
      internal_np::to_double(alpha), internal_np::to_double(beta),
      internal_np::to_double(gamma)});
  }

  /// sets the weight of the geodesic distance, and the factors of the angle distance at concave and
  /// at convex edges
  template <class Number1, class Number2, class Number3>
  auto distance_weights(Number1 delta, Number2 concave_eta, Number3 convex_eta) const
  {
    static_assert(internal_np::is_real<Number1>::value && internal_np::is_real<Number2>::value &&
                  internal_np::is_real<Number3>::value,
                  "distance_weights takes three numbers: delta, eta at concave edges, eta at "
                  "convex edges");
    return with<internal_np::distance_weights_t>(std::array<double, 3>{
      internal_np::to_double(delta), internal_np::to_double(concave_eta),
      internal_np::to_double(convex_eta)});
  }

  /// receives all cuts with their salience
  template <class Hierarchy>
  auto hierarchy(Hierarchy& h) const
  {
    static_assert(std::is_same<Hierarchy, Segmentation_hierarchy>::value,
                  "hierarchy takes a CGAL::Spectral_segmentation::Segmentation_hierarchy, not "
                  "const");
    return with<internal_np::hierarchy_t>(std::ref(h));
  }

  /// receives for each part the faces of the mesh that its faces come from
  template <class FaceDescriptor>
  auto faces_of_parts(std::vector<std::vector<FaceDescriptor> >& faces) const
  { return with<internal_np::faces_of_parts_t>(std::ref(faces)); }

  /// @}
};

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class NamedParameters, class Tag>
constexpr bool is_given =
  !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

// Returns the CGAL pack of a pack.
template <class T, class Tag, class Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
cgal_pack(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{ return np; }

template <class CGALNamedParameters>
const CGALNamedParameters& cgal_pack(const Named_parameters<CGALNamedParameters>& np)
{ return np.cgal_parameters(); }

template <class NotAPack>
const CGAL::parameters::Default_named_parameters& cgal_pack(const NotAPack&)
{
  static_assert(sizeof(NotAPack) == 0, "the last argument is not a pack of named parameters");
  static const CGAL::parameters::Default_named_parameters no_second_error;
  return no_second_error;
}

// Returns the CGAL pack of a pack, and checks that the function reads its parameters.
template <template <class> class Has_only_known_tags, class NamedParameters>
const auto& checked_pack(const NamedParameters& np)
{
  const auto& pack = cgal_pack(np);
  static_assert(Has_only_known_tags<std::decay_t<decltype(pack)> >::value,
                "this pack holds a named parameter that the function does not use; parameters of "
                "the package are added to a pack of CGAL by CGAL::parameters::combine");
  return pack;
}

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation

/// The namespace of \cgal's named parameters. For each parameter of the package it has a function
/// that starts a pack, with the arguments of the function of this name in
/// `CGAL::Spectral_segmentation::Named_parameters`.
namespace parameters {

/// \cond SKIP_IN_MANUAL

// Starts a pack. Templates of this name that take one argument are better matches, so that no call
// is ambiguous.
#define CGAL_SPECTRAL_SEGMENTATION_START(name, ...)                                 \
  template <class... Values>                                                        \
  auto name(const Values&... values)                                                \
  { return Spectral_segmentation::Named_parameters<>().name(values...); }

CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(CGAL_SPECTRAL_SEGMENTATION_START)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(CGAL_SPECTRAL_SEGMENTATION_START)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_OTHER_VALUES(CGAL_SPECTRAL_SEGMENTATION_START)

template <class... Hierarchy, class = std::enable_if_t<(std::is_same<
            const Hierarchy, const Spectral_segmentation::Segmentation_hierarchy>::value && ...)> >
auto hierarchy(Hierarchy&... h)
{ return Spectral_segmentation::Named_parameters<>().hierarchy(h...); }

template <class FaceDescriptor>
auto faces_of_parts(std::vector<std::vector<FaceDescriptor> >& faces)
{ return Spectral_segmentation::Named_parameters<>().faces_of_parts(faces); }

template <class CGALNamedParameters>
auto combine(const Spectral_segmentation::Named_parameters<CGALNamedParameters>& np) { return np; }

template <class CGALNamedParameters, class Other, class... Others>
auto combine(const Spectral_segmentation::Named_parameters<CGALNamedParameters>& np,
             const Other& other, const Others&... others)
{ return combine(np.combine(other), others...); }

/// \endcond

/// a pack with the parameters of `np` and of other packs, each of which may be \cgal's or the
/// package's. If a parameter is given twice, the last value counts.
template <class T, class Tag, class Base, class... Others>
auto combine(const Named_function_parameters<T, Tag, Base>& np, const Others&... others)
{ return combine(Spectral_segmentation::Named_parameters(np), others...); }

} // namespace parameters

namespace Spectral_segmentation {

/// The functions of the package in `CGAL::parameters`, and functions that start a pack with a
/// parameter of \cgal, to which parameters of the package can be added.
namespace parameters {

/// the empty pack: every parameter has its default
inline Named_parameters<> default_values() { return Named_parameters<>(); }

/// a pack with the parameters of a pack of \cgal, the same as `combine(np)`
template <class T, class Tag, class Base>
auto from(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{ return CGAL::parameters::combine(np); }

CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL(CGAL_SPECTRAL_SEGMENTATION_START)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL_FOR_RESULTS(CGAL_SPECTRAL_SEGMENTATION_START)
#undef CGAL_SPECTRAL_SEGMENTATION_START

#define CGAL_SPECTRAL_SEGMENTATION_USING(name, ...) using CGAL::parameters::name;
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(CGAL_SPECTRAL_SEGMENTATION_USING)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(CGAL_SPECTRAL_SEGMENTATION_USING)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_OTHER_VALUES(CGAL_SPECTRAL_SEGMENTATION_USING)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_BY_REFERENCE(CGAL_SPECTRAL_SEGMENTATION_USING)
#undef CGAL_SPECTRAL_SEGMENTATION_USING
using CGAL::parameters::combine;

} // namespace parameters
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_H
