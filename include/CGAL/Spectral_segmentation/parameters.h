// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_H
#define CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spectral_segmentation {

class Segment_tree;

/// \ingroup PkgSpectralSegmentationRef
/// The values of the named parameter `method`, which chooses the defaults of all others.
enum class Method
{
  ZHANG_LIU_2005, ///< the method of the paper
  CALIBRATED      ///< cuts whose salience is the probability that a person would cut there
};

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for a `Weighted_part_salience`: of the
/// multiples of 0.02 the one value for all meshes with the smallest Rand error on the odd half of
/// the Princeton benchmark.
constexpr double default_salience_threshold = 0.54;

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `salience_threshold` for any other part salience: amid the
/// values from 0.40 to 0.46, among which the Rand error on the odd half of the Princeton benchmark
/// hardly changes. It is below 1/2, as a cut too many costs less than one too few.
constexpr double default_probability_threshold = 0.42;

/// \ingroup PkgSpectralSegmentationRef
/// The default of the named parameter `minimum_segment_size`.
constexpr double default_minimum_segment_size(Method method)
{ return method == Method::CALIBRATED ? 0.003 : 0.005; }

/// \cond SKIP_IN_MANUAL

namespace internal_np {

enum method_t { method };

enum maximum_number_of_segments_t { maximum_number_of_segments };
enum minimum_segment_size_t { minimum_segment_size };
enum salience_threshold_t { salience_threshold };
enum part_salience_t { part_salience };
enum geodesic_weight_t { geodesic_weight };
enum concave_angle_weight_t { concave_angle_weight };
enum convex_angle_weight_t { convex_angle_weight };
enum concavity_radius_t { concavity_radius };
enum number_of_reference_faces_t { number_of_reference_faces };
enum single_source_orderings_t { single_source_orderings };
enum thickness_orderings_t { thickness_orderings };
enum number_of_candidates_t { number_of_candidates };
enum number_of_refined_candidates_t { number_of_refined_candidates };
enum number_of_pieces_t { number_of_pieces };
enum number_of_smoothing_iterations_t { number_of_smoothing_iterations };
enum boundary_smoothing_t { boundary_smoothing };
enum segment_tree_t { segment_tree };

template <class T>
using is_flag = std::is_same<T, bool>;

template <class T>
using is_count = std::bool_constant<std::is_integral<T>::value && !is_flag<T>::value>;

template <class T>
using is_real = std::bool_constant<std::is_arithmetic<T>::value && !is_flag<T>::value>;

template <class T, class = void>
struct is_part_salience : std::false_type {};

template <class T>
struct is_part_salience<
  T, std::void_t<std::invoke_result_t<const T&, const Salience_factors&> > >
  : is_real<std::decay_t<std::invoke_result_t<const T&, const Salience_factors&> > > {};

template <class Tag, class... Tags>
using is_one_of = std::bool_constant<(std::is_same<Tag, Tags>::value || ...)>;

template <class T>
struct unwrapped { typedef T type; };

template <class T>
struct unwrapped<std::reference_wrapper<T> > { typedef T type; };

template <class T, class = void>
struct is_property_map : std::false_type {};

template <class T>
struct is_property_map<T, std::void_t<typename boost::property_traits<T>::value_type> >
  : std::true_type {};

template <class T, class = void>
struct has_coordinates : std::false_type {};

template <class T>
struct has_coordinates<T, std::void_t<decltype(std::declval<const T&>().compute_x_3_object())> >
  : std::true_type {};

template <class Pack, class... Tags>
struct has_only : std::false_type {};

template <class... Tags>
struct has_only<CGAL::internal_np::No_property, Tags...> : std::true_type {};

// CGAL's own functions ignore in silence the tags that they do not read; ours do not.
template <class T, class Tag, class Base, class... Tags>
struct has_only<CGAL::Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<is_one_of<Tag, CGAL::internal_np::all_default_t, Tags...>::value &&
                       has_only<Base, Tags...>::value> {};

template <class Pack>
using has_only_face_index_map = has_only<Pack, CGAL::internal_np::face_index_t>;

template <class Pack>
using has_only_known_tags = has_only<Pack,
  CGAL::internal_np::vertex_point_t, CGAL::internal_np::face_index_t,
  CGAL::internal_np::geom_traits_t, CGAL::internal_np::random_seed_t,
  CGAL::internal_np::visitor_t, method_t,
  maximum_number_of_segments_t, minimum_segment_size_t, salience_threshold_t, part_salience_t,
  geodesic_weight_t, concave_angle_weight_t, convex_angle_weight_t, concavity_radius_t,
  number_of_reference_faces_t, single_source_orderings_t, thickness_orderings_t,
  number_of_candidates_t, number_of_refined_candidates_t, number_of_pieces_t,
  number_of_smoothing_iterations_t, boundary_smoothing_t, segment_tree_t>;

} // namespace internal_np

/// \endcond

/// \ingroup PkgSpectralSegmentationRef
/// A pack of named parameters: holds a CGAL pack, and offers the names that the functions of this
/// package read, ours and CGAL's, to be chained in any order.
///
/// A pack is made by a function of the namespace `CGAL::Spectral_segmentation::parameters`;
/// see `segment_spectral_recursive()` for the meaning of each name.
template <class CGALNamedParameters = CGAL::parameters::Default_named_parameters>
class Named_parameters
{
  CGALNamedParameters np_;

  template <class Tag, class T>
  using With = Named_parameters<CGAL::Named_function_parameters<T, Tag, CGALNamedParameters> >;

  template <class Tag, class T>
  With<Tag, T> with(const T& value) const
  {
    return With<Tag, T>(
      CGAL::Named_function_parameters<T, Tag, CGALNamedParameters>(value, np_));
  }

public:
  /// a pack with the parameters of a pack of CGAL, which must have none that the functions of this
  /// package do not read
  explicit Named_parameters(const CGALNamedParameters& np = CGALNamedParameters()) : np_(np)
  {
    static_assert(internal_np::has_only_known_tags<CGALNamedParameters>::value,
                  "this pack holds a CGAL named parameter that the package does not use");
  }

  /// the same parameters as a pack of CGAL, for CGAL's own functions
  const CGALNamedParameters& cgal_parameters() const { return np_; }

  /// \name Parameters
  /// Each function returns a pack that has its parameter besides those of this pack; of a parameter
  /// that is given twice the last value counts. An argument of a wrong type is an error at compile
  /// time, a value out of its range an exception of the function that is called with the pack.
  /// @{

  template <class VertexPointMap>
  auto vertex_point_map(const VertexPointMap& map) const
  {
    static_assert(internal_np::is_property_map<VertexPointMap>::value,
                  "vertex_point_map takes a property map");
    return with<CGAL::internal_np::vertex_point_t>(map);
  }

  template <class FaceIndexMap>
  auto face_index_map(const FaceIndexMap& map) const
  {
    static_assert(internal_np::is_property_map<FaceIndexMap>::value,
                  "face_index_map takes a property map");
    return with<CGAL::internal_np::face_index_t>(map);
  }

  template <class GeomTraits>
  auto geom_traits(const GeomTraits& traits) const
  {
    static_assert(internal_np::has_coordinates<GeomTraits>::value,
                  "geom_traits takes a class with the functor Compute_x_3");
    return with<CGAL::internal_np::geom_traits_t>(traits);
  }

  template <class Integer>
  auto random_seed(Integer seed) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "random_seed takes an integer");
    return with<CGAL::internal_np::random_seed_t>(seed);
  }

  template <class Visitor>
  auto visitor(const Visitor& v) const
  {
    static_assert(std::is_base_of<Segmentation_visitor,
                                  typename internal_np::unwrapped<Visitor>::type>::value,
                  "visitor takes a class derived from Segmentation_visitor, or std::ref to one");
    return with<CGAL::internal_np::visitor_t>(v);
  }

  template <class T>
  auto method(T m) const
  {
    static_assert(std::is_same<T, Method>::value,
                  "method takes a CGAL::Spectral_segmentation::Method");
    return with<internal_np::method_t>(m);
  }

  /// the method of the paper: short for `method(Method::ZHANG_LIU_2005)`
  auto zhang_liu_2005() const { return method(Method::ZHANG_LIU_2005); }

  template <class Integer>
  auto maximum_number_of_segments(Integer n) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "maximum_number_of_segments takes an integer");
    return with<internal_np::maximum_number_of_segments_t>(n);
  }

  template <class Number>
  auto minimum_segment_size(Number share) const
  {
    static_assert(internal_np::is_real<Number>::value,
                  "minimum_segment_size takes a number");
    return with<internal_np::minimum_segment_size_t>(static_cast<double>(share));
  }

  template <class Number>
  auto salience_threshold(Number threshold) const
  {
    static_assert(internal_np::is_real<Number>::value,
                  "salience_threshold takes a number");
    return with<internal_np::salience_threshold_t>(static_cast<double>(threshold));
  }

  template <class PartSalience>
  auto part_salience(const PartSalience& model) const
  {
    static_assert(internal_np::is_part_salience<PartSalience>::value,
                  "part_salience takes a class that is called with Salience_factors, while const, "
                  "and returns a number");
    return with<internal_np::part_salience_t>(model);
  }

  /// short for `part_salience(Weighted_part_salience{alpha, beta, gamma})`
  template <class Number1, class Number2, class Number3>
  auto salience_weights(Number1 alpha, Number2 beta, Number3 gamma) const
  {
    static_assert(internal_np::is_real<Number1>::value && internal_np::is_real<Number2>::value &&
                  internal_np::is_real<Number3>::value,
                  "salience_weights takes three numbers: alpha, beta, gamma");
    return part_salience(Weighted_part_salience{
      static_cast<double>(alpha), static_cast<double>(beta), static_cast<double>(gamma)});
  }

  template <class Number>
  auto geodesic_weight(Number delta) const
  {
    static_assert(internal_np::is_real<Number>::value,
                  "geodesic_weight takes a number");
    return with<internal_np::geodesic_weight_t>(static_cast<double>(delta));
  }

  template <class Number>
  auto concave_angle_weight(Number eta) const
  {
    static_assert(internal_np::is_real<Number>::value,
                  "concave_angle_weight takes a number");
    return with<internal_np::concave_angle_weight_t>(static_cast<double>(eta));
  }

  template <class Number>
  auto convex_angle_weight(Number eta) const
  {
    static_assert(internal_np::is_real<Number>::value,
                  "convex_angle_weight takes a number");
    return with<internal_np::convex_angle_weight_t>(static_cast<double>(eta));
  }

  template <class Number>
  auto concavity_radius(Number radius) const
  {
    static_assert(internal_np::is_real<Number>::value,
                  "concavity_radius takes a number");
    return with<internal_np::concavity_radius_t>(static_cast<double>(radius));
  }

  template <class Integer>
  auto number_of_reference_faces(Integer k) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "number_of_reference_faces takes an integer");
    return with<internal_np::number_of_reference_faces_t>(k);
  }

  template <class Bool>
  auto single_source_orderings(Bool on) const
  {
    static_assert(internal_np::is_flag<Bool>::value,
                  "single_source_orderings takes a bool");
    return with<internal_np::single_source_orderings_t>(on);
  }

  template <class Bool>
  auto thickness_orderings(Bool on) const
  {
    static_assert(internal_np::is_flag<Bool>::value,
                  "thickness_orderings takes a bool");
    return with<internal_np::thickness_orderings_t>(on);
  }

  template <class Integer>
  auto number_of_candidates(Integer n) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "number_of_candidates takes an integer");
    return with<internal_np::number_of_candidates_t>(n);
  }

  template <class Integer>
  auto number_of_refined_candidates(Integer n) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "number_of_refined_candidates takes an integer");
    return with<internal_np::number_of_refined_candidates_t>(n);
  }

  template <class Integer>
  auto number_of_pieces(Integer n) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "number_of_pieces takes an integer");
    return with<internal_np::number_of_pieces_t>(n);
  }

  template <class Integer>
  auto number_of_smoothing_iterations(Integer n) const
  {
    static_assert(internal_np::is_count<Integer>::value,
                  "number_of_smoothing_iterations takes an integer");
    return with<internal_np::number_of_smoothing_iterations_t>(n);
  }

  template <class Bool>
  auto boundary_smoothing(Bool on) const
  {
    static_assert(internal_np::is_flag<Bool>::value,
                  "boundary_smoothing takes a bool");
    return with<internal_np::boundary_smoothing_t>(on);
  }

  template <class Tree>
  auto segment_tree(Tree& tree) const
  {
    static_assert(std::is_same<Tree, Segment_tree>::value,
                  "segment_tree takes a CGAL::Spectral_segmentation::Segment_tree, not const");
    return with<internal_np::segment_tree_t>(std::ref(tree));
  }

  /// @}
};

/// The functions that start a pack of named parameters.
namespace parameters {

/// the empty pack: every parameter has its default
inline Named_parameters<> default_values() { return Named_parameters<>(); }

/// takes over a pack of CGAL, e.g. one that the caller was handed
template <class T, class Tag, class Base>
auto from(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{ return Named_parameters<CGAL::Named_function_parameters<T, Tag, Base> >(np); }

/// \name Parameters
/// Each function starts a pack with the parameter of its name; it takes what the function of this
/// name in `Named_parameters` takes.
/// @{

#define CGAL_SPECTRAL_SEGMENTATION_START_PACK(NAME)               \
  template <class... Values>                                      \
  auto NAME(const Values&... values)                              \
  { return default_values().NAME(values...); }

CGAL_SPECTRAL_SEGMENTATION_START_PACK(vertex_point_map)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(face_index_map)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(geom_traits)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(random_seed)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(visitor)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(method)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(zhang_liu_2005)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(maximum_number_of_segments)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(minimum_segment_size)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(salience_threshold)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(part_salience)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(salience_weights)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(geodesic_weight)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(concave_angle_weight)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(convex_angle_weight)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(concavity_radius)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(number_of_reference_faces)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(single_source_orderings)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(thickness_orderings)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(number_of_candidates)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(number_of_refined_candidates)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(number_of_pieces)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(number_of_smoothing_iterations)
CGAL_SPECTRAL_SEGMENTATION_START_PACK(boundary_smoothing)

#undef CGAL_SPECTRAL_SEGMENTATION_START_PACK

template <class Tree>
auto segment_tree(Tree& tree)
{ return default_values().segment_tree(tree); }

/// @}

} // namespace parameters

/// \cond SKIP_IN_MANUAL

namespace internal {

template <class CGALNamedParameters>
const CGALNamedParameters& cgal_pack(const Named_parameters<CGALNamedParameters>& np)
{ return np.cgal_parameters(); }

template <class T, class Tag, class Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
cgal_pack(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  static_assert(internal_np::has_only_known_tags<
                  CGAL::Named_function_parameters<T, Tag, Base> >::value,
                "this pack holds a CGAL named parameter that the package does not use");
  return np;
}

template <class NotAPack>
CGAL::parameters::Default_named_parameters cgal_pack(const NotAPack&)
{
  static_assert(sizeof(NotAPack) == 0, "the last argument is not a pack of named parameters");
  return CGAL::parameters::default_values();
}

} // namespace internal

/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_H
