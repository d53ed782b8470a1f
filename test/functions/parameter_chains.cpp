// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(parameter_chains)

namespace package = CGAL::Spectral_segmentation;
namespace tags = CGAL::Spectral_segmentation::internal_np;

namespace {

struct Traits
{
  int compute_x_3_object() const { return 0; }
};

template <template <class> class Is_accepted, class Type, class... Types>
auto first_accepted()
{
  if constexpr (Is_accepted<Type>::value)
    return Type();
  else
    return first_accepted<Is_accepted, Types...>();
}

// Returns a value that a parameter accepts.
template <template <class> class Is_accepted>
auto value_for()
{
  return first_accepted<Is_accepted, bool, int, const int*, Traits, package::Segmentation_visitor,
                        package::Weighted_part_salience, package::Options, std::vector<int> >();
}

#define DEFINE_PREDICATE(name, tag, predicate, what)                                             \
  template <class T> struct Is_accepted_by_##name : tags::predicate<T> {};
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL(DEFINE_PREDICATE)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL_FOR_RESULTS(DEFINE_PREDICATE)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(DEFINE_PREDICATE)
CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(DEFINE_PREDICATE)
#undef DEFINE_PREDICATE

template <class NamedParameters, class Tag>
using Value = decltype(CGAL::parameters::get_parameter(
  std::declval<const NamedParameters&>().cgal_parameters(), Tag()));

// Returns whether each chain has the value of `start` and the values of the two other parameters.
template <class T, class Tag, class... Chains>
constexpr auto have_all_values(
  const package::Named_parameters<
    CGAL::Named_function_parameters<T, Tag, CGAL::parameters::Default_named_parameters> >&,
  const Chains&...)
{
  return std::bool_constant<((std::is_same<Value<Chains, Tag>, T>::value &&
                              std::is_same<Value<Chains, tags::salience_threshold_t>, int>::value &&
                              std::is_same<Value<Chains, tags::random_seed_t>, int>::value) &&
                             ...)>();
}

} // namespace

#define CHECK_CHAINS(start, name, values)                                                        \
  static_assert(decltype(have_all_values(                                                        \
    start::name values, start::name values.salience_threshold(1).random_seed(2),                 \
    start::name values.random_seed(2).salience_threshold(1),                                     \
    threshold.name values.random_seed(2), threshold.random_seed(2).name values,                  \
    CGAL::parameters::combine(seed, start::name values, threshold),                              \
    CGAL::parameters::combine(seed, threshold.name values)))::value, #name);

// The name is found, and is not ambiguous, in a program that uses the namespaces.
#define CHECK_NAME(start, name, values)                                                          \
  static_assert(std::is_same<decltype(name values), decltype(start::name values)>::value, #name);

#define CHECK_OF_CGAL(name, ...)                                                                 \
  CHECK_CHAINS(package::parameters, name, (value_for<Is_accepted_by_##name>()))                  \
  CHECK_NAME(CGAL::parameters, name, (value_for<Is_accepted_by_##name>()))

#define CHECK_OF_PACKAGE(name, values)                                                           \
  CHECK_CHAINS(CGAL::parameters, name, values)                                                   \
  CHECK_NAME(CGAL::parameters, name, values)                                                     \
  CHECK_NAME(package::parameters, name, values)

#define CHECK_ONE_VALUE(name, ...)                                                               \
  CHECK_OF_PACKAGE(name, (value_for<Is_accepted_by_##name>()))

#define CHECK_OTHER(name) CHECK_OF_PACKAGE(name, VALUES_OF_##name)
#define VALUES_OF_zhang_liu_2005 ()
#define VALUES_OF_salience_weights (0.1, 0.6, 0.3)
#define VALUES_OF_distance_weights (0.03, 1, 0.1)
#define VALUES_OF_hierarchy (std::declval<package::Segmentation_hierarchy&>())
#define VALUES_OF_faces_of_parts (std::declval<std::vector<std::vector<int> >&>())

// The tables of the package name all parameters, so that a new one is checked, too.
BOOST_AUTO_TEST_CASE(each_parameter_has_each_place_in_a_chain_of_three)
{
  using namespace CGAL::parameters;
  using namespace CGAL::Spectral_segmentation::parameters;
  const auto threshold = CGAL::parameters::salience_threshold(1);
  const auto seed = CGAL::parameters::random_seed(2);
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL(CHECK_OF_CGAL)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_CGAL_FOR_RESULTS(CHECK_OF_CGAL)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS(CHECK_ONE_VALUE)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_RESULTS(CHECK_ONE_VALUE)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_OF_OTHER_VALUES(CHECK_OTHER)
  CGAL_SPECTRAL_SEGMENTATION_PARAMETERS_BY_REFERENCE(CHECK_OTHER)

  const auto values_of = [](const auto& np) {
    const auto& pack = np.cgal_parameters();
    return std::vector<int>{CGAL::parameters::get_parameter(pack, tags::salience_threshold),
                            CGAL::parameters::get_parameter(pack, CGAL::internal_np::random_seed)};
  };
  const std::vector<int> values{1, 2};
  BOOST_TEST(values_of(threshold.random_seed(2)) == values);
  BOOST_TEST(values_of(CGAL::parameters::combine(seed, threshold)) == values);
  BOOST_TEST(values_of(threshold.combine(seed)) == values);
}
#undef CHECK_CHAINS
#undef CHECK_NAME
#undef CHECK_OF_CGAL
#undef CHECK_OF_PACKAGE
#undef CHECK_ONE_VALUE
#undef CHECK_OTHER
#undef VALUES_OF_zhang_liu_2005
#undef VALUES_OF_salience_weights
#undef VALUES_OF_distance_weights
#undef VALUES_OF_hierarchy
#undef VALUES_OF_faces_of_parts

BOOST_AUTO_TEST_CASE(the_last_value_of_a_combination_counts)
{
  const auto one = CGAL::parameters::random_seed(1), two = CGAL::parameters::random_seed(2);
  const auto both = CGAL::parameters::salience_threshold(3).random_seed(4);
  const auto seed = [](const auto& np)
  { return CGAL::parameters::get_parameter(np.cgal_parameters(), CGAL::internal_np::random_seed); };
  BOOST_TEST(seed(CGAL::parameters::combine(one)) == 1);
  BOOST_TEST(seed(CGAL::parameters::combine(one, two)) == 2);
  BOOST_TEST(seed(CGAL::parameters::combine(two, one)) == 1);
  BOOST_TEST(seed(CGAL::parameters::combine(one, both)) == 4);
  BOOST_TEST(seed(CGAL::parameters::combine(both, one, CGAL::parameters::default_values())) == 1);
  BOOST_TEST(seed(both.combine(one.verbose(true).random_seed(2))) == 2);
}

BOOST_AUTO_TEST_SUITE_END()
