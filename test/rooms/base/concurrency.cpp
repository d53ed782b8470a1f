// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <cmath>
#include <cstddef>
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

BOOST_AUTO_TEST_SUITE_END()
