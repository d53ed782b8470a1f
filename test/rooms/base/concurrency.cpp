// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(concurrency)

namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using internal::Execution;
using internal::call_all;
using internal::call_isolated;
using internal::for_each_index;
using internal::sum_of;

namespace {

// The second is the same as the first if there is no TBB.
const Execution executions[] = {Execution::SEQUENTIAL, Execution::PARALLEL};

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

BOOST_AUTO_TEST_CASE(each_index_is_visited_once)
{
  for (Execution execution : executions)
    for (std::size_t n : {0, 1, 2, 1000, 100000}) {
      std::vector<int> visits(n, 0);
      for_each_index(execution, n, [&](std::size_t i) { ++visits[i]; });
      BOOST_TEST(visits == std::vector<int>(n, 1));
    }
}

BOOST_AUTO_TEST_CASE(indices_may_be_visited_within_a_visit)
{
  for (Execution execution : executions) {
    std::vector<int> visits(50 * 60, 0);
    for_each_index(execution, 50, [&](std::size_t i) {
      for_each_index(execution, 60, [&](std::size_t j) { ++visits[60 * i + j]; });
    });
    BOOST_TEST(visits == std::vector<int>(50 * 60, 1));
  }
}

BOOST_AUTO_TEST_CASE(all_functions_are_called_once)
{
  for (Execution execution : executions) {
    int calls[3] = {0, 0, 0};
    call_all(execution, [&] { ++calls[0]; }, [&] { ++calls[1]; }, [&] { ++calls[2]; });
    int isolated_calls = 0;
    call_isolated([&] { ++isolated_calls; });
    for (int number : {calls[0], calls[1], calls[2], isolated_calls})
      BOOST_TEST(number == 1);
  }
}

BOOST_AUTO_TEST_CASE(an_exception_reaches_the_caller)
{
  for (Execution execution : executions) {
    const auto fail = [](std::size_t i) {
      if (i == 700)
        throw std::runtime_error("700");
    };
    BOOST_CHECK_THROW(for_each_index(execution, 1000, fail), std::runtime_error);
    BOOST_CHECK_THROW(call_all(execution, [] {}, [&] { fail(700); }), std::runtime_error);
    BOOST_CHECK_THROW(call_isolated([&] { fail(700); }), std::runtime_error);
  }
}

BOOST_AUTO_TEST_CASE(sums_have_all_terms)
{
  for (Execution execution : executions)
    for (std::size_t n : {0, 1, 2, 4095, 4096, 4097, 8192, 100001}) {
      const auto index = [](std::size_t i) { return i; };
      BOOST_TEST(sum_of(execution, n, std::size_t(0), index) == n * (n + 1) / 2 - n);
    }
}

BOOST_AUTO_TEST_CASE(the_rounding_of_a_sum_does_not_depend_on_the_threads)
{
  const auto term = [](std::size_t i) { return std::sin(static_cast<double>(i)) / 3; };
  const double sum = sum_of(Execution::SEQUENTIAL, 1000000, 0., term);
  for (int i = 0; i < 20; ++i)
    BOOST_TEST(sum_of(Execution::PARALLEL, 1000000, 0., term) == sum);
}

BOOST_AUTO_TEST_CASE(order_equals_a_stable_sort_with_any_number_of_threads)
{
  Random random(1);
  for (std::size_t n : {0, 1, 2, 500, 10001, 60000})
    for (unsigned number_of_values : {1, 2, 50, 1000000}) {
      std::vector<float> values;
      for (std::size_t i = 0; i < n; ++i)
        values.push_back((float(random() % number_of_values) - float(number_of_values / 2)) / 1024);
      const std::vector<double> distances(values.begin(), values.end());
      for (Execution execution : {Execution::SEQUENTIAL, Execution::PARALLEL}) {
        BOOST_TEST(internal::sorted_indices(execution, values) == stably_sorted(values));
        BOOST_TEST(internal::sorted_indices(execution, distances) == stably_sorted(distances));
      }
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
  for (Execution execution : {Execution::SEQUENTIAL, Execution::PARALLEL})
    BOOST_TEST(internal::sorted_indices(execution, values, is_first) == expected);
}

BOOST_AUTO_TEST_CASE(infinite_values_and_both_zeros_have_their_place)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values = {infinity, 0., -infinity, -0., 1., 0., infinity};
  for (Execution execution : {Execution::SEQUENTIAL, Execution::PARALLEL})
    BOOST_TEST(internal::sorted_indices(execution, values) ==
               std::vector<Index>({2, 1, 3, 5, 4, 0, 6}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
