// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

BOOST_AUTO_TEST_SUITE(sorted_indices)

namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;

namespace {

template <class Value>
std::vector<Index> stably_sorted(const std::vector<Value>& values)
{
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return values[i] < values[j]; });
  return order;
}

} // namespace

BOOST_AUTO_TEST_CASE(order_equals_a_stable_sort)
{
  Random random(1);
  for (std::size_t n : {0, 1, 2, 500, 10001, 60000})
    for (unsigned number_of_values : {1, 2, 50, 1000000}) {
      std::vector<float> values;
      for (std::size_t i = 0; i < n; ++i)
        values.push_back((float(random() % number_of_values) - float(number_of_values / 2)) / 1024);
      const std::vector<double> distances(values.begin(), values.end());
      BOOST_TEST(internal::sorted_indices(values) == stably_sorted(values));
      BOOST_TEST(internal::sorted_indices(distances) == stably_sorted(distances));
    }
}

BOOST_AUTO_TEST_CASE(the_caller_may_break_ties)
{
  Random random(2);
  std::vector<double> values(10001), second(10001);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = double(random() % 20);
    second[i] = double(random() % 20);
  }
  const auto is_first = [&](Index i, Index j)
  { return second[i] < second[j] || (second[i] == second[j] && i > j); };
  std::vector<Index> expected = stably_sorted(values);
  std::sort(expected.begin(), expected.end(), [&](Index i, Index j)
    { return values[i] < values[j] || (values[i] == values[j] && is_first(i, j)); });
  BOOST_TEST(internal::sorted_indices(values, is_first) == expected);
}

BOOST_AUTO_TEST_CASE(infinite_values_and_both_zeros_have_their_place)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values = {infinity, 0., -infinity, -0., 1., 0., infinity};
  BOOST_TEST(internal::sorted_indices(values) ==
             std::vector<Index>({2, 1, 3, 5, 4, 0, 6}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
